// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatLatticeTorn.h"

#include "vtkMath.h"
#include "vtkPointSplatDisjointSets.h"

#include <algorithm>
#include <cmath>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
using Point = vtkPointSplatLatticeTorn::Point;
using Index = vtkPointSplatDisjointSets::Index;

/// The faces that a corner lies in.
unsigned int GetFaces(int corner)
{
  unsigned int faces = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    faces |= 1u << (2 * axis + ((corner >> axis) & 1));
  }
  return faces;
}
}

void vtkPointSplatLatticeTorn::AddTriangles(
  const vtkPointSplatLatticeVoxel& voxel, std::vector<Point> points, std::vector<vtkIdType>& corners) const
{
  using Cases = vtkPointSplatLatticeCases;
  for (int e = 0; e < 12; ++e)
  {
    if (voxel.Cut[e] != vtkPointSplatLatticeVoxel::None)
    {
      const int a = Cases::EdgeEnds[e], b = a | (1 << Cases::EdgeAxes[e]);
      points.push_back({ voxel.Cut[e], GetFaces(a) & GetFaces(b) });
    }
  }
  for (int corner = 0; corner < 8; ++corner)
  {
    if (voxel.At[corner] != vtkPointSplatLatticeVoxel::None)
    {
      points.push_back({ voxel.At[corner], GetFaces(corner) });
    }
  }
  const std::size_t count = points.size();
  vtkPointSplatDisjointSets sheets(count);
  for (unsigned int face = 1; face < 64; face <<= 1)
  {
    std::vector<std::size_t> in;
    for (std::size_t i = 0; i < count; ++i)
    {
      if (points[i].Faces & face)
      {
        in.push_back(i);
      }
    }
    if (in.size() == 2)
    {
      sheets.Join(sheets.Find(static_cast<Index>(in[0])), sheets.Find(static_cast<Index>(in[1])));
    }
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    double nearest2 = std::numeric_limits<double>::max();
    std::size_t nearest = i;
    for (std::size_t j = 0; j < count && points[i].Faces == 0; ++j)
    {
      const double distance2 = vtkMath::Distance2BetweenPoints(
        this->Positions.data() + 3 * points[i].Id, this->Positions.data() + 3 * points[j].Id);
      if (points[j].Faces != 0 && distance2 < nearest2)
      {
        nearest2 = distance2;
        nearest = j;
      }
    }
    sheets.Join(sheets.Find(static_cast<Index>(i)), sheets.Find(static_cast<Index>(nearest)));
  }
  for (Index first = 0; first < count; ++first)
  {
    std::vector<vtkIdType> sheet;
    for (Index i = first; i < count && sheets.Find(first) == first; ++i)
    {
      if (sheets.Find(i) == first)
      {
        sheet.push_back(points[i].Id);
      }
    }
    if (sheet.size() >= 3)
    {
      this->AddPolygon(sheet, corners);
    }
  }
}

void vtkPointSplatLatticeTorn::AddPolygon(std::vector<vtkIdType>& sheet, std::vector<vtkIdType>& corners) const
{
  double middle[3] = { 0, 0, 0 }, normal[3] = { 0, 0, 0 };
  for (const vtkIdType id : sheet)
  {
    for (int c = 0; c < 3; ++c)
    {
      middle[c] += this->Positions[3 * id + c] / static_cast<double>(sheet.size());
      normal[c] += this->Normals[3 * id + c];
    }
  }
  if (vtkMath::Normalize(normal) == 0)
  {
    return;
  }
  double u[3], v[3];
  vtkMath::Perpendiculars(normal, u, v, 0);
  const auto getAngle = [&](vtkIdType id) {
    double way[3];
    vtkMath::Subtract(this->Positions.data() + 3 * id, middle, way);
    return std::atan2(vtkMath::Dot(way, v), vtkMath::Dot(way, u));
  };
  std::sort(sheet.begin(), sheet.end(), [&](vtkIdType a, vtkIdType b) { return getAngle(a) < getAngle(b); });
  const std::size_t count = sheet.size();
  std::size_t from = 0;
  double shortest = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < count; ++i)
  {
    double longest = 0;
    for (std::size_t j = 0; j < count; ++j)
    {
      longest = std::max(longest, vtkMath::Distance2BetweenPoints(
                                    this->Positions.data() + 3 * sheet[i], this->Positions.data() + 3 * sheet[j]));
    }
    if (longest < shortest)
    {
      shortest = longest;
      from = i;
    }
  }
  for (std::size_t k = 1; k + 1 < count; ++k)
  {
    corners.insert(corners.end(), { sheet[from], sheet[(from + k) % count], sheet[(from + k + 1) % count] });
  }
}

VTK_ABI_NAMESPACE_END
