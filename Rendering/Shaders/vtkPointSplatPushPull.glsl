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

uvec2 fetchCoarse(ivec2 pixel)
{
  if (pixel != clamp(pixel, CoarseWindow.xy, CoarseWindow.zw))
  {
    return uvec2(NoDepth, 0u);
  }
#ifdef COMPUTE_IMAGES
  return texelFetch(Coarse, pixel.y * CoarseWidth + pixel.x).xy;
#else
  return texelFetch(Coarse, pixel, 0).xy;
#endif
}

// Of the four coarse pixels about a pixel, with the weights that bilinear interpolation
// gives them, those before it must have three quarters. It takes what comes from nearest
// by in the image.
uvec2 pushPixel(ivec2 pixel, vec2 centre)
{
  uvec2 own = uvec2(fetchCode(pixel), fetchSource(pixel));
  ivec2 parent = pixel >> 1;
  ivec2 side = ivec2((pixel.x & 1) == 0 ? -1 : 1, (pixel.y & 1) == 0 ? -1 : 1);
  int weights = 0;
  float least = 3e38;
  uvec2 best = own;
  for (int k = 0; k < 4; ++k)
  {
    uvec2 other = fetchCoarse(parent + ivec2(k & 1, k >> 1) * side);
    if (other.x >= own.x)
    {
      continue;
    }
    float layer = layerOf(other.x);
    float size = PixelSize.x + PixelSize.y * depthOf(other.x);
    float spacing = SlotSpacings[int((other.x & TagMask) >> 1)];
    if (layer < 0.0 || spacing < PixelsNeeded * size ||
      !(own.x == NoDepth || depthOf(other.x) + layer < depthOf(own.x)))
    {
      continue;
    }
    weights += k == 0 ? 9 : k == 3 ? 1 : 3;
    vec2 away = vec2(sourcePixel(other.y)) - centre;
    float distance = dot(away, away);
    best = distance < least ? other : best;
    least = min(least, distance);
  }
  return weights >= 12 ? best : own;
}
#endif
