// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// splatview: point clouds, and volumes by way of them, drawn as smooth surfaces.
#include "Display.h"
#include "Messages.h"
#include "OctreeFiles.h"
#include "Options.h"
#include "Report.h"
#include "Scene.h"
#include "Session.h"

#include "vtkCamera.h"
#include "vtkEGLHeadlessRenderWindow.h"
#include "vtkDataSet.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkVersion.h"
#include "vtkWindowToImageFilter.h"

#include <chrono>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <new>

namespace
{
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

/**
 * Before the work and not after it.
 */
void CheckWritable(const std::string& file)
{
  const bool existed = static_cast<bool>(std::ifstream(file));
  if (!std::ofstream(file, std::ios::app))
  {
    throw UserError(file + ": cannot be written");
  }
  if (!existed)
  {
    std::remove(file.c_str());
  }
}

void WritePicture(vtkRenderWindow* window, const std::string& file)
{
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  image->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputConnection(image->GetOutputPort());
  writer->Write();
}

/**
 * What VTK said is wrong, if anything; the exit code.
 */
int ShowMessages()
{
  const std::string error = MessageKeeper::TakeError();
  if (!error.empty())
  {
    std::fprintf(stderr, "splatview: %s\n", error.c_str());
    return 1;
  }
  MessageKeeper::ShowWarnings();
  return 0;
}

/**
 * In one line: what was drawn, how, how long frames took if that was measured, and the file if one
 * is written.
 */
void PrintSummary(
  const Scene& scene, const std::vector<double>& milliseconds, const std::string& output)
{
  vtkIdType splats = 0;
  vtkIdType points = 0;
  for (const Surface& surface : scene.Surfaces)
  {
    const vtkIdType own = surface.Mapper->IsProgressing()
      ? vtkDataSet::SafeDownCast(surface.Mapper->GetInputDataObject(0, 0))->GetNumberOfPoints()
      : surface.Mapper->GetNumberOfSplats() - surface.NumberOfFillPoints;
    splats += own;
    points += surface.Stream ? surface.Stream->GetNumberOfPointsInFile() : own;
  }
  if (splats < points)
  {
    std::printf("%lld splats for ", static_cast<long long>(splats));
  }
  std::printf("%lld points in %zu surface%s, %s by %s", static_cast<long long>(points),
    scene.Surfaces.size(), scene.Surfaces.size() == 1 ? "" : "s",
    scene.Surfaces[0].Mapper->GetMethodUsed(), scene.Surfaces[0].Mapper->GetProjectionUsed());
  if (!milliseconds.empty())
  {
    std::printf(", %.1f ms a frame", Median(milliseconds));
  }
  std::printf("%s%s\n", output.empty() ? "" : ", written to ", output.c_str());
  std::fflush(stdout);
}

int Run(const Options& options)
{
  const bool interactive = options.Output.empty() && !options.Files.empty() && HasDisplay();
  const std::string output = !options.Output.empty() ? options.Output
    : options.Files.empty()                          ? "hydrogen.png"
                                                     : "splatview.png";
  if (!interactive)
  {
    CheckWritable(output);
  }
  if (!options.Json.empty())
  {
    CheckWritable(options.Json);
  }
  Options own = options;
  own.InWindow = interactive;
  Scene scene = Scene::Make(own);

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
  window->SetWindowName(TitleOf(options.Files).c_str());
  window->AddRenderer(scene.Renderer);
  // Before the first Render(): VTK 9.1 crashes at the session's end where the window has opened the
  // X server's connection, and closes it, while the interactor still reads from it.
  vtkNew<Session> style;
  vtkNew<vtkRenderWindowInteractor> interactor;
  if (interactive)
  {
    interactor->SetRenderWindow(window);
    interactor->SetInteractorStyle(style);
    style->SetScene(scene, options.Quiet);
    // Else the first frame would show all of a large cloud, when that is there.
    interactor->Initialize();
    style->StartFollowing();
  }
  window->Render();
  if (ShowMessages() != 0)
  {
    return 1;
  }

  // Only for a report, since the user would have to watch and wait.
  std::vector<double> times;
  if (!options.Json.empty())
  {
    times = TimeFrames(window, scene.Renderer, options.Frames);
    WriteReport(options.Json, scene, window, times);
  }
  if (!options.Quiet)
  {
    PrintSummary(scene, times, interactive ? "" : output);
  }
  if (!interactive)
  {
    WritePicture(window, output);
    return ShowMessages();
  }
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
    if (options.Convert)
    {
      CheckWritable(options.Output);
      ConvertFiles(options);
      return ShowMessages();
    }
    return Run(options);
  }
  catch (const UserError& error)
  {
    std::fprintf(stderr, "splatview: %s\n", OneLine(error.what()).c_str());
    return 2;
  }
  catch (const std::bad_alloc&)
  {
    std::fprintf(stderr, "splatview: there is not enough memory\n");
    return 1;
  }
}
