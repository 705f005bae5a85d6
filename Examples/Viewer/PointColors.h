// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PointColors_h
#define PointColors_h

#include "vtkSmartPointer.h"

#include <vector>

class vtkUnsignedCharArray;

/**
 * Array "RGB" (3 unsigned chars) from red, green, blue of one point after the
 * other, all of which stand for white at greatest. Values beyond are clamped.
 */
vtkSmartPointer<vtkUnsignedCharArray> MakeColors(const std::vector<float>& rgb, double greatest);

#endif
