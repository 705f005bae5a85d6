// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Where the columns of a grid are that are up to `dense` times as close in the middle: what cells of such points reach
// differs by much all over them, and by little from one to the next.
#ifndef UnevenColumns_h
#define UnevenColumns_h

#include "vtkMath.h"

#include <cmath>

/// The integral of the distance of columns, which is 1 but for a bell curve about the middle of `size` of them.
inline double PlaceColumn(double t, int size, double dense)
{
  const double width = 0.25 * size;
  return t - (1 - 1 / dense) * width * std::sqrt(0.5 * vtkMath::Pi()) *
    std::erf((t - 0.5 * size) / (width * std::sqrt(2.0)));
}

#endif
