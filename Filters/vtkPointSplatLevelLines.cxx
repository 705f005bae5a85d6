// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatLevelLines.h"

#include "vtkMath.h"

#include <algorithm>
#include <array>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
using Splat = vtkPointSplatLevelLines::Splat;
using Disk = vtkPointSplatLevelLines::Disk;

// The sine of the angle by which a line's direction may leave the plane of the splat above.
constexpr double MostTilt = 0.35;
// The cosine of the angle between directions that are of one edge.
constexpr double LeastAlike = 0.7;
// Radii: what splats below may lie beyond an edge, which bends and is known as well as they are.
constexpr double MostBeyond = 0.1;
// Radii: an edge through the centre is so far from it.
constexpr double LeastEdgeDistance = 1e-6;

/// A line in the plane of the splat above: how far from its centre, and the direction out of the face.
struct LevelEdge
{
  std::array<double, 3> Point; // from the centre
  std::array<double, 3> Direction;

  double GetDistanceAlong(const std::array<double, 3>& direction) const
  {
    return vtkMath::Dot(this->Point.data(), direction.data());
  }
  double GetDistance() const { return this->GetDistanceAlong(this->Direction); }
};

/// Adds a line of a splat below, c = n / d, if it is one that tells of the edge above.
void AddEdge(const Splat& below, const double c[3], const Disk& above, std::vector<LevelEdge>& edges)
{
  const double square = vtkMath::Dot(c, c);
  const double out = vtkMath::Dot(c, above.Normal);
  // NaN compares false.
  if (!(square > 0.0 && std::isfinite(square) && out * out <= MostTilt * MostTilt * square))
  {
    return;
  }
  LevelEdge edge;
  for (int k = 0; k < 3; ++k)
  {
    edge.Point[k] = below.Position[k] + c[k] / square - above.Position[k];
    edge.Direction[k] = c[k] - out * above.Normal[k];
  }
  vtkMath::Normalize(edge.Direction.data());
  edges.push_back(edge);
}

/// Takes the nearest edge, and those that are one with it, out of all.
LevelEdge TakeEdge(std::vector<LevelEdge>& edges)
{
  const LevelEdge nearest = *std::min_element(edges.begin(), edges.end(),
    [](const LevelEdge& a, const LevelEdge& b) { return a.GetDistance() < b.GetDistance(); });
  const auto first = std::partition(edges.begin(), edges.end(), [&nearest](const LevelEdge& edge) {
    return vtkMath::Dot(edge.Direction.data(), nearest.Direction.data()) < LeastAlike;
  });
  LevelEdge one{ nearest.Point, { { 0.0, 0.0, 0.0 } } };
  std::for_each(first, edges.end(),
    [&one](const LevelEdge& edge) { vtkMath::Add(one.Direction.data(), edge.Direction.data(), one.Direction.data()); });
  vtkMath::Normalize(one.Direction.data());
  one.Point = std::max_element(first, edges.end(), [&one](const LevelEdge& a, const LevelEdge& b) {
    return a.GetDistanceAlong(one.Direction) < b.GetDistanceAlong(one.Direction);
  })->Point;
  edges.erase(first, edges.end());
  return one;
}

/// Whether no splat below lies beyond an edge.
bool IsEnd(const LevelEdge& edge, const std::vector<Splat>& below, const Disk& above)
{
  const double most = edge.GetDistance() + MostBeyond * above.Radius;
  return std::all_of(below.begin(), below.end(), [&](const Splat& splat) {
    double offset[3];
    vtkMath::Subtract(splat.Position, above.Position, offset);
    return vtkMath::Dot(offset, edge.Direction.data()) <= most;
  });
}
}

//------------------------------------------------------------------------------
void vtkPointSplatLevelLines::Find(
  const std::vector<Splat>& below, const Disk& above, double lines[6])
{
  std::fill_n(lines, 6, 0.0);
  std::vector<LevelEdge> edges;
  for (const Splat& splat : below)
  {
    AddEdge(splat, splat.Lines, above, edges);
    AddEdge(splat, splat.Lines + 3, above, edges);
  }
  for (double* line = lines; !edges.empty() && line < lines + 6;)
  {
    const LevelEdge edge = TakeEdge(edges);
    if (!IsEnd(edge, below, above))
    {
      continue;
    }
    const double distance = std::max(edge.GetDistance(), LeastEdgeDistance * above.Radius);
    for (int k = 0; k < 3; ++k)
    {
      line[k] = edge.Direction[k] / distance;
    }
    line += 3;
  }
}

VTK_ABI_NAMESPACE_END
