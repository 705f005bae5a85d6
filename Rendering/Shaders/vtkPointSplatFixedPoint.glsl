// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The units of the integer sums.

// A weight of 1. Even a weight at a Gaussian's end, about 0.03, keeps seven bits.
const float WeightScale = 4096.0;
// Past this sum of weights a pixel takes no more: what is in flight at the same
// time still fits into 31 bits.
const int WeightLimit = 1 << 28;
// Depths behind the nearest one are counted in this unit, world units.
uniform float DepthUnit;
