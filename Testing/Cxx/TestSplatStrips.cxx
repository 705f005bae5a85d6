// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// That vertices of meshes of parts, whose normals are averages at edges, tell these edges where a face is narrow or bends: the
// top of a rib that has one row of vertices between its edges, or none, and the rims of small holes; and that disks at edges end
// past shallow ones, and are large on a face that is much sparser than the other.
#include "Expect.h"
#include "Gathered.h"
#include "ScatteredFaces.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace
{
constexpr int Length = 60;

/// How many points from first to last have no line on the edge that is along a direction, no disk in the plane of a face with one
/// of two normals, or no fold.
int CountWrong(const Estimated& splats, vtkIdType first, vtkIdType last, const double along[3],
  const double faces[2][3])
{
  int wrong = 0;
  for (vtkIdType id = first; id < last; ++id)
  {
    double line[3], fold[3];
    bool right = false;
    for (int k = 0; k < 2; ++k)
    {
      const double length = splats.GetLine(id, k, line);
      right = right ||
        (length * 0.1 > 1 && std::abs(vtkMath::Dot(line, along)) < 0.1 * length);
    }
    const bool flat =
      splats.GetPlanePart(id, faces[0]) > 0.99 || splats.GetPlanePart(id, faces[1]) > 0.99;
    wrong += !right || !flat || !(splats.GetFold(id, 0, fold) > 0 || splats.GetFold(id, 1, fold) > 0);
  }
  return wrong;
}

/// A rib along y whose top is so wide, with so many rows between its edges.
void Rib(double width, int rows)
{
  const double up[3] = { 0, 0, 1 };
  const double sides[2][3] = { { -1, 0, 0 }, { 1, 0, 0 } };
  Gathered gathered;
  // Triangles at a vertex are more on one face or the other, and so are the weights of its normal.
  vtkIdType first[2];
  for (const int side : { 0, 1 })
  {
    first[side] = gathered.Cloud->GetNumberOfPoints();
    for (int i = 0; i < Length; ++i)
    {
      const double x[3] = { side * width, i + 0.0, 0 };
      const double part = i % 2 ? 0.7 : 1.0;
      double n[3] = { part * sides[side][0], 0, 1 };
      vtkMath::Normalize(n);
      gathered.Add(x, n);
    }
  }
  for (int row = 1; row <= rows; ++row)
  {
    for (int i = 0; i < Length; ++i)
    {
      const double x[3] = { row * width / (rows + 1), i + 0.5 * (row % 2), 0 };
      gathered.Add(x, up);
    }
  }
  for (int row = 1; row < 20; ++row)
  {
    for (int i = 0; i < Length; ++i)
    {
      for (const int side : { 0, 1 })
      {
        const double x[3] = { side * width, i + 0.5 * (row % 2), -0.9 * row };
        gathered.Add(x, sides[side]);
      }
    }
  }
  const Estimated splats(gathered.Cloud);
  const double along[3] = { 0, 1, 0 }, faces[2][3] = { { 0, 0, 1 }, { 1, 0, 0 } };
  int wrong = 0;
  for (const int side : { 0, 1 })
  {
    wrong += CountWrong(splats, first[side] + 8, first[side] + Length - 8, along, faces);
  }
  AtMost(wrong, 0,
    "a rib " + std::to_string(width) + " wide with " + std::to_string(rows) +
      " rows on it: points on its edges without lines and folds there, in a plane of no face");
}

/// A plate's hole of so many spacings' radius. most: points on its rim that may be wrong.
void Hole(double radius, int most)
{
  const double pi = vtkMath::Pi();
  const int number = static_cast<int>(std::round(2 * pi * radius));
  Gathered gathered;
  auto addRing = [&](double r, double z, int count, double shift, const double slope[2]) {
    for (int i = 0; i < count; ++i)
    {
      const double angle = 2 * pi * (i + shift) / count;
      const double x[3] = { r * std::cos(angle), r * std::sin(angle), z };
      double n[3] = { -slope[0] * std::cos(angle), -slope[0] * std::sin(angle), slope[1] };
      vtkMath::Normalize(n);
      gathered.Add(x, n);
    }
  };
  const double edge[2] = { 1, 1 }, wall[2] = { 1, 0 }, top[2] = { 0, 1 };
  addRing(radius, 0, number, 0, edge);
  for (int row = 1; row < 12; ++row)
  {
    addRing(radius, -0.9 * row, number, 0.5 * (row % 2), wall);
    addRing(radius + 0.9 * row, 0, static_cast<int>(std::round(2 * pi * (radius + 0.9 * row))), 0.3 * row, top);
  }
  const Estimated splats(gathered.Cloud);
  int wrong = 0;
  for (vtkIdType id = 0; id < number; ++id)
  {
    const double angle = 2 * pi * id / number;
    const double along[3] = { -std::sin(angle), std::cos(angle), 0 };
    const double faces[2][3] = { { 0, 0, 1 }, { std::cos(angle), std::sin(angle), 0 } };
    wrong += CountWrong(splats, id, id + 1, along, faces);
  }
  AtMost(wrong, most,
    "a hole of " + std::to_string(radius) +
      " spacings: points on its rim without lines and folds there, in a plane of no face");
}

/// A wall along x with a top, whose upper strip of two rows leans back by so few degrees, and an end across it: at the edge below
/// the strip, which is no line, disks reach no farther than elsewhere.
void Lean(double degrees)
{
  constexpr int last = 10; // of the rows along and across
  constexpr int strip = 2;
  const double slope = std::tan(vtkMath::RadiansFromDegrees(degrees));
  const auto depth = [slope](int y) { return y > 0 ? -slope * y : 0; };
  Gathered gathered;
  // Its normal is the mean of those of all faces that it is on.
  const auto add = [&](double x, int y, double z) {
    double n[3] = { 0, 0, 0 };
    if (z == depth(y))
    {
      const double lower[3] = { 0, 0, 1 };
      double upper[3] = { 0, slope, 1 };
      vtkMath::Normalize(upper);
      for (int c = 0; c < 3; ++c)
      {
        // Two triangles of three at the last vertex are below the edge.
        n[c] = (y <= 0 ? (x == last ? 2 : 1) * lower[c] : 0) + (y >= 0 ? upper[c] : 0);
      }
      vtkMath::Normalize(n);
    }
    n[0] -= x == 0 ? 1 : 0;
    n[1] += y == strip ? 1 : 0;
    vtkMath::Normalize(n);
    const double place[3] = { x, y + 0.0, z };
    gathered.Add(place, n);
  };
  for (int y = -last; y <= strip; ++y)
  {
    for (int x = 0; x <= last; ++x)
    {
      add(x, y, depth(y));
    }
    for (int back = 1; back <= last; ++back)
    {
      add(0, y, depth(y) - back);
    }
  }
  for (int x = 1; x <= last; ++x)
  {
    for (int back = 1; back <= last; ++back)
    {
      add(x, strip, depth(strip) - back);
    }
  }
  const Estimated splats(gathered.Cloud);
  double largest = 0;
  for (vtkIdType id = 0; id < gathered.Cloud->GetNumberOfPoints(); ++id)
  {
    double x[3];
    gathered.Cloud->GetPoint(id, x);
    // Others are at the corners of the end and the top, which end in the open.
    largest = x[2] > -1 ? std::max(largest, splats.GetRadius(id)) : largest;
  }
  AtMost(largest, 0.9, "the largest disk of a wall that leans by " + std::to_string(degrees) + " degrees above");
}

/// An edge along y between a top, whose rows are the denser the nearer they are to it, and a wall of one density: of its points
/// splats on the wall alone are as large as the wall's.
void DenseTop()
{
  const double up[3] = { 0, 0, 1 }, out[3] = { -1, 0, 0 };
  Gathered gathered;
  for (int y = 0; y < Length; ++y)
  {
    const double x[3] = { 0, y + 0.0, 0 };
    double n[3] = { -0.6, 0, 0.8 };
    gathered.Add(x, n);
  }
  for (double row = 0.06; row < 10; row += std::min(row, 1.0))
  {
    const double spacing = std::max(0.25, std::min(row, 1.0));
    for (double y = 0; y < Length; y += spacing)
    {
      const double x[3] = { row, y, 0 };
      gathered.Add(x, up);
    }
  }
  for (int row = 1; row < 10; ++row)
  {
    for (double y = 0; y < Length; y += 0.5)
    {
      const double x[3] = { 0, y, -1.3 * row };
      gathered.Add(x, out);
    }
  }
  const Estimated splats(gathered.Cloud, true);
  int found = 0;
  for (vtkIdType id = gathered.Cloud->GetNumberOfPoints(); id < splats.GetNumberOfPoints(); ++id)
  {
    double x[3], line[3];
    splats.GetPoint(id, x);
    splats.GetLine(id, 0, line);
    const bool onWall = splats.GetPlanePart(id, out) > 0.99;
    // The line is the edge, and what is kept is below.
    found += x[0] == 0 && x[2] == 0 && onWall && line[2] > 100 && std::abs(line[1]) < 0.1 * line[2] &&
        splats.GetRadius(id) > 1
      ? 1
      : 0;
  }
  AtLeast(found, Length - 16, "splats on the wall alone at points on the edge to a denser top");
}
}

int TestSplatStrips(int, char*[])
{
  for (const double width : { 1.2, 1.6, 2.0 })
  {
    Rib(width, 1);
  }
  for (const double width : { 0.7, 0.9, 1.1 })
  {
    Rib(width, 0);
  }
  // 25 and 31 where the walls, whose nearest points are too few to tell how they bend, were no faces.
  Hole(4, 8);
  Hole(5, 0);
  Hole(8, 0);
  // 1.8 and 1.0 where the strip's points did not bound the disks below.
  Lean(15);
  Lean(10);
  DenseTop();
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
