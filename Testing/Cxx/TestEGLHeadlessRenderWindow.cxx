// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The headless window with nothing of this project in it: VTK's own mesh of a
// sphere must look as it does in any window. Then what windows are used for:
// several at once, a new size, reading pixels and depth, a second life.
#include "vtkActor.h"
#include "vtkEGLHeadlessRenderWindow.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRegressionTestImage.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

#include <iostream>

namespace
{
bool Check(bool ok, const char* what)
{
  if (!ok)
  {
    std::cerr << "Not so: " << what << "\n";
  }
  return ok;
}

// How many of the pixels have red in them.
vtkIdType CountRed(vtkRenderWindow* window)
{
  const int* size = window->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels, 0);
  vtkIdType red = 0;
  for (vtkIdType i = 0; i < pixels->GetNumberOfTuples(); ++i)
  {
    red += pixels->GetTypedComponent(i, 0) > 0 ? 1 : 0;
  }
  return red;
}
}

int TestEGLHeadlessRenderWindow(int argc, char* argv[])
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(60);
  sphere->SetPhiResolution(30);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.9, 0.6, 0.2);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  vtkNew<vtkEGLHeadlessRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(200, 200);
  window->AddRenderer(renderer);

  bool ok = Check(*window->GetPlatform() == '\0', "no platform before the first Render()");
  window->Render();
  ok &= Check(*window->GetPlatform() != '\0', "a platform after it");
  const vtkIdType red = CountRed(window);
  ok &= Check(red > 8000 && red < 12000, "the sphere covers a quarter of the picture");

  vtkNew<vtkFloatArray> depth;
  window->GetZbufferData(0, 0, 199, 199, depth);
  ok &= Check(depth->GetValue(0) == 1.f, "depth 1 in the corner");
  ok &= Check(depth->GetValue(100 * 200 + 100) < 1.f, "less in the middle");

  // Another window beside the first, each with a context of its own.
  {
    vtkNew<vtkActor> second;
    vtkNew<vtkPolyDataMapper> secondMapper;
    secondMapper->SetInputConnection(sphere->GetOutputPort());
    second->SetMapper(secondMapper);
    vtkNew<vtkRenderer> secondRenderer;
    secondRenderer->AddActor(second);
    vtkNew<vtkEGLHeadlessRenderWindow> secondWindow;
    secondWindow->SetSize(100, 80);
    secondWindow->AddRenderer(secondRenderer);
    secondWindow->Render();
    ok &= Check(CountRed(secondWindow) > 1000, "a sphere in the second window");
    window->Render();
    ok &= Check(CountRed(window) == red, "the first window draws the same beside it");
  }
  window->Render();
  ok &= Check(CountRed(window) == red, "and the same when the second is gone");

  window->SetSize(400, 300);
  window->Render();
  ok &= Check(CountRed(window) > 2 * red, "the sphere grows with the window");
  window->Finalize();
  window->SetSize(200, 200);
  window->Render();
  ok &= Check(CountRed(window) == red, "the same picture after Finalize()");

#if !PointSplatting_VTK_HAS_EGL_WINDOW
  ok &= Check(window->GetNumberOfDevices() > 0, "EGL lists a device");
  window->Finalize();
  window->SetDeviceIndex(window->GetNumberOfDevices());
  window->Render();
  ok &= Check(CountRed(window) == red, "the same picture where there is no such device");
#endif

  const int same = vtkRegressionTestImage(window);
  return ok && same == vtkRegressionTester::PASSED ? EXIT_SUCCESS : EXIT_FAILURE;
}
