// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Points in text, a line each: x y z, then nx ny nz, or r g b, or both.
#ifndef TextPoints_h
#define TextPoints_h

#include "vtkSmartPointer.h"

#include <string>

class vtkPolyData;

/**
 * Separators are blanks, tabs, commas and semicolons. Lines that begin with # or //
 * and a leading line with the count are passed over. Three further columns are
 * normals if each is a unit vector within 1 %, else colours of 0 to 255; six are
 * normals and colours; one or four have an intensity first, which is passed over.
 * Throws UserError.
 */
vtkSmartPointer<vtkPolyData> ReadTextPoints(const std::string& file);

#endif
