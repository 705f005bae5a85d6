// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One step of filling holes (Dobrev, Rosenthal, Linsen 2010, sections 3.2 and 3.3). A pixel
// that is background, or lies behind its neighbours by more than the least layer distance,
// takes what the nearest of them has, unless one of the eight masks matches: it lies beyond
// a silhouette then. Background is what lies infinitely far behind, so that one test
// makes both fillings.

#include "vtkPointSplatMasks"

// What fills a pixel, or what it has itself. own: that; codes: the coded depths of the ring
// about it.
uvec2 fill(ivec2 pixel, uvec2 own, uint codes[8])
{
  uint nearest = NoDepth;
  int from = 0;
  for (int k = 0; k < 8; ++k)
  {
    from = codes[k] < nearest ? k : from;
    nearest = min(nearest, codes[k]);
  }
  float layer = layerOf(nearest);
  float limit = layer < 0.0 ? -1.0 : own.x == NoDepth ? 3e38 : decodeDepth(own.x) - layer;
  uint white = 0u;
  for (int k = 0; k < 8; ++k)
  {
    // Background, which is no number as a depth, is before nothing.
    white |= decodeDepth(codes[k]) < limit ? 0u : 1u << k;
  }
  uint source = fetchFilled(pixel + Ring[from]).y;
  return nearest >= own.x || masksMatch(white) ? own : uvec2(nearest, source);
}
