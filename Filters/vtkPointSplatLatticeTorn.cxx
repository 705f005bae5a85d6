// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatLatticeTorn.h"

#include "vtkMath.h"
#include "vtkPointSplatDisjointSets.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
using Cases = vtkPointSplatLatticeCases;
using Index = vtkPointSplatDisjointSets::Index;

constexpr int NumberOfFaces = 6;

/// The faces that a corner lies in.
unsigned int GetFaces(int corner)
{
  unsigned int faces = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    faces |= vtkPointSplatLatticeTorn::GetFace(axis, (corner >> axis) & 1);
  }
  return faces;
}
}

void vtkPointSplatLatticeTorn::Sort()
{
  vtkSMPTools::Sort(this->Loose.begin(), this->Loose.end(), [](const LoosePoint& a, const LoosePoint& b) {
    return a.Voxel != b.Voxel ? a.Voxel < b.Voxel : a.At.Id < b.At.Id;
  });
}

std::vector<vtkPointSplatLatticeTorn::LoosePoint>::const_iterator vtkPointSplatLatticeTorn::FindFirst(std::int64_t voxel) const
{
  return std::lower_bound(this->Loose.begin(), this->Loose.end(), voxel,
    [](const LoosePoint& point, std::int64_t at) { return point.Voxel < at; });
}

bool vtkPointSplatLatticeTorn::Has(std::int64_t voxel) const
{
  const auto first = this->FindFirst(voxel);
  return first != this->Loose.end() && first->Voxel == voxel;
}

std::vector<vtkPointSplatLatticeTorn::Point> vtkPointSplatLatticeTorn::GetPoints(const vtkPointSplatLatticeVoxel& voxel) const
{
  std::vector<Point> points;
  for (auto at = this->FindFirst(voxel.Index); at != this->Loose.end() && at->Voxel == voxel.Index; ++at)
  {
    points.push_back(at->At);
  }
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
  return points;
}

/// The nearest point in a face, or the point itself if there is none.
std::size_t vtkPointSplatLatticeTorn::FindNearest(const std::vector<Point>& points, std::size_t of) const
{
  double nearest2 = std::numeric_limits<double>::max();
  std::size_t nearest = of;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const double distance2 = vtkMath::Distance2BetweenPoints(
      this->Positions.data() + 3 * points[of].Id, this->Positions.data() + 3 * points[i].Id);
    if (points[i].Faces != 0 && distance2 < nearest2)
    {
      nearest2 = distance2;
      nearest = i;
    }
  }
  return nearest;
}

void vtkPointSplatLatticeTorn::AddTriangles(const vtkPointSplatLatticeVoxel& voxel, std::vector<vtkIdType>& corners) const
{
  const std::vector<Point> points = this->GetPoints(voxel);
  const Index count = static_cast<Index>(points.size());
  vtkPointSplatDisjointSets sheets(count);
  const auto join = [&sheets](Index a, Index b) { sheets.Join(sheets.Find(a), sheets.Find(b)); };
  for (int face = 0; face < NumberOfFaces; ++face)
  {
    std::vector<Index> in;
    for (Index i = 0; i < count; ++i)
    {
      if (points[i].Faces & (1u << face))
      {
        in.push_back(i);
      }
    }
    if (in.size() == 2)
    {
      join(in[0], in[1]);
    }
  }
  for (Index i = 0; i < count; ++i)
  {
    if (points[i].Faces == 0)
    {
      join(i, static_cast<Index>(this->FindNearest(points, i)));
    }
  }
  std::vector<std::vector<vtkIdType>> ofSheet(count);
  for (Index i = 0; i < count; ++i)
  {
    ofSheet[sheets.Find(i)].push_back(points[i].Id);
  }
  for (std::vector<vtkIdType>& sheet : ofSheet)
  {
    if (sheet.size() >= 3)
    {
      this->AddPolygon(sheet, corners);
    }
  }
}

void vtkPointSplatLatticeTorn::AddPolygon(std::vector<vtkIdType>& sheet, std::vector<vtkIdType>& corners) const
{
  const double* positions = this->Positions.data();
  double middle[3] = { 0, 0, 0 }, normal[3] = { 0, 0, 0 };
  for (const vtkIdType id : sheet)
  {
    for (int c = 0; c < 3; ++c)
    {
      middle[c] += positions[3 * id + c] / static_cast<double>(sheet.size());
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
    vtkMath::Subtract(positions + 3 * id, middle, way);
    return std::atan2(vtkMath::Dot(way, v), vtkMath::Dot(way, u));
  };
  std::sort(sheet.begin(), sheet.end(), [&](vtkIdType a, vtkIdType b) { return getAngle(a) < getAngle(b); });
  const auto getLongest2 = [&](vtkIdType from) {
    double longest2 = 0;
    for (const vtkIdType to : sheet)
    {
      longest2 = std::max(longest2, vtkMath::Distance2BetweenPoints(positions + 3 * from, positions + 3 * to));
    }
    return longest2;
  };
  const auto from = std::min_element(
    sheet.begin(), sheet.end(), [&](vtkIdType a, vtkIdType b) { return getLongest2(a) < getLongest2(b); });
  std::rotate(sheet.begin(), from, sheet.end());
  for (std::size_t i = 1; i + 1 < sheet.size(); ++i)
  {
    corners.insert(corners.end(), { sheet[0], sheet[i], sheet[i + 1] });
  }
}

VTK_ABI_NAMESPACE_END
