// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// From a file's name to its data.
#ifndef Readers_h
#define Readers_h

#include "vtkSmartPointer.h"

#include <string>
#include <utility>
#include <vector>

class vtkDataSet;

/// Whether the file's name is that of a file of points with levels of detail.
bool IsOctree(const std::string& file);

/**
 * What lies in the file, each a vtkImageData or a vtkPointSet with at least one
 * point, and its name: the file's, and of more than one the block's. Of .h5 files at most so many
 * splats are read; 0: all points. Throws UserError.
 */
std::vector<std::pair<std::string, vtkSmartPointer<vtkDataSet>>> ReadFile(
  const std::string& file, bool quiet, long mostPoints);

#endif
