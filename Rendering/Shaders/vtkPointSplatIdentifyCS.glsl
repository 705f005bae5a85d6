#version 430
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Names the splat that has the greatest weight at each pixel of the nearest
// layer, for hardware selection; of equals the one with the least id. Run twice:
// first for the greatest weight, then for the id of the splat that has it.
// Reads: Depths. Writes: Ids, two uints a pixel: weight, id.

#include "vtkPointSplatSplatsCS"
#include "vtkPointSplatKernel"

layout(std430, binding = 0) buffer Ids { uint ids[]; };
layout(std430, binding = 2) readonly buffer IdMap { uint idMap[]; };

uniform usamplerBuffer Depths; // R32UI
uniform float PrefilterRadius; // pixels
uniform bool FindWeight;
uniform bool UseIdMap;

void drawPixel(Splat q, uint index, ivec2 pixel)
{
  int at = pixelIndex(pixel);
  uint nearest = texelFetch(Depths, at).r;
  Hit hit;
  if (((nearest ^ q.tag) & TagMask) > 1u ||
    !intersect(q, vec2(pixel) + 0.5, KernelSupport, hit) || !sameLayer(q, hit.depth, nearest))
  {
    return;
  }
  uint weight = floatBitsToUint(kernelWeight(hit.r2, KernelSupport));
  if (FindWeight)
  {
    atomicMax(ids[2 * at], weight);
  }
  else if (ids[2 * at] == weight)
  {
    atomicMin(ids[2 * at + 1], UseIdMap ? idMap[index] : splatId(index));
  }
}

void main()
{
  drawSplats(KernelSupport, PrefilterRadius);
}
