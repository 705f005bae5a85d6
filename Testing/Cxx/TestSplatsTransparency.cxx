// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Translucent layers: against closed forms, meshes with exact peeling, and in any order.
#include "SplatScene.h"

#include "vtkHardwareSelector.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlaneSource.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkInformation.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>

namespace
{
using namespace SplatScene;
using Colour = std::array<double, 3>;

struct Shell
{
  double Radius;
  Colour Rgb;
  double Opacity;
};
const std::vector<Shell> Nested = { { 1.0, { 0.2, 0.4, 0.9 }, 0.3 }, { 0.7, { 0.2, 0.8, 0.3 }, 0.5 },
  { 0.4, { 0.9, 0.6, 0.2 }, 1.0 } };
const Colour Background = { 0.1, 0.2, 0.4 };

void Unlit(vtkActor* actor, const Colour& rgb, double opacity)
{
  vtkProperty* property = actor->GetProperty();
  property->SetColor(rgb[0], rgb[1], rgb[2]);
  property->SetOpacity(opacity);
  property->SetAmbient(1.0);
  property->SetDiffuse(0.0);
  property->SetSpecular(0.0);
  property->LightingOff();
}

/**
 * Where the ray through a pixel crosses each shell, as (distance, shell), nearest first, of
 * those in front of the near plane; and how near it comes to an outline, in pixels.
 */
struct Crossing
{
  double Distance;
  size_t Shell;
};

double Field(bool torus, const double p[3], double r)
{
  if (!torus)
  {
    return std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) - r;
  }
  const double q = std::sqrt(p[0] * p[0] + p[1] * p[1]) - 1.0;
  return std::sqrt(q * q + p[2] * p[2]) - 0.5 * r;
}

std::vector<Crossing> Crossings(Window& window, bool torus, double x, double y)
{
  double from[4], to[4];
  vtkRenderer* renderer = window.Renderer;
  renderer->SetDisplayPoint(x, y, 0.0);
  renderer->DisplayToWorld();
  renderer->GetWorldPoint(from);
  renderer->SetDisplayPoint(x, y, 1.0);
  renderer->DisplayToWorld();
  renderer->GetWorldPoint(to);
  std::vector<Crossing> crossings;
  const int steps = 1500;
  for (size_t s = 0; s < Nested.size(); ++s)
  {
    double last = 0.0;
    for (int i = 0; i <= steps; ++i)
    {
      const double t = static_cast<double>(i) / steps;
      double p[3];
      for (int k = 0; k < 3; ++k)
      {
        p[k] = from[k] / from[3] + t * (to[k] / to[3] - from[k] / from[3]);
      }
      const double f = Field(torus, p, Nested[s].Radius);
      if (i > 0 && (f < 0) != (last < 0))
      {
        crossings.push_back({ t, s });
      }
      last = f;
    }
  }
  std::sort(crossings.begin(), crossings.end(),
    [](const Crossing& a, const Crossing& b) { return a.Distance < b.Distance; });
  return crossings;
}

Colour Composite(const std::vector<Crossing>& crossings)
{
  Colour result = { 0, 0, 0 };
  double left = 1.0;
  for (const Crossing& crossing : crossings)
  {
    const Shell& shell = Nested[crossing.Shell];
    for (int c = 0; c < 3; ++c)
    {
      result[c] += left * shell.Opacity * shell.Rgb[c];
    }
    left *= 1.0 - shell.Opacity;
  }
  for (int c = 0; c < 3; ++c)
  {
    result[c] += left * Background[c];
  }
  return result;
}

/**
 * Of nested tori or spheres, whose splats have their sizes: one each, which actors scale.
 */
struct Shells
{
  bool Torus;
  std::vector<vtkSmartPointer<vtkPolyData>> Clouds;

  explicit Shells(bool torus)
    : Torus(torus)
  {
    for (const Shell& shell : Nested)
    {
      this->Clouds.push_back(
        Estimated(torus ? RandomTorus(30000, 0.5 * shell.Radius) : RandomSphere(20000)));
    }
  }
};

/**
 * Nested shells, every pixel away from outlines against the closed form.
 */
void TestExact(
  Checks& checks, const Shells& shells, bool parallel, bool inside, bool peeling, bool quads)
{
  const bool torus = shells.Torus;
  const std::string what = std::string(torus ? "tori" : "spheres") +
    (parallel ? ", parallel" : ", perspective") + (inside ? ", inside" : "") +
    (peeling ? ", depth peeling" : "") + (quads ? ", quads" : "");
  Window window;
  window.Renderer->SetBackground(Background[0], Background[1], Background[2]);
  window.Renderer->SetUseDepthPeeling(peeling);
  window.Renderer->SetMaximumNumberOfPeels(20);
  window.Renderer->SetOcclusionRatio(0.0);
  std::vector<vtkSmartPointer<vtkPointSplatMapper>> mappers;
  for (const Shell& shell : Nested)
  {
    auto mapper = vtkSmartPointer<vtkPointSplatMapper>::New();
    mapper->SetInputData(shells.Clouds[mappers.size()]);
    if (quads)
    {
      mapper->SetProjectionToQuads();
    }
    vtkActor* actor = window.Add(mapper);
    if (!torus)
    {
      actor->SetScale(shell.Radius);
    }
    Unlit(actor, shell.Rgb, shell.Opacity);
    mappers.push_back(mapper);
  }
  vtkCamera* camera = window.Renderer->GetActiveCamera();
  camera->SetParallelProjection(parallel);
  window.Renderer->ResetCamera();
  camera->Elevation(torus ? 50 : 20);
  camera->Azimuth(30);
  camera->OrthogonalizeViewUp();
  if (inside)
  {
    // Between the shells, looking across.
    camera->SetPosition(torus ? 1.4 : 0.0, 0.0, torus ? 0.0 : 0.85);
    camera->SetFocalPoint(0.0, 0.3, 0.0);
    camera->SetViewUp(0, 1, 0);
    camera->SetViewAngle(60);
  }
  window.Renderer->ResetCameraClippingRange();
  if (inside)
  {
    camera->SetClippingRange(0.02, 6.0);
  }
  const Picture picture = window.Draw();
  int compared = 0;
  int wrong = 0;
  for (int y = 4; y < Size - 4; y += 13)
  {
    for (int x = 4; x < Size - 4; x += 13)
    {
      const std::vector<Crossing> crossings = Crossings(window, torus, x + 0.5, y + 0.5);
      bool outline = false;
      for (const int d : { -4, 4 })
      {
        outline = outline ||
          Crossings(window, torus, x + 0.5 + d, y + 0.5).size() != crossings.size() ||
          Crossings(window, torus, x + 0.5, y + 0.5 + d).size() != crossings.size();
      }
      if (outline)
      {
        continue;
      }
      ++compared;
      const Colour expected = Composite(crossings);
      for (int c = 0; c < 3; ++c)
      {
        if (std::abs(picture.At(x, y)[c] - 255.0 * expected[c]) > 2.0)
        {
          ++wrong;
          break;
        }
      }
    }
  }
  checks.AtLeast(compared, 250, what + ": pixels compared");
  checks.AtMost(wrong, 0, what + ": pixels that are not the closed form's of " +
      std::to_string(compared));
  checks.AtLeast(mappers[0]->GetNumberOfLayersDrawn(), inside ? 2 : 4, what + ": layers");
}

/**
 * Nested splats, of a cloud or else of the mesh, a translucent mesh between them, an opaque one, and a volume.
 */
Picture Mixed(const std::vector<int>& order, bool peeling, vtkPolyData* mesh, vtkPolyData* cloud)
{
  Window window;
  window.Renderer->SetBackground(Background[0], Background[1], Background[2]);
  window.Renderer->SetUseDepthPeeling(peeling);
  window.Renderer->SetMaximumNumberOfPeels(20);
  window.Renderer->SetOcclusionRatio(0.0);
  for (const int which : order)
  {
    if (which == 4)
    {
      vtkNew<vtkImageData> image;
      image->SetDimensions(8, 8, 8);
      image->SetSpacing(0.1, 0.1, 0.1);
      image->SetOrigin(0.9, 0.5, -0.35);
      image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
      std::fill_n(static_cast<unsigned char*>(image->GetScalarPointer()), 512, 200);
      vtkNew<vtkOpenGLGPUVolumeRayCastMapper> mapper;
      mapper->SetInputData(image);
      mapper->SetUseJittering(0);
      vtkNew<vtkPiecewiseFunction> opacity;
      opacity->AddPoint(0, 0.0);
      opacity->AddPoint(255, 0.05);
      vtkNew<vtkColorTransferFunction> colour;
      colour->AddRGBPoint(0, 1, 0, 0);
      colour->AddRGBPoint(255, 1, 0.5, 0);
      vtkNew<vtkVolume> volume;
      volume->SetMapper(mapper);
      volume->GetProperty()->SetScalarOpacity(opacity);
      volume->GetProperty()->SetColor(colour);
      window.Renderer->AddVolume(volume);
      continue;
    }
    vtkSmartPointer<vtkPolyDataMapper> mapper;
    if (which < 2 && cloud)
    {
      mapper = vtkSmartPointer<vtkPointSplatMapper>::New();
      mapper->SetInputData(cloud);
    }
    else
    {
      mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
      mapper->SetInputData(mesh);
    }
    vtkActor* actor = window.Add(mapper);
    const double scales[] = { 2.0, 1.2, 1.6, 0.6 }; // splats, splats, a mesh between, an opaque one
    actor->SetScale(scales[which]);
    actor->SetPosition(which == 3 ? 0.3 : 0.0, 0, 0);
    actor->GetProperty()->SetColor(which == 0, which == 1, which >= 2);
    actor->GetProperty()->SetOpacity(which == 3 ? 1.0 : 0.4);
  }
  window.Renderer->GetActiveCamera()->SetPosition(1, 2, 5);
  window.Renderer->ResetCamera(-1, 1.6, -1, 1.2, -1, 1);
  return window.Draw();
}

void TestMixed(Checks& checks)
{
  const vtkSmartPointer<vtkPolyData> mesh = MakeSphereMesh(300);
  const vtkSmartPointer<vtkPolyData> cloud = Estimated(Cloud(mesh));
  for (const bool peeling : { true, false })
  {
    const std::string what = peeling ? "depth peeling" : "order-independent pass";
    std::vector<int> order = { 0, 1, 2, 3, 4 };
    const Picture first = Mixed(order, peeling, mesh, cloud);
    for (const auto& other : { std::vector<int>{ 4, 3, 2, 1, 0 }, std::vector<int>{ 2, 0, 4, 1, 3 },
           std::vector<int>{ 1, 4, 0, 3, 2 } })
    {
      checks.AtMost(LargestDifference(first, Mixed(other, peeling, mesh, cloud)), 1,
        what + ": the order of actors changes the picture");
    }
    checks.AtLeast(PsnrOfAll(first, Mixed(order, peeling, mesh, nullptr)), peeling ? 28.0 : 26.0,
      what + ": like the scene of meshes");
  }
}

/**
 * The number of layers follows the scene; what an opaque mesh hides is not peeled.
 */
void TestNumberOfLayers(Checks& checks)
{
  Window window;
  vtkNew<vtkPointSplatMapper> mapper;
  mapper->SetInputData(Cloud(MakeSphereMesh()));
  vtkActor* actor = window.Add(mapper);
  actor->GetProperty()->SetOpacity(0.2);
  window.Renderer->ResetCamera();
  window.Draw();
  checks.Expect(mapper->GetNumberOfLayersDrawn() >= 2 && mapper->GetNumberOfLayersDrawn() <= 3,
    "a sphere has two layers, not " + std::to_string(mapper->GetNumberOfLayersDrawn()));
  const Picture clear = window.Draw();

  // Behind 0.99 and 0.99 the third of three nested ones can change nothing.
  Window three;
  vtkNew<vtkPointSplatMapper> mappers[3];
  for (int i = 0; i < 3; ++i)
  {
    mappers[i]->SetInputData(Cloud(MakeSphereMesh()));
    vtkActor* shell = three.Add(mappers[i]);
    shell->SetScale(1.0 - 0.25 * i);
    shell->GetProperty()->SetOpacity(0.99);
  }
  three.Draw();
  checks.AtMost(mappers[0]->GetNumberOfLayersDrawn(), 2, "layers that change nothing");

  mapper->SetMaximumNumberOfLayers(1);
  window.Draw();
  checks.Expect(mapper->GetNumberOfLayersDrawn() == 1, "one layer at most");
  mapper->SetMaximumNumberOfLayers(32);

  vtkNew<vtkPlaneSource> wall;
  wall->SetOrigin(-2, -2, 0);
  wall->SetPoint1(2, -2, 0);
  wall->SetPoint2(-2, 2, 0);
  vtkNew<vtkPolyDataMapper> plane;
  plane->SetInputConnection(wall->GetOutputPort());
  for (const int samples : { 0, 8 })
  {
    Window cut;
    cut.Win->SetMultiSamples(samples);
    vtkNew<vtkPointSplatMapper> sphere;
    sphere->SetInputData(Cloud(MakeSphereMesh()));
    vtkActor* translucent = cut.Add(sphere);
    translucent->GetProperty()->SetOpacity(0.2);
    Unlit(cut.Add(plane), { 1, 1, 1 }, 1.0);
    Unlit(translucent, { 1, 0, 0 }, 0.2);
    cut.Renderer->ResetCamera(-0.5, 0.5, -0.5, 0.5, -0.5, 0.5);
    const Picture picture = cut.Draw();
    const std::string what = "a wall through the sphere, " + std::to_string(samples) + " samples: ";
    checks.AtMost(sphere->GetNumberOfLayersDrawn(), samples ? 3 : 2, what + "layers");
    const unsigned char* centre = picture.At(Size / 2, Size / 2);
    checks.AtMost(std::abs(centre[1] - 204), 2, what + "one layer before it");
  }
}

void TestGather(Checks& checks)
{
  // Four layers, of which two are drawn: without gathering the others are lost, with it the
  // last drawn one stands for them.
  Window window;
  window.Renderer->SetBackground(1, 1, 1);
  vtkNew<vtkPointSplatMapper> mappers[2];
  for (int i = 0; i < 2; ++i)
  {
    mappers[i]->SetInputData(Cloud(MakeSphereMesh()));
    vtkActor* actor = window.Add(mappers[i]);
    actor->SetScale(i ? 1.0 : 1.6);
    Unlit(actor, i ? Colour{ 0, 1, 0 } : Colour{ 1, 0, 0 }, 0.5);
  }
  window.Renderer->ResetCamera();
  auto centre = [&]() {
    const Picture picture = window.Draw();
    const unsigned char* p = picture.At(Size / 2, Size / 2);
    return Colour{ { double(p[0]), double(p[1]), double(p[2]) } };
  };
  for (const bool quads : { false, true })
  {
    for (auto& mapper : mappers)
    {
      mapper->SetProjection(quads ? vtkPointSplatMapper::QUADS : 0);
      mapper->SetMaximumNumberOfLayers(2);
      mapper->SetGatherRemaining(false);
    }
    const Colour lost = centre();
    mappers[0]->SetGatherRemaining(true);
    const Colour gathered = centre();
    // Red over green over the background, without the two behind.
    checks.AtMost(std::abs(lost[0] - (127.5 + 0.25 * 255)), 3.0, "two of four layers, red");
    checks.AtMost(std::abs(lost[1] - (0.25 * 255 + 63.75)), 3.0, "two of four layers, green");
    // The gathered layer is the mean of two green ones and a red one: that is 21 levels from what
    // one green layer alone shows.
    checks.AtMost(std::abs(gathered[0] - (127.5 + 0.25 * 85 + 63.75)), 5.0, "gathered, red");
    checks.AtMost(std::abs(gathered[1] - (0.25 * 170 + 63.75)), 5.0, "gathered, green");
    checks.AtMost(std::abs(gathered[2] - 63.75), 3.0, "gathered, blue");
    checks.Expect(mappers[0]->GetNumberOfLayersDrawn() == 2, "gathered in two layers");
  }

  // A sphere's front and back are as bright as each other by a headlight, and so is their mean.
  Window lit;
  vtkNew<vtkPointSplatMapper> sphere;
  sphere->SetInputData(Cloud(MakeSphereMesh()));
  sphere->ScalarVisibilityOff();
  sphere->SetMaximumNumberOfLayers(1);
  vtkProperty* property = lit.Add(sphere)->GetProperty();
  property->SetOpacity(0.5);
  property->SetSpecular(0.0);
  property->SetAmbient(0.0);
  lit.Renderer->GetActiveCamera()->ParallelProjectionOn();
  lit.Renderer->ResetCamera();
  for (const int projection : { vtkPointSplatMapper::COMPUTE, vtkPointSplatMapper::QUADS })
  {
    sphere->SetProjection(projection);
    sphere->GatherRemainingOff();
    const Picture front = lit.Draw();
    sphere->GatherRemainingOn();
    checks.AtLeast(Psnr(front, lit.Draw()), 40.0, "light of a gathered front and back");
  }

  // A wall behind the first layer hides the others, which are not gathered then, in whatever way
  // layers are made.
  vtkNew<vtkPlaneSource> wall;
  wall->SetOrigin(-2, -2, 0.65);
  wall->SetPoint1(2, -2, 0.65);
  wall->SetPoint2(-2, 2, 0.65);
  vtkNew<vtkPolyDataMapper> plane;
  plane->SetInputConnection(wall->GetOutputPort());
  Unlit(window.Add(plane), { 1, 1, 1 }, 1.0);
  using Mapper = vtkPointSplatMapper;
  for (const auto& way : { std::make_pair(int(Mapper::COMPUTE), int(Mapper::TWO_PASS)),
         std::make_pair(int(Mapper::QUADS), int(Mapper::TWO_PASS)),
         std::make_pair(int(Mapper::COMPUTE), int(Mapper::IMAGE_SPACE)),
         std::make_pair(int(Mapper::QUADS), int(Mapper::IMAGE_SPACE)) })
  {
    for (auto& mapper : mappers)
    {
      mapper->SetProjection(way.first);
      mapper->SetMethod(way.second);
      mapper->SetMaximumNumberOfLayers(1);
    }
    const std::string what = std::string("gathered before a wall, ") +
      (way.first == Mapper::QUADS ? "quads" : "compute") +
      (way.second == Mapper::IMAGE_SPACE ? ", image space" : "");
    const Colour before = centre();
    checks.AtLeast(before[0], 252.0, what + ", red");
    checks.AtMost(std::abs(before[1] - 127.5), 3.0, what + ", green");
  }
}

/**
 * Opacities of points, from a lookup table.
 */
void TestPointOpacity(Checks& checks)
{
  vtkSmartPointer<vtkPolyData> sphere = Cloud(MakeSphereMesh());
  vtkNew<vtkFloatArray> scalars;
  for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
  {
    scalars->InsertNextValue(sphere->GetPoint(i)[0] < 0 ? 0.0f : 1.0f);
  }
  sphere->GetPointData()->SetScalars(scalars);
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(2);
  table->SetTableValue(0, 1, 0, 0, 0.25);
  table->SetTableValue(1, 0, 1, 0, 0.75);
  for (const bool quads : { false, true })
  {
    vtkNew<vtkPointSplatMapper> mapper;
    mapper->SetInputData(sphere);
    mapper->SetLookupTable(table);
    mapper->SetScalarRange(0, 1);
    mapper->SetProjection(quads ? vtkPointSplatMapper::QUADS : 0);
    Window window;
    window.Renderer->SetBackground(0, 0, 1);
    Unlit(window.Add(mapper), { 1, 1, 1 }, 1.0);
    window.Renderer->ResetCamera();
    const Picture picture = window.Draw();
    const unsigned char* left = picture.At(Size / 2 - 60, Size / 2);
    const unsigned char* right = picture.At(Size / 2 + 60, Size / 2);
    checks.AtMost(std::abs(left[0] - 255 * (1 - 0.75 * 0.75)), 3.0, "opacity 0.25, twice");
    checks.AtMost(std::abs(right[1] - 255 * (1 - 0.25 * 0.25)), 3.0, "opacity 0.75, twice");
    checks.AtMost(std::abs(left[2] - 255 * 0.5625), 3.0, "behind opacity 0.25, twice");
  }
}

void TestPicking(Checks& checks)
{
  Window window;
  vtkNew<vtkPointSplatMapper> mappers[2];
  vtkActor* actors[2];
  for (int i = 0; i < 2; ++i)
  {
    mappers[i]->SetInputData(Cloud(MakeSphereMesh()));
    actors[i] = window.Add(mappers[i]);
    actors[i]->SetScale(i ? 0.5 : 1.0);
    actors[i]->GetProperty()->SetOpacity(i ? 0.8 : 0.2);
  }
  window.Renderer->ResetCamera();
  window.Draw();
  auto pick = [&]() -> vtkProp* {
    vtkNew<vtkHardwareSelector> selector;
    selector->SetRenderer(window.Renderer);
    selector->SetArea(Size / 2, Size / 2, Size / 2, Size / 2);
    selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_POINTS);
    vtkSmartPointer<vtkSelection> selection;
    selection.TakeReference(selector->Select());
    return selection && selection->GetNumberOfNodes() == 1
      ? vtkProp::SafeDownCast(
          selection->GetNode(0)->GetProperties()->Get(vtkSelectionNode::PROP()))
      : nullptr;
  };
  checks.Expect(pick() == actors[0], "the nearest layer is picked");
  mappers[0]->SetPickOpacityThreshold(0.5);
  checks.Expect(pick() == actors[1], "faint actors are looked through");
}
}

int TestSplatsTransparency(int, char*[])
{
  Checks checks;
  for (const bool torus : { false, true })
  {
    const Shells shells(torus);
    for (const bool parallel : { false, true })
    {
      TestExact(checks, shells, parallel, false, false, false);
    }
    TestExact(checks, shells, false, true, false, false);
    TestExact(checks, shells, false, false, true, false);
    TestExact(checks, shells, false, false, false, true);
  }
  TestMixed(checks);
  TestNumberOfLayers(checks);
  TestGather(checks);
  TestPointOpacity(checks);
  TestPicking(checks);
  return checks.Failures ? EXIT_FAILURE : EXIT_SUCCESS;
}
