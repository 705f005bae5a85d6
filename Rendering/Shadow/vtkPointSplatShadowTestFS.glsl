#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Whether a light reaches a splat, a pixel of the image a splat: it is no farther than the layer
// that the light sees there. Outside the map nothing is known to be in the way.
// Holes are filled where they are asked for (vtkPointSplatShadowFilled).
// Reads: Splats, Map. Writes: lit, 1 or 0, which is added up.

#include "vtkPointSplatShadowProjection"
#include "vtkPointSplatShadowFilled"

const int CountWidth = 4096; // pixels of the image

layout(location = 0) out float lit;

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
