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
  if (mean.code == NoDepth)
  {
    texel = uvec4(NoDepth, 0u, 0u, 0u);
#ifdef FACTORS
    factorTexel = 0u;
#endif
    return;
  }
  float range = smoothingRange(mean, pixel);
  scaleSum(mean, 16.0);
  // Of what is beyond the window nothing is known.
  uint codes[8] = uint[8](mean.code, mean.code, mean.code, mean.code, mean.code, mean.code,
    mean.code, mean.code);
  for (int k = 0; k < 8; ++k)
  {
    ivec2 other = pixel + Ring[k];
    if (!isOutside(other))
    {
      Sum sum = fetchSum(other);
      codes[k] = sum.code;
      addNeighbour(mean, mean.code, sum, (k & 1) == 0 ? 2.0 : 1.0, range);
    }
  }
  texel = texelOf(mean, isSilhouette(mean.code, uint[4](codes[0], codes[2], codes[4], codes[6])));
#ifdef FACTORS
  factorTexel = factorTexelOf(mean);
#endif
}
