// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Smooth outlines: against the mesh's picture that is drawn with many samples a pixel.
#include "SplatScene.h"

#include "vtkParametricFunctionSource.h"
#include "vtkParametricTorus.h"
#include "vtkPlaneSource.h"

namespace
{
using namespace SplatScene;

constexpr int Samples = 4; // of the reference, along each side of a pixel

vtkSmartPointer<vtkPolyData> MakeTorusMesh()
{
  vtkNew<vtkParametricTorus> torus;
  torus->SetRingRadius(1.0);
  torus->SetCrossSectionRadius(0.4);
  vtkNew<vtkParametricFunctionSource> source;
  source->SetParametricFunction(torus);
  source->SetUResolution(300);
  source->SetVResolution(150);
  source->Update();
  return source->GetOutput();
}

/// Means of Samples x Samples pixels.
Picture Reduce(const Picture& fine)
{
  Picture mean;
  mean.Width = fine.Width / Samples;
  mean.Height = fine.Height / Samples;
  mean.Pixels.resize(static_cast<size_t>(3 * mean.Width * mean.Height));
  for (int y = 0; y < mean.Height; ++y)
  {
    for (int x = 0; x < mean.Width; ++x)
    {
      for (int c = 0; c < 3; ++c)
      {
        int sum = 0;
        for (int k = 0; k < Samples * Samples; ++k)
        {
          sum += fine.At(Samples * x + k % Samples, Samples * y + k / Samples)[c];
        }
        mean.Pixels[static_cast<size_t>(3 * (y * mean.Width + x) + c)] =
          static_cast<unsigned char>((sum + Samples * Samples / 2) / (Samples * Samples));
      }
    }
  }
  return mean;
}

struct Scene
{
  std::string Name;
  double Opacity = 1.0;
  bool Parallel = false;
  int Lists = 0;
  bool Multisampled = false;
};

/// A torus, and a mesh of a ball through its hole.
Picture Draw(const Scene& scene, bool mesh, bool smooth)
{
  Window window(mesh ? Samples * Size : Size);
  window.SmoothOutlines = smooth;
  window.Win->SetMultiSamples(scene.Multisampled ? 4 : 0);
  window.Renderer->SetBackground(0.1, 0.2, 0.4);
  vtkSmartPointer<vtkPolyData> torus = MakeTorusMesh();
  vtkSmartPointer<vtkMapper> mapper;
  if (mesh)
  {
    auto polygons = vtkSmartPointer<vtkPolyDataMapper>::New();
    polygons->SetInputData(torus);
    mapper = polygons;
    window.Renderer->UseDepthPeelingOn();
    window.Renderer->SetMaximumNumberOfPeels(8);
    window.Renderer->SetOcclusionRatio(0.0);
  }
  else
  {
    auto splats = vtkSmartPointer<vtkPointSplatMapper>::New();
    splats->SetInputData(Cloud(torus));
    splats->SetTileLists(scene.Lists);
    mapper = splats;
  }
  if (scene.Multisampled)
  {
    vtkNew<vtkPolyDataMapper> ball;
    ball->SetInputData(MakeSphereMesh());
    window.Add(ball)->SetScale(0.8);
  }
  vtkProperty* property = window.Add(mapper)->GetProperty();
  property->SetOpacity(scene.Opacity);
  // Highlights brighter than white are cut off at other places by peeling than without it.
  property->SetSpecular(0.0);
  window.Renderer->GetActiveCamera()->SetParallelProjection(scene.Parallel);
  window.Renderer->GetActiveCamera()->Elevation(50);
  window.Renderer->ResetCamera();
  const Picture picture = window.Draw();
  return mesh ? Reduce(picture) : picture;
}

/**
 * Nearer to the reference by as much as outlines make out.
 */
void TestAgainstMesh(Checks& checks)
{
  std::vector<Scene> scenes(5);
  scenes[0].Name = "opaque";
  scenes[1].Name = "parallel";
  scenes[1].Parallel = true;
  scenes[2].Name = "translucent";
  scenes[2].Opacity = 0.5;
  scenes[3].Name = "lists made on the device";
  scenes[3].Lists = vtkPointSplatMapper::DEVICE;
  scenes[4].Name = "multisampled, with a mesh";
  scenes[4].Multisampled = true;
  for (const Scene& scene : scenes)
  {
    const Picture reference = Draw(scene, true, false);
    const double rough = PsnrOfAll(reference, Draw(scene, false, false));
    const double smooth = PsnrOfAll(reference, Draw(scene, false, true));
    checks.AtLeast(smooth, 40.0, scene.Name + ": smooth");
    checks.AtLeast(smooth, rough + 4.0, scene.Name + ": smooth, against rough");
  }
}

/**
 * A wall that is drawn after splats is seen at their outlines, and not what was there before it.
 */
void TestMeshAfter(Checks& checks)
{
  for (const bool first : { true, false })
  {
    Window window;
    window.SmoothOutlines = true;
    vtkNew<vtkPlaneSource> source;
    source->SetOrigin(-5, -5, -2);
    source->SetPoint1(5, -5, -2);
    source->SetPoint2(-5, 5, -2);
    vtkNew<vtkPolyDataMapper> plane;
    plane->SetInputConnection(source->GetOutputPort());
    vtkNew<vtkPointSplatMapper> mapper;
    mapper->SetInputData(Cloud(MakeSphereMesh()));
    vtkMapper* order[] = { plane, mapper };
    for (int i = 0; i < 2; ++i)
    {
      vtkProperty* property = window.Add(order[first ? i : 1 - i])->GetProperty();
      property->LightingOff();
      property->SetColor(1, 1, 1);
      property->SetAmbient(1);
      property->SetDiffuse(0);
      property->SetSpecular(0);
    }
    window.Renderer->SetBackground(0, 0, 0);
    window.Renderer->ResetCamera(-1, 1, -1, 1, -1, 1);
    window.Renderer->ResetCameraClippingRange();
    const Picture picture = window.Draw();
    const int least = *std::min_element(picture.Pixels.begin(), picture.Pixels.end());
    checks.AtLeast(least, 254, first ? "a wall drawn before" : "a wall drawn after");
  }
}
}

int TestSplatsOutlines(int, char*[])
{
  Checks checks;
  TestAgainstMesh(checks);
  TestMeshAfter(checks);
  return checks.Result();
}
