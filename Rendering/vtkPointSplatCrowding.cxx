// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatCrowding.h"

#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <tuple>

namespace
{
constexpr double CellSpacings = 1.25;
constexpr double OffSpacings = 0.5;
constexpr vtkIdType PointsDrawn = 40000;

struct Point
{
  uint64_t Cell;
  size_t Cloud;
  vtkIdType Splat;
  glm::dvec3 Position;
  glm::dvec3 Normal;
};

/// As decodeNormal() in vtkPointSplatOctahedron.glsl.
glm::dvec3 DecodeNormal(uint32_t code)
{
  const double x = static_cast<int16_t>(code & 0xffffu) / 32767.0;
  const double y = static_cast<int16_t>(code >> 16) / 32767.0;
  const double z = 1.0 - std::abs(x) - std::abs(y);
  const double fold = std::max(-z, 0.0);
  return { x + (x >= 0.0 ? -fold : fold), y + (y >= 0.0 ? -fold : fold), z };
}

/// Of a cube: all 64 bits hang on each of its three numbers (the finalizer of MurmurHash3).
uint64_t Hash(const glm::dvec3& cube)
{
  uint64_t hash = 0;
  for (int k = 0; k < 3; ++k)
  {
    hash ^= static_cast<uint64_t>(static_cast<int64_t>(cube[k]));
    hash = (hash ^ (hash >> 33)) * 0xff51afd7ed558ccdull;
    hash = (hash ^ (hash >> 33)) * 0xc4ceb9fe1a85ec53ull;
    hash ^= hash >> 33;
  }
  return hash;
}

/// Appends the points of cubes that were drawn, one of `share` cubes.
void Draw(const vtkPointSplatCrowding::Cloud& cloud, size_t number, double side, uint64_t share,
  std::vector<Point>& points)
{
  vtkSMPThreadLocal<std::vector<Point>> found;
  const glm::dmat3 normals = glm::transpose(glm::inverse(glm::dmat3(cloud.ToWorld)));
  const vtkIdType count = static_cast<vtkIdType>(cloud.Splats->size() / cloud.Words);
  vtkSMPTools::For(0, count, [&](vtkIdType begin, vtkIdType end) {
    std::vector<Point>& own = found.Local();
    for (vtkIdType i = begin; i < end; ++i)
    {
      const uint32_t* words = cloud.Splats->data() + cloud.Words * static_cast<size_t>(i);
      float p[3];
      std::memcpy(p, words, sizeof(p));
      const glm::dvec3 position(cloud.ToWorld * glm::dvec4(p[0], p[1], p[2], 1.0));
      const glm::dvec3 cube = glm::floor(position / side);
      if (!(glm::dot(cube, cube) < 1e36))
      {
        continue;
      }
      const uint64_t cell = Hash(cube);
      if (cell % share == 0)
      {
        own.push_back({ cell, number, i, position, normals * DecodeNormal(words[5]) });
      }
    }
  });
  for (const std::vector<Point>& own : found)
  {
    points.insert(points.end(), own.begin(), own.end());
  }
}

bool IsCrowded(const Point* first, const Point* last, double off)
{
  const double length = glm::length(first->Normal);
  return std::any_of(first, last, [&](const Point& point) {
    return point.Cloud != first->Cloud || glm::dot(point.Normal, first->Normal) < 0.0 ||
      std::abs(glm::dot(point.Position - first->Position, first->Normal)) > off * length;
  });
}
}

//------------------------------------------------------------------------------
double vtkPointSplatCrowding::Share(const std::vector<Cloud>& clouds, double spacing)
{
  if (!(spacing > 0.0) || !std::isfinite(spacing))
  {
    return 1.0;
  }
  vtkIdType count = 0;
  for (const Cloud& cloud : clouds)
  {
    count += static_cast<vtkIdType>(cloud.Splats->size() / cloud.Words);
  }
  std::vector<Point> points;
  for (size_t i = 0; i < clouds.size(); ++i)
  {
    Draw(clouds[i], i, CellSpacings * spacing, static_cast<uint64_t>(1 + count / PointsDrawn),
      points);
  }
  // Threads find them in any order.
  vtkSMPTools::Sort(points.begin(), points.end(), [](const Point& a, const Point& b) {
    return std::tie(a.Cell, a.Cloud, a.Splat) < std::tie(b.Cell, b.Cloud, b.Splat);
  });
  size_t crowded = 0;
  for (size_t first = 0, last = 0; first < points.size(); first = last)
  {
    while (last < points.size() && points[last].Cell == points[first].Cell)
    {
      ++last;
    }
    const Point* cube = points.data() + first;
    crowded += IsCrowded(cube, cube + (last - first), OffSpacings * spacing) ? last - first : 0;
  }
  return points.empty() ? 0.0
                        : static_cast<double>(crowded) / static_cast<double>(points.size());
}
