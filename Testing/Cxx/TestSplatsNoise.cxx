// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// By default a noisy cloud, with or without normals, is drawn where vtkPointSplatProjection moves its points, and layers that lie upon one
// another are drawn where they are: they contradict one another as noise does, but do so still, and are rough still, once
// they are projected. So are isosurfaces of noisy volumes, whose relief it is.
#include "SplatScene.h"

#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkPlatonicSolidSource.h"
#include "vtkPointSplatEstimation.h"

#include <cmath>
#include <string>

namespace
{
using namespace SplatScene;

constexpr int Count = 2000; // points on the unit sphere
constexpr int Rows = 120;   // of points on the wall

/// Of unit deviation, from two uniform numbers between 0 and 1 (Box, Muller 1958).
double Gaussian(double u, double v)
{
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
      const double u = random->GetNextValue(), v = random->GetNextValue();
      const double r = radius + noise * Gaussian(u, v);
      points->InsertNextPoint(r * n[0], r * n[1], r * n[2]);
      normals->InsertNextTuple(n);
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->GetPointData()->SetNormals(normals);
  return data;
}

/// A slanting wall, as it is or as a depth camera sees it from far away: rows of points, one unit apart, with noise and in steps.
vtkSmartPointer<vtkPolyData> MakeWall(bool seen)
{
  constexpr double slope = 0.3, step = 3.0;
  int i = 0;
  return RandomCloud(Rows * Rows, [&](double u, double v, double* p, double* n) {
    p[0] = i % Rows;
    p[1] = i / Rows;
    p[2] = seen ? step * std::round((slope * p[0] + Gaussian(u, v)) / step) : slope * p[0];
    n[0] = -slope;
    n[1] = 0.0;
    n[2] = 1.0;
    vtkMath::Normalize(n);
    ++i;
  });
}

/// The vertices of an isosurface, a ball's, in a volume with noise of 0.4 voxels.
vtkSmartPointer<vtkPolyData> MakeIsosurface()
{
  constexpr int size = 48;
  vtkNew<vtkImageData> image;
  image->SetDimensions(size, size, size);
  image->SetSpacing(0.7, 0.7, 0.7);
  image->AllocateScalars(VTK_FLOAT, 1);
  float* value = static_cast<float*>(image->GetScalarPointer());
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(1);
  for (int i = 0; i < size * size * size; ++i)
  {
    const double x[3] = { i % size - 23.7, i / size % size - 23.7, i / (size * size) - 23.7 };
    const double u = random->GetNextValue(), v = random->GetNextValue();
    value[i] = static_cast<float>(20 - vtkMath::Norm(x) + 0.4 * Gaussian(u, v));
  }
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(image);
  contour->SetValue(0, 0.0);
  contour->ComputeScalarsOff();
  contour->Update();
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(contour->GetOutput()->GetPoints());
  data->GetPointData()->SetNormals(contour->GetOutput()->GetPointData()->GetNormals());
  return data;
}

/// The same points, moved by up to a fiftieth of a voxel, so that they lie on no lattice.
vtkSmartPointer<vtkPolyData> OffLattice(vtkPolyData* cloud)
{
  auto moved = vtkSmartPointer<vtkPolyData>::New();
  moved->DeepCopy(cloud);
  for (vtkIdType id = 0; id < moved->GetNumberOfPoints(); ++id)
  {
    double x[3];
    cloud->GetPoint(id, x);
    moved->GetPoints()->SetPoint(
      id, x[0] + 0.02 * std::sin(x[1]), x[1] + 0.02 * std::sin(x[2]), x[2] + 0.02 * std::sin(x[0]));
  }
  return moved;
}

/// A cloud's points alone.
vtkSmartPointer<vtkPolyData> WithoutNormals(vtkPolyData* cloud)
{
  auto bare = vtkSmartPointer<vtkPolyData>::New();
  bare->SetPoints(cloud->GetPoints());
  return bare;
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

  const auto bare = WithoutNormals(noisy);
  const Picture guessed = Draw(bare, true, choices);
  checks.Expect(isProjected(), "a noisy sphere without normals projected");
  checks.AtLeast(Psnr(smooth, guessed), Psnr(smooth, Draw(bare, false, choices)) + 3.0,
    "psnr of the noisy sphere without normals projected");
  Draw(WithoutNormals(MakeShells(1, 0, 0)), true, choices);
  checks.Expect(!isProjected(), "a smooth sphere without normals as given");
  vtkNew<vtkPlatonicSolidSource> solid;
  solid->SetSolidTypeToIcosahedron();
  solid->Update();
  Draw(WithoutNormals(solid->GetOutput()), true, choices);
  checks.Expect(!isProjected(), "twelve points as given");

  const auto layers = MakeShells(3, 1.6 * spacing, 0);
  const Picture layered = Draw(layers, true, choices);
  checks.Expect(!isProjected(), "layers as given");
  checks.AtMost(LargestDifference(layered, Draw(layers, false, choices)), 0, "layers as given");

  const auto isosurface = MakeIsosurface();
  Draw(isosurface, true, choices);
  checks.Expect(!isProjected(), "a noisy volume's isosurface as given");
  vtkNew<vtkPointSplatEstimation> estimation;
  estimation->SetInputData(isosurface);
  estimation->Update();
  checks.Expect(estimation->IsRough() && estimation->GetContradiction() == 0, "the volume's noise is relief");
  estimation->SetInputData(OffLattice(isosurface));
  estimation->Update();
  checks.Expect(estimation->IsNoisy(), "off the lattice it is noise");
  estimation->ReliefOn();
  estimation->Update();
  checks.Expect(!estimation->IsNoisy() && estimation->GetContradiction() > 0, "unless it is known to be relief");

  const Picture even = Draw(MakeWall(false), true, choices);
  const auto steps = MakeWall(true);
  const Picture settled = Draw(steps, true, choices);
  checks.Expect(isProjected(), "a wall in steps projected");
  checks.AtLeast(Psnr(even, settled), Psnr(even, Draw(steps, false, choices)) + 4.0, "psnr of the wall projected");
  return checks.Result();
}
