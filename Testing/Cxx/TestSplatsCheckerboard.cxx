// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// A checkerboard plane to the horizon (Guennebaud, Barthe, Paulin 2006, figure 3)
// against the closed-form board, supersampled: sharp near by, grey and without moire
// far off.
#include "SplatScene.h"

#include "vtkActorCollection.h"
#include "vtkMath.h"

namespace
{
using namespace SplatScene;

constexpr int Points = 400;   // in a row
constexpr double Extent = 20; // the board is from -Extent to Extent
constexpr double Field = 1.0; // the width of its fields

double Board(double x, double y)
{
  const long i = static_cast<long>(std::floor(x / Field)) + static_cast<long>(std::floor(y / Field));
  return i % 2 == 0 ? 1.0 : 0.0;
}
}

int TestSplatsCheckerboard(int, char*[])
{
  Checks checks;
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetName("board");
  colours->SetNumberOfComponents(3);
  for (int j = 0; j < Points; ++j)
  {
    for (int i = 0; i < Points; ++i)
    {
      const double x = 2.0 * Extent * (i + 0.5) / Points - Extent;
      const double y = 2.0 * Extent * (j + 0.5) / Points - Extent;
      points->InsertNextPoint(x, y, 0.0);
      normals->InsertNextTuple3(0, 0, 1);
      const double c = 40 + 200 * Board(x, y);
      colours->InsertNextTuple3(c, c, c);
    }
  }
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);
  cloud->GetPointData()->SetNormals(normals);
  cloud->GetPointData()->SetScalars(colours);

  Window window;
  vtkNew<vtkPointSplatMapper> mapper;
  mapper->SetInputData(cloud);
  window.Add(mapper)->GetProperty()->LightingOff();
  window.Renderer->GetActors()->GetLastActor()->GetProperty()->SetAmbient(0);
  vtkCamera* camera = window.Renderer->GetActiveCamera();
  camera->SetPosition(0, -Extent + 1.0, 1.0);
  camera->SetFocalPoint(0, Extent, 0.0);
  camera->SetViewUp(0, 0, 1);
  camera->SetViewAngle(40);
  camera->SetClippingRange(0.1, 60);
  const Picture picture = window.Draw();

  // Rows of the picture by how far off the plane is there.
  double error[3] = { 0, 0, 0 };
  double variation[3] = { 0, 0, 0 };
  double exactVariation[3] = { 0, 0, 0 };
  long count[3] = { 0, 0, 0 };
  const double tangent = std::tan(20.0 * M_PI / 180.0);
  double forward[3], up[3] = { 0, 0, 1 }, right[3], upward[3];
  camera->GetDirectionOfProjection(forward);
  vtkMath::Cross(forward, up, right);
  vtkMath::Normalize(right);
  vtkMath::Cross(right, forward, upward);
  constexpr int Samples = 8;
  for (int y = 0; y < Size; ++y)
  {
    double before = -1.0, exactBefore = -1.0;
    for (int x = 0; x < Size; ++x)
    {
      double exact = 0.0, distance = 0.0;
      bool on = true;
      for (int s = 0; s < Samples * Samples && on; ++s)
      {
        const double u = (2.0 * (x + (s % Samples + 0.5) / Samples) / Size - 1.0) * tangent;
        const double v = (2.0 * (y + (s / Samples + 0.5) / Samples) / Size - 1.0) * tangent;
        double d[3];
        for (int k = 0; k < 3; ++k)
        {
          d[k] = forward[k] + u * right[k] + v * upward[k];
        }
        const double t = d[2] < 0.0 ? -1.0 / d[2] : 0.0;
        const double px = t * d[0];
        const double py = -Extent + 1.0 + t * d[1];
        on = t > 0.0 && std::abs(px) < Extent - 0.3 && py < Extent - 0.3;
        exact += (40 + 200 * Board(px, py)) / (Samples * Samples);
        distance = t;
      }
      if (!on)
      {
        before = -1.0;
        continue;
      }
      const int zone = distance < 6.0 ? 0 : distance < 15.0 ? 1 : 2;
      const double drawn = picture.At(x, y)[0];
      error[zone] += std::abs(drawn - exact);
      ++count[zone];
      if (before >= 0.0)
      {
        variation[zone] += std::abs(drawn - before);
        exactVariation[zone] += std::abs(exact - exactBefore);
      }
      before = drawn;
      exactBefore = exact;
    }
  }
  const char* names[3] = { "near", "middle", "far" };
  // Mean errors, of 255. Near by only the fields' edges are soft; far off fields are
  // of pixels' size.
  const double bounds[3] = { 8.5, 9.5, 26.0 };
  for (int zone = 0; zone < 3; ++zone)
  {
    const double mean = error[zone] / std::max(count[zone], 1L);
    std::cout << names[zone] << ": " << count[zone] << " pixels, mean error " << mean
              << ", variation along rows " << variation[zone] / std::max(exactVariation[zone], 1e-9)
              << " of the exact\n";
    checks.AtLeast(count[zone], 1000L, std::string(names[zone]) + ": pixels");
    checks.AtMost(mean, bounds[zone], std::string(names[zone]) + ": mean error");
    // Moire would vary more than the filtered board does; the prefilter is narrower than a
    // pixel, for sharpness, and leaves some.
    checks.AtMost(variation[zone], 1.35 * exactVariation[zone],
      std::string(names[zone]) + ": variation along rows");
  }
  return checks.Result();
}
