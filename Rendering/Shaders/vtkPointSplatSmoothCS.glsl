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
#include "vtkPointSplatSmoothing"

layout(std430, binding = 0) writeonly buffer Result { uvec4 result[]; };
#ifdef FACTORS
layout(std430, binding = 2) writeonly buffer FactorResult { uint factorResult[]; };
#endif

struct Row
{
  Sum left;
  Sum middle;
  Sum right;
};

Row fetchRow(ivec2 pixel, bool left, bool right)
{
  Row row;
  row.left.code = row.middle.code = row.right.code = NoDepth;
  row.left.weight = row.middle.weight = row.right.weight = 0.0;
  if (pixel.y >= FilledWindow.y && pixel.y <= FilledWindow.w)
  {
    if (left)
    {
      row.left = fetchSum(pixel - ivec2(1, 0));
    }
    row.middle = fetchSum(pixel);
    if (right)
    {
      row.right = fetchSum(pixel + ivec2(1, 0));
    }
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
  Row below = fetchRow(pixel - ivec2(0, 1), left, right);
  Row row = fetchRow(pixel, left, right);
  for (; pixel.y <= end; ++pixel.y)
  {
    Row above = fetchRow(pixel + ivec2(0, 1), left, right);
    uvec4 texel = uvec4(NoDepth, 0u, 0u, 0u);
    Sum mean = row.middle;
    if (mean.code != NoDepth)
    {
      float range = smoothingRange(mean, pixel);
      scaleSum(mean, 16.0);
      addNeighbour(mean, mean.code, row.right, 2.0, range);
      addNeighbour(mean, mean.code, above.right, 1.0, range);
      addNeighbour(mean, mean.code, above.middle, 2.0, range);
      addNeighbour(mean, mean.code, above.left, 1.0, range);
      addNeighbour(mean, mean.code, row.left, 2.0, range);
      addNeighbour(mean, mean.code, below.left, 1.0, range);
      addNeighbour(mean, mean.code, below.middle, 2.0, range);
      addNeighbour(mean, mean.code, below.right, 1.0, range);
      // Of what is beyond the window nothing is known.
      texel = texelOf(mean,
        isSilhouette(mean.code,
          uint[4](right ? row.right.code : mean.code,
            pixel.y < FilledWindow.w ? above.middle.code : mean.code,
            left ? row.left.code : mean.code,
            pixel.y > FilledWindow.y ? below.middle.code : mean.code)));
    }
    result[pixelIndex(pixel)] = texel;
#ifdef FACTORS
    // Where there is nothing, nobody asks for factors.
    if (mean.code != NoDepth)
    {
      factorResult[pixelIndex(pixel)] = factorTexelOf(mean);
    }
#endif
    below = row;
    row = above;
  }
}
