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
  ivec2 parent = pixel >> 1;
  ivec2 side = 2 * (pixel & 1) - 1;
  filled = pushPixel(fetchInside(pixel),
    uvec2[4](fetchCoarse(parent), fetchCoarse(parent + ivec2(side.x, 0)),
      fetchCoarse(parent + ivec2(0, side.y)), fetchCoarse(parent + side)),
    (vec2(pixel) + 0.5) * LevelScale);
#else
  filled = pullPixel(pixel);
#endif
}
