// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Splats in VTK's own shadow map pass: what they cast and receive, against meshes there.
#include "ShadowScene.h"

#include "vtkCameraPass.h"
#include "vtkRenderPassCollection.h"
#include "vtkSequencePass.h"
#include "vtkShadowMapBakerPass.h"
#include "vtkShadowMapPass.h"

namespace
{
using SplatScene::Checks;
using SplatScene::Picture;
using SplatScene::Window;

/// A ball, by splats or as a mesh.
void AddBall(Window& window, const ShadowScene::Ball& ball, bool splats, int resolution)
{
  vtkNew<vtkSphereSource> source;
  source->SetCenter(ball.Centre.data());
  source->SetRadius(ball.Radius);
  source->SetThetaResolution(2 * resolution);
  source->SetPhiResolution(resolution);
  vtkSmartPointer<vtkPolyDataMapper> mapper;
  if (splats)
  {
    mapper = vtkSmartPointer<vtkPointSplatMapper>::New();
  }
  else
  {
    mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  }
  mapper->SetInputConnection(source->GetOutputPort());
  window.Add(mapper);
}

/// Two balls over the ground, which is a large one; of each whether it is splats.
Picture Draw(const std::array<bool, 3>& splats, bool positional, bool pass)
{
  Window window;
  window.Win->SetSize(400, 300);
  AddBall(window, { { 0.0, 0.0, -6.0 }, 6.0 }, splats[0], 400);
  AddBall(window, { { 0.0, 0.0, 0.9 }, 0.5 }, splats[1], 100);
  AddBall(window, { { 1.1, 0.3, 0.7 }, 0.35 }, splats[2], 100);
  vtkRenderer* renderer = window.Renderer;
  renderer->AutomaticLightCreationOff();
  renderer->AddLight(ShadowScene::MakeLight({ 2, 1, 4 }, { 0, 0, 0.5 }, positional, 40.0));
  auto second = ShadowScene::MakeLight({ -3, -1, 4 }, { 0, 0, 0.5 }, false);
  second->SetIntensity(0.4);
  renderer->AddLight(second);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.5, -5.0, 5.0);
  camera->SetFocalPoint(0.3, 0.2, 0.3);
  camera->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCameraClippingRange();
  if (pass)
  {
    vtkNew<vtkShadowMapBakerPass> baker;
    vtkNew<vtkShadowMapPass> shadows;
    shadows->SetShadowMapBakerPass(baker);
    vtkNew<vtkRenderPassCollection> passes;
    passes->AddItem(baker);
    passes->AddItem(shadows);
    vtkNew<vtkSequencePass> sequence;
    sequence->SetPasses(passes);
    vtkNew<vtkCameraPass> cameraPass;
    cameraPass->SetDelegatePass(sequence);
    renderer->SetPass(cameraPass);
  }
  const Picture picture = window.Draw();
  if (renderer->GetPass())
  {
    renderer->GetPass()->ReleaseGraphicsResources(window.Win);
  }
  return picture;
}
}

int TestSplatsShadowMaps(int, char*[])
{
  Checks checks;
  for (const bool positional : { false, true })
  {
    const Picture mesh = Draw({ false, false, false }, positional, true);
    const Picture bare = Draw({ false, false, false }, positional, false);
    const std::string light = positional ? "spot light" : "directional light";
    const double shadows = SplatScene::Psnr(mesh, bare);
    std::cout << light << ": shadows make " << shadows << " dB\n";
    checks.AtMost(shadows, 30.0, light + ": what shadows change, dB");
    for (const std::array<bool, 3>& splats : { std::array<bool, 3>{ true, true, true },
           std::array<bool, 3>{ true, false, false }, std::array<bool, 3>{ false, true, true } })
    {
      const double psnr = SplatScene::Psnr(mesh, Draw(splats, positional, true));
      const std::string name = light + (splats[0] ? ", ground" : "") + (splats[1] ? ", balls" : "");
      std::cout << name << " of splats: " << psnr << " dB\n";
      checks.AtLeast(psnr, 42.0, name + ": psnr of the mesh's picture");
    }
  }
  return checks.Result();
}
