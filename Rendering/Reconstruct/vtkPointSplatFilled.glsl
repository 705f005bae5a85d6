// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A layer while its holes are filled (RG32UI): the coded depth, and the pixel (column, and row in
// the upper half) whose projected attributes are meant. The first step starts from the projected
// depths (FIRST_FILL, which needs vtkPointSplatSums), each pixel its own.

#include "vtkPointSplatDepthCode"
#include "vtkPointSplatItemTable"

#ifndef FIRST_FILL
uniform usampler2D Filled;
#endif

uniform ivec4 FilledWindow; // pixels that hold something: first x, y, last x, y
uniform ivec2 LastPixel;    // of the image
uniform vec2 PixelSize;     // world units: at depth 0, and its growth with the depth

// Of a pixel inside, the coded depth, and the pixel that is meant.
uvec2 fetchInside(ivec2 pixel)
{
#ifdef FIRST_FILL
  return uvec2(fetchDepth(pixel), uint(pixel.x) | uint(pixel.y) << 16);
#else
  return texelFetch(Filled, pixel, 0).xy;
#endif
}

// The same of any pixel. Beyond the image, of which nothing is known, goes on what is at its
// border. CPUs skip no branch, so that a fetch costs less than a condition.
uvec2 fetchFilled(ivec2 pixel)
{
  ivec2 known = clamp(pixel, ivec2(0), LastPixel);
  ivec2 inside = clamp(known, FilledWindow.xy, FilledWindow.zw);
  uvec2 filled = fetchInside(inside);
  return inside == known ? filled : uvec2(NoDepth, 0u);
}

ivec2 sourcePixel(uint source)
{
  return ivec2(source & 0xffffu, source >> 16);
}

// Of a coded depth that is none, the farthest.
float depthOf(uint code)
{
  return code == NoDepth ? 3e38 : decodeDepth(code);
}

// Whether a coded depth is a point's, which fills holes; splats have an extent, and leave none.
bool isPoint(uint code)
{
  return code != NoDepth && itemIsPoints(code & TagMask);
}

// The least layer distance of points, world units.
float layerOf(uint code)
{
  vec4 points = itemPoints(code & TagMask);
  return max(points.x, points.y * (PixelSize.x + PixelSize.y * decodeDepth(code)));
}
