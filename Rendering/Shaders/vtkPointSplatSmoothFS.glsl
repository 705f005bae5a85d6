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
#ifdef FACTORS
layout(location = 1) out uint factorTexel;
#endif

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  Sum mean = fetchSum(pixel);
  uint own = mean.code;
  vec3 ray = pixelRay(pixel);
  float range = smoothingRange(mean, ray);
  scaleSum(mean, 16.0);
  Sum beside[4];
  for (int k = 0; k < 4; ++k)
  {
    beside[k] = fetchSum(pixel + Ring[2 * k]);
    addNeighbour(mean, own, beside[k], 2.0, range);
    addNeighbour(mean, own, fetchSum(pixel + Ring[2 * k + 1]), 1.0, range);
  }
  uint factors;
  smoothPixel(pixel, ray, mean, beside, texel, factors);
#ifdef FACTORS
  factorTexel = factors;
#endif
}
