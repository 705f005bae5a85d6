// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Points in text, a line each.
#ifndef TextPoints_h
#define TextPoints_h

#include "vtkSmartPointer.h"

#include <string>

class ProgressBar;
class vtkPolyData;

/**
 * Columns are x y z, then normals, colours, both in either order, or neither, with
 * one scalar before or behind those: three columns are normals if they are unit
 * vectors within 1 % (or zero), else colours, from 0 to 1 or from 0 to 255. The
 * scalar becomes the array "Intensity".
 *
 * How the numbers may be written, TextTable tells. Throws UserError.
 */
vtkSmartPointer<vtkPolyData> ReadTextPoints(const std::string& file, ProgressBar& progress);

#endif
