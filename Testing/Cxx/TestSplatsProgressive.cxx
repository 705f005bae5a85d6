// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A window that can be asked for frames shows some of a large cloud's points at once, and asks for
// others until it shows all: then with the picture that a window without an interactor has at once.
#include "Expect.h"
#include "PickedPoints.h"
#include "SplatScene.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCommand.h"
#include "vtkGenericRenderWindowInteractor.h"
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkMath.h"

#include <chrono>
#include <cstring>
#include <thread>

namespace
{
using namespace SplatScene;

constexpr vtkIdType Many = 2200000; // so that there is more than one draft
constexpr vtkIdType Enough = 1100000;

vtkSmartPointer<vtkPolyData> Torus(vtkIdType count)
{
  vtkNew<vtkMinimalStandardRandomSequence> sequence;
  sequence->SetSeed(5);
  auto random = [&sequence](double high) {
    sequence->Next();
    return sequence->GetRangeValue(0.0, high);
  };
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> values;
  values->SetName("Values");
  const double pi = vtkMath::Pi();
  while (points->GetNumberOfPoints() < count)
  {
    const double a = random(2.0 * pi);
    const double b = random(2.0 * pi);
    if (random(1.4) <= 1.0 + 0.4 * std::cos(b))
    {
      const double n[3] = { std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b) };
      points->InsertNextPoint(std::cos(a) + 0.4 * n[0], std::sin(a) + 0.4 * n[1], 0.4 * n[2]);
      normals->InsertNextTuple(n);
      values->InsertNextValue(static_cast<float>(std::sin(3.0 * a)));
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->GetPointData()->SetNormals(normals);
  data->GetPointData()->SetScalars(values);
  return data;
}

/// A user's window: its interactor has timers, which go off when Wait() says.
struct Scene
{
  vtkNew<vtkPointSplatMapper> Mapper;
  Window Win;
  vtkNew<vtkGenericRenderWindowInteractor> Interactor;
  int Timers = 0;
  int Frames = 0;
  bool InEvent = false;
  bool EndedInEvent = false; // which interactors of X windows do not survive

  Scene(vtkPolyData* data, bool interactive, bool timers = true)
  {
    this->Mapper->SetInputData(data);
    this->Mapper->SetScalarRange(-1.0, 1.0);
    this->Win.SmoothOutlines = true;
    this->Win.Add(this->Mapper);
    this->Win.Renderer->ResetCamera();
    this->Win.Renderer->GetActiveCamera()->Elevation(-50.0);
    this->Win.Renderer->ResetCameraClippingRange();
    if (!interactive)
    {
      return;
    }
    this->Win.Win->SetShowWindow(true);
    this->Interactor->SetRenderWindow(this->Win.Win);
    this->Interactor->SetEnableRender(false); // not at once
    this->Interactor->SetTimerEventResetsTimer(false);
    if (timers)
    {
      this->Follow(this->Interactor, vtkCommand::CreateTimerEvent);
      this->Follow(this->Interactor, vtkCommand::DestroyTimerEvent);
    }
    this->Interactor->Initialize();
    this->Interactor->SetEnableRender(true);
    this->Follow(this->Interactor, vtkCommand::RenderEvent);
  }
  void Follow(vtkObject* object, unsigned long event)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback([](vtkObject*, unsigned long id, void* scene, void*) {
      Scene& self = *static_cast<Scene*>(scene);
      self.Frames += id == vtkCommand::RenderEvent;
      self.Timers += id == vtkCommand::CreateTimerEvent;
      self.Timers -= id == vtkCommand::DestroyTimerEvent;
      self.EndedInEvent = self.EndedInEvent || (self.InEvent && id == vtkCommand::DestroyTimerEvent);
    });
    object->AddObserver(event, command);
  }
  void Tick()
  {
    this->InEvent = true;
    this->Interactor->TimerEvent();
    this->InEvent = false;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  bool Tells(const char* text) const
  {
    return std::strstr(this->Mapper->GetChoices(), text) != nullptr;
  }
  /// Lets time go by until the mapper tells something, at most five minutes; then nothing more may
  /// come, and with the user's next frame the timer ends.
  bool Wait(const char* text)
  {
    for (int i = 0; i < 15000 && !this->Tells(text); ++i)
    {
      this->Tick();
    }
    const int frames = this->Frames;
    for (int i = 0; i < 20; ++i)
    {
      this->Tick();
    }
    const bool good = this->Tells(text) && this->Frames == frames && !this->EndedInEvent;
    this->Win.Draw();
    return good && this->Timers == 0;
  }
};

void TestPictures(vtkPolyData* data)
{
  Scene script(data, false);
  const Picture all = script.Win.Draw();
  Expect(!script.Mapper->IsProgressing(), "without an interactor all are drawn");
  // Random points leave some gaps with fill points.
  const vtkIdType splats = script.Mapper->GetNumberOfSplats();
  Expect(splats >= Many && splats < 1.05 * Many, "all splats are there");

  Scene scene(data, true);
  double bounds[6];
  scene.Mapper->GetBounds(bounds);
  for (int k = 0; k < 6; ++k)
  {
    Expect(bounds[k] == script.Mapper->GetBounds()[k], "the bounds of all points");
  }
  const Picture first = scene.Win.Draw();
  Expect(scene.Mapper->IsProgressing(), "a part is drawn first");
  Expect(scene.Timers == 1, "another frame will be asked for");
  const vtkIdType drawn = scene.Mapper->GetNumberOfPointsProjected();
  Expect(drawn > 100000 && drawn < Many / 8, "points at first: " + std::to_string(drawn));
  Expect(scene.Tells("one point of 17 is drawn"), scene.Mapper->GetChoices());
  std::cout << "first: " << Psnr(first, all) << " dB\n";
  Expect(Psnr(first, all) > 35.0, "the first picture is like the last");

  int picked = 0;
  const double farthest = FarthestPicked(scene.Win, data, picked);
  std::cout << "picked: " << picked << ", pixels off: " << farthest << "\n";
  Expect(picked > 5000 && farthest < 2.0, "ids are the input's");

  // Other scalars are shown at once, and do not begin it anew.
  auto values = vtkFloatArray::SafeDownCast(data->GetPointData()->GetScalars());
  for (vtkIdType i = 0; i < Many; ++i)
  {
    values->SetValue(i, -values->GetValue(i));
  }
  values->Modified();
  const Picture turned = scene.Win.Draw();
  Expect(Psnr(turned, first) < 20.0, "scalars that changed are shown");
  for (vtkIdType i = 0; i < Many; ++i)
  {
    values->SetValue(i, -values->GetValue(i));
  }
  values->Modified();
  Expect(Psnr(scene.Win.Draw(), first) > 90.0, "and change back");

  Expect(scene.Wait("stand for others"), "it comes to an end, with levels");
  std::cout << "frames asked for: " << scene.Frames << "\n";
  Expect(scene.Frames == 2, "frames: " + std::to_string(scene.Frames));
  Expect(!scene.Mapper->IsProgressing(), "all are drawn in the end");
  Expect(scene.Mapper->GetNumberOfSplats() == splats, "all splats are there");
  const Picture last = Read(scene.Win.Win);
  std::cout << "last, with levels: " << Psnr(last, all) << " dB\n";
  Expect(Psnr(last, all) > 40.0, "the last picture shows all");
  scene.Mapper->LevelOfDetailOff();
  Expect(Psnr(scene.Win.Draw(), all) > 60.0, "without levels it is the script's");
}

void TestLevelsAskFor(vtkPolyData* data)
{
  // All is drawn at once, and nobody moves: when there are levels, there is another frame.
  Scene scene(data, true);
  scene.Mapper->ProgressiveOff();
  scene.Win.Draw();
  Expect(!scene.Mapper->IsProgressing(), "not progressive");
  Expect(scene.Timers == 1, "levels are waited for");
  Expect(scene.Wait("stand for others"), "they come");
  Expect(scene.Frames == 1, "one frame shows them");
}

/// Points that never rest are all drawn when the sizes of one frame's are there.
void TestMoving(vtkPolyData* data)
{
  Scene scene(data, true);
  vtkNew<vtkPoints> rest;
  rest->DeepCopy(data->GetPoints());
  const auto draw = [&](int frame) {
    for (vtkIdType i = 0; i < rest->GetNumberOfPoints(); ++i)
    {
      double p[3];
      rest->GetPoint(i, p);
      p[2] *= 1.0 + 0.1 * std::sin(0.05 * frame);
      data->GetPoints()->SetPoint(i, p);
    }
    data->GetPoints()->Modified();
    return scene.Win.Draw();
  };
  int frame = 0;
  const auto begin = std::chrono::steady_clock::now();
  do
  {
    draw(frame++);
    if (frame == 1)
    {
      Expect(scene.Mapper->IsProgressing(), "a part is drawn while points move");
    }
  } while (scene.Mapper->IsProgressing() &&
    std::chrono::steady_clock::now() - begin < std::chrono::minutes(3));
  std::cout << "all that move after frames: " << frame << "\n";
  for (int i = 0; i < 2; ++i)
  {
    const Picture moving = draw(frame++);
    Expect(!scene.Mapper->IsProgressing() && scene.Tells("sizes of an earlier frame"), "all that move are drawn");
    Scene script(data, false);
    script.Win.Renderer->GetActiveCamera()->DeepCopy(scene.Win.Renderer->GetActiveCamera());
    const double psnr = Psnr(moving, script.Win.Draw());
    std::cout << "moving, against new sizes: " << psnr << " dB\n";
    Expect(psnr > 40.0, "moving points look as with new sizes");
  }
  data->GetPoints()->DeepCopy(rest);
  data->GetPoints()->Modified();
}

void TestChanges(vtkPolyData* data)
{
  {
    Scene scene(data, true, false);
    scene.Win.Draw();
    Expect(!scene.Mapper->IsProgressing(), "without timers all are drawn");
  }
  Scene scene(data, true);
  // Points that change with each frame are never more than a part of them.
  for (int i = 0; i < 3; ++i)
  {
    data->GetPoints()->Modified();
    scene.Win.Draw();
    scene.Tick();
    Expect(scene.Mapper->IsProgressing() && scene.Frames == 0, "points that change");
  }
  // Styles that drag would move the camera on at each timer's event.
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  scene.Interactor->SetInteractorStyle(style);
  double before[3];
  scene.Win.Renderer->GetActiveCamera()->GetPosition(before);
  scene.Interactor->SetEventInformation(150, 150);
  scene.Interactor->InvokeEvent(vtkCommand::LeftButtonPressEvent);
  scene.Interactor->SetEventInformation(170, 150);
  scene.Interactor->InvokeEvent(vtkCommand::MouseMoveEvent);
  double after[3];
  scene.Win.Renderer->GetActiveCamera()->GetPosition(after);
  Expect(before[0] != after[0], "the user turns the scene");
  Expect(scene.Timers == 0, "no timer while the user drags");
  Expect(scene.Mapper->IsProgressing(), "nothing is ready yet");
  scene.Interactor->InvokeEvent(vtkCommand::LeftButtonReleaseEvent);
  Expect(scene.Timers == 1, "then it goes on");
  scene.Win.Renderer->GetActiveCamera()->GetPosition(before);
  scene.Tick();
  scene.Win.Renderer->GetActiveCamera()->GetPosition(after);
  Expect(before[0] == after[0], "timers' events are for us alone");

  // Whoever follows the progress may end it.
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback([](vtkObject* mapper, unsigned long, void*, void*) {
    auto self = static_cast<vtkPointSplatMapper*>(mapper);
    if (self->GetProgress() > 0.1 && self->GetProgress() < 1.0)
    {
      self->AbortExecuteOn();
    }
  });
  const unsigned long tag = scene.Mapper->AddObserver(vtkCommand::ProgressEvent, abort);
  Expect(scene.Wait("that was aborted"), "aborted work ends");
  scene.Mapper->RemoveObserver(tag);

  // What is gone while it is being made leaves nothing behind.
  data->GetPoints()->Modified();
  scene.Win.Draw();
  scene.Tick();
  scene.Tick();
  data->GetPoints()->Resize(1); // the thread has its own
  data->GetPoints()->Modified();
  vtkNew<vtkPolyData> other;
  scene.Mapper->SetInputData(other);
  scene.Tick();
  scene.Win.Draw();
  Expect(!scene.Mapper->IsProgressing(), "no points, nothing to wait for");
  scene.Win.Draw();
  Expect(scene.Timers == 0, "and no timer");
}

/// Where there are cells, points that none uses are never drawn, and those of vertices always are.
void TestCells(vtkPolyData* points)
{
  vtkNew<vtkPolyData> data;
  data->ShallowCopy(points);
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkCellArray> triangles;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    if (data->GetPoint(i)[1] < 0.0)
    {
      vertices->InsertNextCell(1, &i);
    }
  }
  // A small triangle: those of points that lie far apart are not there before the last picture.
  vtkIdType three[3] = { 0, 0, 0 };
  double best = 1.0;
  double corner[3];
  points->GetPoint(0, corner);
  for (vtkIdType i = 1; i < data->GetNumberOfPoints(); ++i)
  {
    const double square = vtkMath::Distance2BetweenPoints(points->GetPoint(i), corner);
    if (square < best)
    {
      best = square;
      three[2] = three[1];
      three[1] = i;
    }
  }
  triangles->InsertNextCell(3, three);
  data->SetVerts(vertices);
  data->SetPolys(triangles);
  Scene script(data, false);
  const Picture half = script.Win.Draw();
  Scene scene(data, true);
  double bounds[6];
  scene.Mapper->GetBounds(bounds);
  for (int k = 0; k < 6; ++k)
  {
    Expect(bounds[k] == script.Mapper->GetBounds()[k], "the bounds of points that are shown");
  }
  scene.Win.Renderer->GetActiveCamera()->DeepCopy(script.Win.Renderer->GetActiveCamera());
  const Picture first = scene.Win.Draw();
  Expect(scene.Mapper->IsProgressing(), "with cells: a part is drawn first");
  std::cout << "half, first: " << Psnr(first, half) << " dB\n";
  Expect(Psnr(first, half) > 30.0, "with cells: the first picture is like the last");
  Expect(scene.Wait("stand for others"), "with cells: it comes to an end");
  const Picture last = Read(scene.Win.Win);
  std::cout << "half, last: " << Psnr(last, half) << " dB\n";
  Expect(Psnr(last, half) > 35.0, "with cells: the last picture shows the same");
  Expect(scene.Mapper->GetNumberOfSplats() == script.Mapper->GetNumberOfSplats(),
    "with cells: as many splats");
}
}

int TestSplatsProgressive(int, char*[])
{
  // These windows pass for shown ones, unless they are VTK's own. (TestSplatviewSession has real ones.)
  Window probe(8);
  probe.Win->SetShowWindow(true);
  probe.Draw();
  if (!probe.Win->GetShowWindow())
  {
    std::cout << "skipped: windows of this VTK without a screen cannot be shown\n";
    return EXIT_SUCCESS;
  }
  TestPictures(Torus(Many));
  vtkSmartPointer<vtkPolyData> data = Torus(Enough);
  TestLevelsAskFor(data);
  TestCells(data);
  TestMoving(data);
  TestChanges(data);
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
