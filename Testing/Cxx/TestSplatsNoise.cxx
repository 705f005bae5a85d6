// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// By default a noisy cloud is drawn where vtkPointSplatProjection moves its points, and layers that lie upon one
// another are drawn where they are: they contradict one another as noise does, but do so still, and are rough still, once
// they are projected.
#include "SplatScene.h"

#include <string>

namespace
{
using namespace SplatScene;

constexpr int Count = 2000; // points on the unit sphere
constexpr int Rows = 120;   // of points on the wall

/// One standard deviation, at random.
double Gaussian(vtkMinimalStandardRandomSequence* random)
{
  const double u = random->GetNextValue(), v = random->GetNextValue();
  return std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * M_PI * v);
}

/// Points of even density, in shells. noise: the standard deviation of their radii.
vtkSmartPointer<vtkPolyData> MakeShells(int shells, double apart, double noise)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(1);
  for (int shell = 0; shell < shells; ++shell)
  {
    const double radius = 1.0 + shell * apart;
    const int count = static_cast<int>(Count * radius * radius);
    for (int i = 0; i < count; ++i)
    {
      const double z = 1.0 - (2.0 * i + 1.0) / count, across = std::sqrt(1.0 - z * z);
      const double angle = M_PI * (1.0 + std::sqrt(5.0)) * i; // a turn's golden section on
      const double n[3] = { across * std::cos(angle), across * std::sin(angle), z };
      const double r = radius + noise * Gaussian(random);
      points->InsertNextPoint(r * n[0], r * n[1], r * n[2]);
      normals->InsertNextTuple(n);
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->GetPointData()->SetNormals(normals);
  return data;
}

/// A slanting wall as a depth camera sees it from far away: rows of points, one unit apart, with noise and in steps.
vtkSmartPointer<vtkPolyData> MakeWall(double slope, double noise, double step)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(1);
  const double across = std::sqrt(1.0 + slope * slope);
  for (int i = 0; i < Rows * Rows; ++i)
  {
    const double x = i % Rows, y = i / Rows, depth = slope * x + noise * Gaussian(random);
    points->InsertNextPoint(x, y, step > 0.0 ? step * std::round(depth / step) : depth);
    normals->InsertNextTuple3(-slope / across, 0.0, 1.0 / across);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->GetPointData()->SetNormals(normals);
  return data;
}

/// Draws a cloud, and says in choices how.
Picture Draw(vtkPolyData* cloud, bool projects, std::string& choices)
{
  Window window;
  vtkNew<vtkPointSplatMapper> mapper;
  mapper->SetInputData(cloud);
  mapper->SetProjectNoise(projects);
  window.Add(mapper);
  window.Renderer->ResetCamera();
  const Picture picture = window.Draw();
  choices = mapper->GetChoices();
  return picture;
}
}

int TestSplatsNoise(int, char*[])
{
  Checks checks;
  const double spacing = std::sqrt(4.0 * M_PI / Count);
  std::string choices;
  const auto isProjected = [&choices]() { return choices.find("points: projected") != std::string::npos; };

  const Picture smooth = Draw(MakeShells(1, 0, 0), true, choices);
  checks.Expect(!isProjected(), "a smooth sphere as given");
  const auto noisy = MakeShells(1, 0, 0.35 * spacing);
  const Picture projected = Draw(noisy, true, choices);
  checks.Expect(isProjected(), "a noisy sphere projected");
  const Picture given = Draw(noisy, false, choices);
  checks.Expect(!isProjected(), "switched off");
  checks.AtLeast(Psnr(smooth, projected), Psnr(smooth, given) + 5.0, "psnr of the noisy sphere projected");

  const auto layers = MakeShells(3, 1.6 * spacing, 0);
  const Picture layered = Draw(layers, true, choices);
  checks.Expect(!isProjected(), "layers as given");
  checks.AtMost(LargestDifference(layered, Draw(layers, false, choices)), 0, "layers as given");

  const Picture even = Draw(MakeWall(0.3, 0.0, 0.0), true, choices);
  const auto steps = MakeWall(0.3, 1.0, 3.0);
  const Picture settled = Draw(steps, true, choices);
  checks.Expect(isProjected(), "a wall in steps projected");
  checks.AtLeast(Psnr(even, settled), Psnr(even, Draw(steps, false, choices)) + 4.0, "psnr of the wall projected");
  return checks.Result();
}
