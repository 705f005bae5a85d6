// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Camera.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkRenderer.h"

#include <cmath>

//------------------------------------------------------------------------------
void PlaceCamera(
  vtkRenderer* renderer, const std::vector<double>& numbers, const vtkBoundingBox& also)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  if (numbers.size() >= 9)
  {
    camera->SetPosition(numbers.data());
    camera->SetFocalPoint(numbers.data() + 3);
    camera->SetViewUp(numbers.data() + 6);
    if (numbers.size() > 9)
    {
      camera->SetViewAngle(numbers[9]);
    }
  }
  else
  {
    double bounds[6];
    renderer->ComputeVisiblePropBounds(bounds);
    if (also.IsValid())
    {
      vtkBoundingBox box(bounds);
      box.AddBox(also);
      box.GetBounds(bounds);
    }
    renderer->ResetCamera(bounds);
    if (numbers.size() >= 2)
    {
      camera->Azimuth(numbers[0]);
      // In steps, so that the view never comes to lie along the view up.
      const int steps = 1 + static_cast<int>(std::abs(numbers[1]) / 45.0);
      for (int i = 0; i < steps; ++i)
      {
        camera->Elevation(numbers[1] / steps);
        camera->OrthogonalizeViewUp();
      }
      camera->Dolly(numbers.size() > 2 ? numbers[2] : 1.0);
    }
  }
  renderer->ResetCameraClippingRange();
}
