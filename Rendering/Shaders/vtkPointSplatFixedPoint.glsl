// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The units of the integer sums.

// A weight of 1. Even a weight at a Gaussian's end, about 0.03, keeps seven bits.
const float WeightScale = 4096.0;
// Past this sum of weights, some thousand splats, a pixel takes no more: 31 bits
// hold the sums and what is in flight at the same time.
const int WeightLimit = 1 << 24;
// Depths behind the nearest one are counted in this unit, world units, and finer
// than the weights, since the largest splat sets it for all.
uniform float DepthUnit;
const float DepthScale = 32.0;
