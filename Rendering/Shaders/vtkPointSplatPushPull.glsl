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
    ivec2 child = 2 * pixel + ivec2(k & 1, k >> 1);
    if (!isOutside(child))
    {
      uint code = fetchCode(child);
      nearest = code < nearest.x ? uvec2(code, fetchSource(child)) : nearest;
    }
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

uint fetchCoarseCode(ivec2 pixel)
{
  if (pixel != clamp(pixel, CoarseWindow.xy, CoarseWindow.zw))
  {
    return NoDepth;
  }
#ifdef COMPUTE_IMAGES
  return texelFetch(Coarse, pixel.y * CoarseWidth + pixel.x).x;
#else
  return texelFetch(Coarse, pixel, 0).x;
#endif
}

// Of a pixel inside.
uint fetchCoarseSource(ivec2 pixel)
{
#ifdef COMPUTE_IMAGES
  return texelFetch(Coarse, pixel.y * CoarseWidth + pixel.x).y;
#else
  return texelFetch(Coarse, pixel, 0).y;
#endif
}

// Of the four coarse pixels about a pixel, with the weights that bilinear interpolation
// gives them, those before it must have three quarters. It takes what comes from nearest
// by in the image.
uvec2 pushPixel(ivec2 pixel, vec2 centre)
{
  uvec2 best = uvec2(fetchCode(pixel), fetchSource(pixel));
  uint own = best.x;
  ivec2 parent = pixel >> 1;
  ivec2 side = ivec2((pixel.x & 1) == 0 ? -1 : 1, (pixel.y & 1) == 0 ? -1 : 1);
  uint codes[4];
  uint nearest = NoDepth;
  for (int k = 0; k < 4; ++k)
  {
    codes[k] = fetchCoarseCode(parent + ivec2(k & 1, k >> 1) * side);
    nearest = min(nearest, codes[k]);
  }
  if (nearest >= own)
  {
    return best;
  }
  float layer = layerOf(nearest);
  float spacing = SlotSpacings[slotOf(nearest)];
  if (layer < 0.0 || spacing < PixelsNeeded * (PixelSize.x + PixelSize.y * decodeDepth(nearest)))
  {
    return best;
  }
  float limit = own == NoDepth ? 3e38 : decodeDepth(own) - layer;
  int weights = 0;
  for (int k = 0; k < 4; ++k)
  {
    weights += decodeDepth(codes[k]) < limit ? (k == 0 ? 9 : k == 3 ? 1 : 3) : 0;
  }
  if (weights < 12)
  {
    return best;
  }
  float least = 3e38;
  for (int k = 0; k < 4; ++k)
  {
    if (decodeDepth(codes[k]) < limit)
    {
      uint source = fetchCoarseSource(parent + ivec2(k & 1, k >> 1) * side);
      vec2 away = vec2(sourcePixel(source)) + 0.5 - centre;
      float distance = dot(away, away);
      best = distance < least ? uvec2(codes[k], source) : best;
      least = min(least, distance);
    }
  }
  return best;
}
#endif
