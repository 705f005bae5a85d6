// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From view coordinates to the pixels of the images.

uniform vec4 PixelX;   // view coordinates to x w
uniform vec4 PixelY;   // to y w
uniform vec4 PixelW;   // to w
uniform bool Parallel; // parallel projection
