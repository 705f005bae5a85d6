// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Points without a surface: along a line and a helix, with normals and without, in a volume, and
// scattered about a sphere. From whatever side they are seen, every point draws at least a pixel.
#include "SplatScene.h"

#include "vtkMath.h"
#include "vtkMatrix4x4.h"

#include <algorithm>

namespace
{
using namespace SplatScene;

/// Without normals if there are none.
vtkSmartPointer<vtkPolyData> MakeCloud(int count, const double* normal,
  const std::function<void(int, double*)>& place)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  for (int i = 0; i < count; ++i)
  {
    double p[3];
    place(i, p);
    points->InsertNextPoint(p);
    if (normal)
    {
      normals->InsertNextTuple(normal);
    }
  }
  auto cloud = vtkSmartPointer<vtkPolyData>::New();
  cloud->SetPoints(points);
  if (normal)
  {
    cloud->GetPointData()->SetNormals(normals);
  }
  return cloud;
}

/// How many of the points from `first` on have no drawn pixel whose centre is within 3/4 of one.
int CountMissing(Window& window, vtkPolyData* cloud, vtkIdType first)
{
  const Picture picture = window.Draw();
  vtkMatrix4x4* matrix =
    window.Renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(1, -1, 1);
  int missing = 0;
  for (vtkIdType i = first; i < cloud->GetNumberOfPoints(); ++i)
  {
    double p[4] = { 0, 0, 0, 1 }, q[4];
    cloud->GetPoint(i, p);
    matrix->MultiplyPoint(p, q);
    const double x = 0.5 * (q[0] / q[3] + 1) * picture.Width;
    const double y = 0.5 * (q[1] / q[3] + 1) * picture.Height;
    bool drawn = false;
    for (int k = 0; k < 9; ++k)
    {
      const int column = static_cast<int>(std::floor(x)) + k % 3 - 1;
      const int row = static_cast<int>(std::floor(y)) + k / 3 - 1;
      const bool isNear = std::abs(column + 0.5 - x) < 0.75 && std::abs(row + 0.5 - y) < 0.75 &&
        column >= 0 && row >= 0 && column < picture.Width && row < picture.Height;
      drawn = drawn || (isNear && !picture.IsBackground(column, row));
    }
    missing += !drawn;
  }
  return missing;
}

void Look(Checks& checks, const std::string& name, vtkPolyData* cloud, vtkIdType first = 0)
{
  const double directions[6][3] = { { 0, -1, 0 }, { 1, 0, 0 }, { 0.01, 0, 1 }, { 0.4, 0.7, 0.5 },
    { -0.7, 0.6, -0.4 }, { 0.7, -0.7, 0 } };
  for (int projection : { vtkPointSplatMapper::AUTOMATIC_PROJECTION, vtkPointSplatMapper::QUADS })
  {
    for (int size : { 300, 512 })
    {
      vtkNew<vtkPointSplatMapper> mapper;
      mapper->SetInputData(cloud);
      mapper->SetProjection(projection);
      Window window(size);
      window.Add(mapper);
      vtkCamera* camera = window.Renderer->GetActiveCamera();
      camera->SetFocalPoint(0, 0, 0);
      int most = 0;
      for (const double* d : directions)
      {
        camera->SetFocalPoint(0, 0, 0);
        camera->SetPosition(d);
        camera->SetViewUp(0.2, 0.3, 1);
        window.Renderer->ResetCamera();
        most = std::max(most, CountMissing(window, cloud, first));
      }
      checks.AtMost(most, 0, name + ", " + std::to_string(size) + " pixels, projection " +
        std::to_string(projection) + ": points that are not drawn");
    }
  }
}
}

int TestSplatsBodies(int, char*[])
{
  Checks checks;
  const int count = 500;
  const auto line = [](int i, double* p) {
    p[0] = i / 500.0;
    p[1] = 0.3 * p[0];
    p[2] = 0;
  };
  const auto helix = [](int i, double* p) {
    const double turns = 5.0 * i / 499, angle = 2 * vtkMath::Pi() * turns;
    p[0] = std::cos(angle);
    p[1] = std::sin(angle);
    p[2] = 0.5 * turns;
  };
  const double up[3] = { 0, 0, 1 }, across[3] = { 1, 0, 0 };
  Look(checks, "line", MakeCloud(count, nullptr, line));
  Look(checks, "line, normals across it", MakeCloud(count, up, line));
  Look(checks, "line, normals nearly along it", MakeCloud(count, across, line));
  Look(checks, "helix", MakeCloud(count, nullptr, helix));
  Look(checks, "helix, normals along its axis", MakeCloud(count, up, helix));

  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(5);
  const auto next = [&random]() {
    random->Next();
    return random->GetValue();
  };
  const auto volume = [&next](int, double* p) {
    std::generate_n(p, 3, next);
  };
  Look(checks, "volume", MakeCloud(count, nullptr, volume));
  // A sphere, and a hundredth of its points about it.
  const int surface = 10000;
  Look(checks, "spray", MakeCloud(surface + surface / 100, nullptr, [&](int i, double* p) {
    const double z = 2 * next() - 1, angle = 2 * vtkMath::Pi() * next(), r = std::sqrt(1 - z * z);
    const double ball[3] = { r * std::cos(angle), r * std::sin(angle), z };
    for (int c = 0; c < 3; ++c)
    {
      p[c] = i < surface ? ball[c] : 6 * (next() - 0.5);
    }
  }), surface);
  return checks.Result();
}
