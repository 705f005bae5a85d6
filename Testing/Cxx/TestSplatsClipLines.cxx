// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Splats that end at clip lines, drawn by every method, against the rays that hit their faces: each
// pixel shows one face's colour, or none, and that of the face that is there.
#include "ClipScene.h"

#include "vtkCallbackCommand.h"
#include "vtkCameraPass.h"
#include "vtkDoubleArray.h"
#include "vtkHardwareSelector.h"
#include "vtkLight.h"
#include "vtkPointShadowTexture.h"
#include "vtkPointSplatPass.h"
#include "vtkRenderPassCollection.h"
#include "vtkSequencePass.h"
#include "vtkTransform.h"

namespace
{
using namespace ClipScene;
using SplatScene::Checks;

// Pixels: splats go on for a sixteenth beyond their lines, which is more along x and y.
constexpr double Still = 0.0625 * 1.42;

const View Full{ "full", { 3.1, 2.3, 2.6 }, { 0.5, 0.5, 0.5 }, 25.0, false, Still };
const View Close{ "close", { 1.5, 1.3, 1.5 }, { 1.0, 1.0, 1.0 }, 20.0, false, Still };
const View Huge{ "huge", { 1.2, 1.15, 1.25 }, { 1.0, 1.0, 1.0 }, 15.0, false, Still };
const View Inside{ "reflex", { 1.6, 1.9, 2.2 }, { 0.45, 0.45, 0.8 }, 18.0, false, Still };
const View Parallel{ "parallel", { 3.1, 2.3, 2.6 }, { 0.5, 0.5, 0.5 }, 1.8, true, Still };
const View ParallelClose{ "parallel close", { 3.1, 2.3, 2.6 }, { 1.0, 0.4, 1.0 }, 0.2, true,
  Still };
// The prefilter blends what is within a pixel.
const View Far{ "far", { 3.1, 2.3, 2.6 }, { 0.5, 0.5, 0.5 }, 70.0, false, 1.25 };

void Report(Checks& checks, const std::string& name, const Count& count)
{
  std::cout << name << ": " << count.Holes << " holes, " << count.Spilt << " spilt, " << count.Wrong
            << " wrong of " << count.Edges << " pixels at edges and "
            << count.Inside << " others\n";
  checks.Expect(count.Inside > 0 && count.Edges > 0, name + " shows no faces");
  checks.Expect(count.Faults() == 0, name + " has faults");
}

using Setting = std::function<void(vtkPointSplatMapper*)>;

const std::vector<std::pair<const char*, Setting>> Methods = {
  { "tiles", [](vtkPointSplatMapper* m) { m->SetMethodToTwoPass(); } },
  { "tiles of the device", [](vtkPointSplatMapper* m) { m->SetTileListsToDevice(); } },
  { "quads", [](vtkPointSplatMapper* m) { m->SetProjectionToQuads(); } },
  { "deferred", [](vtkPointSplatMapper* m) { m->SetMethodToDeferred(); } },
};

void Expected(Checks& checks, const std::string& name, Scene& scene, const View& view,
  Mean mean = OfFaces)
{
  scene.Look(view);
  Report(checks, name + ", " + view.Name, Compare(scene.Win.Draw(), scene, view.Blur, mean));
}

/// Every method from every side; and by the same measure splats without lines fail.
void TestMethods(Checks& checks)
{
  const auto corner = Splats(Corner(), Sampling());
  for (const auto& method : Methods)
  {
    Scene scene(Corner(), corner);
    method.second(scene.Mapper);
    for (const View& view : { Full, Close, Huge, Inside, Parallel, ParallelClose, Far })
    {
      Expected(checks, method.first, scene, view);
    }
    vtkNew<vtkPolyData> bare;
    bare->ShallowCopy(corner);
    bare->GetPointData()->RemoveArray("SplatClip");
    Scene whole(Corner(), bare);
    method.second(whole.Mapper);
    whole.Look(Full);
    checks.AtLeast(Compare(whole.Win.Draw(), whole, Full.Blur).Faults(), 500,
      std::string(method.first) + ": faults without lines");
  }
}

/// What changes splats but not where they end.
void TestPlacement(Checks& checks)
{
  const auto place = [](Scene& scene) {
    vtkNew<vtkTransform> transform;
    transform->RotateWXYZ(25.0, 1.0, 2.0, 3.0);
    transform->Scale(0.7, 1.4, 1.1);
    scene.Actor->SetUserTransform(transform);
  };
  Sampling coarse;
  coarse.Reach = 6.0;
  Sampling ellipses;
  ellipses.Aspect = 1.7;
  for (const auto& method : Methods)
  {
    const std::string name = method.first;
    Scene scene(Corner(), Splats(Corner(), coarse));
    method.second(scene.Mapper);
    scene.Mapper->SetRadiusScale(1.8);
    Expected(checks, name + " with larger splats", scene, Full);
    scene.Mapper->SetRadiusScale(1.0);
    scene.Mapper->SetKernelToPlateau();
    Expected(checks, name + " with plateaus", scene, Full);
    place(scene);
    for (const View& view : { Full, Parallel })
    {
      Expected(checks, name + " under a matrix", scene, view);
    }
    Scene elliptical(Corner(), Splats(Corner(), ellipses));
    method.second(elliptical.Mapper);
    Expected(checks, name + " with ellipses", elliptical, Full);
    Expected(checks, name + " with ellipses", elliptical, Close);
    place(elliptical);
    Expected(checks, name + " with ellipses under a matrix", elliptical, Full);
  }
  Scene far(Corner(), Splats(Corner(), Sampling()));
  double away[3] = { 1e5, 2e5, 0.0 };
  far.Actor->SetPosition(away);
  View view = Full;
  for (size_t k = 0; k < 3; ++k)
  {
    view.Position[k] += away[k];
    view.Focus[k] += away[k];
  }
  Expected(checks, "far from the origin", far, view);
}

/// Colours beside those of a normal: the light's share.
void TestNormals(Checks& checks)
{
  for (const auto& method : Methods)
  {
    const auto splats = Splats(Cube(), Sampling());
    splats->GetPointData()->SetScalars(nullptr);
    Scene scene(Cube(), splats);
    method.second(scene.Mapper);
    scene.Actor->GetProperty()->SetColor(1, 1, 1);
    scene.Actor->GetProperty()->SetAmbient(0.0);
    scene.Actor->GetProperty()->SetDiffuse(1.0);
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->SetPosition(2.0, 3.0, 4.0);
    light->SetFocalPoint(0.0, 0.0, 0.0);
    scene.Win.Renderer->AddLight(light);
    for (Face& face : scene.Shape.Faces)
    {
      const double share = std::max(Dot(face.Normal, Unit({ 2.0, 3.0, 4.0 })), 0.0);
      face.Colour.fill(static_cast<unsigned char>(std::lround(255.0 * share)));
    }
    Expected(checks, std::string(method.first) + " lit", scene, Full, OfNormals);
    Expected(checks, std::string(method.first) + " lit", scene, Parallel, OfNormals);
  }
}

/// Outlines are blended with what is beyond, and nothing else is.
void TestOutlines(Checks& checks)
{
  const auto splats = Splats(Corner(), Sampling());
  for (const bool device : { false, true })
  {
    Scene scene(Corner(), splats, true);
    scene.Mapper->SetTileLists(
      device ? vtkPointSplatMapper::DEVICE : vtkPointSplatMapper::PROCESSOR);
    for (const View& view : { Full, Close, Parallel })
    {
      scene.Look(view);
      Report(checks, std::string("smooth outlines, ") + view.Name,
        Compare(scene.Win.Draw(), scene, 1.0, WithBackground));
    }
  }
}

/// What layers of half opacity make of the hits of a ray.
std::array<double, 3> Blend(const Body& body, const std::vector<Hit>& hits)
{
  std::array<double, 3> colour{};
  double light = 1.0;
  for (const Hit& hit : hits)
  {
    for (size_t c = 0; c < 3; ++c)
    {
      colour[c] += 0.5 * light * body.Faces[static_cast<size_t>(hit.Face)].Colour[c];
    }
    light *= 0.5;
  }
  return colour;
}

/// Translucent layers, where no two of them make one and no edge is near.
void TestLayers(Checks& checks)
{
  const std::vector<std::pair<const char*, Setting>> ways = {
    { "peeled by tiles", [](vtkPointSplatMapper* m) { m->SetTransparencyToPeeling(); } },
    { "peeled by quads", [](vtkPointSplatMapper* m) { m->SetProjectionToQuads(); } },
    { "sorted", [](vtkPointSplatMapper* m) { m->SetTransparencyToSorted(); } },
    { "nearest exact", [](vtkPointSplatMapper* m) { m->SetTransparencyToNearestExact(); } },
  };
  Sampling sampling;
  sampling.Reach = 5.0; // sorted splats are drawn twice as large
  const auto splats = Splats(Corner(), sampling);
  vtkNew<vtkPolyData> bare;
  bare->ShallowCopy(splats);
  bare->GetPointData()->RemoveArray("SplatClip");
  for (const auto& way : ways)
  {
    int wrong[2] = { 0, 0 };
    for (const bool clipped : { false, true })
    {
      Scene scene(Corner(), clipped ? splats.Get() : bare.Get());
      way.second(scene.Mapper);
      scene.Actor->GetProperty()->SetOpacity(0.5);
      scene.Look(Full);
      const Picture picture = scene.Win.Draw();
      const Rays rays(scene.Win.Renderer, scene.Actor);
      int asked = 0;
      for (int y = 1; y < picture.Height; ++y)
      {
        for (int x = 1; x < picture.Width; ++x)
        {
          // By the ray's length, from the near to the far clipping plane: about 2.
          const std::vector<Hit> hits = rays.Cast(scene.Shape, x + 0.5, y + 0.5);
          bool clear = true;
          for (size_t k = 0; k + 1 < hits.size(); ++k)
          {
            clear = clear && hits[k + 1].At - hits[k].At > 0.15;
          }
          for (int k = 0; k < 9 && clear; ++k)
          {
            const std::vector<Hit> other = rays.Cast(
              scene.Shape, x + 0.5 + 0.25 * (k % 3 - 1), y + 0.5 + 0.25 * (k / 3 - 1));
            clear = other.size() == hits.size() &&
              std::equal(hits.begin(), hits.end(), other.begin(),
                [](const Hit& a, const Hit& b) { return a.Face == b.Face; });
          }
          const std::array<double, 3> wanted = Blend(scene.Shape, hits);
          double off = 0.0;
          for (size_t c = 0; c < 3; ++c)
          {
            off = std::max(off, std::abs(wanted[c] - picture.At(x, y)[c]));
          }
          asked += clear;
          wrong[clipped] += clear && off > 8.0;
        }
      }
      std::cout << way.first << (clipped ? "" : " without lines") << ": " << wrong[clipped]
                << " wrong of " << asked << "\n";
      checks.AtLeast(asked, 10000, std::string(way.first) + ": pixels asked");
    }
    checks.AtMost(wrong[1], wrong[0] / 20, std::string(way.first) + ": wrong pixels");
  }
}

/// The point that is picked is of the face that is seen. Whatever the method, no groups are drawn.
void TestPicking(Checks& checks)
{
  const auto splats = Splats(Corner(), Sampling());
  for (const auto& method : Methods)
  {
    if (std::string(method.first) == "deferred")
    {
      continue;
    }
    Scene scene(Corner(), splats);
    method.second(scene.Mapper);
    scene.Look(Full);
    scene.Win.Draw();
    const Rays rays(scene.Win.Renderer, scene.Actor);
    vtkNew<vtkHardwareSelector> selector;
    selector->SetRenderer(scene.Win.Renderer);
    selector->SetArea(0, 0, SplatScene::Size - 1, SplatScene::Size - 1);
    selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_POINTS);
    checks.Expect(selector->CaptureBuffers(), "nothing is captured");
    auto* colours =
      vtkUnsignedCharArray::SafeDownCast(splats->GetPointData()->GetScalars());
    int asked = 0;
    int wrong = 0;
    for (unsigned int y = 0; y < SplatScene::Size; ++y)
    {
      for (unsigned int x = 0; x < SplatScene::Size; ++x)
      {
        const int face = Nearest(rays.Cast(scene.Shape, x + 0.5, y + 0.5));
        bool clear = true;
        for (int k = 0; k < 9; ++k)
        {
          clear = clear && face == Nearest(rays.Cast(scene.Shape, x + 0.5 + Still * (k % 3 - 1),
                                     y + 0.5 + Still * (k / 3 - 1)));
        }
        if (!clear)
        {
          continue;
        }
        const unsigned int place[2] = { x, y };
        const vtkHardwareSelector::PixelInformation info = selector->GetPixelInformation(place, 0);
        unsigned char rgb[3] = { 0, 0, 0 };
        if (info.Valid && info.AttributeID >= 0)
        {
          colours->GetTypedTuple(info.AttributeID, rgb);
        }
        ++asked;
        wrong += !Shows(rgb, scene.Shape, face);
      }
    }
    selector->ClearBuffers();
    checks.AtLeast(asked, 10000, std::string(method.first) + ": pixels picked at");
    checks.AtMost(wrong, 0, std::string(method.first) + ": points of another face picked");
  }
}

/// A floor is unlit under a body, and not beside it.
void TestShadows(Checks& checks)
{
  const Sampling sampling;
  const auto body = Splats(Corner(), sampling);
  const vtkIdType count = body->GetNumberOfPoints();
  vtkNew<vtkPolyData> scene;
  scene->DeepCopy(body);
  auto* normals = scene->GetPointData()->GetNormals();
  constexpr int side = 150;
  for (int i = 0; i < side * side; ++i)
  {
    scene->GetPoints()->InsertNextPoint(
      -0.5 + 2.0 * (i % side) / side, -0.5 + 2.0 * (i / side) / side, -0.5);
    normals->InsertNextTuple3(0.0, 0.0, 1.0);
    scene->GetPointData()->GetArray("SplatRadius")->InsertNextTuple1(0.02);
    scene->GetPointData()->GetScalars()->InsertNextTuple3(255, 255, 255);
    const double none[6] = { 0, 0, 0, 0, 0, 0 };
    scene->GetPointData()->GetArray("SplatClip")->InsertNextTuple(none);
  }
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(0.0, 0.0, 5.0);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  for (const bool positional : { false, true })
  {
    light->SetPositional(positional);
    for (const bool compute : { true, false })
    {
      int wrong[2] = { 0, 0 };
      int asked = 0;
      for (const bool clipped : { false, true })
      {
        vtkNew<vtkPolyData> data;
        data->ShallowCopy(scene);
        if (!clipped)
        {
          data->GetPointData()->RemoveArray("SplatClip");
        }
        vtkNew<vtkPointShadowTexture> texture;
        texture->SetInputData(data);
        texture->AddLight(light);
        texture->SetUseComputeShaders(compute);
        texture->Update();
        vtkDataArray* factors = texture->GetOutput()->GetPointData()->GetArray("ShadowFactor");
        checks.Expect(factors != nullptr, "no factors");
        asked = 0;
        for (vtkIdType i = count; factors && i < data->GetNumberOfPoints(); ++i)
        {
          Vector p;
          data->GetPoint(i, p.data());
          const Vector from = positional ? Vector{ 0.0, 0.0, 5.0 } : Sum(p, 5.0, { 0, 0, 1 });
          const double pixel = texture->GetPixelSizeUsed() * (positional ? 5.5 : 1.0);
          bool lit[5];
          for (int k = 0; k < 5; ++k)
          {
            const Vector to = Sum(p, pixel, { k == 1 ? 1.0 : k == 2 ? -1.0 : 0.0,
                                              k == 3 ? 1.0 : k == 4 ? -1.0 : 0.0, 0.0 });
            lit[k] = Corner().Cast(positional ? from : Sum(to, 5.0, { 0, 0, 1 }), to).empty();
          }
          if (std::all_of(lit, lit + 5, [&lit](bool other) { return other == lit[0]; }))
          {
            ++asked;
            wrong[clipped] += factors->GetComponent(i, 0) != (lit[0] ? 1.0 : 0.0);
          }
        }
      }
      const std::string name = std::string(positional ? "point light" : "directional light") +
        (compute ? " by compute" : " by points");
      std::cout << name << ": " << wrong[0] << " wrong without lines, " << wrong[1] << " with, of "
                << asked << "\n";
      checks.AtLeast(wrong[0], 100, name + ": wrong without lines");
      checks.AtMost(wrong[1], 0, name + ": wrong");
    }
  }
}

/// The pass draws as the mapper does.
void TestPass(Checks& checks)
{
  const auto splats = Splats(Corner(), Sampling());
  Scene scene(Corner(), splats);
  vtkNew<vtkPointSplatPass> pass;
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(pass);
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(sequence);
  scene.Win.Renderer->SetPass(camera);
  Expected(checks, "pass", scene, Full);
}

/// Errors of a picture, which are kept off the output.
struct Errors
{
  int Number = 0;
  vtkNew<vtkCallbackCommand> Command;
  explicit Errors(vtkObject* object)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback([](vtkObject*, unsigned long, void* self, void*) {
      ++static_cast<Errors*>(self)->Number;
    });
    object->AddObserver(vtkCommand::ErrorEvent, this->Command);
  }
};

void TestBadInput(Checks& checks)
{
  const auto splats = Splats(Cube(), Sampling());
  const auto draw = [&](vtkPolyData* data, int* errors = nullptr) {
    Scene scene(Cube(), data);
    const Errors seen(scene.Mapper);
    scene.Look(Full);
    const Picture picture = scene.Win.Draw();
    if (errors)
    {
      *errors = seen.Number;
    }
    return picture;
  };
  const auto with = [&](vtkDataArray* lines) {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->ShallowCopy(splats);
    data->GetPointData()->RemoveArray("SplatClip");
    if (lines)
    {
      lines->SetName("SplatClip");
      data->GetPointData()->AddArray(lines);
    }
    return data;
  };
  const Picture whole = draw(with(nullptr));
  const Picture clipped = draw(splats);
  checks.Expect(whole.Pixels != clipped.Pixels, "lines change nothing");

  vtkNew<vtkFloatArray> narrow;
  narrow->SetNumberOfComponents(3);
  narrow->SetNumberOfTuples(splats->GetNumberOfPoints());
  narrow->FillValue(10.0f);
  int errors = 0;
  checks.Expect(draw(with(narrow), &errors).Pixels == whole.Pixels, "3 components are used");
  checks.Expect(errors > 0, "3 components are no error");
  vtkNew<vtkFloatArray> few;
  few->SetNumberOfComponents(6);
  few->SetNumberOfTuples(7);
  few->FillValue(10.0f);
  checks.Expect(draw(with(few), &errors).Pixels == whole.Pixels, "7 tuples are used");
  checks.Expect(errors > 0, "7 tuples are no error");

  for (const double value : { std::nan(""), HUGE_VAL, -HUGE_VAL, 0.0 })
  {
    vtkNew<vtkDoubleArray> bad;
    bad->SetNumberOfComponents(6);
    bad->SetNumberOfTuples(splats->GetNumberOfPoints());
    for (int c = 0; c < 6; ++c)
    {
      bad->FillComponent(c, value);
    }
    checks.Expect(draw(with(bad), &errors).Pixels == whole.Pixels,
      "lines of " + std::to_string(value) + " cut");
    checks.AtMost(errors, 0, "errors for lines of " + std::to_string(value));
  }
  // Lines that leave half a splat at most: nothing is drawn where there is no face.
  vtkNew<vtkDoubleArray> mixed;
  mixed->DeepCopy(splats->GetPointData()->GetArray("SplatClip"));
  for (vtkIdType i = 0; i < splats->GetNumberOfPoints(); i += 20)
  {
    double lines[6];
    mixed->GetTuple(i, lines);
    if (std::all_of(lines, lines + 6, [](double c) { return c == 0.0; }))
    {
      mixed->SetTuple6(i, 1e300, -1e300, 1e300, 1e30, 1e30, -1e30);
    }
  }
  const auto data = with(mixed);
  Scene scene(Cube(), data);
  scene.Look(Full);
  const Count count = Compare(scene.Win.Draw(), scene, Full.Blur);
  checks.AtMost(count.Spilt, 0, "spilt by huge lines");
  checks.AtMost(count.Holes + count.Wrong, count.Inside / 10, "others spoilt by huge lines");
  // Normals are lines that lie along the normal, and cut nothing.
  vtkNew<vtkFloatArray> along;
  along->SetNumberOfComponents(6);
  for (vtkIdType i = 0; i < splats->GetNumberOfPoints(); ++i)
  {
    double n[3];
    splats->GetPointData()->GetNormals()->GetTuple(i, n);
    along->InsertNextTuple6(9 * n[0], 9 * n[1], 9 * n[2], 0.0, 0.0, 0.0);
  }
  checks.AtMost(SplatScene::LargestDifference(draw(with(along)), whole), 1, "lines along normals");
}
}

int TestSplatsClipLines(int, char*[])
{
  Checks checks;
  TestMethods(checks);
  TestPlacement(checks);
  TestNormals(checks);
  TestOutlines(checks);
  TestLayers(checks);
  TestPicking(checks);
  TestShadows(checks);
  TestPass(checks);
  TestBadInput(checks);
  return checks.Result();
}
