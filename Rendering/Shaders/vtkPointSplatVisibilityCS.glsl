#version 430
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Visibility splatting, by compute: the nearest depth of all disks at each
// pixel. Disks are drawn without the kernel's tail, which would draw the
// surface past its silhouettes. Of what is behind the layers that were peeled before.
// Reads: Previous. Writes: Depths, one uint a pixel (see encodeDepth).

#include "vtkPointSplatSplatsCS"
#ifdef PEELING
#include "vtkPointSplatPeel"
#include "vtkPointSplatPreviousCS"
#endif

layout(std430, binding = 0) buffer Depths { uint depths[]; };
#ifdef PEELING
layout(std430, binding = 3) buffer Found { uint found; }; // whether anything was, at all
#endif

uniform float DiskReach;      // radii that are drawn
uniform float CoverageRadius; // pixels: below, a disk might miss every pixel

void drawPixel(Splat q, uint index, ivec2 pixel)
{
  Hit hit;
  if (intersect(q, vec2(pixel) + 0.5, DiskReach, hit))
  {
    int at = pixelIndex(pixel);
#ifdef PEELING
    if (PreviousCount > 0 && isPeeled(q, hit.depth, previousDepths(pixel)))
    {
      return;
    }
    if (HasSceneDepth && isHidden(hit.depth, pixel))
    {
      return;
    }
    found = 1u;
#endif
    atomicMin(depths[at], encodeDepth(hit.depth, q.tag));
  }
}

void main()
{
  drawSplats(DiskReach, CoverageRadius);
}
