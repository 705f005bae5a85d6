// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Mappers that come and go in one window share the programs that its context has: another one builds none, and
// its picture has nothing of what was set for the one before.
#include "SplatMemory.h"

#include "vtkPlane.h"

namespace
{
using namespace SplatScene;

constexpr int Side = 120;

struct Setting
{
  const char* Name;
  std::function<void(vtkActor*, vtkPointSplatMapper*, vtkRenderer*)> Apply;
};

std::vector<Setting> Settings()
{
  return {
    { "nothing set", [](vtkActor*, vtkPointSplatMapper*, vtkRenderer*) {} },
    { "a clipping plane",
      [](vtkActor*, vtkPointSplatMapper* mapper, vtkRenderer*)
      {
        vtkNew<vtkPlane> plane;
        plane->SetNormal(1, 0.3, 0.2);
        mapper->AddClippingPlane(plane);
      } },
    { "translucent",
      [](vtkActor* actor, vtkPointSplatMapper*, vtkRenderer*)
      { actor->GetProperty()->SetOpacity(0.4); } },
    { "sorted",
      [](vtkActor* actor, vtkPointSplatMapper* mapper, vtkRenderer*)
      {
        actor->GetProperty()->SetOpacity(0.4);
        mapper->SetTransparencyToSorted();
      } },
    { "a plateau",
      [](vtkActor*, vtkPointSplatMapper* mapper, vtkRenderer*)
      {
        mapper->SetKernelToPlateau();
        mapper->SetRadiusScale(1.4);
      } },
    { "front faces culled",
      [](vtkActor* actor, vtkPointSplatMapper*, vtkRenderer*)
      { actor->GetProperty()->FrontfaceCullingOn(); } },
    { "in image space",
      [](vtkActor*, vtkPointSplatMapper* mapper, vtkRenderer*)
      { mapper->SetMethodToImageSpace(); } },
    { "deferred",
      [](vtkActor*, vtkPointSplatMapper* mapper, vtkRenderer*) { mapper->SetMethodToDeferred(); } },
    { "quads",
      [](vtkActor*, vtkPointSplatMapper* mapper, vtkRenderer*)
      { mapper->SetProjectionToQuads(); } },
    { "a parallel projection",
      [](vtkActor*, vtkPointSplatMapper*, vtkRenderer* renderer)
      { renderer->GetActiveCamera()->ParallelProjectionOn(); } },
    { "shadows",
      [](vtkActor*, vtkPointSplatMapper* mapper, vtkRenderer*)
      {
        mapper->ShadowsOn();
        mapper->SetShadowLightRadius(0.2);
        mapper->SetNumberOfShadowSamples(2);
      } },
    { "flat shading",
      [](vtkActor* actor, vtkPointSplatMapper*, vtkRenderer*)
      { actor->GetProperty()->SetInterpolationToFlat(); } },
    { "no smooth outlines",
      [](vtkActor*, vtkPointSplatMapper* mapper, vtkRenderer*) { mapper->AntiAliasingOff(); } },
  };
}

/// With an actor of its own, which goes again. programs: of the context, while it is there.
Picture Draw(Window& window, const Setting& setting, int& programs)
{
  vtkNew<vtkPointSplatMapper> mapper;
  mapper->SetInputData(RandomSphere(2000));
  vtkActor* actor = window.Add(mapper);
  window.Renderer->SetActiveCamera(vtkNew<vtkCamera>());
  setting.Apply(actor, mapper, window.Renderer);
  window.Renderer->ResetCamera();
  const Picture picture = window.Draw();
  programs = SplatMemory::Objects(window.Win).Programs;
  window.Renderer->RemoveActor(actor);
  return picture;
}
}

int TestSplatsPrograms(int, char*[])
{
  Checks checks;
  int programs = 0;
  std::vector<Setting> settings = Settings();
  std::vector<Picture> alone;
  for (const Setting& setting : settings)
  {
    Window window(Side);
    window.SmoothOutlines = true;
    alone.push_back(Draw(window, setting, programs));
    checks.AtLeast(alone.back().CountDrawn(), 1000, std::string("pixels drawn with ") + setting.Name);
  }

  Window shared(Side);
  shared.SmoothOutlines = true;
  int first = 0;
  for (int round = 0; round < 2; ++round)
  {
    for (size_t i = 0; i < settings.size(); ++i)
    {
      // There and back, so that each follows two others.
      const size_t k = round == 0 ? i : settings.size() - 1 - i;
      checks.Expect(Draw(shared, settings[k], programs).Pixels == alone[k].Pixels,
        std::string("in a window with others before it: ") + settings[k].Name);
      const int left = SplatMemory::Objects(shared.Win).Programs;
      checks.Expect(left == programs,
        std::string("programs that stay: ") + std::to_string(left) + " of " +
          std::to_string(programs) + ", " + settings[k].Name);
    }
    first = round == 0 ? programs : first;
  }
  checks.Expect(programs == first, "programs of the second round: " + std::to_string(programs - first));
  return checks.Result();
}
