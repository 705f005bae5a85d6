// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Shadow textures against exact ray casting; reproducible, cached, and on bad input.
#include "ShadowScene.h"

#include "vtkCallbackCommand.h"
#include "vtkDoubleArray.h"
#include "vtkPointShadowTexture.h"
#include "vtkUnstructuredGrid.h"

namespace
{
using namespace ShadowScene;
using SplatScene::Checks;

std::vector<float> Factors(vtkPointShadowTexture* texture, int component = 0)
{
  texture->Update();
  vtkDataArray* array = texture->GetOutput()->GetPointData()->GetArray("ShadowFactor");
  std::vector<float> factors;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    factors.push_back(static_cast<float>(array->GetComponent(i, component)));
  }
  return factors;
}

/// Counts events, and keeps errors off the test's output.
struct Counter
{
  int Count = 0;
  vtkNew<vtkCallbackCommand> Command;
  Counter(vtkObject* object, unsigned long event)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback([](vtkObject*, unsigned long, void* self, void*) {
      ++static_cast<Counter*>(self)->Count;
    });
    object->AddObserver(event, this->Command);
  }
};

/// Lit or unlit, against ray casting, where no edge is within a pixel.
void CheckHard(Checks& checks, const std::string& name, const Scene& scene, vtkLight* light,
  double leastClear)
{
  vtkNew<vtkPointShadowTexture> texture;
  texture->SetInputData(scene.Points);
  texture->AddLight(light);
  const std::vector<float> byCompute = Factors(texture);
  texture->UseComputeShadersOff();
  const std::vector<float> byPoints = Factors(texture);
  const vtkIdType count = texture->GetOutput()->GetNumberOfPoints();
  checks.Expect(byCompute.size() == static_cast<size_t>(count), name + ": no factors");
  long different = 0;
  long clear = 0;
  long wrong = 0;
  long dark = 0;
  long asked = 0;
  Vector from;
  Vector to;
  light->GetTransformedPosition(from.data());
  light->GetTransformedFocalPoint(to.data());
  for (vtkIdType i = 0; i < count && byCompute.size() == byPoints.size(); ++i)
  {
    Vector p;
    texture->GetOutput()->GetPoint(i, p.data());
    const double inCone = Dot(Unit(Between(from, p)), Unit(Between(from, to)));
    if (light->GetPositional() && light->GetConeAngle() < 90.0 &&
      inCone < std::cos(vtkMath::RadiansFromDegrees(light->GetConeAngle())))
    {
      continue;
    }
    ++asked;
    const float factor = byCompute[static_cast<size_t>(i)];
    different += factor != byPoints[static_cast<size_t>(i)];
    bool isClear = false;
    const bool lit = IsLit(scene, light, p, texture->GetPixelSizeUsed(), isClear);
    clear += isClear;
    dark += isClear && !lit;
    wrong += isClear && (factor != (lit ? 1.0f : 0.0f));
  }
  std::cout << name << ": pixel " << texture->GetPixelSizeUsed() << ", map "
            << texture->GetResolutionUsed() << ", d~ " << texture->GetLayerDistanceUsed() << ", "
            << 100.0 * clear / asked << " % clear of edges, " << 100.0 * dark / clear
            << " % of them unlit, " << 100.0 * wrong / clear << " % wrong; " << different
            << " differ between compute and points\n";
  checks.AtMost(100.0 * wrong / clear, 1.0, name + ": per cent wrong");
  checks.AtLeast(100.0 * clear / asked, leastClear, name + ": per cent clear of edges");
  checks.AtLeast(100.0 * dark / clear, 10.0, name + ": per cent unlit");
  checks.AtMost(different, asked / 1000, name + ": differ between compute and points");
}

void TestHard(Checks& checks)
{
  const Vector middle{ 0.0, 0.0, 0.5 };
  const Spheres spheres(60000);
  CheckHard(checks, "spheres, directional", spheres, MakeLight({ 2, 1, 3 }, middle, false), 80.0);
  CheckHard(
    checks, "spheres, grazing", spheres, MakeLight({ 3, 0, 1 }, middle, false), 80.0);
  CheckHard(checks, "spheres, point outside", spheres, MakeLight({ 2, 1, 3 }, middle, true), 80.0);
  CheckHard(checks, "spheres, point far away", spheres, MakeLight({ 20, 10, 30 }, middle, true), 80.0);
  CheckHard(
    checks, "spheres, point inside", spheres, MakeLight({ 0.5, -0.6, 0.8 }, middle, true), 80.0);
  CheckHard(
    checks, "spheres, spot", spheres, MakeLight({ 0.5, -0.6, 2.8 }, middle, true, 25.0), 70.0);
  CheckHard(checks, "spheres, wide spot inside", spheres,
    MakeLight({ 0.5, -0.6, 1.2 }, { 0.2, 0.0, 0.0 }, true, 70.0), 70.0);
  const Tori tori(60000);
  CheckHard(checks, "tori, directional", tori, MakeLight({ 2, 1, 3 }, { 0, 0, 0 }, false), 60.0);
  CheckHard(checks, "tori, point outside", tori, MakeLight({ 1, 2, 2 }, { 0, 0, 0 }, true), 60.0);
  CheckHard(checks, "tori, point inside", tori, MakeLight({ 0, 0, 0.1 }, { 1, 0, 0 }, true), 60.0);

  // A mesh casts on the plane's points.
  Spheres one(10);
  one.Balls = { { { 0.0, 0.0, 0.9 }, 0.5 } };
  const auto plane = SplatScene::RandomSquare(40000);
  vtkNew<vtkSphereSource> mesh;
  mesh->SetCenter(0.0, 0.0, 0.9);
  mesh->SetRadius(0.5);
  mesh->SetThetaResolution(100);
  mesh->SetPhiResolution(50);
  mesh->Update();
  for (const bool positional : { false, true })
  {
    auto light = MakeLight({ 0.3, 0.2, 3 }, { 0, 0, 0 }, positional);
    vtkNew<vtkPointShadowTexture> texture;
    texture->SetInputData(plane);
    texture->AddLight(light);
    const std::vector<float> without = Factors(texture);
    checks.Expect(std::all_of(without.begin(), without.end(), [](float f) { return f == 1.0f; }),
      "A plane alone is in a shadow.");
    // The shadow is a twentieth of the plane's points.
    texture->AddOccluderData(mesh->GetOutput());
    long clear = 0;
    long wrong = 0;
    long dark = 0;
    const std::vector<float> factors = Factors(texture);
    for (vtkIdType i = 0; i < plane->GetNumberOfPoints(); ++i)
    {
      Vector p;
      plane->GetPoint(i, p.data());
      bool isClear = false;
      const bool lit = IsLit(one, light, p, texture->GetPixelSizeUsed(), isClear);
      clear += isClear;
      dark += isClear && !lit;
      wrong += isClear && factors[static_cast<size_t>(i)] != (lit ? 1.0f : 0.0f);
    }
    checks.AtLeast(dark, 1000l, "points in a mesh's shadow");
    checks.AtMost(100.0 * wrong / clear, 1.0, "per cent wrong of points beside a mesh");
  }
}

void TestSoft(Checks& checks)
{
  const Spheres scene(30000);
  const double radius = 0.12;
  // References of 1024 directions, or places, on a sunflower's spiral.
  for (const bool positional : { false, true })
  {
    auto light = MakeLight({ 1.0, 0.5, 3.0 }, { 0.0, 0.0, 0.5 }, positional);
    const double size = positional ? 3.0 * radius : radius;
    std::vector<double> reference;
    std::vector<size_t> ids;
    Vector from;
    Vector to;
    light->GetPosition(from.data());
    light->GetFocalPoint(to.data());
    const Vector axis = Unit(Between(from, to));
    Vector u;
    Vector v;
    Across(axis, u, v);
    for (size_t id = 0; id < 30000; id += 7)
    {
      Vector p;
      scene.Points->GetPoint(static_cast<vtkIdType>(id), p.data());
      if (p[2] != 0.0)
      {
        continue;
      }
      double lit = 0.0;
      for (int k = 0; k < 1024; ++k)
      {
        const double r = size * std::sqrt((k + 0.5) / 1024.0);
        const double a = 2.399963229728653 * k;
        const Vector off = Along(Along({ 0, 0, 0 }, r * std::cos(a), u), r * std::sin(a), v);
        Vector o = Along(from, 1.0, off);
        Vector d = Between(o, p);
        double distance = vtkMath::Normalize(d.data());
        if (!positional)
        {
          d = Unit(Along(axis, 1.0, off));
          o = Along(p, -10.0, d);
          distance = 10.0;
        }
        lit += scene.Cast(o, d).T > distance - 1e-3;
      }
      reference.push_back(lit / 1024.0);
      ids.push_back(id);
    }
    const long partly = std::count_if(
      reference.begin(), reference.end(), [](double f) { return f > 0.02 && f < 0.98; });
    checks.AtLeast(partly, 100l, "points in the half-shadow");

    vtkNew<vtkPointShadowTexture> texture;
    texture->SetInputData(scene.Points);
    texture->AddLight(light);
    texture->SetLightRadius(size);
    double last = 0.0;
    for (const int samples : { 1, 4, 16, 64 })
    {
      texture->SetNumberOfSamples(samples);
      const std::vector<float> factors = Factors(texture);
      double sum = 0.0;
      for (size_t k = 0; k < ids.size(); ++k)
      {
        sum += std::abs(factors[ids[k]] - reference[k]);
      }
      const double error = sum / static_cast<double>(ids.size());
      std::cout << (positional ? "positional" : "directional") << " light of " << samples
                << " samples: mean error " << error << "\n";
      if (samples > 1)
      {
        checks.AtMost(error, 0.75 * last, "mean error of " + std::to_string(samples) + " samples");
      }
      last = error;
    }
    checks.AtMost(last, 0.01, "mean error of 64 samples");
  }
}

void TestReproducible(Checks& checks)
{
  const Spheres scene(10000);
  auto light = MakeLight({ 2, 1, 3 }, { 0, 0, 0.5 }, false);
  vtkNew<vtkPointShadowTexture> texture;
  texture->SetInputData(scene.Points);
  texture->AddLight(light);
  texture->SetLightRadius(0.1);
  texture->SetNumberOfSamples(5);
  const std::vector<float> first = Factors(texture);
  texture->SetSeed(2);
  checks.Expect(Factors(texture) != first, "Another seed gives the same factors.");
  texture->SetSeed(1);
  checks.Expect(Factors(texture) == first, "The same seed gives other factors.");

  // The same points from last to first.
  const vtkIdType count = scene.Points->GetNumberOfPoints();
  vtkNew<vtkPolyData> reversed;
  vtkNew<vtkPoints> points;
  points->SetDataType(scene.Points->GetPoints()->GetDataType());
  reversed->GetPointData()->CopyAllocate(scene.Points->GetPointData(), count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    points->InsertNextPoint(scene.Points->GetPoint(count - 1 - i));
    reversed->GetPointData()->CopyData(scene.Points->GetPointData(), count - 1 - i, i);
  }
  reversed->SetPoints(points);
  texture->SetInputData(reversed);
  std::vector<float> backwards = Factors(texture);
  std::reverse(backwards.begin(), backwards.end());
  checks.Expect(backwards == first, "Factors depend on the points' order.");

  // Nothing is done again unless something changes.
  Counter executions(texture, vtkCommand::EndEvent);
  texture->Update();
  checks.AtMost(executions.Count, 0, "executions where nothing changed");
  light->SetPosition(2, 0, 3);
  texture->Update();
  checks.Expect(executions.Count == 1, "A light that moved does not bring the filter to execute.");

  // One component a light, each as if it were alone.
  texture->AddLight(MakeLight({ 0.5, -0.6, 0.8 }, { 0, 0, 0 }, true));
  texture->SetNumberOfSamples(1);
  const std::vector<float> second = Factors(texture, 1);
  texture->RemoveAllLights();
  texture->AddLight(MakeLight({ 0.5, -0.6, 0.8 }, { 0, 0, 0 }, true));
  checks.Expect(second == Factors(texture), "Lights depend on each other.");
}

void TestBadInput(Checks& checks)
{
  const Spheres scene(3000);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  auto light = MakeLight({ 2, 1, 3 }, { 0, 0, 0.5 }, false);
  vtkNew<vtkPointShadowTexture> texture;
  Counter errors(texture, vtkCommand::ErrorEvent);
  texture->SetInputData(scene.Points);
  checks.Expect(Factors(texture).empty() && errors.Count == 1, "No error without lights.");
  texture->AddLight(MakeLight({ nan, 1, 3 }, { 0, 0, 0.5 }, false));
  checks.Expect(Factors(texture).empty() && errors.Count == 2, "No error on a light at NaN.");
  texture->RemoveAllLights();
  texture->AddLight(light);
  texture->SetNumberOfSamples(0);
  checks.Expect(texture->GetNumberOfSamples() == 1, "0 samples.");
  const std::vector<float> good = Factors(texture);
  checks.Expect(good.size() == 3000, "No factors.");

  // No points; one; many at one place.
  vtkNew<vtkPolyData> none;
  texture->SetInputData(none);
  checks.Expect(Factors(texture).empty(), "Factors of no points.");
  for (const int count : { 1, 50 })
  {
    texture->SetInputData(SplatScene::RandomCloud(count, [](double, double, double* p, double* n) {
      p[0] = p[1] = p[2] = n[0] = n[1] = 0.0;
      n[2] = 1.0;
    }));
    const std::vector<float> factors = Factors(texture);
    checks.Expect(factors.size() == static_cast<size_t>(count), "No factors of points at one place.");
  }

  // A light at a point, and one that shines on itself.
  double p[3];
  scene.Points->GetPoint(17, p);
  texture->RemoveAllLights();
  texture->AddLight(MakeLight({ p[0], p[1], p[2] }, { p[0], p[1], p[2] }, true));
  texture->SetInputData(scene.Points);
  checks.Expect(Factors(texture).size() == 3000, "No factors of a light at a point.");
  texture->RemoveAllLights();
  texture->AddLight(light);

  // Points and normals that are no numbers, far away or zero leave the others as they are, but for the six
  // or so around each, whose disks close where it is missing.
  vtkNew<vtkPolyData> spoilt;
  spoilt->DeepCopy(scene.Points);
  std::vector<vtkIdType> bad{ 3, 100, 101, 2999 };
  spoilt->GetPoints()->SetPoint(bad[0], nan, 0, 0);
  spoilt->GetPointData()->GetNormals()->SetTuple3(bad[1], 0, 0, 0);
  spoilt->GetPointData()->GetNormals()->SetTuple3(bad[2], nan, 0, 1);
  spoilt->GetPointData()->GetArray("SplatRadius")->SetTuple1(bad[3], -1.0);
  spoilt->GetPoints()->Modified();
  texture->SetInputData(spoilt);
  vtkObject::GlobalWarningDisplayOff();
  const std::vector<float> factors = Factors(texture);
  vtkObject::GlobalWarningDisplayOn();
  long changed = 0;
  for (size_t i = 0; i < factors.size(); ++i)
  {
    const bool isBad = std::find(bad.begin(), bad.end(), static_cast<vtkIdType>(i)) != bad.end();
    checks.Expect(!isBad || factors[i] == 1.0f, "A point that cannot be drawn is unlit.");
    changed += !isBad && factors[i] != good[i];
  }
  checks.AtMost(changed, 6l * static_cast<long>(bad.size()), "points that a few bad ones changed");

  // Without normals: they are estimated. With ones of another number: an error.
  vtkNew<vtkUnstructuredGrid> bare;
  bare->SetPoints(scene.Points->GetPoints());
  texture->SetInputData(bare);
  checks.Expect(Factors(texture).size() == 3000, "No factors of points without normals.");
  vtkNew<vtkPolyData> wrong;
  wrong->SetPoints(scene.Points->GetPoints());
  vtkNew<vtkDoubleArray> normals;
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(5);
  normals->Fill(1.0);
  wrong->GetPointData()->SetNormals(normals);
  texture->SetInputData(wrong);
  const int before = errors.Count;
  checks.Expect(
    Factors(texture).empty() && errors.Count == before + 1, "No error on too few normals.");

  // Far from the origin, as in UTM.
  vtkNew<vtkPolyData> far;
  far->DeepCopy(scene.Points);
  vtkNew<vtkPoints> moved;
  moved->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < far->GetNumberOfPoints(); ++i)
  {
    far->GetPoint(i, p);
    moved->InsertNextPoint(p[0] + 4e5, p[1] + 5e6, p[2]);
  }
  far->SetPoints(moved);
  texture->RemoveAllLights();
  texture->AddLight(MakeLight({ 4e5 + 2, 5e6 + 1, 3 }, { 4e5, 5e6, 0.5 }, false));
  texture->SetInputData(far);
  const std::vector<float> away = Factors(texture);
  long differing = 0;
  for (size_t i = 0; i < away.size(); ++i)
  {
    differing += away[i] != good[i];
  }
  checks.AtMost(differing, 10l, "points that change far from the origin");
}
}

int TestPointShadowTexture(int, char*[])
{
  Checks checks;
  TestHard(checks);
  TestSoft(checks);
  TestReproducible(checks);
  TestBadInput(checks);
  return checks.Result();
}
