#version 430
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Makes a coarser level of a layer, or fills one from the next coarser (PUSH), by compute:
// see vtkPointSplatPushPull.
// Reads: the layer's level, the next coarser one. Writes: see vtkPointSplatFilled.

#include "vtkPointSplatFetch"
#include "vtkPointSplatFilled"
#include "vtkPointSplatPushPull"

layout(local_size_x = 32) in;

layout(std430, binding = 0) writeonly buffer Result { uvec2 result[]; };

uniform ivec4 ResultWindow; // pixels that are written
uniform int ResultWidth;
uniform float LevelScale;   // pixels of the projection to one of the level

void main()
{
  ivec2 pixel = ResultWindow.xy + ivec2(gl_GlobalInvocationID.xy);
  if (pixel.x > ResultWindow.z || pixel.y > ResultWindow.w)
  {
    return;
  }
#ifdef PUSH
  uvec2 filled = pushPixel(pixel, (vec2(pixel) + 0.5) * LevelScale);
#else
  uvec2 filled = pullPixel(pixel);
#endif
  result[pixel.y * ResultWidth + pixel.x] = filled;
}
