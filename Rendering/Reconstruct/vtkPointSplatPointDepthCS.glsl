#version 430
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Projection of points as single pixels, by compute: the nearest depth at each pixel, of
// what is behind the layers that were peeled before.
// Writes: Depths, one uint a pixel (see encodeDepth).

#include "vtkPointSplatPointsCS"
#ifdef PEELING
#include "vtkPointSplatPeel"
#endif

layout(std430, binding = 0) buffer Depths { uint depths[]; };
#ifdef PEELING
layout(std430, binding = 3) buffer Found { uint found; }; // whether anything was, at all
#endif

void drawPoint(uint index, Splat q, ivec2 pixel)
{
#ifdef PEELING
  if (isPeeled(q, q.depth, pixel) || isHidden(undelayedDepth(q), pixel))
  {
    return;
  }
  found = 1u;
#endif
  atomicMin(depths[pixelIndex(pixel)], encodeDepth(q.depth, q.tag));
}

void main()
{
  drawPoints();
}
