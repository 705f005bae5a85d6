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
 * What the columns are, TextColumns tells; how the numbers may be written, TextTable.
 * Throws UserError.
 */
vtkSmartPointer<vtkPolyData> ReadTextPoints(const std::string& file, ProgressBar& progress);

#endif
