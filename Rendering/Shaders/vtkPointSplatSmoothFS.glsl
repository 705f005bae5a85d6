#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Smooths a filled layer, by fragments: see vtkPointSplatSmoothing.
// Reads: the filled layer and the projection's sums. Writes: see vtkPointSplatTexel.

#include "vtkPointSplatTexel"
#include "vtkPointSplatFetch"
#include "vtkPointSplatFilled"
#include "vtkPointSplatMasks"
#include "vtkPointSplatSmoothing"

layout(location = 0) out uvec4 texel;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  Sum mean = fetchSum(pixel);
  if (mean.code == NoDepth)
  {
    texel = uvec4(NoDepth, 0u, 0u, 0u);
    return;
  }
  float range = smoothingRange(mean, pixel);
  scaleSum(mean, 16.0);
  for (int k = 0; k < 8; ++k)
  {
    ivec2 other = pixel + Ring[k];
    if (!isOutside(other))
    {
      addNeighbour(mean, mean.code, fetchSum(other), (k & 1) == 0 ? 2.0 : 1.0, range);
    }
  }
  texel = texelOf(mean);
}
