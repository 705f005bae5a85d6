// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatFoldSides.h"

#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointSplatBorders.h"
#include "vtkPointSplatInput.h"
#include "vtkPointSplatThreads.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPThreadLocalObject.h"
#include "vtkStaticPointLocator.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// How many times as large a splat on a side is as the edge point's for that to be too small (Testing/Accuracy/fit_constants.py).
constexpr float SparserSide = 3.0f;
/// How far, in radii of the splat on a side, the edge point is off its line and its plane.
constexpr float OffSide = 0.1f;
/// The line is so far from the edge point at least, since lines are as long as they are near.
constexpr float LeastOfRadius = 1e-3f;
}

vtkPointSplatFoldSides::vtkPointSplatFoldSides(
  const vtkPointSplatNeighbors& neighbors, std::function<float(Slot)> getRadius)
  : Neighbors(neighbors)
  , GetRadius(std::move(getRadius))
{
}

bool vtkPointSplatFoldSides::Candidate::operator<(const Candidate& other) const
{
  // Planes and splats lie in the order of slots.
  return std::tie(this->Of.Plane, this->SquaredWay, this->Of.Next) <
    std::tie(other.Of.Plane, other.SquaredWay, other.Of.Next);
}

bool vtkPointSplatFoldSides::IsEdge(const Splat& splat)
{
  // Twins, where points of several faces share a place, have a face each.
  return splat.Id < 0 && !vtkPointSplatInput::IsZero(splat.Fold) && vtkPointSplatInput::IsZero(splat.Clip + 3);
}

/// Adds the sides of an edge point, some way off, that the splat is next to.
void vtkPointSplatFoldSides::AddSides(
  const Splat& next, float radius, const Splat& edge, const float way[3], std::vector<Candidate>& found) const
{
  if (std::abs(vtkMath::Dot(way, next.Normal)) > OffSide * radius)
  {
    return;
  }
  for (const float* line : { next.Clip, next.Clip + 3 })
  {
    const float length = vtkMath::Norm(line);
    const float past = length > 0 ? (1 - vtkMath::Dot(way, line)) / length : radius;
    if (std::abs(past) > OffSide * radius)
    {
      continue;
    }
    for (const float* plane : { edge.Normal, edge.Fold })
    {
      if (std::abs(vtkMath::Dot(plane, next.Normal)) > vtkPointSplatCreases::OwnCosine)
      {
        Candidate candidate{ { &edge, &next, plane, { 0, 0, 0 } }, vtkMath::Dot(way, way) };
        for (int c = 0; c < 3; ++c)
        {
          candidate.Of.Clip[c] = line[c] / (length * std::max(past, LeastOfRadius * radius));
        }
        found.push_back(candidate);
      }
    }
  }
}

std::vector<vtkPointSplatFoldSides::Side> vtkPointSplatFoldSides::Find(const std::vector<Splat>& splats) const
{
  std::vector<Side> sides;
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  std::vector<const Splat*> edges;
  std::vector<float> least; // the radii from which on splats beside these are looked at
  for (const Splat& splat : splats)
  {
    if (IsEdge(splat))
    {
      double x[3];
      this->Neighbors.GetPosition(splat.At, x);
      places->InsertNextPoint(x);
      edges.push_back(&splat);
      least.push_back(SparserSide * this->GetRadius(splat.At));
    }
  }
  if (edges.empty())
  {
    return sides;
  }
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(places);
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(cloud);
  locator->BuildLocator();
  const float leastOfAll = *std::min_element(least.begin(), least.end());
  vtkSMPThreadLocal<std::vector<Candidate>> found;
  vtkSMPThreadLocalObject<vtkIdList> lists;
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(splats.size()), [&](vtkIdType begin, vtkIdType end) {
    std::vector<Candidate>& local = found.Local();
    vtkIdList* near = lists.Local();
    for (vtkIdType k = begin; k < end; ++k)
    {
      const Splat& next = splats[k];
      const bool ends = next.Id < 0 && vtkPointSplatCreases::HasLine(next) && !vtkPointSplatCreases::HasFold(next);
      const float radius = ends ? this->GetRadius(next.At) : 0.0f;
      if (!(radius > 0) || radius < leastOfAll)
      {
        continue;
      }
      double x[3], y[3];
      this->Neighbors.GetPosition(next.At, x);
      locator->FindPointsWithinRadius(vtkPointSplatBorders::KernelReach * radius, x, near);
      for (const vtkIdType i : *near)
      {
        if (radius < least[i])
        {
          continue;
        }
        places->GetPoint(i, y);
        const float way[3] = { static_cast<float>(y[0] - x[0]), static_cast<float>(y[1] - x[1]),
          static_cast<float>(y[2] - x[2]) };
        this->AddSides(next, radius, *edges[i], way, local);
      }
    }
  });
  std::vector<Candidate> all;
  for (const std::vector<Candidate>& local : found)
  {
    all.insert(all.end(), local.begin(), local.end());
  }
  std::sort(all.begin(), all.end());
  for (const Candidate& candidate : all)
  {
    // The nearest of a side comes first.
    if (sides.empty() || sides.back().Plane != candidate.Of.Plane)
    {
      sides.push_back(candidate.Of);
    }
  }
  return sides;
}

VTK_ABI_NAMESPACE_END
