#version 430
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Visibility splatting, by compute: the nearest depth of all disks at each
// pixel. Disks are drawn without the kernel's tail, which would draw the
// surface past its silhouettes.
// Writes: Depths, one uint a pixel (see encodeDepth).

#include "vtkPointSplatSplatsCS"

layout(std430, binding = 0) buffer Depths { uint depths[]; };

uniform float DiskReach;      // radii that are drawn
uniform float CoverageRadius; // pixels: below, a disk might miss every pixel

void drawPixel(Splat q, uint index, ivec2 pixel)
{
  Hit hit;
  if (intersect(q, vec2(pixel) + 0.5, DiskReach, hit))
  {
    atomicMin(depths[pixelIndex(pixel)], encodeDepth(hit.depth, q.tag));
  }
}

void main()
{
  drawSplats(DiskReach, CoverageRadius);
}
