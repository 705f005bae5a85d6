// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatChunkCache.h"

#include "vtkAbstractArray.h"

//------------------------------------------------------------------------------
vtkTypeInt64 vtkPointSplatChunkCache::BytesOf(vtkAbstractArray* chunk)
{
  return static_cast<vtkTypeInt64>(chunk->GetActualMemorySize()) * 1024;
}

//------------------------------------------------------------------------------
void vtkPointSplatChunkCache::SetBudget(vtkTypeInt64 bytes)
{
  this->Budget = bytes;
  this->KeepBudget();
}

//------------------------------------------------------------------------------
void vtkPointSplatChunkCache::KeepBudget()
{
  while (this->Size > this->Budget)
  {
    const Entry& last = this->Entries.back();
    this->Size -= last.Bytes;
    this->SizeOfCut -= last.Cut == this->Cut ? last.Bytes : 0;
    this->Places.erase(last.Name);
    this->Entries.pop_back();
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatChunkCache::Use(Entry& entry)
{
  this->SizeOfCut += entry.Cut == this->Cut ? 0 : entry.Bytes;
  entry.Cut = this->Cut;
}

//------------------------------------------------------------------------------
vtkAbstractArray* vtkPointSplatChunkCache::Find(const Key& key)
{
  const auto place = this->Places.find(key);
  if (place == this->Places.end())
  {
    return nullptr;
  }
  this->Entries.splice(this->Entries.begin(), this->Entries, place->second);
  this->Use(this->Entries.front());
  return this->Entries.front().Chunk;
}

//------------------------------------------------------------------------------
void vtkPointSplatChunkCache::Add(const Key& key, vtkAbstractArray* chunk)
{
  const vtkTypeInt64 bytes = vtkPointSplatChunkCache::BytesOf(chunk);
  this->SizeOfAdded += bytes;
  if (bytes > this->Budget || this->Has(key))
  {
    return;
  }
  this->Entries.push_front({ key, chunk, bytes, this->Cut - 1 });
  this->Places[key] = this->Entries.begin();
  this->Size += bytes;
  this->Use(this->Entries.front());
  this->KeepBudget();
}

//------------------------------------------------------------------------------
bool vtkPointSplatChunkCache::HasRoomBesideCut(vtkAbstractArray* chunk) const
{
  return this->SizeOfCut + vtkPointSplatChunkCache::BytesOf(chunk) <= this->Budget;
}

//------------------------------------------------------------------------------
void vtkPointSplatChunkCache::BeginCut()
{
  ++this->Cut;
  this->SizeOfCut = 0;
}

//------------------------------------------------------------------------------
void vtkPointSplatChunkCache::Clear()
{
  this->Entries.clear();
  this->Places.clear();
  this->Size = this->SizeOfCut = 0;
}
