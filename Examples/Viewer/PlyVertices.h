// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The vertices of a .ply file with their normals and colours, which vtkPLYReader
// of VTK 9.1 leaves out. Faces are not read.
#ifndef PlyVertices_h
#define PlyVertices_h

#include "vtkSmartPointer.h"

#include <string>

class vtkPolyData;

/**
 * Points, with the active normals where the vertices have nx, ny, nz, and with
 * scalars "RGB" (3 unsigned chars) where they have red, green, blue; ascii and both
 * binary formats. hasFaces: whether the file has faces. Throws UserError.
 */
vtkSmartPointer<vtkPolyData> ReadPlyVertices(const std::string& file, bool& hasFaces);

#endif
