// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatLatticeLabels.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// Edges, at most, whose points do not say what regions' votes do: two where both have surfaces, else one.
constexpr double MostAgainst = 0.02;

using LatticeCases = vtkPointSplatLatticeCases;
}

vtkPointSplatLatticeLabels::vtkPointSplatLatticeLabels(
  const std::vector<Crossing>& crossings, const std::int64_t size[3], const float* normals)
  : Regions(crossings, size)
  , Normals(normals)
{
}

/// Returns false where a point lies within a region, too many on an edge, or too few of them say what the votes do.
bool vtkPointSplatLatticeLabels::Vote()
{
  this->Votes.assign(this->Regions.GetCount(), 0.0f);
  if (!this->Regions.VisitEdges([this](const Range& on, int axis, std::size_t a, std::size_t b) {
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
  this->Regions.VisitEdges([&](const Range& on, int, std::size_t a, std::size_t b) {
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
  const Range on = this->Regions.Get(this->Regions.GetCorner(voxel, lower), axis);
  const auto isLess = [&](const Crossing& a, const Crossing& b) {
    return way * this->Normals[3 * a.Id + axis] < way * this->Normals[3 * b.Id + axis];
  };
  return std::max_element(on.First, on.Last, isLess)->Id;
}

void vtkPointSplatLatticeLabels::AddTriangles(std::int64_t voxel, std::vector<vtkIdType>& corners) const
{
  std::size_t regions[8];
  for (int corner = 0; corner < 8; ++corner)
  {
    regions[corner] = this->Regions.GetRegion(this->Regions.GetCorner(voxel, corner));
  }
  for (int first = 0; first < 8; ++first)
  {
    const std::size_t region = regions[first];
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
  if (!this->Regions.Find() || !this->Vote())
  {
    return false;
  }
  this->Corners = this->Regions.GetTriangles(
    [this](std::int64_t voxel, std::vector<vtkIdType>& corners) { this->AddTriangles(voxel, corners); });
  return true;
}

VTK_ABI_NAMESPACE_END
