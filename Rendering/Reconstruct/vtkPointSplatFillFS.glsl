#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One step of filling holes (Dobrev, Rosenthal, Linsen 2010, sections 3.2 and 3.3). A pixel
// that is background, or lies behind its neighbours by more than the least layer distance,
// takes what the nearest of them has, unless one of the eight masks matches: it lies beyond
// a silhouette then. Background is what lies infinitely far behind, so that one test
// makes both fillings.
// Reads: the projected depths, or the step before. Writes: see vtkPointSplatFilled.

#include "vtkPointSplatDepthCode"
#ifdef FIRST_FILL
#include "vtkPointSplatSums"
#endif
#include "vtkPointSplatFilled"
#include "vtkPointSplatMasks"

layout(location = 0) out uvec2 filled;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  uvec2 own = fetchInside(pixel);
  uint codes[8];
  uvec2 nearest = uvec2(NoDepth, 0u);
  for (int k = 0; k < 8; ++k)
  {
    uvec2 beside = fetchFilled(pixel + Ring[k]);
    codes[k] = beside.x;
    nearest = beside.x < nearest.x ? beside : nearest;
  }
  filled = own;
  if (nearest.x < own.x && isPoint(nearest.x))
  {
    float limit = own.x == NoDepth ? 3e38 : decodeDepth(own.x) - layerOf(nearest.x);
    uint white = 0u;
    for (int k = 0; k < 8; ++k)
    {
      white |= depthOf(codes[k]) < limit ? 0u : 1u << k;
    }
    filled = masksMatch(white) ? own : nearest;
  }
}
