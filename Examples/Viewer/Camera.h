// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Camera_h
#define Camera_h

#include <vector>

class vtkBoundingBox;
class vtkRenderer;

/**
 * Places the camera by what --camera was given: nothing; azimuth, elevation and
 * zoom relative to where it looks; or position, focal point, view up and angle. also: what is to be in
 * sight beside what the renderer has; may be invalid.
 */
void PlaceCamera(
  vtkRenderer* renderer, const std::vector<double>& numbers, const vtkBoundingBox& also);

#endif
