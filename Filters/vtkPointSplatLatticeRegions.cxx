// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatLatticeRegions.h"

#include "vtkPointSplatDisjointSets.h"
#include "vtkSMPTools.h"

VTK_ABI_NAMESPACE_BEGIN

namespace
{
using LatticeCases = vtkPointSplatLatticeCases;

void SortUnique(std::vector<std::int64_t>& values)
{
  vtkSMPTools::Sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}
}

vtkPointSplatLatticeRegions::vtkPointSplatLatticeRegions(
  const std::vector<Crossing>& crossings, const std::int64_t size[3])
  : Crossings(crossings)
  , Size{ size[0], size[1], size[2] }
  , Strides{ 1, size[0], size[0] * size[1] }
{
}

vtkPointSplatLatticeRegions::Range vtkPointSplatLatticeRegions::Get(std::int64_t sample, int axis) const
{
  const std::int64_t key = 4 * sample + axis;
  const auto first = std::lower_bound(this->Crossings.begin(), this->Crossings.end(), key,
    [](const Crossing& crossing, std::int64_t k) { return crossing.Key < k; });
  auto last = first;
  while (last != this->Crossings.end() && last->Key == key)
  {
    ++last;
  }
  const Crossing* all = this->Crossings.data();
  return { all + (first - this->Crossings.begin()), all + (last - this->Crossings.begin()) };
}

std::int64_t vtkPointSplatLatticeRegions::GetCorner(std::int64_t voxel, int corner) const
{
  return voxel + (corner & 1 ? this->Strides[0] : 0) + (corner & 2 ? this->Strides[1] : 0) +
    (corner & 4 ? this->Strides[2] : 0);
}

/// A sample's number among those of the voxels, or how many there are if it is none of these.
std::size_t vtkPointSplatLatticeRegions::GetNumber(std::int64_t sample) const
{
  const auto at = std::lower_bound(this->Samples.begin(), this->Samples.end(), sample);
  return at != this->Samples.end() && *at == sample ? at - this->Samples.begin() : this->Samples.size();
}

std::size_t vtkPointSplatLatticeRegions::GetRegion(std::int64_t sample) const
{
  const std::size_t number = this->GetNumber(sample);
  return number == this->Samples.size() ? number : this->Regions[number];
}

/// Those around a point's edge, or its sample, within the box.
void vtkPointSplatLatticeRegions::AddVoxels(const Crossing& crossing)
{
  const int axis = static_cast<int>(crossing.Key % 4);
  for (int before = 0; before < 8; ++before)
  {
    if (axis != LatticeCases::AtSample && (before & (1 << axis)))
    {
      continue;
    }
    const std::int64_t voxel = crossing.Key / 4 - this->GetCorner(0, before);
    bool within = true;
    for (int c = 0; c < 3; ++c)
    {
      const std::int64_t at = voxel / this->Strides[c] % this->Size[c];
      within = within && at >= 1 && at < this->Size[c] - 2;
    }
    if (within)
    {
      this->Voxels.push_back(voxel);
    }
  }
}

bool vtkPointSplatLatticeRegions::Find()
{
  for (const Crossing& crossing : this->Crossings)
  {
    this->AddVoxels(crossing);
  }
  SortUnique(this->Voxels);
  this->Samples.reserve(8 * this->Voxels.size());
  for (const std::int64_t voxel : this->Voxels)
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      this->Samples.push_back(this->GetCorner(voxel, corner));
    }
  }
  SortUnique(this->Samples);
  if (this->Samples.size() >= vtkPointSplatNeighbors::None)
  {
    return false;
  }
  this->AtSample.assign(this->Samples.size(), 0);
  for (const Crossing& crossing : this->Crossings)
  {
    const std::size_t number = this->GetNumber(crossing.Key / 4);
    if (crossing.Key % 4 == LatticeCases::AtSample && number != this->Samples.size())
    {
      this->AtSample[number] = 1;
    }
  }
  vtkPointSplatDisjointSets regions(this->Samples.size());
  for (std::size_t i = 0; i < this->Samples.size(); ++i)
  {
    for (int axis = 0; axis < 3 && !this->AtSample[i]; ++axis)
    {
      const std::size_t next = this->GetNumber(this->Samples[i] + this->Strides[axis]);
      if (next != this->Samples.size() && !this->AtSample[next] && this->Get(this->Samples[i], axis).GetCount() == 0)
      {
        regions.Join(regions.Find(static_cast<std::uint32_t>(i)), regions.Find(static_cast<std::uint32_t>(next)));
      }
    }
  }
  this->Regions.resize(this->Samples.size());
  for (std::size_t i = 0; i < this->Samples.size(); ++i)
  {
    this->Regions[i] = regions.Find(static_cast<std::uint32_t>(i));
  }
  return true;
}

VTK_ABI_NAMESPACE_END
