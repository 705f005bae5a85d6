// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Ten thousand frames in which everything changes: the process has no more memory, and the
// context no more OpenGL objects, than after the first hundreds.
#include "SplatMemory.h"

#include "vtkHardwareSelector.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkPointSplatShadowPass.h"
#include "vtkSelection.h"
#include "vtkTexture.h"

#include <set>

namespace
{
using namespace SplatScene;

constexpr int Frames = SplatMemory::MeasureMemory ? 10000 : 400;
// After these every program is built and every image has had its largest size.
constexpr int FirstFrames = 200;
// Frames after which everything is as it was this many frames before.
constexpr int Cycle = 40;
constexpr int Interval = SplatMemory::MeasureMemory ? 25 * Cycle : 5 * Cycle;
// KiB in an interval. One lost image of 16 x 16 pixels and 20 bytes a pixel in a hundred frames would be
// 50, one lost 96 bytes a frame 94.
constexpr long MostGrowth = 40;

/**
 * What takes turns in the window.
 */
struct Cast
{
  vtkActor* Steady;
  vtkActor* Guest;
  vtkPolyData* Small;
  vtkPolyData* Large;
  vtkLight* Lamp;
  vtkTexture* Environment;
};

vtkSmartPointer<vtkTexture> MakeEnvironment()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(8, 4, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  image->GetPointData()->GetScalars()->Fill(150.0);
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  return texture;
}

/**
 * What one frame in a cycle changes.
 */
void Change(Window& window, int frame, const Cast& cast)
{
  vtkActor* steady = cast.Steady;
  vtkActor* guest = cast.Guest;
  vtkPolyData* small = cast.Small;
  vtkPolyData* large = cast.Large;
  vtkPointSplatMapper* mapper = vtkPointSplatMapper::SafeDownCast(steady->GetMapper());
  switch (frame % Cycle)
  {
    case 0:
      window.Win->SetSize(24, 20);
      break;
    case 2:
      mapper->SetMethodToImageSpace();
      break;
    case 4:
      window.Win->SetSize(20, 24);
      mapper->SetMethodToTwoPass();
      break;
    case 6:
      mapper->SetInputData(large);
      break;
    case 8:
    {
      // New arrays in the same data.
      vtkNew<vtkFloatArray> colours;
      colours->SetName("colours");
      colours->SetNumberOfTuples(large->GetNumberOfPoints());
      for (vtkIdType i = 0; i < large->GetNumberOfPoints(); ++i)
      {
        colours->SetValue(i, static_cast<float>(i + frame));
      }
      large->GetPointData()->SetScalars(colours);
      large->Modified();
      break;
    }
    case 10:
      mapper->SetProjectionToQuads();
      break;
    case 11:
      mapper->SetMethodToImageSpace();
      break;
    case 12:
      mapper->SetMethodToDeferred();
      break;
    case 14:
      mapper->SetMethodToTwoPass();
      mapper->SetProjectionToAutomatic();
      break;
    case 16:
      steady->GetProperty()->SetOpacity(0.5);
      break;
    case 18:
      mapper->SetTransparencyToSorted();
      break;
    case 20:
      mapper->SetTransparencyToNearestExact();
      break;
    case 22:
      mapper->SetTransparencyToPeeling();
      window.Renderer->AddActor(guest);
      break;
    case 23:
      // Glass, with what it reflects.
      mapper->RefractionOn();
      window.Renderer->SetEnvironmentTexture(cast.Environment);
      break;
    case 24:
      mapper->RefractionOff();
      window.Renderer->SetEnvironmentTexture(nullptr);
      steady->GetProperty()->SetOpacity(1.0);
      large->GetPointData()->SetScalars(nullptr);
      break;
    case 26:
    {
      // A mapper that goes while its actor stays.
      vtkNew<vtkPointSplatMapper> other;
      other->SetInputData(small);
      guest->SetMapper(other);
      break;
    }
    case 28:
      // A point light, and an area light.
      mapper->ShadowsOn();
      window.Renderer->AddLight(cast.Lamp);
      break;
    case 29:
      mapper->SetNumberOfShadowSamples(3);
      mapper->SetShadowLightRadius(0.2);
      // On meshes, too, and of translucent splats.
      window.Renderer->SetPass(vtkNew<vtkPointSplatShadowPass>());
      steady->GetProperty()->SetOpacity(0.5);
      break;
    case 30:
    {
      vtkNew<vtkHardwareSelector> selector;
      selector->SetRenderer(window.Renderer);
      selector->SetArea(5, 5, 10, 10);
      selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_POINTS);
      vtkSmartPointer<vtkSelection>::Take(selector->Select());
      break;
    }
    case 31:
      mapper->SetMethodToImageSpace();
      break;
    case 32:
      mapper->SetMethodToTwoPass();
      mapper->ShadowsOff();
      mapper->SetNumberOfShadowSamples(1);
      mapper->SetShadowLightRadius(0.0);
      window.Renderer->SetPass(nullptr);
      steady->GetProperty()->SetOpacity(1.0);
      window.Renderer->RemoveLight(cast.Lamp);
      window.Renderer->RemoveActor(guest);
      break;
    case 34:
      steady->ReleaseGraphicsResources(window.Win);
      break;
    case 36:
      mapper->SetInputData(small);
      break;
    default:
      window.Renderer->GetActiveCamera()->SetPosition(
        4 * std::sin(frame % Cycle), 0, 4 * std::cos(frame % Cycle));
      break;
  }
}
}

int TestSplatsMemory(int, char*[])
{
  Checks checks;
  Window window(20);
  vtkSmartPointer<vtkPolyData> small = RandomSphere(60);
  vtkSmartPointer<vtkPolyData> large = RandomSphere(100);
  vtkNew<vtkPointSplatMapper> mapper;
  mapper->SetInputData(small);
  vtkNew<vtkPointSplatMapper> guestMapper;
  guestMapper->SetInputData(small);
  vtkActor* steady = window.Add(mapper);
  vtkSmartPointer<vtkActor> guest = window.Add(guestMapper);
  window.Renderer->RemoveActor(guest);
  window.Renderer->ResetCamera();
  window.Renderer->CreateLight(); // of its own; there is none where others are
  vtkNew<vtkLight> lamp;
  lamp->SetLightTypeToSceneLight();
  lamp->SetPosition(3, 2, 4);
  lamp->PositionalOn();
  const vtkSmartPointer<vtkTexture> environment = MakeEnvironment();
  const Cast cast{ steady, guest, small, large, lamp, environment };

  SplatMemory::Record record;
  std::set<std::string> done;
  for (int round = 0; round == 0 || (round < 3 && record.Grew(MostGrowth)); ++round)
  {
    record = SplatMemory::Record();
    for (int frame = 0; frame <= Frames; ++frame)
    {
      Change(window, frame, cast);
      window.Win->Render();
      if (frame < Cycle)
      {
        done.insert(std::string(mapper->GetMethodUsed()) + ", " + mapper->GetProjectionUsed());
        done.insert(mapper->GetTransparencyUsed());
      }
      if (frame >= FirstFrames && (frame - FirstFrames) % Interval == 0)
      {
        record.Add("frame " + std::to_string(frame), window.Win);
      }
    }
  }
  record.Check(checks, MostGrowth);
  for (const char* what : { "two-pass, compute", "two-pass, quads", "image-space, compute",
         "image-space, quads", "deferred, quads", "none", "peeling", "sorted", "nearest-exact" })
  {
    checks.Expect(done.count(what) == 1, std::string("never drawn: ") + what);
  }
  checks.AtLeast(mapper->GetNumberOfShadowUpdates(), 2ul, "updates of shadows");
  return checks.Result();
}
