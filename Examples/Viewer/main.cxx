// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// splatview: point clouds, and volumes by way of them, drawn as smooth surfaces.
#include "Options.h"
#include "Readers.h"
#include "Report.h"
#include "Scene.h"

#include "vtkCamera.h"
#include "vtkEGLHeadlessRenderWindow.h"
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkVersion.h"
#include "vtkWindowToImageFilter.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>

namespace
{
bool HasDisplay()
{
#if defined(__unix__) && !defined(__APPLE__)
  const char* display = std::getenv("DISPLAY");
  return display && *display;
#else
  return true;
#endif
}

/**
 * Frame times of a small turn about the scene and back.
 */
std::vector<double> TimeFrames(vtkRenderWindow* window, vtkRenderer* renderer, int frames)
{
  std::vector<double> milliseconds;
  vtkNew<vtkCamera> before;
  before->DeepCopy(renderer->GetActiveCamera());
  for (int i = 0; i < frames; ++i)
  {
    renderer->GetActiveCamera()->Azimuth(1.0);
    renderer->ResetCameraClippingRange();
    const auto start = std::chrono::steady_clock::now();
    window->Render();
    window->WaitForCompletion();
    milliseconds.push_back(
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
  }
  renderer->GetActiveCamera()->DeepCopy(before);
  window->Render();
  return milliseconds;
}

void WritePicture(vtkRenderWindow* window, const std::string& file)
{
  if (!std::ofstream(file, std::ios::app))
  {
    throw UserError(file + ": cannot be written");
  }
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  image->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputConnection(image->GetOutputPort());
  writer->Write();
}

int Run(const Options& options)
{
  const bool interactive = options.Output.empty() && !options.Files.empty() && HasDisplay();
  const std::string output = !options.Output.empty() ? options.Output
    : options.Files.empty()                          ? "hydrogen.png"
                                                     : "splatview.png";
  Scene scene = Scene::Make(options);

  vtkSmartPointer<vtkRenderWindow> window;
  if (interactive)
  {
    window = vtkSmartPointer<vtkRenderWindow>::New();
    window->SetMultiSamples(0);
  }
  else
  {
    window = vtkSmartPointer<vtkEGLHeadlessRenderWindow>::New();
  }
  window->SetSize(options.Size[0], options.Size[1]);
  window->SetWindowName("splatview");
  window->AddRenderer(scene.Renderer);
  window->Render();
  const std::string error = MessageKeeper::TakeError();
  if (!error.empty())
  {
    std::fprintf(stderr, "splatview: %s\n", error.c_str());
    return 1;
  }

  if (!options.Json.empty() || !options.Quiet)
  {
    const std::vector<double> times = TimeFrames(window, scene.Renderer, options.Frames);
    if (!options.Json.empty())
    {
      WriteReport(options.Json, scene, window, times);
    }
    if (!options.Quiet)
    {
      vtkIdType points = 0;
      for (const Surface& surface : scene.Surfaces)
      {
        points += surface.Mapper->GetNumberOfSplats();
      }
      std::printf("%lld points in %zu surfaces, %s by %s, %.1f ms a frame%s%s\n",
        static_cast<long long>(points), scene.Surfaces.size(),
        scene.Surfaces[0].Mapper->GetMethodUsed(), scene.Surfaces[0].Mapper->GetProjectionUsed(),
        Median(times), interactive ? "" : ", written to ", interactive ? "" : output.c_str());
      std::fflush(stdout);
    }
  }
  if (!interactive)
  {
    WritePicture(window, output);
    return 0;
  }
  vtkNew<vtkRenderWindowInteractor> interactor;
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  interactor->SetRenderWindow(window);
  interactor->SetInteractorStyle(style);
  interactor->Start();
  return 0;
}
}

int main(int argc, char* argv[])
{
  MessageKeeper keeper;
  try
  {
    const Options options = Options::Parse(argc, argv);
    if (options.Help)
    {
      std::cout << Options::HelpText();
      return 0;
    }
    if (options.Version)
    {
      std::cout << "splatview " SPLATVIEW_VERSION " with VTK " << vtkVersion::GetVTKVersion()
                << "\n";
      return 0;
    }
    return Run(options);
  }
  catch (const UserError& error)
  {
    std::fprintf(stderr, "splatview: %s\n", error.what());
    return 2;
  }
}
