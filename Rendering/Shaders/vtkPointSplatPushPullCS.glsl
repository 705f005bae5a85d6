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

#ifdef PUSH
// Each invocation goes up a strip of coarse pixels: of the nine about one, which serve its four
// pixels here, it reads three anew.
const int StripLength = 8;

struct Row
{
  uvec2 left;
  uvec2 middle;
  uvec2 right;
};

Row fetchRow(ivec2 pixel)
{
  return Row(
    fetchCoarse(pixel - ivec2(1, 0)), fetchCoarse(pixel), fetchCoarse(pixel + ivec2(1, 0)));
}

void push(ivec2 pixel, uvec2 coarse[4])
{
  uvec2 filled = pushPixel(fetchFilled(pixel), coarse, (vec2(pixel) + 0.5) * LevelScale);
  if (!isOutside(pixel))
  {
    result[pixel.y * ResultWidth + pixel.x] = filled;
  }
}

void main()
{
  ivec2 pixel = CoarseWindow.xy + ivec2(gl_GlobalInvocationID.xy) * ivec2(1, StripLength);
  int end = min(pixel.y + StripLength - 1, CoarseWindow.w);
  Row below = fetchRow(pixel - ivec2(0, 1));
  Row row = fetchRow(pixel);
  for (; pixel.y <= end; ++pixel.y)
  {
    Row above = fetchRow(pixel + ivec2(0, 1));
    ivec2 child = 2 * pixel;
    push(child, uvec2[4](row.middle, row.left, below.middle, below.left));
    push(child + ivec2(1, 0), uvec2[4](row.middle, row.right, below.middle, below.right));
    push(child + ivec2(0, 1), uvec2[4](row.middle, row.left, above.middle, above.left));
    push(child + ivec2(1, 1), uvec2[4](row.middle, row.right, above.middle, above.right));
    below = row;
    row = above;
  }
}
#else
void main()
{
  ivec2 pixel = ResultWindow.xy + ivec2(gl_GlobalInvocationID.xy);
  if (pixel.x <= ResultWindow.z && pixel.y <= ResultWindow.w)
  {
    result[pixel.y * ResultWidth + pixel.x] = pullPixel(pixel);
  }
}
#endif
