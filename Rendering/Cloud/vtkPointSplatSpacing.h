// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The mean distance of neighbouring points, roughly; where the sampling changes over the surface,
// their distance where it is sparsest but for a tenth of the area.
//
// 1. The bounding box is divided into cubes of some ten points each. The surface passes through
//    one and a half times as many as it would fill, so that those which hold points tell its area.
// 2. Blocks of 4 x 4 x 4 cubes are sorted by their points a filled cube. The spacing is that of the
//    block which has a tenth of the filled cubes before it.
// 3. Of L points a cube by chance, 1 - exp(-L) of the cubes are filled: L is solved for by
//    iteration. By chance alone evenly random points are sparser there by a factor of 1.4.
#ifndef vtkPointSplatSpacing_h
#define vtkPointSplatSpacing_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

class vtkPointSplatSpacing
{
public:
  /// Of the first count splats of some words each, whose first three are floats relative to low. 0
  /// where all lie in one place.
  static double Estimate(const std::vector<uint32_t>& splats, size_t words, size_t count,
    const std::array<double, 3>& low, double size);
};

#endif
