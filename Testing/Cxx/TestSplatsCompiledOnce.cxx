// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Drivers for processors take seconds to compile a program, and do so anew for another kind of texture, or for samplers
// that others left behind. So what a frame has drawn once is drawn at once from then on: beside opaque things, in
// windows of whatever size, before and after translucent splats. No cache of the driver's may help here
// (CMakeLists.txt).
#include "SplatScene.h"

#include "vtkSphereSource.h"

#include <algorithm>
#include <chrono>

namespace
{
using namespace SplatScene;

/// Seconds in which a frame is drawn whose programs are there; first: of the one that had them compiled.
double Allowed(double first)
{
  return std::max(0.25 * first, 0.3); // where a driver compiles in no time, nothing is asked
}

/// Of a frame, its picture and all.
double Seconds(Window& window)
{
  const auto start = std::chrono::steady_clock::now();
  window.Draw();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}
}

int TestSplatsCompiledOnce(int, char*[])
{
  Checks checks;
  vtkNew<vtkPointSplatMapper> mapper;
  mapper->SetInputData(RandomSphere(20000));
  Window window(200);
  window.SmoothOutlines = true;
  vtkActor* actor = window.Add(mapper);
  window.Renderer->ResetCamera();

  const double opaque = Seconds(window);
  checks.AtMost(Seconds(window), Allowed(opaque), "seconds of the second opaque frame");
  actor->GetProperty()->SetOpacity(0.5);
  const double translucent = Seconds(window);
  checks.AtMost(Seconds(window), Allowed(translucent), "seconds of the second translucent frame");
  actor->GetProperty()->SetOpacity(1.0);
  checks.AtMost(Seconds(window), Allowed(opaque), "seconds of an opaque frame after it");
  checks.AtMost(Seconds(window), Allowed(opaque), "seconds of the next one");

  vtkNew<vtkSphereSource> source;
  source->SetRadius(0.2);
  vtkNew<vtkPolyDataMapper> other;
  other->SetInputConnection(source->GetOutputPort());
  window.Add(other);
  actor->GetProperty()->SetOpacity(0.5);
  checks.AtMost(Seconds(window), Allowed(translucent), "seconds of translucent splats about a mesh");
  window.Win->SetSize(256, 256);
  checks.AtMost(Seconds(window), Allowed(translucent), "seconds of them in a window of 256 pixels");
  actor->GetProperty()->SetOpacity(1.0);
  checks.AtMost(Seconds(window), Allowed(opaque), "seconds of opaque ones there");
  return checks.Result();
}
