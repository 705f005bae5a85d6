// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A shadow map whose holes are filled (Dobrev, Rosenthal, Linsen 2010, sections 3.2 and 3.3):
// an empty pixel that lies beyond no silhouette gets the farthest of its neighbours, unlike there
// the nearest: it is not known what it is a hole in, and so shadows do not grow. An occluded pixel
// gets the nearest: one about which a surface more than the least layer distance nearer leaves no
// five neighbours in a row.

#include "vtkPointSplatMasks"
#include "vtkPointSplatShadowMap"

uniform usampler2D Map;

uint filled(ivec2 pixel, uint own)
{
  bool empty = own == Nothing;
  // White is nothing, and what is too far to occlude the pixel: texels sort by depth.
  float depth = shadowDepth(own);
  uint bound = empty ? Nothing - 1u
                     : encodeShadow(depth - layerOffset(depth, shadowFacing(own)), 1.0);
  uint white = 0u;
  uint nearest = Nothing;
  uint farthest = 0u; // and 1 more, by which Nothing is 0, the least
  for (int k = 0; k < 8; ++k)
  {
    ivec2 at = pixel + Ring[k];
    bool inside = at == clamp(at, ivec2(0), MapSize - 1);
    uint other = inside ? texelFetch(Map, at, 0).r : Nothing;
    white |= uint(other > bound) << k;
    nearest = min(nearest, other);
    farthest = max(farthest, other + 1u);
  }
  return masksMatch(white) ? own : empty ? farthest - 1u : nearest;
}
