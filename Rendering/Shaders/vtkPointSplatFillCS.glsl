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

// A row of an invocation's pixels, one and two, and one more at each side.
struct Row
{
  uvec2 left;
  uvec2 one;
  uvec2 two;
  uvec2 right;
};

Row fetchRow(ivec2 pixel)
{
  return Row(fetchFilled(pixel - ivec2(1, 0)), fetchFilled(pixel),
    fetchFilled(pixel + ivec2(1, 0)), fetchFilled(pixel + ivec2(2, 0)));
}

// Whether there was something to fill. ring: about the pixel, as Ring.
bool fillInto(ivec2 pixel, uvec2 own, uint ring[8])
{
  uvec2 filled = fill(pixel, own, ring);
  if (pixel.x > FilledWindow.z)
  {
    return false;
  }
  result[pixelIndex(pixel)] = filled;
  return filled.x != own.x;
}

void main()
{
  ivec2 pixel = stripPixel(FilledWindow);
  int end = min(pixel.y + StripLength - 1, FilledWindow.w);
  Row below = fetchRow(pixel - ivec2(0, 1));
  Row row = fetchRow(pixel);
  bool any = false;
  for (; pixel.y <= end; ++pixel.y)
  {
    Row above = fetchRow(pixel + ivec2(0, 1));
    bool one = fillInto(pixel, row.one,
      uint[8](row.two.x, above.two.x, above.one.x, above.left.x, row.left.x, below.left.x,
        below.one.x, below.two.x));
    bool two = fillInto(pixel + ivec2(1, 0), row.two,
      uint[8](row.right.x, above.right.x, above.two.x, above.one.x, row.one.x, below.one.x,
        below.two.x, below.right.x));
    any = any || one || two;
    below = row;
    row = above;
  }
  if (any)
  {
    changed = 1u;
  }
}
