// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Between a red and a green splat, the colour is that which the kernels' equations
// give (Pajarola, Sainz, Guidotti 2004, equations 7, 9 and 10).
#include "SplatScene.h"

namespace
{
using namespace SplatScene;

using Kernel = std::function<double(double)>;

void Blend(Checks& checks, const std::string& name, vtkPointSplatMapper* mapper,
  double radius, double support, const Kernel& kernel)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> radii;
  radii->SetName("SplatRadius");
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  for (int i = 0; i < 2; ++i)
  {
    points->InsertNextPoint(i, 0, 0);
    normals->InsertNextTuple3(0, 0, 1);
    radii->InsertNextValue(static_cast<float>(radius));
    colours->InsertNextTuple3(i == 0 ? 255 : 0, i == 1 ? 255 : 0, 0);
  }
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);
  cloud->GetPointData()->SetNormals(normals);
  cloud->GetPointData()->AddArray(radii);
  cloud->GetPointData()->SetScalars(colours);
  mapper->SetInputData(cloud);

  Window window;
  vtkActor* actor = window.Add(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetAmbient(0);
  vtkCamera* camera = window.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetPosition(0.5, 0, 5);
  camera->SetFocalPoint(0.5, 0, 0);
  camera->SetParallelScale(1.0);
  camera->SetClippingRange(1, 10);
  const Picture picture = window.Draw();
  int compared = 0;
  double worst = 0.0;
  for (int x = 0; x < Size; ++x)
  {
    const double at = 2.0 * (x + 0.5) / Size - 0.5;
    const double y = 1.0 / Size;
    const double r[2] = { std::sqrt(at * at + y * y) / radius,
      std::sqrt((1 - at) * (1 - at) + y * y) / radius };
    // Where a disk is drawn, and both kernels reach or the other surely does not.
    if (std::min(r[0], r[1]) > 1.1)
    {
      continue;
    }
    const double w[2] = { r[0] < support ? kernel(r[0]) : 0.0,
      r[1] < support ? kernel(r[1]) : 0.0 };
    const double expected = 255.0 * w[0] / (w[0] + w[1]);
    worst = std::max(worst, std::abs(expected - picture.At(x, Size / 2)[0]));
    ++compared;
  }
  std::cout << name << ": " << compared << " pixels, worst difference " << worst << "\n";
  checks.AtLeast(compared, 100, name + ": pixels");
  // Weights are kept to 1/256.
  checks.AtMost(worst, 4.0, name + ": difference of 255");
}
}

int TestSplatsKernels(int, char*[])
{
  Checks checks;
  for (const bool quads : { false, true })
  {
    const std::string by = quads ? ", quads" : "";
    for (const double sigma : { 0.3, 0.6, 1.0 })
    {
      vtkNew<vtkPointSplatMapper> mapper;
      mapper->SetProjection(
        quads ? vtkPointSplatMapper::QUADS : vtkPointSplatMapper::AUTOMATIC_PROJECTION);
      mapper->SetKernelSigma(sigma);
      Blend(checks, "Gaussian " + std::to_string(sigma) + by, mapper, 0.9, 1.5,
        [sigma](double r) { return std::exp(-r * r / (2.0 * sigma * sigma)); });
    }
    vtkNew<vtkPointSplatMapper> mapper;
    mapper->SetProjection(
      quads ? vtkPointSplatMapper::QUADS : vtkPointSplatMapper::AUTOMATIC_PROJECTION);
    mapper->SetKernelToPlateau();
    mapper->SetPlateauFalloff(3.0);
    mapper->SetPlateauExponent(4.0);
    mapper->SetKernelSupport(1.4);
    Blend(checks, "plateau" + by, mapper, 0.9, 1.4, [](double r) {
      const double x = std::pow(r / 1.4, 4.0);
      return x < 1.0 ? std::exp(-3.0 * x / (1.0 - x)) : 0.0;
    });
    vtkNew<vtkPointSplatMapper> scaled;
    scaled->SetProjection(
      quads ? vtkPointSplatMapper::QUADS : vtkPointSplatMapper::AUTOMATIC_PROJECTION);
    scaled->SetRadiusScale(0.5);
    Blend(checks, "half the radii" + by, scaled, 1.8, 0.75,
      [](double r) { return std::exp(-4.0 * r * r / 0.72); });
  }
  return checks.Result();
}
