#version 430
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Names the nearest point of each pixel, for hardware selection; of equals the one with the
// least id. Run twice, as vtkPointSplatIdentifyCS is: first for the greatest weight, which is
// here that of the nearest depth.
// Reads: Depths. Writes: Ids, two uints a pixel: weight, id.

#include "vtkPointSplatPointsCS"

layout(std430, binding = 0) buffer Ids { uint ids[]; };
layout(std430, binding = 2) readonly buffer IdMap { uint idMap[]; };

uniform usamplerBuffer Depths; // R32UI
uniform bool FindWeight;
uniform bool UseIdMap;

void drawPoint(uint index, Splat q, ivec2 pixel)
{
  int at = pixelIndex(pixel);
  if (encodeDepth(q.depth, q.tag) != texelFetch(Depths, at).r)
  {
    return;
  }
  if (FindWeight)
  {
    atomicMax(ids[2 * at], floatBitsToUint(1.0));
  }
  else if (ids[2 * at] == floatBitsToUint(1.0))
  {
    atomicMin(ids[2 * at + 1], UseIdMap ? idMap[index] : pointId(index));
  }
}

void main()
{
  drawPoints();
}
