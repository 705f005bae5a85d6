// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Files of points with levels of detail, in HDF5.
#ifndef OctreeFiles_h
#define OctreeFiles_h

#include "vtkDataObject.h"
#include "vtkSmartPointer.h"

#include <string>

struct Options;

/**
 * At most so many splats that stand for a file's points; 0: all points.
 */
vtkSmartPointer<vtkDataObject> ReadOctree(const std::string& file, long most, bool quiet);

/**
 * Writes all files' points, file after file, into one.
 */
void ConvertFiles(const Options& options);

#endif
