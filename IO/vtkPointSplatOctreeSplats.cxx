// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatOctreeSplats.h"

#include "vtkPointSplatOctreeFile.h"

#include "vtkAbstractArray.h"
#include "vtkDataSetAttributes.h"

#include <algorithm>
#include <iterator>

namespace
{
using namespace vtkPointSplatHDF5;
namespace Names = vtkPointSplatOctreeFile;

bool IsOfLevelsAlone(const std::string& name)
{
  return std::any_of(std::begin(Names::LevelArrays), std::end(Names::LevelArrays),
    [&name](const char* other) { return name == other; });
}

vtkSmartPointer<vtkAbstractArray> ReadChunkOf(
  const OpenArray& from, const ArrayHead& head, vtkIdType chunk)
{
  const vtkIdType first = chunk * ChunkTuples;
  const Run run{ first, std::min(head.Tuples - first, ChunkTuples) };
  const vtkSmartPointer<vtkAbstractArray> array = NewArray(head);
  if (!array || run.Count <= 0)
  {
    return nullptr;
  }
  array->SetNumberOfTuples(run.Count);
  return ReadTuples(from, run, array) ? array : nullptr;
}
}

//------------------------------------------------------------------------------
vtkPointSplatOctreeSplats::vtkPointSplatOctreeSplats(
  const vtkPointSplatOctreeCut& tree, const vtkPointSplatOctreeCut::Runs& runs)
{
  for (const auto& one : runs)
  {
    const auto [piece, level] = one.first;
    this->Sources.push_back({ piece, level, &tree.GetLevel(piece, level), one.second,
      vtkPointSplatOctreeCut::CountOf(one.second) });
  }
  for (const Source& source : this->Sources)
  {
    this->Count += source.Count;
  }
  const size_t most = this->Sources.empty() ? 0 : this->Sources[0].Level->Heads.size();
  for (size_t a = 0; a < most; ++a)
  {
    std::vector<size_t> numbers = this->NumbersOf(a);
    if (numbers.empty() && a == 0)
    {
      return;
    }
    if (!numbers.empty())
    {
      this->Arrays.push_back(std::move(numbers));
    }
  }
}

//------------------------------------------------------------------------------
std::vector<size_t> vtkPointSplatOctreeSplats::NumbersOf(size_t wanted) const
{
  const ArrayHead& first = this->Sources[0].Level->Heads[wanted];
  std::vector<size_t> numbers;
  for (const Source& source : this->Sources)
  {
    // Coordinates come first, whatever their name is, and others after. Points may have normals that
    // have another name, or none; what both are for tells that they are the same.
    const std::vector<ArrayHead>& heads = source.Level->Heads;
    auto at = wanted == 0
      ? heads.begin()
      : std::find_if(heads.begin() + 1, heads.end(),
          [&first](const ArrayHead& head) { return head.Name == first.Name; });
    // Other attributes of another name, as scalars, are other quantities.
    if (at == heads.end() && first.Role == vtkDataSetAttributes::NORMALS)
    {
      at = std::find_if(heads.begin() + 1, heads.end(),
        [&first](const ArrayHead& head) { return head.Role == first.Role; });
    }
    if (at == heads.end() || at->DataType != first.DataType ||
      at->Components != first.Components || (wanted > 0 && IsOfLevelsAlone(first.Name)))
    {
      return {};
    }
    numbers.push_back(static_cast<size_t>(at - heads.begin()));
  }
  return numbers;
}

//------------------------------------------------------------------------------
const ArrayHead& vtkPointSplatOctreeSplats::GetHead(size_t array) const
{
  return this->Sources[0].Level->Heads[this->Arrays[array][0]];
}

//------------------------------------------------------------------------------
bool vtkPointSplatOctreeSplats::Fill(
  const Source& source, size_t number, const Place& to, vtkPointSplatChunkCache& cache)
{
  const ArrayHead& head = source.Level->Heads[number];
  OpenArray from; // no sooner than something is missing
  vtkPointSplatChunkCache::Key key{ source.Piece, source.LevelNumber,
    static_cast<vtkIdType>(number), 0 };
  vtkSmartPointer<vtkAbstractArray> chunk;
  vtkIdType at = to.First;
  for (const Run& run : source.Runs)
  {
    vtkIdType next = 0;
    for (vtkIdType first = run.First; first < run.First + run.Count; first = next)
    {
      const vtkIdType wanted = first / ChunkTuples;
      next = std::min(run.First + run.Count, (wanted + 1) * ChunkTuples);
      if (!chunk || key[3] != wanted)
      {
        key[3] = wanted;
        chunk = cache.Find(key);
      }
      if (!chunk)
      {
        if (!from)
        {
          from = OpenArray(source.Level->Group, static_cast<int>(number));
        }
        chunk = ReadChunkOf(from, head, wanted);
        if (!chunk)
        {
          return false;
        }
        cache.Add(key, chunk);
      }
      const vtkIdType begin = first - wanted * ChunkTuples;
      if (begin + next - first > chunk->GetNumberOfTuples())
      {
        return false;
      }
      to.Array->InsertTuples(at, next - first, begin, chunk);
      at += next - first;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkAbstractArray> vtkPointSplatOctreeSplats::Read(
  size_t array, vtkPointSplatChunkCache& cache) const
{
  const vtkSmartPointer<vtkAbstractArray> all = NewArray(this->GetHead(array));
  if (!all)
  {
    return nullptr;
  }
  all->SetNumberOfTuples(this->Count);
  vtkIdType first = 0;
  for (size_t s = 0; s < this->Sources.size(); ++s)
  {
    const Source& source = this->Sources[s];
    if (!vtkPointSplatOctreeSplats::Fill(
          source, this->Arrays[array][s], { all, first }, cache))
    {
      return nullptr;
    }
    first += source.Count;
  }
  return all;
}

//------------------------------------------------------------------------------
std::vector<vtkPointSplatChunkCache::Key> vtkPointSplatOctreeSplats::GetChunks() const
{
  std::vector<vtkPointSplatChunkCache::Key> chunks;
  for (const std::vector<size_t>& numbers : this->Arrays)
  {
    for (size_t s = 0; s < this->Sources.size(); ++s)
    {
      const Source& source = this->Sources[s];
      vtkIdType next = 0; // the first that is not yet among them
      for (const Run& run : source.Runs)
      {
        const vtkIdType end = (run.First + run.Count + ChunkTuples - 1) / ChunkTuples;
        for (next = std::max(next, run.First / ChunkTuples); next < end; ++next)
        {
          chunks.push_back(
            { source.Piece, source.LevelNumber, static_cast<vtkIdType>(numbers[s]), next });
        }
      }
    }
  }
  return chunks;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkAbstractArray> vtkPointSplatOctreeSplats::ReadChunk(
  const vtkPointSplatOctreeCut& tree, const vtkPointSplatChunkCache::Key& key)
{
  const vtkPointSplatOctreeCut::Level& level =
    tree.GetLevel(static_cast<int>(key[0]), static_cast<int>(key[1]));
  return ReadChunkOf(OpenArray(level.Group, static_cast<int>(key[2])),
    level.Heads[static_cast<size_t>(key[2])], key[3]);
}
