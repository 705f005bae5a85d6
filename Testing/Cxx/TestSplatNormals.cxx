// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Points alone: normals are those of a surface of second order, which takes more neighbours where there is noise, and face
// the same way on both sides of a sharp edge.
#include "Expect.h"

#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSplatEstimation.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace
{
using Vector = std::array<double, 3>;

struct Cloud
{
  vtkNew<vtkPoints> Points;
  std::vector<Vector> Normals; // the surface's
  vtkNew<vtkMinimalStandardRandomSequence> Random;

  double Next()
  {
    this->Random->Next();
    return this->Random->GetValue();
  }

  void Add(const Vector& x, const Vector& n)
  {
    this->Points->InsertNextPoint(x.data());
    this->Normals.push_back(n);
  }

  /// The cosines between the normals that are found and the surface's.
  std::vector<double> GetCosines() const
  {
    vtkNew<vtkPolyData> data;
    data->SetPoints(this->Points);
    vtkNew<vtkPointSplatEstimation> estimation;
    estimation->FillGapsOff();
    estimation->SetInputData(data);
    estimation->Update();
    vtkDataArray* found = estimation->GetOutput()->GetPointData()->GetNormals();
    std::vector<double> cosines;
    for (std::size_t i = 0; i < this->Normals.size(); ++i)
    {
      double n[3];
      found->GetTuple(static_cast<vtkIdType>(i), n);
      cosines.push_back(vtkMath::Dot(n, this->Normals[i].data()));
    }
    return cosines;
  }
};

/// The angle between normals of 5,000 random points of a torus and its own, root mean square in degrees. noise: the largest
/// deviation, in distances between points.
double GetError(double noise)
{
  constexpr int count = 5000;
  constexpr double minor = 0.4;
  const double spacing = std::sqrt(4 * vtkMath::Pi() * vtkMath::Pi() * minor / count);
  Cloud cloud;
  while (cloud.Points->GetNumberOfPoints() < count)
  {
    const double u = 2 * vtkMath::Pi() * cloud.Next(), v = 2 * vtkMath::Pi() * cloud.Next();
    const double deviation = noise * spacing * (2 * cloud.Next() - 1);
    if (cloud.Next() * (1 + minor) > 1 + minor * std::cos(v))
    {
      continue; // else points on the inside would be denser
    }
    const Vector n = { std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v) };
    const double r = minor + deviation;
    cloud.Add({ std::cos(u) + r * n[0], std::sin(u) + r * n[1], r * n[2] }, n);
  }
  double sum = 0;
  for (const double cosine : cloud.GetCosines())
  {
    const double angle = std::acos(std::min(1.0, std::abs(cosine)));
    sum += angle * angle;
  }
  return vtkMath::DegreesFromRadians(std::sqrt(sum / count));
}

/// The share of a wedge's points whose normals look inward where others look outward. Two of its faces meet at an edge with
/// points on it, at so many degrees, and the others close it; edges have no normal.
double GetTurned(double degrees)
{
  constexpr int along = 60, across = 30;
  const double half = 0.5 * vtkMath::RadiansFromDegrees(degrees);
  const double depth = std::cos(half), width = std::sin(half);
  Cloud cloud;
  for (int j = 0; j <= along; ++j)
  {
    const double cap = j == 0 ? -1 : j == along ? 1 : 0;
    for (int i = 0; i <= across; ++i)
    {
      // Across the wedge, as far from its tip as the i-th row of its faces.
      const int most = static_cast<int>(std::ceil(2 * i * width));
      const bool isBack = i == across;
      for (int k = 0; k <= most; ++k)
      {
        const double side = most == 0 ? 0 : 2.0 * k / most - 1;
        const bool isFace = std::abs(side) == 1;
        if (cap == 0 && !isBack && !isFace && i > 0)
        {
          continue; // inside
        }
        const bool isEdge = i == 0 || (cap != 0 && (isFace || isBack)) || (isFace && isBack);
        const Vector face = { -width, side * depth, 0 }, back = { 1, 0, 0 }, top = { 0, 0, cap };
        cloud.Add({ i * depth, i * side * width, 1.0 * j }, isEdge ? Vector{ 0, 0, 0 } : cap != 0 ? top : isBack ? back : face);
      }
    }
  }
  double inward = 0, outward = 0;
  for (const double cosine : cloud.GetCosines())
  {
    inward += cosine < -0.5 ? 1 : 0;
    outward += cosine > 0.5 ? 1 : 0;
  }
  return std::min(inward, outward) / (inward + outward);
}
}

int TestSplatNormals(int, char*[])
{
  // Planes of as many neighbours are off by 2.5 degrees, with noise by 2.9 and 5.4.
  AtMost(GetError(0), 0.6, "error of a torus");
  AtMost(GetError(0.1), 1.5, "error of a torus with noise");
  AtMost(GetError(0.3), 2.7, "error of a torus with more noise");
  for (const double degrees : { 30.0, 45.0, 75.0, 90.0, 120.0 })
  {
    AtMost(GetTurned(degrees), 0.01, "share of a wedge's points that look inward, " + std::to_string(degrees));
  }
  return failures;
}
