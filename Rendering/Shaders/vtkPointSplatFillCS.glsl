#version 430
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One step of filling holes, by compute: see vtkPointSplatFillStep.
// Reads: the projected depths, or the step before. Writes: see vtkPointSplatFilled.

#include "vtkPointSplatFetch"
#include "vtkPointSplatStripsCS"
#include "vtkPointSplatFilled"
#include "vtkPointSplatFillStep"

layout(std430, binding = 0) writeonly buffer Result { uvec2 result[]; };
layout(std430, binding = 1) buffer Changed { uint changed; }; // whether anything was filled

// A row's three codes about a pixel; left, right: whether these are inside.
uvec3 fetchRow(ivec2 pixel, bool left, bool right)
{
  uvec3 row = uvec3(NoDepth);
  if (pixel.y >= FilledWindow.y && pixel.y <= FilledWindow.w)
  {
    row.x = left ? fetchCode(pixel - ivec2(1, 0)) : NoDepth;
    row.y = fetchCode(pixel);
    row.z = right ? fetchCode(pixel + ivec2(1, 0)) : NoDepth;
  }
  return row;
}

void main()
{
  ivec2 pixel = FilledWindow.xy + ivec2(gl_GlobalInvocationID.xy) * ivec2(1, StripLength);
  if (pixel.x > FilledWindow.z)
  {
    return;
  }
  bool left = pixel.x > FilledWindow.x;
  bool right = pixel.x < FilledWindow.z;
  int end = min(pixel.y + StripLength - 1, FilledWindow.w);
  uvec3 below = fetchRow(pixel - ivec2(0, 1), left, right);
  uvec3 row = fetchRow(pixel, left, right);
  bool any = false;
  for (; pixel.y <= end; ++pixel.y)
  {
    uvec3 above = fetchRow(pixel + ivec2(0, 1), left, right);
    uvec2 filled = uvec2(row.y, fetchSource(pixel));
    int from = fillFrom(row.y,
      uint[8](row.z, above.z, above.y, above.x, row.x, below.x, below.y, below.z));
    if (from >= 0)
    {
      ivec2 other = pixel + Ring[from];
      filled = uvec2(fetchCode(other), fetchSource(other));
      any = true;
    }
    result[pixelIndex(pixel)] = filled;
    below = row;
    row = above;
  }
  if (any)
  {
    changed = 1u;
  }
}
