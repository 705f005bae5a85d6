// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Points in rows, without normals: scan lines of a surface, with noise and without, have the surface's normals and are
// covered; wires side by side, coils and curves in a volume are no surface.
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSplatArrays.h"
#include "vtkPointSplatEstimation.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace
{
int failures = 0;

void Check(bool holds, const std::string& what, const std::string& which)
{
  if (!holds)
  {
    std::cerr << "FAILED: " << what << ": " << which << "\n";
    ++failures;
  }
}

struct Cloud
{
  vtkNew<vtkPoints> Points;
  vtkNew<vtkPointSplatEstimation> Estimation;

  vtkPointData* Estimate()
  {
    vtkNew<vtkPolyData> data;
    data->SetPoints(this->Points);
    this->Estimation->FillGapsOff();
    this->Estimation->SetInputData(data);
    this->Estimation->Update();
    return this->Estimation->GetOutput()->GetPointData();
  }

  /// What part of the points are bodies.
  double GetShareAlone()
  {
    this->Estimate();
    return double(this->Estimation->GetNumberOfPointsAlone()) / this->Points->GetNumberOfPoints();
  }
};

/// Rings of a tube of the radius 1, of so many points that these are `ratio` times as near together as the rings. noise:
/// the deviation of points from it, in their distances along a ring. All but a share of the normals must be within an angle.
void Tube(double ratio, double noise, double share, double degrees)
{
  const int around = 600, rings = 24;
  const double apart = 2 * vtkMath::Pi() / around;
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(3);
  Cloud cloud;
  for (int i = 0; i < around * rings; ++i)
  {
    random->Next();
    const double radius = 1 + 1.7 * noise * apart * (2 * random->GetValue() - 1);
    const double angle = 2 * vtkMath::Pi() * (i % around) / around;
    cloud.Points->InsertNextPoint(
      radius * std::cos(angle), radius * std::sin(angle), ratio * apart * (i / around));
  }
  const std::string what = "tube of ratio " + std::to_string(ratio) + ", noise " + std::to_string(noise);
  vtkPointData* found = cloud.Estimate();
  vtkDataArray* radii = found->GetArray(vtkPointSplatArrays::Radius);
  int off = 0, small = 0, sign = 0;
  for (int i = 0; i < around * rings; ++i)
  {
    double n[3], p[3];
    found->GetNormals()->GetTuple(i, n);
    cloud.Points->GetPoint(i, p);
    const double cosine = (p[0] * n[0] + p[1] * n[1]) / std::hypot(p[0], p[1]);
    off += std::abs(cosine) < std::cos(vtkMath::RadiansFromDegrees(degrees)) ? 1 : 0;
    sign += cosine > 0 ? 1 : -1;
    small += radii->GetTuple1(i) < 0.4 * ratio * apart ? 1 : 0;
  }
  const vtkIdType alone = cloud.Estimation->GetNumberOfPointsAlone();
  std::cout << what << ": off " << off << ", small " << small << ", alone " << alone << "\n";
  const double most = share * around * rings;
  Check(off <= most && alone <= most, what, "normals or bodies");
  // What is farther off than points are apart has small disks, until it is projected.
  Check(small <= most || noise >= 1, what, "radii");
  Check(std::abs(sign) >= (1 - 2 * share) * around * rings, what, "orientation");
}

/// Straight wires along z at so many places.
void Wires(const std::string& what, const std::vector<std::pair<double, double>>& at)
{
  Cloud cloud;
  for (const auto& [x, y] : at)
  {
    for (int i = 0; i < 300; ++i)
    {
      cloud.Points->InsertNextPoint(x, y, 0.1 * i);
    }
  }
  Check(cloud.GetShareAlone() == 1, what, "a surface was seen");
}

/// Curves that start anywhere and follow a flow.
void Flow()
{
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(7);
  Cloud cloud;
  for (int curve = 0; curve < 60; ++curve)
  {
    double x[3];
    for (double& c : x)
    {
      random->Next();
      c = 2 * random->GetValue() - 1;
    }
    for (int i = 0; i < 500; ++i)
    {
      double v[3] = { 1 + 0.3 * std::sin(3 * x[1]), 0.4 * std::sin(2 * x[2] + x[0]), 0.4 * std::cos(2 * x[1]) };
      vtkMath::Normalize(v);
      for (int c = 0; c < 3; ++c)
      {
        x[c] += 0.003 * v[c];
      }
      cloud.Points->InsertNextPoint(x);
    }
  }
  const double alone = cloud.GetShareAlone();
  std::cout << "flow: alone " << alone << "\n";
  Check(alone > 0.98, "flow", "surfaces were seen");
}

/// Turns half as far apart as the coil is wide.
void Coil()
{
  Cloud cloud;
  for (int i = 0; i < 4000; ++i)
  {
    const double turns = 8.0 * i / 4000, angle = 2 * vtkMath::Pi() * turns;
    cloud.Points->InsertNextPoint(std::cos(angle), std::sin(angle), turns);
  }
  Check(cloud.GetShareAlone() == 1, "coil", "a surface was seen");
}
}

int TestSplatRows(int, char*[])
{
  for (const double ratio : { 3.0, 5.0, 8.0, 12.0, 20.0 })
  {
    Tube(ratio, 0, 0, 10);
  }
  Tube(8, 0.5, 0.02, 10);
  Tube(10, 1, 0.02, 15);
  Wires("three wires", { { 0, 0 }, { 2, 0 }, { 4, 0.3 } });
  Wires("six wires", { { 0, 0 }, { 2, 0 }, { 0, 1.7 }, { 2, 1.7 }, { 0, 3.4 }, { 2, 3.4 } });
  Flow();
  Coil();
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
