// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatLatticeLabels.h"

#include "vtkPointSplatDisjointSets.h"
#include "vtkPointSplatThreads.h"
#include "vtkSMPTools.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// Edges, at most, whose points do not say what regions' votes do: two where both have surfaces, else one.
constexpr double MostAgainst = 0.02;
/// So many voxels have their triangles in one list.
constexpr std::size_t VoxelsAtOnce = 1024;

using LatticeCases = vtkPointSplatLatticeCases;

void SortUnique(std::vector<std::int64_t>& values)
{
  vtkSMPTools::Sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}
}

vtkPointSplatLatticeLabels::vtkPointSplatLatticeLabels(
  const std::vector<Crossing>& crossings, const std::int64_t size[3], const float* normals)
  : Crossings(crossings)
  , Size{ size[0], size[1], size[2] }
  , Strides{ 1, size[0], size[0] * size[1] }
  , Normals(normals)
{
}

vtkPointSplatLatticeLabels::Range vtkPointSplatLatticeLabels::Get(std::int64_t sample, int axis) const
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

std::int64_t vtkPointSplatLatticeLabels::GetCorner(std::int64_t voxel, int corner) const
{
  return voxel + (corner & 1 ? this->Strides[0] : 0) + (corner & 2 ? this->Strides[1] : 0) +
    (corner & 4 ? this->Strides[2] : 0);
}

/// A sample's number among those of the voxels, or how many there are if it is none of these.
std::size_t vtkPointSplatLatticeLabels::GetNumber(std::int64_t sample) const
{
  const auto at = std::lower_bound(this->Samples.begin(), this->Samples.end(), sample);
  return at != this->Samples.end() && *at == sample ? at - this->Samples.begin() : this->Samples.size();
}

/// Those around edges with points, and their samples.
void vtkPointSplatLatticeLabels::FindVoxels()
{
  for (const Crossing& crossing : this->Crossings)
  {
    const std::int64_t sample = crossing.Key / 4;
    const int axis = static_cast<int>(crossing.Key % 4);
    const std::int64_t before[2] = { this->Strides[(axis + 1) % 3], this->Strides[(axis + 2) % 3] };
    for (int k = 0; k < 4; ++k)
    {
      const std::int64_t voxel = sample - (k & 1 ? before[0] : 0) - (k & 2 ? before[1] : 0);
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
}

void vtkPointSplatLatticeLabels::FindRegions()
{
  vtkPointSplatDisjointSets regions(this->Samples.size());
  for (std::size_t i = 0; i < this->Samples.size(); ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const std::size_t next = this->GetNumber(this->Samples[i] + this->Strides[axis]);
      if (next != this->Samples.size() && this->Get(this->Samples[i], axis).GetCount() == 0)
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
}

/// Visits the edges of voxels that have points, and the regions of their ends, until visit(on, axis, a, b) returns false, as is
/// returned.
template <typename Visitor>
bool vtkPointSplatLatticeLabels::VisitEdges(const Visitor& visit) const
{
  for (std::size_t i = 0; i < this->Crossings.size();)
  {
    const std::int64_t sample = this->Crossings[i].Key / 4;
    const int axis = static_cast<int>(this->Crossings[i].Key % 4);
    const Range on = this->Get(sample, axis);
    const std::size_t a = this->GetNumber(sample), b = this->GetNumber(sample + this->Strides[axis]);
    const bool within = a != this->Samples.size() && b != this->Samples.size();
    if (within && !visit(on, axis, this->Regions[a], this->Regions[b]))
    {
      return false;
    }
    i += on.GetCount();
  }
  return true;
}

/// Returns false where a point lies within a region, too many on an edge, or too few of them say what the votes do.
bool vtkPointSplatLatticeLabels::Vote()
{
  this->Votes.assign(this->Samples.size(), 0.0f);
  if (!this->VisitEdges([this](const Range& on, int axis, std::uint32_t a, std::uint32_t b) {
        const bool one = on.GetCount() == 1;
        const float outward = one ? this->Normals[3 * on.First->Id + axis] : 1.0f;
        this->Votes[a] += outward;
        this->Votes[b] += one ? -outward : outward;
        return on.GetCount() <= 2 && a != b;
      }))
  {
    return false;
  }
  std::size_t all = 0, against = 0;
  this->VisitEdges([&](const Range& on, int, std::uint32_t a, std::uint32_t b) {
    const std::size_t surfaces = (this->Votes[a] > 0 ? 1 : 0) + (this->Votes[b] > 0 ? 1 : 0);
    against += surfaces != on.GetCount() ? 1 : 0;
    ++all;
    return true;
  });
  return against <= MostAgainst * all;
}

/// Of an edge's points the one whose normal points out of the corners that are inside.
vtkIdType vtkPointSplatLatticeLabels::GetPoint(std::int64_t voxel, int edge, int inside) const
{
  const int lower = LatticeCases::EdgeEnds[edge], axis = LatticeCases::EdgeAxes[edge];
  const float way = inside & (1 << lower) ? 1.0f : -1.0f;
  const Range on = this->Get(this->GetCorner(voxel, lower), axis);
  const auto isLess = [&](const Crossing& a, const Crossing& b) {
    return way * this->Normals[3 * a.Id + axis] < way * this->Normals[3 * b.Id + axis];
  };
  return std::max_element(on.First, on.Last, isLess)->Id;
}

void vtkPointSplatLatticeLabels::AddTriangles(std::int64_t voxel, std::vector<vtkIdType>& corners) const
{
  std::uint32_t regions[8];
  for (int corner = 0; corner < 8; ++corner)
  {
    regions[corner] = this->Regions[this->GetNumber(this->GetCorner(voxel, corner))];
  }
  for (int first = 0; first < 8; ++first)
  {
    const std::uint32_t region = regions[first];
    if (std::find(regions, regions + first, region) != regions + first || !(this->Votes[region] > 0))
    {
      continue;
    }
    int inside = 0;
    for (int corner = first; corner < 8; ++corner)
    {
      inside |= regions[corner] == region ? 1 << corner : 0;
    }
    LatticeCases::VisitTriangles(inside, [&](const int edges[3]) {
      for (int k = 0; k < 3; ++k)
      {
        corners.push_back(this->GetPoint(voxel, edges[k], inside));
      }
    });
  }
}

bool vtkPointSplatLatticeLabels::Find()
{
  this->FindVoxels();
  if (this->Samples.size() >= vtkPointSplatNeighbors::None)
  {
    return false;
  }
  this->FindRegions();
  if (!this->Vote())
  {
    return false;
  }
  std::vector<std::vector<vtkIdType>> found((this->Voxels.size() + VoxelsAtOnce - 1) / VoxelsAtOnce);
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(found.size()), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType block = begin; block < end; ++block)
    {
      const std::size_t last = std::min<std::size_t>(this->Voxels.size(), (block + 1) * VoxelsAtOnce);
      for (std::size_t i = block * VoxelsAtOnce; i < last; ++i)
      {
        this->AddTriangles(this->Voxels[i], found[block]);
      }
    }
  });
  for (const std::vector<vtkIdType>& corners : found)
  {
    this->Corners.insert(this->Corners.end(), corners.begin(), corners.end());
  }
  return true;
}

VTK_ABI_NAMESPACE_END
