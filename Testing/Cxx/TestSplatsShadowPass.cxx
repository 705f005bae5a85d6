// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Shadows by vtkPointSplatShadowPass on meshes, and of translucent splats on meshes and splats,
// against closed forms.
#include "ShadowView.h"

#include "vtkAbstractArray.h"
#include "vtkAppendPolyData.h"
#include "vtkHardwareSelector.h"
#include "vtkPlaneSource.h"
#include "vtkPointSplatShadowPass.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"

namespace
{
using namespace ShadowScene;

/// The balls of a scene from first to last, as one mesh.
vtkSmartPointer<vtkPolyData> MakeBalls(const Spheres& scene, size_t first, size_t last)
{
  vtkNew<vtkAppendPolyData> append;
  for (size_t k = first; k < last; ++k)
  {
    vtkNew<vtkSphereSource> ball;
    ball->SetCenter(scene.Balls[k].Centre.data());
    ball->SetRadius(scene.Balls[k].Radius);
    ball->SetThetaResolution(200);
    ball->SetPhiResolution(100);
    append->AddInputConnection(ball->GetOutputPort());
  }
  append->Update();
  return append->GetOutput();
}

/// Of the scene's plane: one quad, or as many as splats need.
vtkSmartPointer<vtkPolyData> MakeFloor(int resolution)
{
  vtkNew<vtkPlaneSource> floor;
  floor->SetOrigin(-2.0, -2.0, 0.0);
  floor->SetPoint1(2.0, -2.0, 0.0);
  floor->SetPoint2(-2.0, 2.0, 0.0);
  floor->SetResolution(resolution, resolution);
  floor->Update();
  return floor->GetOutput();
}

/// Adds what looks as the view's own actor does.
vtkActor* AddTo(View& view, vtkPolyData* data, bool splats)
{
  vtkSmartPointer<vtkPolyDataMapper> mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  if (splats)
  {
    auto own = vtkSmartPointer<vtkPointSplatMapper>::New();
    own->ShadowsOn();
    mapper = own;
  }
  mapper->SetInputData(data);
  vtkActor* actor = view.Win.Add(mapper);
  actor->GetProperty()->DeepCopy(view.Actor->GetProperty());
  view.Win.Renderer->ResetCameraClippingRange();
  return actor;
}

std::vector<vtkSmartPointer<vtkLight>> MakeLights(bool among)
{
  auto first = MakeLight({ 2, 1, 3 }, Middle, false);
  auto second =
    among ? MakeLight({ 0.3, -1.3, 1.3 }, Middle, true) : MakeLight({ -3, 1, 4 }, Middle, true);
  first->SetIntensity(0.6);
  second->SetIntensity(0.4);
  return { first, second };
}

/// A plane and a ball are meshes, two balls splats: all cast on all.
void TestMeshesReceive(Checks& checks)
{
  const Spheres scene(1000);
  for (const bool among : { false, true })
  {
    const auto lights = MakeLights(among);
    View view(MakeBalls(scene, 0, 2), lights);
    view.Mapper->ShadowsOn();
    AddTo(view, MakeFloor(1), false);
    AddTo(view, MakeBalls(scene, 2, 3), false);
    vtkNew<vtkPointSplatShadowPass> pass;
    view.Win.Renderer->SetPass(pass);
    Compare(checks, among ? "meshes, a light among them" : "meshes", view, scene, lights);
  }
}

/// Where the mapper wants no shadows, or lights are headlights, the pass changes nothing.
void TestNone(Checks& checks)
{
  const Spheres scene(1000);
  View view(MakeBalls(scene, 0, 3), MakeLights(false));
  AddTo(view, MakeFloor(1), false);
  const Picture bare = view.Win.Draw();
  vtkNew<vtkPointSplatShadowPass> pass;
  view.Win.Renderer->SetPass(pass);
  checks.Expect(
    view.Win.Draw().Pixels == bare.Pixels, "A pass without shadows changes the picture.");
  view.Mapper->ShadowsOn();
  checks.Expect(view.Win.Draw().Pixels != bare.Pixels, "Shadows that come later are not drawn.");
  view.Mapper->ShadowsOff();
  checks.Expect(view.Win.Draw().Pixels == bare.Pixels, "Shadows stay that are turned off.");
  view.Win.Renderer->RemoveAllLights();
  vtkNew<vtkLight> head;
  head->SetLightTypeToHeadlight();
  view.Win.Renderer->AddLight(head);
  const Picture without = view.Win.Draw();
  view.Mapper->ShadowsOn();
  checks.Expect(view.Win.Draw().Pixels == without.Pixels, "A headlight casts shadows.");
  pass->SetDelegatePass(nullptr);
  view.Win.Draw();
}

/// A translucent ball over the plane: two layers of its colour take light away. lamp: the radius of
/// the light, small enough that the middle of the shadow has no light beside them.
void TestTranslucent(Checks& checks, bool splatFloor, bool opaqueToo, double lamp)
{
  const std::string name = std::string("translucent ball on ") +
    (splatFloor ? "splats" : "a mesh") +
    (opaqueToo ? ", an opaque one beside it" : "") + (lamp > 0.0 ? ", soft" : "");
  Spheres scene(1000);
  auto light = MakeLight({ 1, 1, 4 }, Middle, false);
  View view(MakeBalls(scene, 0, 1), { light });
  const Vector ballColour{ 0.9, 0.3, 0.1 };
  constexpr double opacity = 0.5;
  view.Mapper->ShadowsOn();
  view.Mapper->SetShadowLightRadius(lamp);
  vtkActor* floor = AddTo(view, MakeFloor(splatFloor ? 150 : 1), splatFloor);
  if (auto mapper = vtkPointSplatMapper::SafeDownCast(floor->GetMapper()))
  {
    mapper->SetShadowLightRadius(lamp);
  }
  if (opaqueToo)
  {
    AddTo(view, MakeBalls(scene, 1, 2), true);
  }
  view.Actor->GetProperty()->SetColor(ballColour[0], ballColour[1], ballColour[2]);
  view.Actor->GetProperty()->SetOpacity(opacity);
  vtkNew<vtkPointSplatShadowPass> pass;
  if (!splatFloor)
  {
    view.Win.Renderer->SetPass(pass);
  }
  const Picture picture = view.Win.Draw();
  long inside = 0;
  long coloured = 0;
  long black = 0;
  long wrong = 0;
  double sum = 0.0;
  const double margin = 0.05 + 2.0 * lamp;
  for (int y = 10; y < picture.Height - 10; ++y)
  {
    for (int x = 10; x < picture.Width - 10; ++x)
    {
      Vector o;
      Vector d;
      view.Ray(x + 0.5, y + 0.5, o, d);
      const double t = -o[2] / d[2];
      const Vector p = Along(o, t, d);
      if (t <= 0.0 || std::abs(p[0]) > 1.9 || std::abs(p[1]) > 1.9)
      {
        continue;
      }
      Vector from;
      Vector ray;
      RayTo(light, p, from, ray);
      bool clear = true;
      std::array<bool, 2> shadowed{ { false, false } };
      for (size_t k = 0; k < (opaqueToo ? 2 : 1); ++k)
      {
        const Ball& ball = scene.Balls[k];
        const Vector c = Between(o, ball.Centre);
        const double eye = std::sqrt(Dot(c, c) - Dot(c, d) * Dot(c, d));
        const Vector q = Between(p, ball.Centre);
        const double lit = std::sqrt(std::max(0.0, Dot(q, q) - Dot(q, ray) * Dot(q, ray)));
        clear = clear && eye > ball.Radius + 0.05 && std::abs(lit - ball.Radius) > margin;
        shadowed[k] = lit < ball.Radius;
      }
      if (!clear)
      {
        continue;
      }
      ++inside;
      coloured += shadowed[0] && !shadowed[1];
      black += shadowed[1];
      double worst = 0.0;
      for (size_t c = 0; c < 3; ++c)
      {
        const double layer = (1.0 - opacity) * (1.0 + opacity * ballColour[c]);
        const double passed = shadowed[1] ? 0.0 : shadowed[0] ? layer * layer : 1.0;
        const double wanted =
          255.0 * std::min(1.0, (Ambient + Diffuse * -ray[2] * passed) * Colour[c]);
        worst = std::max(worst, std::abs(wanted - picture.At(x, y)[c]));
      }
      sum += worst;
      wrong += worst > 8.0;
    }
  }
  std::cout << name << ": " << inside << " pixels, " << coloured << " in a coloured shadow, "
            << black << " in a black one, mean error " << sum / inside << ", " << 100.0 * wrong / inside
            << " % wrong\n";
  checks.AtLeast(inside, 1000l, name + ": pixels");
  checks.AtLeast(coloured, 300l, name + ": pixels in a coloured shadow");
  checks.AtLeast(black, opaqueToo ? 100l : 0l, name + ": pixels in a black shadow");
  checks.AtMost(sum / inside, 2.0, name + ": mean error");
  checks.AtMost(100.0 * wrong / inside, 0.5, name + ": per cent wrong");
}

/// The pass is no hindrance to selections of what lies in a window.
void TestSelections(Checks& checks)
{
  Spheres scene(1000);
  View view(MakeBalls(scene, 0, 2), { MakeLight({ 1, 1, 4 }, Middle, false) });
  view.Mapper->ShadowsOn();
  AddTo(view, MakeFloor(150), false);
  view.Win.Win->SetMultiSamples(0);
  view.Win.Draw();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(view.Win.Renderer);
  const int* size = view.Win.Win->GetSize();
  selector->SetArea(0, 0, size[0] - 1, size[1] - 1);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_POINTS);
  std::array<std::vector<vtkIdType>, 2> found;
  for (std::vector<vtkIdType>& counts : found)
  {
    const auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
    for (unsigned int i = 0; i < selection->GetNumberOfNodes(); ++i)
    {
      counts.push_back(selection->GetNode(i)->GetSelectionList()->GetNumberOfTuples());
    }
    view.Win.Renderer->SetPass(vtkNew<vtkPointSplatShadowPass>());
  }
  checks.AtLeast(found[0].size(), size_t(2), "props that are selected");
  checks.Expect(found[0] == found[1], "The pass changes what is selected.");
}
}

int TestSplatsShadowPass(int, char*[])
{
  Checks checks;
  TestSelections(checks);
  TestMeshesReceive(checks);
  TestNone(checks);
  for (const bool splatFloor : { false, true })
  {
    for (const double lamp : { 0.0, 0.05 })
    {
      TestTranslucent(checks, splatFloor, false, lamp);
      TestTranslucent(checks, splatFloor, true, lamp);
    }
  }
  return checks.Result();
}
