// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The smallest program that draws a point cloud as a surface: put
// vtkPointSplatMapper where vtkPolyDataMapper would stand. Here the cloud is a
// sphere's vertices and normals; the picture goes to a file, no X server needed.
// For a window on the screen take vtkRenderWindow and an interactor, as ever.
#include <vtkActor.h>
#include <vtkEGLHeadlessRenderWindow.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPointSplatMapper.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkWindowToImageFilter.h>

int main(int argc, char* argv[])
{
  vtkNew<vtkSphereSource> cloud;
  cloud->SetThetaResolution(120);
  cloud->SetPhiResolution(60);

  vtkNew<vtkPointSplatMapper> mapper;
  mapper->SetInputConnection(cloud->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);

  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  vtkNew<vtkEGLHeadlessRenderWindow> window;
  window->SetSize(400, 400);
  window->AddRenderer(renderer);
  window->Render();

  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(picture->GetOutputPort());
  writer->SetFileName(argc > 1 ? argv[1] : "splat_sphere.png");
  writer->Write();
  return 0;
}
