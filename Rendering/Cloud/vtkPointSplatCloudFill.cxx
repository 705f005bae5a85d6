// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Of the cloud: which points splats are of, where some are fill points and some have copies.
#include "vtkPointSplatCloud.h"

#include "vtkPointSet.h"

#include <algorithm>
#include <numeric>

//------------------------------------------------------------------------------
void vtkPointSplatCloud::NumberFillPoints(
  const Block& block, const vtkPointSplatPacking& packing)
{
  const size_t words = this->GetWordsPerSplat();
  const size_t own = static_cast<size_t>(block.Data->GetNumberOfPoints());
  for (vtkIdType i = block.First; block.Fill && i < block.First + block.Count; ++i)
  {
    uint32_t& number = this->Splats[words * static_cast<size_t>(i) + 7];
    if (number >= own)
    {
      number = static_cast<uint32_t>(packing.Fill[number - own].Ends[0]);
    }
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkPointSplatCloud::NumberOf(const Block& block, size_t splat) const
{
  const uint32_t* words = this->GetRestingSplats().data() + this->GetWordsPerSplat() * splat;
  return block.Fill ? block.Fill->GetNumber(words) : static_cast<vtkIdType>(words[7]);
}

//------------------------------------------------------------------------------
vtkIdType vtkPointSplatCloud::GetNumberOfCopies() const
{
  return std::accumulate(
    this->Blocks.begin(), this->Blocks.end(), vtkIdType(0), [](vtkIdType sum, const Block& block) {
      return sum + (block.Copies ? static_cast<vtkIdType>(block.Copies->Get().size()) : 0);
    });
}

//------------------------------------------------------------------------------
std::vector<vtkPointSplatCopies::Copy> vtkPointSplatCloud::GetCopies() const
{
  std::vector<vtkPointSplatCopies::Copy> all;
  for (const Block& block : this->Blocks)
  {
    if (block.Copies)
    {
      all.insert(all.end(), block.Copies->Get().begin(), block.Copies->Get().end());
    }
  }
  return all;
}

//------------------------------------------------------------------------------
bool vtkPointSplatCloud::AreCopiesSame(const std::vector<Block>& blocks)
{
  if (blocks.size() != this->Blocks.size() || this->GetNumberOfCopies() == 0)
  {
    return true;
  }
  Key key;
  for (const Block& block : blocks)
  {
    for (vtkDataArray* array : vtkPointSplatCopies::GetTelling(block.Data))
    {
      key.emplace_back(array, array ? array->GetMTime() : 0);
    }
  }
  const bool same = key == this->CopiesToldBy ||
    std::equal(this->Blocks.begin(), this->Blocks.end(), blocks.begin(),
      [](const Block& own, const Block& block) {
        return !own.Copies || own.Copies->AreSame(block.Data);
      });
  this->CopiesToldBy = same ? std::move(key) : Key();
  return same;
}
