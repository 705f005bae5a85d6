// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Pictures with shadows against closed forms, in every method; when shadows are computed again;
// saved factors.
#include "ShadowView.h"

#include "vtkCallbackCommand.h"
#include "vtkPointShadowTexture.h"

namespace
{
using namespace ShadowScene;
void TestMethods(Checks& checks)
{
  const Spheres scene(40000);
  auto first = MakeLight({ 2, 1, 3 }, Middle, false);
  auto second = MakeLight({ -3, 1, 4 }, Middle, true);
  first->SetIntensity(0.6);
  second->SetIntensity(0.4);
  for (const bool both : { false, true })
  {
    std::vector<vtkSmartPointer<vtkLight>> lights{ first };
    if (both)
    {
      lights.push_back(second);
    }
    const std::string name = both ? "two lights" : "one light";
    {
      View view(scene.Points, lights);
      view.Mapper->ShadowsOn();
      Compare(checks, name, view, scene, lights);
    }
    {
      View view(scene.Points, lights);
      view.Mapper->ShadowsOn();
      view.Mapper->SetProjectionToQuads();
      view.Mapper->SetMethodToTwoPass();
      Compare(checks, name, view, scene, lights);
    }
    for (const int projection : { vtkPointSplatMapper::COMPUTE, vtkPointSplatMapper::QUADS })
    {
      View view(scene.Points, lights);
      view.Mapper->ShadowsOn();
      view.Mapper->SetMethod(vtkPointSplatMapper::IMAGE_SPACE);
      view.Mapper->SetProjection(projection);
      Compare(checks, name, view, scene, lights);
    }
    {
      View view(scene.Points, lights);
      view.Mapper->ShadowsOn();
      view.Mapper->SetMethodToDeferred();
      Compare(checks, name, view, scene, lights);
      checks.Expect(std::string(view.Mapper->GetMethodUsed()) == "deferred", "Not deferred.");
    }
  }
  // With colours, and more lights than one word of the sums holds.
  vtkNew<vtkPolyData> coloured;
  coloured->ShallowCopy(scene.Points);
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < coloured->GetNumberOfPoints(); ++i)
  {
    colours->InsertNextTuple3(std::lround(255 * Colour[0]), std::lround(255 * Colour[1]),
      std::lround(255 * Colour[2]));
  }
  coloured->GetPointData()->SetScalars(colours);
  for (const bool quads : { false, true })
  {
    for (const bool withColours : { false, true })
    {
      std::vector<vtkSmartPointer<vtkLight>> lights{ first, second,
        MakeLight({ 0, -4, 4 }, Middle, false), MakeLight({ -1, 3, 2 }, Middle, true) };
      first->SetIntensity(0.3);
      second->SetIntensity(0.3);
      lights[2]->SetIntensity(0.2);
      lights[3]->SetIntensity(0.2);
      View view(withColours ? coloured.Get() : scene.Points.Get(), lights);
      view.Mapper->SetScalarVisibility(withColours);
      view.Mapper->ShadowsOn();
      view.Mapper->SetProjection(
        quads ? vtkPointSplatMapper::QUADS : vtkPointSplatMapper::COMPUTE);
      Compare(checks, "four lights", view, scene, lights);
    }
  }
}

/// A translucent plane in the shadow of an opaque mesh.
void TestTranslucent(Checks& checks)
{
  Spheres scene(10);
  scene.Balls = { { { 0.0, 0.0, 1.2 }, 0.6 } };
  const auto plane = SplatScene::RandomSquare(40000);
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(0.6);
  ball->SetThetaResolution(100);
  ball->SetPhiResolution(50);
  vtkNew<vtkPolyDataMapper> mesh;
  mesh->SetInputConnection(ball->GetOutputPort());
  const std::vector<vtkSmartPointer<vtkLight>> lights{ MakeLight({ 1, -1, 2.5 }, Middle, false) };
  for (const int transparency : { vtkPointSplatMapper::PEELING, vtkPointSplatMapper::SORTED,
         vtkPointSplatMapper::NEAREST_EXACT })
  {
    View view(plane, lights);
    view.Win.Add(mesh)->SetPosition(0.0, 0.0, 1.2);
    view.Mapper->ShadowsOn();
    view.Mapper->SetTransparency(transparency);
    view.Actor->GetProperty()->SetOpacity(0.6);
    Compare(checks, "translucent", view, scene, lights, 0.6);
  }
}

/// What a ray sees of two sheets, z = 0 and below it, in the shadow of a ball: by which lights
/// each is lit, and, Dimmed, by which through the upper sheet, or ~0u where the ray misses it.
struct Sheets
{
  static constexpr int Dimmed = 8;
  double Opacity = 0.6;
  Ball Caster{ { 0.0, 0.0, 1.2 }, 0.5 };
  std::array<double, 2> Heights{ { 0.0, -0.7 } };

  bool IsHidden(const Vector& p, const Vector& towards) const
  {
    const Vector c = Between(p, this->Caster.Centre);
    const double along = Dot(c, towards);
    return along > 0.0 && Dot(c, c) - along * along < this->Caster.Radius * this->Caster.Radius;
  }
  std::array<unsigned int, 2> See(const std::vector<vtkSmartPointer<vtkLight>>& lights,
    const Vector& o, const Vector& d) const
  {
    std::array<unsigned int, 2> seen{ { ~0u, ~0u } };
    for (size_t k = 0; k < 2 && !this->IsHidden(o, d); ++k)
    {
      const Vector p = Along(o, (this->Heights[k] - o[2]) / d[2], d);
      if (std::abs(p[0]) > 2.0 || std::abs(p[1]) > 2.0)
      {
        continue;
      }
      seen[k] = 0u;
      for (size_t i = 0; i < lights.size(); ++i)
      {
        Vector from;
        Vector ray;
        RayTo(lights[i], p, from, ray);
        seen[k] |= this->IsHidden(p, { -ray[0], -ray[1], -ray[2] }) ? 0u : 1u << i;
        const Vector above = Along(p, (this->Heights[0] - p[2]) / ray[2], ray);
        const bool through = k == 1 && std::abs(above[0]) <= 2.0 && std::abs(above[1]) <= 2.0;
        seen[k] |= through ? 1u << (Dimmed + i) : 0u;
      }
    }
    return seen;
  }
  /// How bright a sheet is where it is seen, of a component of Colour.
  double Shade(size_t sheet, unsigned int lit, double colour,
    const std::vector<vtkSmartPointer<vtkLight>>& lights, const Vector& o, const Vector& d) const
  {
    double light = Ambient;
    const double passed = (1.0 - this->Opacity) * (1.0 + this->Opacity * colour);
    for (size_t i = 0; i < lights.size(); ++i)
    {
      Vector from;
      Vector ray;
      RayTo(lights[i], Along(o, (this->Heights[sheet] - o[2]) / d[2], d), from, ray);
      light += (lit >> i & 1u) * (lit >> (Dimmed + i) & 1u ? passed : 1.0) * Diffuse *
        std::abs(ray[2]) * lights[i]->GetIntensity();
    }
    return light;
  }
};

/// Layers that were filled in image space have each its own shadows, and let coloured light through.
void TestTranslucentLayers(Checks& checks)
{
  const Sheets sheets;
  const auto points =
    SplatScene::RandomCloud(80000, [&](double u, double v, double* p, double* n) {
      const size_t k = u < 0.5 ? 0 : 1;
      p[0] = 4.0 * (2.0 * u - static_cast<double>(k)) - 2.0;
      p[1] = 4.0 * v - 2.0;
      p[2] = sheets.Heights[k];
      n[0] = n[1] = 0.0;
      n[2] = 1.0;
    });
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    colours->InsertNextTuple3(std::lround(255 * Colour[0]), std::lround(255 * Colour[1]),
      std::lround(255 * Colour[2]));
  }
  points->GetPointData()->SetScalars(colours);
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(sheets.Caster.Radius);
  ball->SetThetaResolution(100);
  ball->SetPhiResolution(50);
  vtkNew<vtkPolyDataMapper> mesh;
  mesh->SetInputConnection(ball->GetOutputPort());
  // More than one word of the sums holds.
  const std::vector<vtkSmartPointer<vtkLight>> lights{ MakeLight({ 1, -1, 3 }, Middle, false),
    MakeLight({ -3, 1, 4 }, Middle, true), MakeLight({ 0, 4, 4 }, Middle, false) };
  const std::array<double, 3> intensities{ { 0.4, 0.3, 0.3 } };
  for (size_t i = 0; i < lights.size(); ++i)
  {
    lights[i]->SetIntensity(intensities[i]);
  }
  const double opacity = sheets.Opacity;
  constexpr int reach = 4;
  for (const bool quads : { false, true })
  {
    for (const bool coloured : { false, true })
    {
      View view(points, lights);
      view.Mapper->SetScalarVisibility(coloured);
      view.Win.Add(mesh)->SetPosition(
        sheets.Caster.Centre[0], sheets.Caster.Centre[1], sheets.Caster.Centre[2]);
      view.Mapper->ShadowsOn();
      view.Mapper->SetMethod(vtkPointSplatMapper::IMAGE_SPACE);
      view.Mapper->SetProjection(
        quads ? vtkPointSplatMapper::QUADS : vtkPointSplatMapper::COMPUTE);
      view.Mapper->SetTransparency(vtkPointSplatMapper::PEELING);
      view.Actor->GetProperty()->SetOpacity(opacity);
      const Picture picture = view.Win.Draw();
      double sum = 0.0;
      long inside = 0;
      long different = 0;
      long wrong = 0;
      for (int y = 10; y < picture.Height - 10; y += 2)
      {
        for (int x = 10; x < picture.Width - 10; x += 2)
        {
          Vector o;
          Vector d;
          view.Ray(x + 0.5, y + 0.5, o, d);
          const auto seen = sheets.See(lights, o, d);
          bool clear = seen[0] != ~0u && seen[1] != ~0u;
          for (int k = 0; k < 8 && clear; ++k)
          {
            Vector o2;
            Vector d2;
            view.Ray(x + 0.5 + reach * std::cos(k * vtkMath::Pi() / 4),
              y + 0.5 + reach * std::sin(k * vtkMath::Pi() / 4), o2, d2);
            clear = sheets.See(lights, o2, d2) == seen;
          }
          if (!clear)
          {
            continue;
          }
          ++inside;
          different += ((seen[0] ^ seen[1]) & 7u) != 0u;
          double worst = 0.0;
          for (int c = 0; c < 3; ++c)
          {
            const double colour = Colour[static_cast<size_t>(c)];
            const double light = opacity *
              (sheets.Shade(0, seen[0], colour, lights, o, d) +
                (1.0 - opacity) * sheets.Shade(1, seen[1], colour, lights, o, d));
            worst = std::max(worst, std::abs(255.0 * light * colour - picture.At(x, y)[c]));
          }
          sum += worst;
          wrong += worst > 8.0;
        }
      }
      const std::string name = coloured ? "translucent layers, colours" : "translucent layers";
      std::cout << name << " (" << view.Mapper->GetMethodUsed() << ", "
                << view.Mapper->GetProjectionUsed() << "): " << inside << " pixels, " << different
                << " of them with other shadows on either sheet, mean error " << sum / inside
                << ", " << 100.0 * wrong / inside << " % wrong\n";
      checks.AtLeast(view.Mapper->GetNumberOfLayersDrawn(), 2, name + ": layers");
      // The second image comes and goes with the factors.
      view.Mapper->ShadowsOff();
      checks.Expect(
        view.Win.Draw().Pixels != picture.Pixels, name + ": the picture does not need shadows.");
      view.Mapper->ShadowsOn();
      checks.Expect(view.Win.Draw().Pixels == picture.Pixels,
        name + ": shadows that are off and on again change the picture.");
      checks.AtLeast(inside, 1000l, name + ": pixels");
      checks.AtLeast(different, 100l, name + ": pixels with other shadows");
      checks.AtMost(sum / inside, 2.0, name + ": mean error");
      checks.AtMost(100.0 * wrong / inside, 1.0, name + ": per cent wrong");
    }
  }
}

void TestUpdates(Checks& checks)
{
  const Spheres scene(10000);
  auto light = MakeLight({ 2, 1, 3 }, Middle, false);
  View view(scene.Points, { light });
  vtkPointSplatMapper* mapper = view.Mapper;
  mapper->ShadowsOn();
  mapper->SetShadowLightRadius(0.1);
  mapper->SetNumberOfShadowSamples(8);
  unsigned long updates = 0;
  auto expect = [&](bool again, int samples, const std::string& what) {
    view.Win.Win->Render();
    checks.Expect((mapper->GetNumberOfShadowUpdates() != updates) == again,
      what + (again ? " does not bring shadows up to date" : " computes shadows again"));
    checks.Expect(mapper->GetNumberOfShadowSamplesUsed() == samples,
      what + ": " + std::to_string(mapper->GetNumberOfShadowSamplesUsed()) + " samples");
    updates = mapper->GetNumberOfShadowUpdates();
  };
  expect(true, 8, "The first frame");
  expect(false, 8, "The same again");
  view.Win.Renderer->GetActiveCamera()->Azimuth(20);
  expect(false, 8, "Another camera");
  view.Actor->GetProperty()->SetColor(1, 0, 0);
  expect(false, 8, "Another colour");
  light->SetPosition(2, 0, 3);
  expect(true, 8, "A light that moved");
  view.Actor->RotateZ(10);
  expect(true, 8, "An actor that turned");
  mapper->SetShadowSeed(5);
  expect(true, 8, "Another seed");

  // While the user drags: one sample for what changes, and what is there stays.
  view.Win.Win->SetDesiredUpdateRate(15.0);
  view.Win.Renderer->GetActiveCamera()->Azimuth(20);
  expect(false, 8, "A camera that is dragged");
  light->SetPosition(2, -1, 3);
  expect(true, 1, "A light that is dragged");
  expect(false, 1, "The same again");
  mapper->SetNumberOfInteractiveShadowSamples(4);
  expect(true, 4, "More samples while dragging");
  view.Win.Win->SetDesiredUpdateRate(0.0001);
  expect(true, 8, "A window at rest");

  // Meshes: one that comes, moves and goes.
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(0.3);
  vtkNew<vtkPolyDataMapper> ballMapper;
  ballMapper->SetInputConnection(ball->GetOutputPort());
  vtkActor* mesh = view.Win.Add(ballMapper);
  mesh->SetPosition(0.5, 0.5, 2.0);
  expect(true, 8, "A mesh");
  mesh->SetPosition(0.5, 0.7, 2.0);
  expect(true, 8, "A mesh that moved");
  ball->SetRadius(0.4);
  expect(true, 8, "A mesh that changed");
  mesh->VisibilityOff();
  expect(true, 8, "A mesh that went");
  mapper->SetMethodToDeferred();
  expect(false, 8, "Deferred blending");

  // A headlight casts none, and nothing but its light is drawn.
  view.Win.Renderer->RemoveAllLights();
  auto head = vtkSmartPointer<vtkLight>::New();
  head->SetLightTypeToHeadlight();
  view.Win.Renderer->AddLight(head);
  view.Win.Renderer->SetLightFollowCamera(true);
  const Picture with = view.Win.Draw();
  mapper->ShadowsOff();
  const Picture without = view.Win.Draw();
  checks.Expect(with.Pixels == without.Pixels, "A headlight's picture changes by shadows.");
  view.Win.Win->Finalize();
}

/// Factors that were saved draw the picture that the mapper computes.
void TestSaved(Checks& checks)
{
  const Spheres scene(40000);
  auto light = MakeLight({ 2, 1, 3 }, Middle, false);
  vtkNew<vtkPointShadowTexture> texture;
  texture->SetInputData(scene.Points);
  texture->AddLight(light);
  texture->SetLightRadius(0.1);
  texture->Update();
  for (const int method : { vtkPointSplatMapper::TWO_PASS, vtkPointSplatMapper::DEFERRED })
  {
    View computed(scene.Points, { light });
    computed.Mapper->ShadowsOn();
    computed.Mapper->SetShadowLightRadius(0.1);
    computed.Mapper->SetMethod(method);
    View saved(texture->GetOutput(), { light });
    saved.Mapper->SetMethod(method);
    View bare(scene.Points, { light });
    bare.Mapper->SetMethod(method);
    const Picture a = computed.Win.Draw();
    const Picture b = saved.Win.Draw();
    const Picture c = bare.Win.Draw();
    checks.Expect(a.Pixels == b.Pixels, "Saved factors draw another picture.");
    long shadowed = 0;
    for (size_t i = 0; i < a.Pixels.size(); ++i)
    {
      shadowed += std::abs(int(b.Pixels[i]) - int(c.Pixels[i])) > 20;
    }
    checks.AtLeast(shadowed, 3000l, "values that saved shadows change");
    checks.Expect(saved.Mapper->GetNumberOfShadowUpdates() == 0, "Shadows are computed in vain.");
  }

  // Factors of another number of points are not used.
  vtkNew<vtkPolyData> wrong;
  wrong->ShallowCopy(scene.Points);
  vtkNew<vtkFloatArray> few;
  few->SetName("ShadowFactor");
  few->SetNumberOfTuples(5);
  wrong->GetPointData()->AddArray(few);
  View spoilt(scene.Points, { light });
  View bare(scene.Points, { light });
  int errors = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&errors);
  count->SetCallback([](vtkObject*, unsigned long, void* n, void*) { ++*static_cast<int*>(n); });
  spoilt.Mapper->AddObserver(vtkCommand::ErrorEvent, count);
  spoilt.Mapper->SetInputData(wrong);
  const Picture a = spoilt.Win.Draw();
  checks.Expect(errors == 1, "No error on too few factors, or several.");
  checks.Expect(a.Pixels == bare.Win.Draw().Pixels, "Too few factors change the picture.");
}
}

int TestSplatsShadows(int, char*[])
{
  Checks checks;
  TestMethods(checks);
  TestTranslucent(checks);
  TestTranslucentLayers(checks);
  TestUpdates(checks);
  TestSaved(checks);
  return checks.Result();
}
