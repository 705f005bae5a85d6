// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Vertices of a mesh whose triangles are wound both ways: their normals cancel along seams, and are those of the surface again.
// What only looks like that stays as it is given.
#include "Expect.h"
#include "Gathered.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSplatEstimation.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace
{
using Vector = std::array<double, 3>;

constexpr int Size = 60;

/// A point of a hilly surface, in rows of triangles, and its normal.
Vector GetPlace(int row, int column)
{
  const double x = column + 0.5 * (row % 2), y = 0.87 * row;
  return { x, y, 2 * std::sin(0.3 * x) * std::cos(0.2 * y) };
}

Vector GetNormal(int row, int column)
{
  const Vector p = GetPlace(row, column);
  Vector n{ -0.6 * std::cos(0.3 * p[0]) * std::cos(0.2 * p[1]), 0.4 * std::sin(0.3 * p[0]) * std::sin(0.2 * p[1]), 1 };
  vtkMath::Normalize(n.data());
  return n;
}

/// Adds to the sum of normals of a triangle's corners. It is wound the other way, as is returned, in every second square of so many
/// rows and columns.
bool AddTriangle(std::vector<Vector>& sums, const int corners[3][2], int square)
{
  Vector p[3], e[2], n;
  for (int k = 0; k < 3; ++k)
  {
    p[k] = GetPlace(corners[k][0], corners[k][1]);
  }
  vtkMath::Subtract(p[1], p[0], e[0]);
  vtkMath::Subtract(p[2], p[0], e[1]);
  vtkMath::Cross(e[0].data(), e[1].data(), n.data());
  vtkMath::Normalize(n.data());
  const bool turned = (corners[0][0] / square + corners[0][1] / square) % 2 != 0;
  const double sign = turned ? -1 : 1;
  for (int k = 0; k < 3; ++k)
  {
    for (int c = 0; c < 3; ++c)
    {
      sums[corners[k][0] * Size + corners[k][1]][c] += sign * n[c];
    }
  }
  return turned;
}

/// The hills with normals of their triangles, and these, if they are wanted.
void Hills(Gathered& gathered, int square, vtkCellArray* triangles = nullptr)
{
  std::vector<Vector> sums(Size * Size, Vector{ 0, 0, 0 });
  for (int row = 0; row + 1 < Size; ++row)
  {
    for (int column = 0; column + 1 < Size; ++column)
    {
      const int odd = row % 2;
      const int first[3][2] = { { row, column }, { row, column + 1 }, { row + 1, column + odd } };
      const int second[3][2] = { { row, column + 1 - odd }, { row + 1, column + 1 }, { row + 1, column } };
      for (const auto& corners : { first, second })
      {
        const bool turned = AddTriangle(sums, corners, square);
        vtkIdType ids[3];
        for (int k = 0; k < 3; ++k)
        {
          ids[turned ? 2 - k : k] = corners[k][0] * Size + corners[k][1];
        }
        if (triangles)
        {
          triangles->InsertNextCell(3, ids);
        }
      }
    }
  }
  for (int row = 0; row < Size; ++row)
  {
    for (int column = 0; column < Size; ++column)
    {
      Vector& n = sums[row * Size + column];
      vtkMath::Normalize(n.data());
      gathered.Add(GetPlace(row, column).data(), n.data());
    }
  }
}

vtkIdType Estimate(const Gathered& gathered, vtkPointSplatEstimation* estimation)
{
  estimation->SetInputData(gathered.Cloud);
  estimation->Update();
  return estimation->GetNumberOfMendedNormals();
}

Vector GetTuple(vtkPointSet* points, vtkIdType id)
{
  Vector n;
  points->GetPointData()->GetNormals()->GetTuple(id, n.data());
  return n;
}

void WoundBothWays(int shape, bool withTriangles)
{
  const std::string which = withTriangles ? " with triangles"
    : shape == vtkPointSplatEstimation::Circular ? " of circles" : " of ellipses";
  Gathered gathered;
  vtkNew<vtkCellArray> triangles;
  Hills(gathered, 15, triangles);
  if (withTriangles)
  {
    gathered.Cloud->SetPolys(triangles);
  }
  vtkNew<vtkPointSplatEstimation> estimation;
  estimation->SetShape(shape);
  const vtkIdType mended = Estimate(gathered, estimation);
  int cancelled = 0, wrong = 0, changed = 0;
  for (int row = 3; row < Size - 3; ++row)
  {
    for (int column = 3; column < Size - 3; ++column)
    {
      const vtkIdType id = row * Size + column;
      const Vector right = GetNormal(row, column), given = GetTuple(gathered.Cloud, id),
                   found = GetTuple(estimation->GetOutput(), id);
      const double was = std::abs(vtkMath::Dot(given.data(), right.data()));
      cancelled += was < 0.7;
      wrong += std::abs(vtkMath::Dot(found.data(), right.data())) < 0.98;
      changed += was > 0.99 && vtkMath::Dot(given.data(), found.data()) < 0.9999;
    }
  }
  AtLeast(cancelled, 50, "normals that cancelled, or nothing is tested");
  AtLeast(mended, cancelled, "of them so many were replaced");
  AtMost(wrong, 0, "normals off the surface's by more than 11 degrees" + which);
  AtMost(changed, 0, "right normals that were changed" + which);
}

/// The same triangles, all wound one way.
void WoundOneWay()
{
  Gathered gathered;
  Hills(gathered, 10 * Size);
  vtkNew<vtkPointSplatEstimation> estimation;
  AtMost(Estimate(gathered, estimation), 0, "normals of consistent triangles that were replaced");
}

/// Strips, of which every second triangle has its corners the other way round, with normals that are none of theirs.
void Strips()
{
  Gathered gathered;
  Hills(gathered, 10 * Size);
  vtkDataArray* normals = gathered.Cloud->GetPointData()->GetNormals();
  for (vtkIdType id = 0; id < normals->GetNumberOfTuples(); ++id)
  {
    Vector n = GetTuple(gathered.Cloud, id);
    n[0] += 0.4;
    vtkMath::Normalize(n.data());
    normals->SetTuple(id, n.data());
  }
  vtkNew<vtkCellArray> strips;
  for (int row = 0; row + 1 < Size; ++row)
  {
    std::vector<vtkIdType> ids;
    for (int i = 0; i < Size; ++i)
    {
      // Backwards in every second row, so that all strips show the same side.
      const bool odd = row % 2 != 0;
      const int column = odd ? Size - 1 - i : i;
      ids.push_back((odd ? row + 1 : row) * Size + column);
      if (!odd || column > 0)
      {
        ids.push_back(odd ? row * Size + column - 1 : (row + 1) * Size + column);
      }
    }
    strips->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  }
  gathered.Cloud->SetStrips(strips);
  vtkNew<vtkPointSplatEstimation> estimation;
  AtMost(Estimate(gathered, estimation), 0, "normals of strips' corners that were replaced");
}

/// All points of one place with a normal that cancelled get the same one.
void Copies()
{
  Gathered gathered;
  Hills(gathered, 15);
  const vtkIdType count = gathered.Cloud->GetNumberOfPoints();
  for (vtkIdType id = 0; id < count; ++id)
  {
    const Vector n = GetTuple(gathered.Cloud, id);
    double x[3];
    gathered.Cloud->GetPoint(id, x);
    gathered.Add(x, n.data());
  }
  vtkNew<vtkPointSplatEstimation> estimation;
  AtLeast(Estimate(gathered, estimation), 2 * 50, "replaced normals of copies");
  int other = 0;
  for (vtkIdType id = 0; id < count; ++id)
  {
    other += GetTuple(estimation->GetOutput(), id) != GetTuple(estimation->GetOutput(), id + count);
  }
  AtMost(other, 0, "copies with another normal");
}

/// A hoof: a wall whose last vertices' normals lean over to a base with one vertex, by 60 degrees: every one, or each of so many, of which
/// neighbours to one side alone tell. shift: of every second row along it; without, several neighbours lie one behind the other.
void Rim(int every, double shift)
{
  Gathered gathered;
  constexpr int around = 60;
  const double radius = around / (2 * vtkMath::Pi());
  for (int row = 0; row < 30; ++row)
  {
    for (int i = 0; i < around; ++i)
    {
      const double angle = 2 * vtkMath::Pi() * (i + shift * (row % 2)) / around;
      const double x[3] = { radius * std::cos(angle), radius * std::sin(angle), 0.87 * row };
      double n[3] = { std::cos(angle), std::sin(angle), row == 0 && i % every == 0 ? -1.7 : 0.0 };
      vtkMath::Normalize(n);
      gathered.Add(x, n);
    }
  }
  const double centre[3] = { 0, 0, 0 }, down[3] = { 0, 0, -1 };
  gathered.Add(centre, down);
  vtkNew<vtkPointSplatEstimation> estimation;
  AtMost(Estimate(gathered, estimation), 0, "normals of a rim with rows shifted by " + std::to_string(shift) + " that were replaced");
}
}

int TestSplatSeams(int, char*[])
{
  WoundBothWays(vtkPointSplatEstimation::Circular, false);
  WoundBothWays(vtkPointSplatEstimation::Elliptical, false);
  WoundBothWays(vtkPointSplatEstimation::Circular, true);
  WoundOneWay();
  Strips();
  Copies();
  Rim(1, 0.5);
  Rim(4, 0.5);
  Rim(4, 0);
  return failures ? EXIT_FAILURE : EXIT_SUCCESS;
}
