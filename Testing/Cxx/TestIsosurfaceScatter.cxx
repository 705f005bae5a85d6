// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkIsosurfacePoints of scattered samples against closed forms: how far points are from the
// surface, their normals, gaps and clumps.
#include "vtkDoubleArray.h"
#include "vtkIsosurfacePoints.h"
#include "vtkMath.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStaticPointLocator.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace
{
int failures = 0;

void AtMost(double value, double bound, const std::string& what)
{
  if (!(value <= bound))
  {
    std::fprintf(stderr, "FAILED: %s: %g is more than %g\n", what.c_str(), value, bound);
    ++failures;
  }
}

/// In the cube from -1 to 1.
struct Field
{
  const char* Name;
  double (*Get)(const double p[3]);
  double Isovalue;

  /// The difference to the isovalue, and its gradient.
  double Evaluate(const double p[3], double gradient[3]) const
  {
    const double step = 1e-5;
    for (int c = 0; c < 3; ++c)
    {
      double a[3] = { p[0], p[1], p[2] }, b[3] = { p[0], p[1], p[2] };
      a[c] -= step;
      b[c] += step;
      gradient[c] = (this->Get(b) - this->Get(a)) / (2 * step);
    }
    return this->Get(p) - this->Isovalue;
  }
};

double Ball(const double p[3])
{
  return p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
}

double Distance(const double p[3])
{
  return std::sqrt(Ball(p));
}

double Torus(const double p[3])
{
  const double q = std::sqrt(p[0] * p[0] + p[1] * p[1]) - 0.55;
  return std::sqrt(q * q + p[2] * p[2]);
}

double Gyroid(const double p[3])
{
  const double a = 4.5;
  return std::sin(a * p[0]) * std::cos(a * p[1]) + std::sin(a * p[1]) * std::cos(a * p[2]) +
    std::sin(a * p[2]) * std::cos(a * p[0]);
}

double Metaballs(const double p[3])
{
  const double a[3] = { p[0] - 0.36, p[1], p[2] }, b[3] = { p[0] + 0.36, p[1], p[2] };
  return std::exp(-6 * Ball(a)) + std::exp(-6 * Ball(b));
}

const Field fields[] = { { "sphere", Distance, 0.7 }, { "torus", Torus, 0.25 },
  { "gyroid", Gyroid, 0.1 }, { "metaballs", Metaballs, 0.55 } };

/// Ten times denser at one side than at the other, by a ramp or by a step.
enum Density
{
  Uniform,
  Ramp,
  Step
};

double GetDensity(Density density, double x)
{
  // The mean is 1.
  x = std::clamp(x, -1.0, 1.0);
  return density == Uniform ? 1 : density == Ramp ? (5.5 + 4.5 * x) / 5.5 : (x < 0 ? 1 : 10) / 5.5;
}

double GetSpacing(Density density, int count, double x)
{
  return std::cbrt(8 / (count * GetDensity(density, x)));
}

vtkSmartPointer<vtkPolyData> Scatter(const Field& field, Density density, int count)
{
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(7);
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> values;
  values->SetName("Field");
  while (points->GetNumberOfPoints() < count)
  {
    double p[4];
    for (double& x : p)
    {
      x = random->GetNextRangeValue(-1, 1);
    }
    if (GetDensity(density, p[0]) >= (p[3] + 1) / 2 * GetDensity(density, 1))
    {
      points->InsertNextPoint(p);
      values->InsertNextValue(field.Get(p));
    }
  }
  auto samples = vtkSmartPointer<vtkPolyData>::New();
  samples->SetPoints(points);
  samples->GetPointData()->SetScalars(values);
  return samples;
}

double Quantile(std::vector<double>& values, double q)
{
  std::sort(values.begin(), values.end());
  return values.empty() ? 1e300 : values[static_cast<std::size_t>(q * (values.size() - 1))];
}

struct Measured
{
  double Median, Percentile95, Normals, Gap, Nearest;
};

/// In spacings of the samples, or of the points where that is given.
Measured Measure(
  const Field& field, Density density, int count, vtkPolyData* surface, double spacing)
{
  std::vector<double> distances, angles;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3], n[3], g[3];
    surface->GetPoint(i, p);
    surface->GetPointData()->GetNormals()->GetTuple(i, n);
    const double difference = field.Evaluate(p, g);
    const double h = GetSpacing(density, count, p[0]);
    distances.push_back(std::abs(difference) / vtkMath::Norm(g) / h);
    angles.push_back(
      vtkMath::DegreesFromRadians(
      std::acos(std::clamp(-vtkMath::Dot(n, g) / vtkMath::Norm(g), -1.0, 1.0))));
  }
  Measured measured;
  measured.Median = Quantile(distances, 0.5);
  measured.Percentile95 = Quantile(distances, 0.95);
  measured.Normals = Quantile(angles, 0.5);

  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(surface);
  locator->BuildLocator();
  auto to = [&](const double p[3], int rank) {
    vtkNew<vtkIdList> ids;
    locator->FindClosestNPoints(rank, p, ids);
    double x[3];
    surface->GetPoint(ids->GetId(rank - 1), x);
    return std::sqrt(vtkMath::Distance2BetweenPoints(p, x)) /
      (spacing > 0 ? spacing : GetSpacing(density, count, p[0]));
  };
  // Places on the surface, but for a border of the cube.
  measured.Gap = 0;
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(3);
  for (int i = 0; i < 10000; ++i)
  {
    double p[3], g[3];
    for (double& x : p)
    {
      x = random->GetNextRangeValue(-1, 1);
    }
    double difference = 1;
    for (int step = 0; step < 20 && std::abs(difference) > 1e-9; ++step)
    {
      difference = field.Evaluate(p, g);
      const double squared = vtkMath::Dot(g, g) + 1e-12;
      for (int c = 0; c < 3; ++c)
      {
        p[c] -= std::clamp(difference / squared * g[c], -0.1, 0.1);
      }
    }
    const double inside = 1 - 1.5 * GetSpacing(density, count, p[0]);
    if (std::abs(difference) <= 1e-9 && std::abs(p[0]) < inside && std::abs(p[1]) < inside &&
      std::abs(p[2]) < inside)
    {
      measured.Gap = std::max(measured.Gap, to(p, 1));
    }
  }
  std::vector<double> nearest;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3];
    surface->GetPoint(i, p);
    nearest.push_back(to(p, 2));
  }
  measured.Nearest = Quantile(nearest, 0.0);
  return measured;
}

/// Points of 4 fields, 3 densities: the figures that are reached, with a fifth to spare.
void Accuracy(int count, double spacing)
{
  for (const Field& field : fields)
  {
    for (const Density density : { Uniform, Ramp, Step })
    {
      vtkSmartPointer<vtkPolyData> samples = Scatter(field, density, count);
      vtkNew<vtkIsosurfacePoints> filter;
      filter->SetInputData(samples);
      filter->SetValue(0, field.Isovalue);
      filter->SetPointSpacing(spacing);
      filter->Update();
      const Measured m = Measure(field, density, count, filter->GetOutput(), spacing);
      const std::string name = std::string(field.Name) + ", " + std::to_string(count) +
        " samples " + (density == Uniform ? "uniform" : density == Ramp ? "on a ramp" : "with a step") +
        ", spacing " + std::to_string(spacing);
      std::printf("%s: %d points, distances %.4f %.4f, normals %.2f, gap %.2f, nearest %.2f\n",
        name.c_str(), static_cast<int>(filter->GetOutput()->GetNumberOfPoints()), m.Median,
        m.Percentile95, m.Normals, m.Gap, m.Nearest);
      const double step = density == Step ? 2 : 1;
      AtMost(m.Median, 0.009, name + ": median distance");
      AtMost(m.Percentile95, 0.032 * step, name + ": 95th percentile of distances");
      AtMost(m.Normals, 1.6, name + ": median angle of normals");
      AtMost(m.Gap, spacing == 0 ? 1.5 : 1.5 * step, name + ": widest gap");
      // Both sides of a step have their own spacing.
      AtMost(spacing == 0 ? 0.35 : 0.79, m.Nearest, name + ": nearest points");
    }
  }
}
}

int TestIsosurfaceScatter(int, char*[])
{
  Accuracy(10000, 0.0);
  Accuracy(50000, 0.0);
  Accuracy(50000, 0.03);
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
