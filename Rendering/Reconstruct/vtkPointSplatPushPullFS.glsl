#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Makes a coarser level of a layer, or (PUSH) fills one from the next coarser: where points are
// farther apart than pixels, the masks find no closed rims. Holes are filled
// from coarser levels then (pull and push, as Marroquim, Kraus, Cavalcanti 2007 do it for
// splats): each level has half the pixels a side of the one below, and in each the nearest of
// four; holes of the coarsest level are filled by the masks.
// Reads: the layer's level, the next coarser one. Writes: see vtkPointSplatFilled.

#include "vtkPointSplatFilled"

layout(location = 0) out uvec2 filled;

#ifdef PUSH
uniform usampler2D Coarse;
uniform ivec4 CoarseWindow;
uniform ivec2 CoarseLastPixel;
uniform float PixelsNeeded; // what lies closer, in this level's pixels, needs no filling from above
uniform float LevelScale;   // pixels of the projection to one of the level

// As fetchFilled.
uvec2 fetchCoarse(ivec2 pixel)
{
  ivec2 known = clamp(pixel, ivec2(0), CoarseLastPixel);
  ivec2 inside = clamp(known, CoarseWindow.xy, CoarseWindow.zw);
  uvec2 coarse = texelFetch(Coarse, inside, 0).xy;
  return inside == known ? coarse : uvec2(NoDepth, 0u);
}

// coarse: the four pixels about this one, its own, that at the side, that above or below, that
// at the corner. With the weights that bilinear interpolation gives them, those before the
// pixel must have three quarters. It takes what comes from nearest by in the image.
uvec2 pushPixel(uvec2 own, uvec2 coarse[4], vec2 centre)
{
  uint nearest = min(min(coarse[0].x, coarse[1].x), min(coarse[2].x, coarse[3].x));
  if (nearest >= own.x || !isPoint(nearest) ||
    itemPoints(nearest & TagMask).z <
      PixelsNeeded * (PixelSize.x + PixelSize.y * decodeDepth(nearest)))
  {
    return own;
  }
  float limit = own.x == NoDepth ? 3e38 : decodeDepth(own.x) - layerOf(nearest);
  int weights = 0;
  float least = 3e38;
  uvec2 best = own;
  for (int k = 0; k < 4; ++k)
  {
    bool before = depthOf(coarse[k].x) < limit;
    weights += before ? (k == 0 ? 9 : k == 3 ? 1 : 3) : 0;
    vec2 away = vec2(sourcePixel(coarse[k].y)) + 0.5 - centre;
    float distance = before ? dot(away, away) : 3e38;
    best = distance < least ? coarse[k] : best;
    least = min(least, distance);
  }
  return weights < 12 ? own : best;
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  ivec2 parent = pixel >> 1;
  ivec2 side = 2 * (pixel & 1) - 1;
  filled = pushPixel(fetchInside(pixel),
    uvec2[4](fetchCoarse(parent), fetchCoarse(parent + ivec2(side.x, 0)),
      fetchCoarse(parent + ivec2(0, side.y)), fetchCoarse(parent + side)),
    (vec2(pixel) + 0.5) * LevelScale);
}
#else
void main()
{
  ivec2 first = 2 * ivec2(gl_FragCoord.xy);
  filled = uvec2(NoDepth, 0u);
  for (int k = 0; k < 4; ++k)
  {
    uvec2 child = fetchFilled(first + ivec2(k & 1, k >> 1));
    filled = child.x < filled.x ? child : filled;
  }
}
#endif
