// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Of the octree's reader: chunks of arrays that were read, kept as long as there is room. HDF5's own
// caches are one for each data set, and forgotten when it is closed, so that no budget for all can be
// stated.
#ifndef vtkPointSplatChunkCache_h
#define vtkPointSplatChunkCache_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <list>
#include <map>

class vtkAbstractArray;

class vtkPointSplatChunkCache
{
public:
  /// Piece, level, number of the array, number of the chunk.
  using Key = std::array<vtkIdType, 4>;

  /// Bytes of memory, of all chunks together.
  void SetBudget(vtkTypeInt64 bytes);
  vtkTypeInt64 GetBudget() const { return this->Budget; }
  vtkTypeInt64 GetSize() const { return this->Size; }
  /// Of all that was ever added, kept or not.
  vtkTypeInt64 GetSizeOfAdded() const { return this->SizeOfAdded; }
  /// None: it is not there. Else it is the one that was used last.
  vtkAbstractArray* Find(const Key& key);
  bool Has(const Key& key) const { return this->Places.count(key) > 0; }
  /// Those that were used least recently go, the new one itself if it is larger than the budget.
  void Add(const Key& key, vtkAbstractArray* chunk);
  /// Whether the chunk fits in beside those that were used since BeginCut().
  bool HasRoomBesideCut(vtkAbstractArray* chunk) const;
  void BeginCut();
  void Clear();
  static vtkTypeInt64 BytesOf(vtkAbstractArray* chunk);

private:
  struct Entry
  {
    Key Name;
    vtkSmartPointer<vtkAbstractArray> Chunk;
    vtkTypeInt64 Bytes;
    int Cut; // in which it was used last
  };
  void Use(Entry& entry);
  void KeepBudget();

  std::list<Entry> Entries; // what was used last comes first
  std::map<Key, std::list<Entry>::iterator> Places;
  vtkTypeInt64 Budget = 0;
  vtkTypeInt64 Size = 0;
  vtkTypeInt64 SizeOfCut = 0;
  vtkTypeInt64 SizeOfAdded = 0;
  int Cut = 0;
};

#endif
