// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Points that move keep the sizes that were estimated for them: pictures are those of new sizes, of even and uneven points, at
// creases, with levels, in shadows, and points are picked where they are. Where sizes cannot follow, they are estimated anew.
#include "LevelScene.h"
#include "PickedPoints.h"
#include "RimmedDisc.h"

#include "vtkCallbackCommand.h"
#include "vtkGenericRenderWindowInteractor.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPlaneSource.h"
#include "vtkTestErrorObserver.h"
#include "vtkTransform.h"

#include <chrono>
#include <functional>
#include <string>
#include <thread>

namespace
{
using namespace SplatScene;
using Place = std::function<void(double p[3], double n[3])>;

/// A cloud whose points are moved from where they were at first.
struct Moving
{
  explicit Moving(vtkPolyData* data)
    : Data(data)
  {
    this->Points->DeepCopy(data->GetPoints());
    this->Normals->DeepCopy(data->GetPointData()->GetNormals());
  }
  /// In new arrays, as readers make them for each time step, or in the same ones.
  void To(const Place& place, bool inPlace = true)
  {
    vtkNew<vtkPoints> points;
    vtkNew<vtkFloatArray> normals;
    normals->DeepCopy(this->Normals);
    points->DeepCopy(this->Points);
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      double p[3], n[3];
      this->Points->GetPoint(i, p);
      this->Normals->GetTuple(i, n);
      place(p, n);
      points->SetPoint(i, p);
      normals->SetTuple(i, n);
    }
    if (inPlace)
    {
      this->Data->GetPoints()->DeepCopy(points);
      this->Data->GetPointData()->GetNormals()->DeepCopy(normals);
      this->Data->GetPoints()->Modified();
      this->Data->GetPointData()->GetNormals()->Modified();
      return;
    }
    this->Data->SetPoints(points);
    this->Data->GetPointData()->SetNormals(normals);
  }

  vtkPolyData* Data;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkFloatArray> Normals;
};

/// By a linear map, and normals likewise.
Place By(const std::function<void(vtkTransform*)>& make)
{
  vtkNew<vtkTransform> transform;
  make(transform);
  transform->Update();
  const vtkSmartPointer<vtkTransform> held = transform.Get();
  return [held](double p[3], double n[3]) {
    double q[3];
    held->TransformPoint(p, q);
    std::copy(q, q + 3, p);
    held->TransformNormal(n, q);
    std::copy(q, q + 3, n);
    vtkMath::Normalize(n);
  };
}

Place Turned(double degrees)
{
  return By([degrees](vtkTransform* t) { t->RotateWXYZ(degrees, 1.0, 0.3, 0.5); });
}

/// z changes with x as a wave's height does.
Place Wave(double phase)
{
  return [phase](double p[3], double n[3]) {
    n[0] -= 0.3 * (std::cos(3.0 * p[0] + phase) - std::cos(3.0 * p[0])) * n[2];
    vtkMath::Normalize(n);
    p[2] += 0.1 * (std::sin(3.0 * p[0] + phase) - std::sin(3.0 * p[0]));
  };
}

struct View
{
  explicit View(vtkDataObject* data, bool follows = true)
  {
    this->Mapper->SetInputDataObject(data);
    this->Mapper->SetFollowMotion(follows);
    this->Actor = this->Win.Add(this->Mapper);
    this->Win.Renderer->ResetCamera();
    this->Win.Renderer->GetActiveCamera()->Elevation(-40.0);
    this->Win.Renderer->GetActiveCamera()->Azimuth(20.0);
    this->Win.Renderer->ResetCameraClippingRange();
  }
  bool Follows() const
  {
    return std::string(this->Mapper->GetChoices()).find("sizes of an earlier frame") != std::string::npos;
  }
  Picture Draw()
  {
    this->Win.Renderer->ResetCameraClippingRange();
    return this->Win.Draw();
  }

  vtkNew<vtkPointSplatMapper> Mapper;
  Window Win;
  vtkActor* Actor = nullptr;
};

void Follow(Checks& checks, const std::string& name, vtkPolyData* data, const std::vector<Place>& places,
  double least, const std::function<void(View&)>& set = {})
{
  Moving moving(data);
  View following(data);
  View anew(data, false);
  for (View* view : { &following, &anew })
  {
    if (set)
    {
      set(*view);
    }
  }
  following.Draw();
  for (size_t i = 0; i < places.size(); ++i)
  {
    moving.To(places[i], i % 2 == 0);
    const std::string label = name + ", " + std::to_string(i);
    const Picture picture = following.Draw();
    checks.AtLeast(Psnr(picture, anew.Draw()), least, label);
    checks.Expect(following.Follows() && !anew.Follows(), label + ": sizes did not follow");
  }
  moving.To([](double*, double*) {});
}

std::vector<Place> Motions()
{
  return { Turned(3.0), Turned(70.0), Turned(200.0), Wave(0.2), Wave(0.8),
    By([](vtkTransform* t) { t->Scale(1.3, 1.3, 1.3); }),
    By([](vtkTransform* t) { t->Translate(40.0, 0.0, 0.0); t->RotateZ(90.0); t->Translate(0.1, 0.0, 0.0); }) };
}

/// Random points on the faces of a cube.
vtkSmartPointer<vtkPolyData> Cube()
{
  return RandomCloud(12000, [face = 0](double u, double v, double* p, double* n) mutable {
    const int axis = face % 3;
    const double side = face % 2 == 0 ? 0.5 : -0.5;
    ++face;
    std::fill_n(n, 3, 0.0);
    n[axis] = 2.0 * side;
    p[axis] = side;
    p[(axis + 1) % 3] = u - 0.5;
    p[(axis + 2) % 3] = v - 0.5;
  });
}

void TestLikeNew(Checks& checks)
{
  std::vector<Place> places = Motions();
  const Place last = places.back();
  places.pop_back(); // the camera does not go along
  Follow(checks, "sphere", Cloud(MakeSphereMesh(120)), places, 45.0);
  Follow(checks, "random torus", RandomTorus(20000), places, 42.0);
  Follow(checks, "translucent", RandomTorus(20000), places, 42.0,
    [](View& view) { view.Actor->GetProperty()->SetOpacity(0.5); });
  Follow(checks, "image space", RandomTorus(40000), places, 45.0,
    [](View& view) { view.Mapper->SetMethodToImageSpace(); });
  Follow(checks, "deferred", RandomTorus(5000), places, 36.0,
    [](View& view) { view.Mapper->SetMethodToDeferred(); });
  Follow(checks, "quads", RandomTorus(20000), places, 42.0,
    [](View& view) { view.Mapper->SetProjection(vtkPointSplatMapper::QUADS); });
  Follow(checks, "fill points", Cloud(RimmedDisc(0.1).MakeMesh(RimmedDisc::Coarse)), places, 38.0);
  Follow(checks, "far off", RandomTorus(20000), { last }, 42.0,
    [](View& view) {
      view.Win.Renderer->GetActiveCamera()->SetFocalPoint(40.0, 0.0, 0.0);
      view.Win.Renderer->GetActiveCamera()->SetPosition(40.0, -4.0, 4.0);
    });
}

/// What is turned and stretched as a whole is what it was: an actor that is transformed shows it.
void TestSimilar(Checks& checks)
{
  const auto compare = [&](const std::string& name, vtkPolyData* data, double least) {
    for (const double degrees : { 10.0, 50.0, 120.0 })
    {
      const auto set = [degrees](vtkTransform* t) {
        t->RotateWXYZ(degrees, 1.0, 0.3, 0.5);
        t->Scale(1.2, 1.2, 1.2);
      };
      vtkNew<vtkPolyData> copy;
      copy->DeepCopy(data);
      Moving moving(copy);
      View following(copy);
      View still(data);
      following.Draw();
      moving.To(By(set));
      vtkNew<vtkTransform> transform;
      set(transform);
      still.Actor->SetUserTransform(transform);
      const Picture picture = following.Draw();
      checks.Expect(following.Follows(), name + " was not followed");
      checks.AtLeast(Psnr(picture, still.Draw()), least, name + " turned by " + std::to_string(degrees));
    }
  };
  compare("sphere", Cloud(MakeSphereMesh(120)), 50.0);
  compare("random torus", RandomTorus(20000), 50.0);
  compare("fill points", Cloud(RimmedDisc(0.1).MakeMesh(RimmedDisc::Coarse)), 50.0);
  compare("creases", Cube(), 50.0);
}

/// With radii of their own points have these.
void TestGivenRadii(Checks& checks)
{
  vtkSmartPointer<vtkPolyData> data = RandomTorus(20000);
  vtkNew<vtkFloatArray> radii;
  radii->SetName("SplatRadius");
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    radii->InsertNextValue(0.03f);
  }
  data->GetPointData()->AddArray(radii);
  Follow(checks, "given radii", data, { Turned(3.0), Wave(0.5), By([](vtkTransform* t) { t->Scale(1.3, 1.0, 1.0); }) }, 50.0);
  View following(data);
  View anew(data, false);
  following.Draw();
  radii->Fill(0.15);
  radii->Modified();
  const Picture picture = following.Draw();
  checks.Expect(following.Follows(), "radii that grow were not followed");
  checks.AtLeast(Psnr(picture, anew.Draw()), 60.0, "radii that grow");
}

/// Points as far apart as stars are in metres, or as atoms.
void TestUnits(Checks& checks)
{
  for (const double unit : { 1e14, 1e-12 })
  {
    vtkSmartPointer<vtkPolyData> data = RandomTorus(20000);
    Moving moving(data);
    const auto enlarge = [unit](double factor) {
      return By([unit, factor](vtkTransform* t) { t->Scale(factor * unit, factor * unit, factor * unit); });
    };
    moving.To(enlarge(1.0));
    View following(data);
    following.Draw();
    moving.To(enlarge(1.1));
    following.Draw();
    checks.Expect(following.Follows(), "points in units of " + std::to_string(unit) + " were not followed");
  }
}

/// Each time step is a data set of its own, the one before is gone, and fill points are drawn.
void TestReplaced(Checks& checks)
{
  vtkSmartPointer<vtkPolyData> data = Cloud(RimmedDisc(0.1).MakeMesh(RimmedDisc::Coarse));
  View following(data);
  following.Draw();
  for (const double degrees : { 5.0, 10.0 })
  {
    vtkNew<vtkPolyData> next;
    next->DeepCopy(data);
    Moving(next).To(Turned(degrees));
    following.Mapper->SetInputData(next);
    data = next;
    const Picture picture = following.Draw();
    checks.Expect(following.Follows(), "a data set in the place of another was not followed");
    View anew(data, false);
    anew.Win.Renderer->SetActiveCamera(following.Win.Renderer->GetActiveCamera());
    checks.AtLeast(Psnr(picture, anew.Draw()), 38.0, "a data set in the place of another");
  }
}

void TestNotFollowed(Checks& checks)
{
  vtkSmartPointer<vtkPolyData> data = RandomTorus(20000);
  Moving moving(data);
  View following(data);
  View anew(data, false);
  vtkNew<vtkTest::ErrorObserver> warnings;
  following.Mapper->AddObserver(vtkCommand::WarningEvent, warnings);
  anew.Mapper->AddObserver(vtkCommand::WarningEvent, warnings);
  following.Draw();
  const auto differs = [&](const std::string& what) {
    const Picture picture = following.Draw();
    checks.Expect(!following.Follows(), what + " was followed");
    checks.AtLeast(Psnr(picture, anew.Draw()), 70.0, what);
  };
  moving.To(By([](vtkTransform* t) { t->Scale(3.0, 1.0, 1.0); }));
  differs("a stretch to three times the width");
  moving.To([](double p[3], double*) { std::fill_n(p, 3, 0.3); });
  following.Draw();
  checks.Expect(!following.Follows(), "all points at one place were followed");
  moving.To(Turned(5.0));
  differs("all points apart again");
  moving.To(Turned(5.0));
  following.Draw();
  moving.To([](double p[3], double*) { p[0] = p[1] = p[2] = 0.0; });
  following.Draw();
  checks.Expect(!following.Follows(), "all points at one place were followed");
  moving.To(Turned(5.0));
  following.Draw();
  // The same points in another order.
  moving.To([&, i = vtkIdType(0)](double p[3], double n[3]) mutable {
    const vtkIdType other = (i++ * 7919) % data->GetNumberOfPoints();
    moving.Points->GetPoint(other, p);
    moving.Normals->GetTuple(other, n);
  });
  differs("another order");
  moving.To([i = 0](double*, double n[3]) mutable {
    if (i++ == 7)
    {
      std::fill_n(n, 3, 0.0);
    }
  });
  differs("a point without a normal");
  moving.To([i = 0](double p[3], double*) mutable { p[0] = i++ == 5 ? vtkMath::Nan() : p[0]; });
  differs("a point without a place");
  checks.Expect(warnings->GetWarning(), "a warning of the point that is not drawn");
  moving.To(Turned(1.0));
  differs("all points again");
  moving.To(Turned(2.0));
  following.Draw();
  checks.Expect(following.Follows(), "all points, moved, were not followed");
  // Fewer points.
  data->GetPoints()->SetNumberOfPoints(10000);
  data->GetPointData()->GetNormals()->SetNumberOfTuples(10000);
  data->GetPoints()->Modified();
  data->GetPointData()->GetNormals()->Modified();
  differs("half of the points");
  following.Mapper->FollowMotionOff();
  data->GetPoints()->Modified();
  differs("with FollowMotionOff()");
}

/// One block moves beside another, and two time steps take turns.
void TestBlocks(Checks& checks)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkSmartPointer<vtkPolyData> still = Cloud(MakeSphereMesh(80));
  vtkSmartPointer<vtkPolyData> data = RandomTorus(20000);
  blocks->SetBlock(0, still);
  blocks->SetBlock(1, data);
  Moving moving(data);
  View following(blocks);
  View anew(blocks, false);
  following.Draw();
  for (const Place& place : { Turned(10.0), Wave(0.4) })
  {
    moving.To(place);
    const Picture picture = following.Draw();
    checks.Expect(following.Follows(), "a block that moves was not followed");
    checks.AtLeast(Psnr(picture, anew.Draw()), 42.0, "a block that moves");
  }
  vtkNew<vtkPolyData> first;
  vtkNew<vtkPolyData> second;
  first->DeepCopy(data);
  moving.To(Turned(20.0));
  second->DeepCopy(data);
  View turns(first);
  const Picture whole = turns.Draw();
  turns.Mapper->SetInputData(second);
  turns.Draw();
  checks.Expect(turns.Follows(), "another time step was not followed");
  turns.Mapper->SetInputData(first);
  checks.AtLeast(Psnr(turns.Draw(), whole), 60.0, "back at the first time step");
}

void TestPicks(Checks& checks)
{
  vtkSmartPointer<vtkPolyData> data = Cloud(MakeSphereMesh(120));
  Moving moving(data);
  View view(data);
  view.Draw();
  moving.To(Turned(33.0));
  view.Draw();
  int picked = 0;
  const double farthest = FarthestPicked(view.Win, data, picked);
  checks.AtLeast(picked, 10000, "points picked");
  checks.AtMost(farthest, 6.0, "pixels off");
}

/// Levels are made while points move, and go along.
void TestLevels(Checks& checks)
{
  vtkSmartPointer<vtkPolyData> data = LevelScene::Torus(1 << 20, 0.0, false);
  LevelScene::Scene scene(data);
  scene.Win.Draw();
  Moving moving(data);
  const auto compare = [&](const std::string& what) {
    const Picture levels = scene.Win.Draw();
    const vtkIdType drawn = scene.Mapper->GetNumberOfPointsProjected();
    checks.Expect(scene.HasLevels(), what + ": there are no levels");
    checks.AtMost<vtkIdType>(drawn, (1 << 20) / 3, what + ", drawn");
    checks.AtLeast(Psnr(levels, scene.DrawAll()), 44.0, what + ", against all");
    scene.Mapper->FollowMotionOff();
    scene.Mapper->LevelOfDetailOff();
    data->GetPoints()->Modified();
    const Picture anew = scene.Win.Draw();
    scene.Mapper->FollowMotionOn();
    scene.Mapper->LevelOfDetailOn();
    checks.AtLeast(Psnr(levels, anew), 44.0, what + ", against new splats");
  };
  for (int i = 0; i < 200 && !scene.HasLevels(); ++i)
  {
    moving.To(Turned(0.1 * i));
    scene.Win.Draw();
  }
  compare("turned");
  checks.Expect(scene.Wait(), "levels of new splats");
  moving.To(Wave(0.7));
  compare("wave");
  checks.Expect(scene.Wait(), "levels of new splats");
  moving.To(Turned(30.0));
  scene.Win.Draw();
  int picked = 0;
  checks.AtMost(FarthestPicked(scene.Win, data, picked), 4.0, "with levels, pixels off");
  // Close up, where points themselves are drawn.
  double p[3];
  data->GetPoint(0, p);
  scene.Win.Renderer->GetActiveCamera()->SetFocalPoint(p);
  scene.Win.Renderer->GetActiveCamera()->Zoom(25.0);
  const Picture close = scene.Win.Draw();
  checks.AtLeast(Psnr(close, scene.DrawAll()), 50.0, "close up, against all");
}

/// Levels stand for points that lay together. Where these are mixed, they are of no use, be radii given.
void TestMixed(Checks& checks)
{
  vtkSmartPointer<vtkPolyData> data = LevelScene::Torus(1 << 20, 0.0, true);
  LevelScene::Scene scene(data);
  checks.Expect(scene.Wait(), "levels");
  Moving moving(data);
  vtkNew<vtkFloatArray> values;
  values->DeepCopy(data->GetPointData()->GetScalars());
  const auto other = [&](vtkIdType i) { return (i * 7919) % data->GetNumberOfPoints(); };
  moving.To([&, i = vtkIdType(0)](double p[3], double n[3]) mutable {
    moving.Points->GetPoint(other(i), p);
    moving.Normals->GetTuple(other(i++), n);
  });
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    values->SetValue(i, vtkArrayDownCast<vtkFloatArray>(data->GetPointData()->GetScalars())->GetValue(other(i)));
  }
  data->GetPointData()->SetScalars(values);
  checks.AtLeast(Psnr(scene.Win.Draw(), scene.DrawAll()), 40.0, "points that were mixed, against all");
}

/// A user's window: sizes were estimated in the background, of a copy of the mesh.
void TestDrafts(Checks& checks)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(1050, 1050);
  plane->Update();
  vtkSmartPointer<vtkPolyData> data = plane->GetOutput();
  Moving moving(data);
  View view(data);
  vtkNew<vtkGenericRenderWindowInteractor> interactor;
  view.Win.Win->SetShowWindow(true);
  interactor->SetRenderWindow(view.Win.Win);
  interactor->SetEnableRender(false); // not at once
  interactor->SetTimerEventResetsTimer(false);
  // Somebody has timers.
  int timers = 0;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&timers);
  command->SetCallback([](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
  interactor->AddObserver(vtkCommand::CreateTimerEvent, command);
  interactor->AddObserver(vtkCommand::DestroyTimerEvent, command);
  interactor->Initialize();
  interactor->SetEnableRender(true);
  const auto tick = [&](int most) {
    for (int i = 0; i < most && view.Mapper->IsProgressing(); ++i)
    {
      interactor->TimerEvent();
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  };
  view.Win.Draw();
  checks.Expect(view.Mapper->IsProgressing(), "a draft comes first");
  tick(15000);
  moving.To(Turned(5.0));
  view.Win.Draw();
  checks.Expect(view.Follows() && !view.Mapper->IsProgressing(), "a mesh after drafts was not followed");
}

void TestShadows(Checks& checks)
{
  Follow(checks, "shadows", RandomTorus(20000), { Turned(20.0), Wave(0.5) }, 40.0, [](View& view) {
    view.Mapper->ShadowsOn();
    vtkNew<vtkLight> lamp;
    lamp->SetLightTypeToSceneLight();
    lamp->SetPosition(3.0, -0.5, 1.0);
    view.Win.Renderer->AddLight(lamp);
  });
}
}

int TestSplatsMotion(int, char*[])
{
  Checks checks;
  TestSimilar(checks);
  TestLikeNew(checks);
  TestGivenRadii(checks);
  TestUnits(checks);
  TestReplaced(checks);
  TestNotFollowed(checks);
  TestBlocks(checks);
  TestPicks(checks);
  TestLevels(checks);
  TestMixed(checks);
  TestDrafts(checks);
  TestShadows(checks);
  return checks.Result();
}
