// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The vertices of a .ply file with all that they carry, which vtkPLYReader of VTK
// 9.1 leaves out. Faces are not read.
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
 * - an array (1 float or double) of each other property that is no list.
 * Reads ascii and both binary formats. hasFaces: whether the file has faces. Throws
 * UserError.
 */
vtkSmartPointer<vtkPolyData> ReadPlyVertices(
  const std::string& file, bool& hasFaces, ProgressBar& progress);

#endif
