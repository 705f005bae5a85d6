// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// That disks of vtkPointSplatEstimation keep to their own sheet: on specks, tubes, sheets that lie
// close, in scan lines, and for points alone. The truth is known in closed form.
#include "ScatteredFaces.h"

#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSplatArrays.h"
#include "vtkPointSplatEstimation.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace
{
int failures = 0;

/// Points, and normals if they are given.
struct Cloud
{
  vtkNew<vtkPoints> Points;
  vtkNew<vtkFloatArray> Normals;

  Cloud() { this->Normals->SetNumberOfComponents(3); }

  void Add(double x, double y, double z, double nx, double ny, double nz)
  {
    this->Points->InsertNextPoint(x, y, z);
    this->Normals->InsertNextTuple3(nx, ny, nz);
  }

  void Estimate(vtkPointSplatEstimation* estimation)
  {
    vtkNew<vtkPolyData> data;
    data->SetPoints(this->Points);
    data->GetPointData()->SetNormals(this->Normals);
    estimation->SetInputData(data);
    estimation->Update();
  }

  /// The least and the greatest radius that there may be, and how many points are alone.
  void Expect(const std::string& what, double least, double most, vtkIdType alone)
  {
    vtkNew<vtkPointSplatEstimation> estimation;
    this->Estimate(estimation);
    double range[2];
    estimation->GetOutput()->GetPointData()->GetArray(vtkPointSplatArrays::Radius)->GetRange(range);
    const vtkIdType found = estimation->GetNumberOfPointsAlone();
    std::cout << what << ": radii " << range[0] << " to " << range[1] << ", alone " << found << "\n";
    if (range[0] < least || range[1] > most || found != alone)
    {
      std::cerr << "FAILED: " << what << ": radii are to be " << least << " to " << most << ", alone "
                << alone << "\n";
      ++failures;
    }
  }
};

/// Octahedra at random: no disk may reach from one to the other, nor past itself.
void Specks()
{
  Cloud cloud;
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(3);
  for (int speck = 0; speck < 200; ++speck)
  {
    double c[3] = { 8.0 * (speck % 6), 8.0 * (speck / 6 % 6), 8.0 * (speck / 36) };
    for (double& x : c)
    {
      x += random->GetNextValue();
    }
    for (int side = 0; side < 6; ++side)
    {
      double n[3] = { 0, 0, 0 };
      n[side / 2] = side % 2 ? 1 : -1;
      cloud.Add(c[0] + 0.7 * n[0], c[1] + 0.7 * n[1], c[2] + 0.7 * n[2], n[0], n[1], n[2]);
    }
  }
  cloud.Expect("octahedra of radius 0.7", 0.4, 0.75, 0);
}

/// Rings of so many points around a tube of radius 1.
void Tube(int around)
{
  Cloud cloud;
  const double step = 2 * vtkMath::Pi() / around;
  for (int ring = 0; ring < 60; ++ring)
  {
    for (int k = 0; k < around; ++k)
    {
      const double a = step * (k + 0.5 * (ring % 2));
      cloud.Add(std::cos(a), std::sin(a), 0.87 * step * ring, std::cos(a), std::sin(a), 0);
    }
  }
  const double chord = 2 * std::sin(0.5 * step);
  cloud.Expect("a tube of " + std::to_string(around) + " points around", 0.5 * chord, 0.8 * chord, 0);
}

/// Two grids that face away from each other: one is no neighbourhood of the other.
void Sheets(double gap)
{
  Cloud cloud;
  for (int i = 0; i < 2 * 40 * 40; ++i)
  {
    const double side = i % 2 ? 1 : -1;
    cloud.Add(i / 2 % 40 + 0.4 * side, i / 80 + 0.3 * side, 0.5 * gap * side, 0, 0, side);
  }
  cloud.Expect("sheets " + std::to_string(gap) + " apart", 0.55, 0.8, 0);
}

/// Droplets over a grid: bodies of the local spacing.
void Alone()
{
  Cloud cloud;
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(9);
  for (int i = 0; i < 40 * 40; ++i)
  {
    cloud.Add(i % 40, i / 40, 0, 0, 0, 1);
  }
  for (int i = 0; i < 9; ++i)
  {
    cloud.Add(12 * (i % 3) + random->GetNextValue(), 12 * (i / 3), 9 + random->GetNextValue(), 1, 0, 0);
  }
  cloud.Expect("droplets", 0.5, 0.76, 9);
}

/// Lines that are twenty times as far from each other as their points: the outer ones, which have
/// neighbours on one side only, reach to the next as well.
void ScanLines()
{
  Cloud cloud;
  for (int i = 0; i < 12 * 400; ++i)
  {
    cloud.Add(i % 400, 20 * (i / 400), 0, 0, 0, 1);
  }
  cloud.Expect("scan lines", 9.5, 15, 0);
}

/// A single line, for all that its normals say, and a circle: bodies, since nothing is beside them.
void Curves()
{
  Cloud line, circle;
  for (int i = 0; i < 500; ++i)
  {
    const double angle = 2 * vtkMath::Pi() * i / 500;
    line.Add(i, 0, 0, 0, 0, 1);
    circle.Add(std::cos(angle), std::sin(angle), 0, 0, 0, 1);
  }
  line.Expect("line", 0.49, 0.51, 500);
  circle.Expect("circle", 0.0062, 0.0064, 500);

  // Where a row of points ends and the next begins a spacing and a half beside it, the cells of a few
  // points close by what is far away.
  Cloud rows;
  for (int i = 0; i < 1000; ++i)
  {
    const double radius = 296.0 + (i < 446 ? 1.4 : 0.0);
    const double angle = (i - 451) / radius;
    rows.Add(radius * std::cos(angle), radius * std::sin(angle), 0, 0, 0, 1);
  }
  rows.Expect("the end of one row and the beginning of the next", 0.45, 1.0, 1000);
}

/// A ball and droplets far about it, with normals at random: all of them are as sparse as those around, and yet no surface.
void Spray()
{
  constexpr vtkIdType onBall = 10000, droplets = 500;
  Cloud cloud;
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(7);
  const auto next = [&random]() { return random->GetNextValue() - 0.5; };
  for (vtkIdType i = 0; i < onBall + droplets; ++i)
  {
    double x[3], n[3];
    for (int c = 0; c < 3; ++c)
    {
      n[c] = next();
      x[c] = 6 * next();
    }
    vtkMath::Normalize(n);
    const double* place = i < onBall ? n : x;
    cloud.Add(place[0], place[1], place[2], n[0], n[1], n[2]);
  }
  vtkNew<vtkPointSplatEstimation> estimation;
  cloud.Estimate(estimation);
  vtkDataArray* radii = estimation->GetOutput()->GetPointData()->GetArray(vtkPointSplatArrays::Radius);
  vtkIdType large = 0;
  for (vtkIdType i = onBall; i < onBall + droplets; ++i)
  {
    large += radii->GetComponent(i, 0) > 0.2 ? 1 : 0;
  }
  std::cout << "spray: " << large << " droplets are plates\n";
  if (large > 5)
  {
    std::cerr << "FAILED: droplets are plates\n";
    ++failures;
  }
}

/// What has, but for so many, the disks that it has without the ball beside it, which is finer and has four times as many points;
/// which of two faces a point on their edge is of is up to rounding.
void FinerBeside(const std::string& what, void (*add)(ScatteredFaces&), vtkIdType most)
{
  ScatteredFaces part, both;
  add(part);
  add(both);
  const vtkIdType count = part.GetNumberOfPoints(), onBall = 4 * count;
  for (vtkIdType i = 0; i < onBall; ++i)
  {
    const double z = 1 - (2 * i + 1.0) / onBall, r = std::sqrt(1 - z * z), angle = i * vtkMath::Pi() * (3 - std::sqrt(5.0));
    const double n[3] = { r * std::cos(angle), r * std::sin(angle), z };
    const double x[3] = { 1.5 + 0.15 * n[0], 0.15 * n[1], 0.15 * n[2] };
    both.Add(x, n, {});
  }
  const Estimated alone(part), beside(both);
  vtkIdType off = 0, lines = 0, linesOff = 0;
  for (vtkIdType id = 0; id < count; ++id)
  {
    const double radius = alone.GetRadius(id);
    off += std::abs(beside.GetRadius(id) - radius) > 0.05 * radius;
    double c[3];
    const bool ends = alone.GetLine(id, 0, c) > 0;
    lines += ends;
    linesOff += ends != (beside.GetLine(id, 0, c) > 0);
  }
  std::cout << what << " beside a finer ball: " << off << " radii off, lines of " << linesOff << " of " << lines << "\n";
  if (off > most || linesOff > 0 || lines == 0)
  {
    std::cerr << "FAILED: " << what << " beside a finer ball has other disks than alone\n";
    ++failures;
  }
}

/// Whose edges are found, and whose points are as regular as the ball's.
void AddCube(ScatteredFaces& faces)
{
  faces.AddGridCube(13);
}

/// Whose points are at random: their gaps are as wide as holes of the ball would be.
void AddCap(ScatteredFaces& faces)
{
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(5);
  const auto next = [&]() {
    random->Next();
    return random->GetValue();
  };
  for (int i = 0; i < 4000; ++i)
  {
    const double z = next(), r = std::sqrt(1 - z * z), angle = 2 * vtkMath::Pi() * next();
    const double n[3] = { r * std::cos(angle), r * std::sin(angle), z };
    faces.Add(n, n, {});
  }
}
}

int TestSplatSizes(int, char*[])
{
  Specks();
  Tube(6);
  Tube(8);
  Tube(16);
  Sheets(1.0);
  Alone();
  ScanLines();
  Curves();
  Spray();
  FinerBeside("cube", AddCube, 0);
  FinerBeside("cap", AddCap, 10);
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
