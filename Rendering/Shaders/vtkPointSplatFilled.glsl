// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A layer while its holes are filled (two uints a pixel: a buffer with COMPUTE_IMAGES, or an
// RG32UI texture): the coded depth, and the pixel (column, and row in the upper half) whose
// projected attributes are meant. The first step starts from the projected depths (FIRST_FILL,
// which needs vtkPointSplatFetch), each pixel its own.

#include "vtkPointSplatDepthCode"

#ifndef FIRST_FILL
#ifdef COMPUTE_IMAGES
uniform usamplerBuffer Filled;
#else
uniform usampler2D Filled;
#endif
#endif

uniform ivec4 FilledWindow;   // pixels that hold something: first x, y, last x, y
// Of the items by their slots, the least layer distance, world units, and in pixels: the larger
// counts. Negative: their splats have an extent, and fill no holes.
uniform float SlotLayers[64];
uniform float SlotLayerPixels[64];
uniform vec2 PixelSize;       // world units: at depth 0, and its growth with the depth

bool isOutside(ivec2 pixel)
{
  return pixel != clamp(pixel, FilledWindow.xy, FilledWindow.zw);
}

// Of a pixel inside, the coded depth, and the pixel that is meant.
uvec2 fetchInside(ivec2 pixel)
{
#if defined(FIRST_FILL)
  return uvec2(fetchDepth(pixel), uint(pixel.x) | uint(pixel.y) << 16);
#elif defined(COMPUTE_IMAGES)
  return texelFetch(Filled, pixel.y * ImageWidth + pixel.x).xy;
#else
  return texelFetch(Filled, pixel, 0).xy;
#endif
}

// The same of any pixel: outside there is nothing. CPUs skip no branch, so that a fetch
// costs less than a condition.
uvec2 fetchFilled(ivec2 pixel)
{
  ivec2 inside = clamp(pixel, FilledWindow.xy, FilledWindow.zw);
  uvec2 filled = fetchInside(inside);
  return inside == pixel ? filled : uvec2(NoDepth, 0u);
}

ivec2 sourcePixel(uint source)
{
  return ivec2(source & 0xffffu, source >> 16);
}

float layerOf(uint code)
{
  int slot = slotOf(code);
  float pixel = PixelSize.x + PixelSize.y * decodeDepth(code);
  return SlotLayers[slot] < 0.0 ? -1.0 : max(SlotLayers[slot], SlotLayerPixels[slot] * pixel);
}
