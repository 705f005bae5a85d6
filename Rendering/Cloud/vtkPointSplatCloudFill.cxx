// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Of the cloud: which points splats are of, where some are fill points.
#include "vtkPointSplatCloud.h"

#include "vtkPointSet.h"

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
