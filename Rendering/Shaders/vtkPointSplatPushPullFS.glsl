#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Makes a coarser level of a layer, or fills one from the next coarser (PUSH), by fragments:
// see vtkPointSplatPushPull.
// Reads: the layer's level, the next coarser one. Writes: see vtkPointSplatFilled.

#include "vtkPointSplatFilled"
#include "vtkPointSplatPushPull"

uniform float LevelScale; // pixels of the projection to one of the level

layout(location = 0) out uvec2 filled;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
#ifdef PUSH
  filled = pushPixel(pixel, (vec2(pixel) + 0.5) * LevelScale);
#else
  filled = pullPixel(pixel);
#endif
}
