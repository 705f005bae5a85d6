// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatRows.h"

#include "vtkMath.h"
#include "vtkPointSplatThreads.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
using Neighborhood = vtkPointSplatNeighbors::Neighborhood;

/// Points lie on a curve if the second variance is less than this part of the first: 12 neighbours
/// on a circle of a hundred points have 0.008, rows of a surface six times as dense along them as
/// across have more than 0.1.
constexpr float CurveVariance = 0.03f;
/// Tighter curves are seen in their nearest six, if the sphere about twice as many has nearly twice
/// the radius, as on a curve (2) and not in a plane (1.4).
constexpr int FewNeighbors = 6;
constexpr float FewVariance = 0.05f;
constexpr float CurveGrowth = 1.7f;
/// Where points are off a row by more than a spacing the second variance of 12 is less than this part; half of a disc has
/// 0.28.
constexpr float LongVariance = 0.2f;
/// What lies in a surface with noise has no more than this part of its variance off it, ...
constexpr float FlatVariance = 0.06f;
/// ... whose normal is farther than 60 degrees from that of the plane of a row and its noise.
constexpr float ThickCosine = 0.5f;
/// The nearest neighbours are of the row itself, ...
constexpr int OwnNeighbors = 12;
/// ... and so is what is within 20 degrees of it, or as far off as noise takes its points: so many times what it does the
/// nearest at the median.
constexpr float RowSine = 0.34f;
constexpr float LeastAcross = 4.0f;
/// How far, in distances from row to row, the plane's points lie, ...
constexpr float PlaneReach = 2.1f;
/// ... and the rows that are counted, ...
constexpr float RowsReach = 5.0f;
/// ... which must extend over this many such distances ...
constexpr float LeastExtent = 2.5f;
/// ... and lie in directions within 27 degrees of the plane.
constexpr float LargestSlope = 0.5f;
/// The variance off the plane, of that across the row: points at random have more than a third.
constexpr float LargestVariance = 0.1f;
/// How many of those beside must agree, ...
constexpr int LeastAgreeing = 2;
/// ... within 37 degrees, ...
constexpr float BesideCosine = 0.8f;
/// ... and how often they are asked, since some are no surface's themselves.
constexpr int NumberOfVotes = 6;

struct Axis
{
  float X[3];
};

/// Where the nearest neighbours lead, either way.
Axis GetAxis(const Neighborhood& around)
{
  Axis along{ { 0, 0, 0 } };
  for (int i = 0; i < std::min(FewNeighbors, around.Count); ++i)
  {
    const float offset[3] = { around.X[i], around.Y[i], around.Z[i] };
    const float side = vtkMath::Dot(along.X, offset) < 0 ? -1.0f : 1.0f;
    for (int c = 0; c < 3; ++c)
    {
      along.X[c] += side * offset[c];
    }
  }
  vtkMath::Normalize(along.X);
  return along;
}

/// How far a neighbour leads along it.
float GetAlong(const Neighborhood& around, int i, const Axis& along)
{
  return along.X[0] * around.X[i] + along.X[1] * around.Y[i] + along.X[2] * around.Z[i];
}
}

bool vtkPointSplatRows::IsCurve(const Neighborhood& around, int count, const float variances[3])
{
  if (count < 2)
  {
    return false;
  }
  if (variances[1] < CurveVariance * variances[0])
  {
    return true;
  }
  if (count < 2 * FewNeighbors ||
    around.SquaredDistance[2 * FewNeighbors - 1] <
      CurveGrowth * CurveGrowth * around.SquaredDistance[FewNeighbors - 1])
  {
    return false;
  }
  return IsRow(around);
}

bool vtkPointSplatRows::IsLong(const float variances[3])
{
  return variances[1] < LongVariance * variances[0];
}

bool vtkPointSplatRows::IsRow(const Neighborhood& around)
{
  const vtkPointSplatPrincipal principal(around, std::min(FewNeighbors, around.Count));
  return principal.Variances[1] < FewVariance * principal.Variances[0];
}

namespace
{
/// The neighbours that are beside a row, nearest first: their places in the neighbourhood.
std::vector<int> GetBeside(const Neighborhood& around, const Axis& along)
{
  std::vector<float> across2(around.Count);
  for (int i = 0; i < around.Count; ++i)
  {
    const float length = GetAlong(around, i, along);
    across2[i] = around.SquaredDistance[i] - length * length;
  }
  std::vector<float> nearest(across2.begin(), across2.begin() + std::min(OwnNeighbors, around.Count));
  const auto middle = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2);
  std::nth_element(nearest.begin(), middle, nearest.end());
  const float least2 = nearest.empty() ? 0.0f : LeastAcross * LeastAcross * *middle;
  std::vector<int> beside;
  for (int i = OwnNeighbors; i < around.Count; ++i)
  {
    if (across2[i] > std::max(least2, RowSine * RowSine * around.SquaredDistance[i]))
    {
      beside.push_back(i);
    }
  }
  return beside;
}

/// How many neighbours are within a distance.
int Count(const Neighborhood& around, float distance2)
{
  const float* end = around.SquaredDistance + around.Count;
  return static_cast<int>(std::upper_bound(around.SquaredDistance, end, distance2) - around.SquaredDistance);
}

/// Whether the nearest count of neighbours lie about in a plane, beside how far they lie across the row.
bool AreFlat(const Neighborhood& around, int count, const Axis& off, const Axis& across)
{
  float widths = 0, heights = 0;
  for (int i = 0; i < count; ++i)
  {
    const float width = GetAlong(around, i, across), height = GetAlong(around, i, off);
    widths += width * width;
    heights += height * height;
  }
  return heights < LargestVariance * widths;
}

/// How far the nearest count of neighbours extend across a row, of those that are not above or below it.
float GetExtent(const Neighborhood& around, int count, const Axis& off, const Axis& across)
{
  float least = 0, most = 0;
  for (int i = 0; i < count; ++i)
  {
    const float width = GetAlong(around, i, across);
    if (std::abs(GetAlong(around, i, off)) < LargestSlope * std::abs(width))
    {
      least = std::min(least, width);
      most = std::max(most, width);
    }
  }
  return most - least;
}
}

bool vtkPointSplatRows::FitThick(const vtkPointSplatPrincipal& principal, float normal[3])
{
  const float* variances = principal.Variances;
  if (!(variances[2] < FlatVariance * (variances[0] + variances[1] + variances[2])))
  {
    return false;
  }
  float plane[3];
  principal.GetNormal(plane);
  if (std::abs(vtkMath::Dot(plane, normal)) < ThickCosine)
  {
    std::copy_n(plane, 3, normal);
    return true;
  }
  return false;
}

bool vtkPointSplatRows::Fit(const Neighborhood& around, Plane& plane)
{
  const Axis along = GetAxis(around);
  const std::vector<int> beside = GetBeside(around, along);
  if (beside.empty())
  {
    return false;
  }
  const float apart2 = around.SquaredDistance[beside[0]];
  Neighborhood near = around;
  near.Count = Count(around, PlaneReach * PlaneReach * apart2);
  vtkPointSplatPrincipal(near).GetNormal(plane.Normal);
  const Axis off{ { plane.Normal[0], plane.Normal[1], plane.Normal[2] } };
  Axis across;
  vtkMath::Cross(off.X, along.X, across.X);
  const int counted = Count(around, RowsReach * RowsReach * apart2);
  if (!AreFlat(around, near.Count, off, across) ||
    GetExtent(around, counted, off, across) < LeastExtent * std::sqrt(apart2))
  {
    return false;
  }
  plane.At = around.Center;
  std::copy_n(around.Slots, NumberOfAlong, plane.Along); // there are OwnNeighbors at least
  const std::size_t reached = std::lower_bound(beside.begin(), beside.end(), counted) - beside.begin();
  for (std::size_t k = 0; k < NumberOfBeside; ++k)
  {
    plane.Beside[k] = k < reached ? around.Slots[beside[k]] : vtkPointSplatNeighbors::None;
  }
  for (std::size_t k = 0; k < NumberOfWitnesses; ++k)
  {
    plane.Witnesses[k] = around.Slots[beside[k * reached / NumberOfWitnesses]];
  }
  return true;
}

void vtkPointSplatRows::KeepSurfaces(
  std::vector<Plane>& planes, const std::vector<unsigned char>& inRow, float* normals)
{
  using Slot = vtkPointSplatNeighbors::Slot;
  const auto normalAt = [normals](Slot slot) { return normals + std::size_t(3) * slot; };
  // Whether neighbours lie in rows all have to know before any is asked.
  const auto isByChance = [&inRow](const Plane& plane) {
    const auto rows = std::count_if(
      plane.Along, std::end(plane.Along), [&inRow](Slot other) { return inRow[other] != 0; });
    return 2 * static_cast<std::size_t>(rows) < NumberOfAlong;
  };
  planes.erase(std::remove_if(planes.begin(), planes.end(), isByChance), planes.end());
  std::vector<unsigned char> hasPlane(inRow.size(), 0);
  for (Plane& plane : planes)
  {
    hasPlane[plane.At] = 1;
    // Until all have voted the normals by the nearest neighbours wait in the planes.
    std::swap_ranges(plane.Normal, plane.Normal + 3, normalAt(plane.At));
  }
  const auto isSurface = [&](const Plane& plane) {
    const float* n = normalAt(plane.At);
    const auto agreeing = std::count_if(plane.Beside, std::end(plane.Beside), [&](Slot other) {
      return other != vtkPointSplatNeighbors::None && (hasPlane[other] || !inRow[other]) &&
        std::abs(vtkMath::Dot(n, normalAt(other))) > BesideCosine;
    });
    int rows = 0, ofSurfaces = 0;
    for (const Slot other : plane.Witnesses)
    {
      rows += inRow[other];
      ofSurfaces += inRow[other] && hasPlane[other] ? 1 : 0;
    }
    return agreeing >= LeastAgreeing && 2 * ofSurfaces >= rows;
  };
  for (int vote = 0; vote < NumberOfVotes; ++vote)
  {
    std::vector<unsigned char> kept(planes.size());
    vtkPointSplatThreads::For(0, static_cast<vtkIdType>(planes.size()), [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType k = begin; k < end; ++k)
      {
        kept[k] = hasPlane[planes[k].At] && isSurface(planes[k]);
      }
    });
    for (std::size_t k = 0; k < planes.size(); ++k)
    {
      hasPlane[planes[k].At] = kept[k];
    }
  }
  const auto end = std::remove_if(planes.begin(), planes.end(), [&](const Plane& plane) {
    if (!hasPlane[plane.At])
    {
      std::copy_n(plane.Normal, 3, normalAt(plane.At));
    }
    return !hasPlane[plane.At];
  });
  planes.erase(end, planes.end());
}

VTK_ABI_NAMESPACE_END
