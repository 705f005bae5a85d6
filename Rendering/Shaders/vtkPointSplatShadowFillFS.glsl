#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Hole filling in a shadow map (Dobrev, Rosenthal, Linsen 2010, sections 3.2 and 3.3). An empty
// pixel that lies beyond no silhouette gets the farthest of its neighbours, unlike there the
// nearest: it is not known what it is a hole in, and so shadows do not grow. An occluded pixel gets
// the nearest: one about which a surface more than the least layer distance nearer leaves no five
// neighbours in a row.

#include "vtkPointSplatShadowMap"
#include "vtkPointSplatMasks"

uniform usampler2D Map;

layout(location = 0) out uint shadow;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  uint own = texelFetch(Map, pixel, 0).r;
  bool empty = own == Nothing;
  float bound = shadowDepth(own) - layerOffset(shadowDepth(own), shadowFacing(own));
  uint white = 0u;
  uint nearest = Nothing;
  uint farthest = 0u;
  for (int k = 0; k < 8; ++k)
  {
    ivec2 at = pixel + Ring[k];
    bool inside = at == clamp(at, ivec2(0), MapSize - 1);
    uint other = inside ? texelFetch(Map, at, 0).r : Nothing;
    bool isWhite = other == Nothing || (!empty && shadowDepth(other) > bound);
    white |= isWhite ? 1u << k : 0u;
    nearest = min(nearest, other);
    farthest = other == Nothing ? farthest : max(farthest, other);
  }
  shadow = masksMatch(white) ? own : empty ? farthest : nearest;
}
