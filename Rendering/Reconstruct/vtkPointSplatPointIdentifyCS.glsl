#version 430
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Names the nearest point of each pixel, for hardware selection; of equals the one with the
// least id; or the colours of their cells (vtkPointSplatCloud.h).
// Reads: Depths. Writes: Ids, one uint a pixel.

#include "vtkPointSplatPointsCS"

layout(std430, binding = 0) buffer Ids { uint ids[]; };

uniform usamplerBuffer Depths;   // R32UI
uniform usamplerBuffer SplatIds; // R32UI, one a splat

void drawPoint(uint index, Splat q, ivec2 pixel)
{
  int at = pixelIndex(pixel);
  if (encodeDepth(q.depth, q.tag) == texelFetch(Depths, at).r)
  {
    atomicMin(ids[at], texelFetch(SplatIds, int(index)).r);
  }
}

void main()
{
  drawPoints();
}
