#version 430
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Smooths a filled layer, by compute: see vtkPointSplatSmoothing.
// Reads: the filled layer and the projection's sums. Writes: see vtkPointSplatTexel.

#include "vtkPointSplatTexel"
#include "vtkPointSplatFetch"
#include "vtkPointSplatStripsCS"
#include "vtkPointSplatFilled"
#include "vtkPointSplatMasks"
#include "vtkPointSplatSmoothing"

layout(std430, binding = 0) writeonly buffer Result { uvec4 result[]; };
#ifdef FACTORS
layout(std430, binding = 2) writeonly buffer FactorResult { uint factorResult[]; };
#endif

// A row of an invocation's pixels, one and two, and one more at each side.
struct Row
{
  Sum left;
  Sum one;
  Sum two;
  Sum right;
};

Row fetchRow(ivec2 pixel)
{
  return Row(fetchSum(pixel - ivec2(1, 0)), fetchSum(pixel), fetchSum(pixel + ivec2(1, 0)),
    fetchSum(pixel + ivec2(2, 0)));
}

// ring: about the pixel, as Ring.
void smoothInto(ivec2 pixel, Sum mean, Sum ring[8])
{
  uint own = mean.code;
  vec3 ray = pixelRay(pixel);
  float range = smoothingRange(mean, ray);
  scaleSum(mean, 16.0);
  for (int k = 0; k < 8; ++k)
  {
    addNeighbour(mean, own, ring[k], (k & 1) == 0 ? 2.0 : 1.0, range);
  }
  uvec4 texel;
  uint factors;
  smoothPixel(pixel, ray, mean, Sum[4](ring[0], ring[2], ring[4], ring[6]), texel, factors);
  if (pixel.x <= FilledWindow.z)
  {
    result[pixelIndex(pixel)] = texel;
#ifdef FACTORS
    factorResult[pixelIndex(pixel)] = factors;
#endif
  }
}

void main()
{
  ivec2 pixel = stripPixel(FilledWindow);
  int end = min(pixel.y + StripLength - 1, FilledWindow.w);
  Row below = fetchRow(pixel - ivec2(0, 1));
  Row row = fetchRow(pixel);
  for (; pixel.y <= end; ++pixel.y)
  {
    Row above = fetchRow(pixel + ivec2(0, 1));
    smoothInto(pixel, row.one,
      Sum[8](row.two, above.two, above.one, above.left, row.left, below.left, below.one, below.two));
    smoothInto(pixel + ivec2(1, 0), row.two,
      Sum[8](row.right, above.right, above.two, above.one, row.one, below.one, below.two,
        below.right));
    below = row;
    row = above;
  }
}
