// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where points are farther apart than pixels, the masks find no closed rims. Holes are filled
// from coarser levels then (pull and push, as Marroquim, Kraus, Cavalcanti 2007 do it for
// splats): each level has half the pixels a side of the one below, and in each the nearest of
// four; holes of the coarsest level are filled by the masks.

// A level's pixel, from the four that it has below.
uvec2 pullPixel(ivec2 pixel)
{
  uvec2 nearest = uvec2(NoDepth, 0u);
  for (int k = 0; k < 4; ++k)
  {
    uvec2 child = fetchFilled(2 * pixel + ivec2(k & 1, k >> 1));
    nearest = child.x < nearest.x ? child : nearest;
  }
  return nearest;
}

#ifdef PUSH
uniform ivec4 CoarseWindow;
uniform int CoarseWidth;
// Of the items by their slots: the points' spacing, world units.
uniform float SlotSpacings[64];
uniform float PixelsNeeded; // what lies closer, in this level's pixels, needs no filling from above
#ifdef COMPUTE_IMAGES
uniform usamplerBuffer Coarse;
#else
uniform usampler2D Coarse;
#endif

// Coded depth and source; outside there is nothing.
uvec2 fetchCoarse(ivec2 pixel)
{
  ivec2 inside = clamp(pixel, CoarseWindow.xy, CoarseWindow.zw);
#ifdef COMPUTE_IMAGES
  uvec2 coarse = texelFetch(Coarse, inside.y * CoarseWidth + inside.x).xy;
#else
  uvec2 coarse = texelFetch(Coarse, inside, 0).xy;
#endif
  return inside == pixel ? coarse : uvec2(NoDepth, 0u);
}

// coarse: the four pixels about this one, its own, that at the side, that above or below, that
// at the corner. With the weights that bilinear interpolation gives them, those before the
// pixel must have three quarters. It takes what comes from nearest by in the image.
uvec2 pushPixel(uvec2 own, uvec2 coarse[4], vec2 centre)
{
  uint nearest = min(min(coarse[0].x, coarse[1].x), min(coarse[2].x, coarse[3].x));
  float layer = layerOf(nearest);
  float spacing = SlotSpacings[slotOf(nearest)];
  float limit = own.x == NoDepth ? 3e38 : decodeDepth(own.x) - layer;
  int weights = 0;
  float least = 3e38;
  uvec2 best = own;
  for (int k = 0; k < 4; ++k)
  {
    bool before = decodeDepth(coarse[k].x) < limit;
    weights += before ? (k == 0 ? 9 : k == 3 ? 1 : 3) : 0;
    vec2 away = vec2(sourcePixel(coarse[k].y)) + 0.5 - centre;
    float distance = before ? dot(away, away) : 3e38;
    best = distance < least ? coarse[k] : best;
    least = min(least, distance);
  }
  bool dense =
    spacing < PixelsNeeded * (PixelSize.x + PixelSize.y * decodeDepth(nearest));
  return nearest >= own.x || layer < 0.0 || dense || weights < 12 ? own : best;
}
#endif
