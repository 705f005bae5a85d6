// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// An isosurface's points are drawn with the sizes that they bring: nothing is estimated, and thin
// vessels look as their mesh does.
#include "Expect.h"
#include "SplatScene.h"

#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkIsosurfacePoints.h"
#include "vtkPointSplatArrays.h"

#include <algorithm>
#include <iostream>
#include <string>

namespace
{
constexpr int Samples = 56;

/// Vessels of 0.7 to 2 voxels' radius as a scanner has them, and specks between them.
vtkSmartPointer<vtkImageData> Vessels()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(Samples, Samples, Samples);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* values = static_cast<unsigned char*>(image->GetScalarPointer());
  vtkNew<vtkMinimalStandardRandomSequence> sequence;
  sequence->SetSeed(5);
  auto random = [&](double a, double b) {
    sequence->Next();
    return sequence->GetRangeValue(a, b);
  };
  double specks[60][4];
  for (auto& speck : specks)
  {
    for (int c = 0; c < 3; ++c)
    {
      speck[c] = random(4, Samples - 5);
    }
    speck[3] = random(0.5, 1.2);
  }
  for (int k = 0; k < Samples; ++k)
  {
    for (int j = 0; j < Samples; ++j)
    {
      for (int i = 0; i < Samples; ++i)
      {
        double least = 100;
        for (int v = 0; v < 5; ++v)
        {
          // One beside the other, each thicker and more bent than the one before.
          const double x = 8 + 10 * v + (1 + v) * std::sin(0.15 * k + v);
          const double y = Samples / 2 + 8 * std::sin(0.1 * k + 2 * v);
          least = std::min(least, std::hypot(i - x, j - y) - (0.7 + 0.325 * v));
        }
        for (const auto& s : specks)
        {
          least = std::min(least,
            std::sqrt((i - s[0]) * (i - s[0]) + (j - s[1]) * (j - s[1]) + (k - s[2]) * (k - s[2])) -
              s[3]);
        }
        *values++ =
          static_cast<unsigned char>(std::lround(255 * std::clamp(0.5 - least / 2, 0.0, 1.0)));
      }
    }
  }
  return image;
}

void LookAt(SplatScene::Window& window, int view)
{
  vtkCamera* camera = window.Renderer->GetActiveCamera();
  camera->SetPosition(0, 0, 1);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetViewUp(0, 1, 0);
  const double bounds[6] = { 0, Samples, 0, Samples, 0, Samples };
  window.Renderer->ResetCamera(bounds);
  camera->Azimuth(25 + 95 * view);
  camera->Elevation(20 - 15 * view);
  window.Renderer->ResetCameraClippingRange(bounds);
}
}

int TestSplatsOfIsosurface(int, char*[])
{
  const double isovalue = 118;
  vtkSmartPointer<vtkImageData> image = Vessels();
  vtkNew<vtkIsosurfacePoints> points;
  points->SetInputData(image);
  points->SetValue(0, isovalue);
  vtkNew<vtkPointSplatMapper> splats;
  splats->SetInputConnection(points->GetOutputPort());
  splats->ScalarVisibilityOff();
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(image);
  contour->SetValue(0, isovalue);
  contour->ComputeScalarsOff();
  vtkNew<vtkPolyDataMapper> triangles;
  triangles->SetInputConnection(contour->GetOutputPort());

  SplatScene::Window drawn(400), reference(400);
  drawn.Add(splats);
  reference.Add(triangles);
  for (int view = 0; view < 3; ++view)
  {
    LookAt(drawn, view);
    LookAt(reference, view);
    const SplatScene::Picture a = drawn.Draw(), b = reference.Draw();
    int spilt = 0, missing = 0, covered = 0;
    for (int y = 2; y < a.Height - 2; ++y)
    {
      for (int x = 2; x < a.Width - 2; ++x)
      {
        int meshes = 0; // pixels of the mesh among the 25 around
        for (int dy = -2; dy <= 2; ++dy)
        {
          for (int dx = -2; dx <= 2; ++dx)
          {
            meshes += !b.IsBackground(x + dx, y + dy);
          }
        }
        covered += !b.IsBackground(x, y);
        spilt += meshes == 0 && !a.IsBackground(x, y);
        missing += meshes == 25 && a.IsBackground(x, y);
      }
    }
    const std::string name = "view " + std::to_string(view);
    Expect(covered > 5000, name + ": the mesh is seen, " + std::to_string(covered) + " pixels");
    Expect(missing == 0, name + ": " + std::to_string(missing) + " pixels are holes");
    Expect(spilt < 0.01 * covered,
      name + ": " + std::to_string(spilt) + " pixels spilt of " + std::to_string(covered));
  }
  // The radii that the points bring are those that are drawn: a tenth of them is a tenth.
  LookAt(drawn, 0);
  const SplatScene::Picture whole = drawn.Draw();
  vtkNew<vtkPolyData> small;
  small->DeepCopy(points->GetOutput());
  vtkDataArray* radii = small->GetPointData()->GetArray(vtkPointSplatArrays::Radius);
  Expect(radii != nullptr, "the points bring their radii");
  for (vtkIdType i = 0; radii && i < radii->GetNumberOfTuples(); ++i)
  {
    radii->SetComponent(i, 0, 0.1 * radii->GetComponent(i, 0));
  }
  splats->SetInputData(small);
  const int part = drawn.Draw().CountDrawn();
  Expect(3 * part < whole.CountDrawn(),
    "points of a tenth of their radius cover " + std::to_string(part) + " pixels of " +
      std::to_string(whole.CountDrawn()));

  // Back in the pipeline, and changed there.
  splats->SetInputConnection(points->GetOutputPort());
  Expect(drawn.Draw().Pixels == whole.Pixels, "the same points, another picture");
  points->SetValue(0, 60);
  Expect(drawn.Draw().CountDrawn() > whole.CountDrawn(), "a lower isovalue has thicker vessels");
  // Without them the mapper estimates.
  points->SetValue(0, isovalue);
  points->SplatSizesOff();
  const SplatScene::Picture estimated = drawn.Draw();
  Expect(estimated.Pixels != whole.Pixels, "switched off, but drawn by the filter's sizes");
  Expect(estimated.CountDrawn() > whole.CountDrawn() / 2, "nothing is drawn without sizes");
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
