#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Whether a light reaches a splat, a pixel of the image a splat: it is no farther than the layer
// that the light sees there. Outside the map nothing is known to be in the way.
// Holes are filled where they are asked for (Dobrev, Rosenthal, Linsen 2010, sections 3.2 and 3.3):
// an empty pixel that lies beyond no silhouette gets the farthest of its neighbours, unlike there
// the nearest: it is not known what it is a hole in, and so shadows do not grow. An occluded pixel
// gets the nearest: one about which a surface more than the least layer distance nearer leaves no
// five neighbours in a row.
// Reads: Splats, Map. Writes: lit, 1 or 0, which is added up.

#include "vtkPointSplatShadowProjection"
#include "vtkPointSplatMasks"

uniform usampler2D Map;

const int CountWidth = 4096; // pixels of the image

layout(location = 0) out float lit;

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

bool isBehind(Seen s, uint texel)
{
  return texel != Nothing && s.depth > shadowDepth(texel) + layerOffset(s.depth, s.facing);
}

void main()
{
  int index = int(gl_FragCoord.y) * CountWidth + int(gl_FragCoord.x);
  if (index >= SplatCount)
  {
    discard;
  }
  Seen s = seeSplat(index);
  bool dark = false;
  if (s.mine && s.inside)
  {
    ivec2 pixel = ivec2(s.pixel);
    uint own = texelFetch(Map, pixel, 0).r;
    // What fills an occluded pixel is nearer still.
    dark = isBehind(s, own) || isBehind(s, filled(pixel, own));
  }
  lit = s.mine && !dark ? 1.0 : 0.0;
}
