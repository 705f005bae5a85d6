// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Six renderers of one window beside their baseline: opaque, coloured by scalars, elliptical
// in parallel projection, by deferred blending with quads, peeled, and sorted layers.
#include "SplatScene.h"

#include "vtkLookupTable.h"
#include "vtkParametricFunctionSource.h"
#include "vtkParametricTorus.h"
#include "vtkPointSplatEstimation.h"
#include "vtkRegressionTestImage.h"
#include "vtkTestUtilities.h"

namespace
{
vtkSmartPointer<vtkPolyData> Torus(double minor)
{
  vtkNew<vtkParametricTorus> torus;
  torus->SetCrossSectionRadius(minor);
  vtkNew<vtkParametricFunctionSource> source;
  source->SetParametricFunction(torus);
  source->SetUResolution(160);
  source->SetVResolution(80);
  source->SetScalarModeToZ();
  source->Update();
  vtkSmartPointer<vtkPolyData> cloud = SplatScene::Cloud(source->GetOutput());
  cloud->GetPointData()->SetScalars(source->GetOutput()->GetPointData()->GetScalars());
  return cloud;
}
}

int TestSplatsPicture(int argc, char* argv[])
{
  vtkNew<vtkEGLHeadlessRenderWindow> window;
  window->SetSize(600, 400);
  window->SetMultiSamples(0);
  for (int which = 0; which < 6; ++which)
  {
    vtkNew<vtkRenderer> renderer;
    renderer->SetViewport(which % 3 / 3.0, which / 3 / 2.0, (which % 3 + 1) / 3.0,
      (which / 3 + 1) / 2.0);
    renderer->SetBackground(0.1, 0.2, 0.4);
    for (const double minor : { 0.5, 0.25 })
    {
      vtkNew<vtkPointSplatMapper> mapper;
      mapper->SetInputData(Torus(minor));
      mapper->SetScalarVisibility(which == 1);
      mapper->SetScalarRange(-minor, minor);
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      actor->GetProperty()->SetColor(minor > 0.3 ? 0.35 : 0.9, 0.6, minor > 0.3 ? 0.95 : 0.3);
      actor->GetProperty()->SetSpecular(0.3);
      actor->GetProperty()->SetSpecularPower(20);
      if (which == 2)
      {
        vtkNew<vtkPointSplatEstimation> ellipses;
        ellipses->SetInputData(Torus(minor));
        ellipses->SetShapeToElliptical();
        mapper->SetInputConnection(ellipses->GetOutputPort());
        renderer->GetActiveCamera()->ParallelProjectionOn();
      }
      else if (which == 3)
      {
        mapper->SetMethodToDeferred();
        mapper->SetProjectionToQuads();
      }
      else if (which >= 4)
      {
        actor->GetProperty()->SetOpacity(minor > 0.3 ? 0.4 : 1.0);
        mapper->SetTransparency(
          which == 4 ? vtkPointSplatMapper::PEELING : vtkPointSplatMapper::SORTED);
      }
      renderer->AddActor(actor);
    }
    renderer->ResetCamera();
    renderer->GetActiveCamera()->Elevation(-50);
    renderer->GetActiveCamera()->Dolly(1.3);
    renderer->ResetCameraClippingRange();
    window->AddRenderer(renderer);
  }
  window->Render();
  return vtkRegressionTestImage(window) ? EXIT_SUCCESS : EXIT_FAILURE;
}
