// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// A .ply file's vertices with all that they carry, which vtkPLYReader of VTK 9.1 leaves out, and
// faces, which it does not check.
#ifndef PlyVertices_h
#define PlyVertices_h

#include "vtkSmartPointer.h"

#include <string>

class ProgressBar;
class vtkPolyData;

/**
 * Points (double if the file's are), with
 * - the active normals where the vertices have nx, ny, nz,
 * - the active scalars "RGB" (3 unsigned chars) where they have red, green, blue, or
 *   the same with diffuse_ before them; floating-point ones are from 0 to 1,
 * - an array (1 float or double) of each other property that is no list,
 * and, where the vertices have no normals, the polygons and strips behind them. Faces that name
 * vertices which are not there are left out, with a warning. Reads ascii and both binary formats.
 * Throws UserError, also where the file ends before it holds what its header says.
 */
vtkSmartPointer<vtkPolyData> ReadPly(const std::string& file, ProgressBar& progress);

#endif
