#version 430
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Attribute accumulation, by compute: weighted normals, depths and colours of
// all splats in each pixel's nearest layer. Sums are of integers, so that they
// are the same in whatever order the splats come.
// Reads: Depths. Writes: Sums, eight ints a pixel: weight, normal x, y, z,
// depth behind the nearest, red, green, blue; each times the weight.

#include "vtkPointSplatSplatsCS"
#include "vtkPointSplatKernel"
#include "vtkPointSplatFixedPoint"

layout(std430, binding = 0) buffer Sums { int sums[]; };
layout(std430, binding = 2) readonly buffer Colours { uint colours[]; };

uniform usamplerBuffer Depths; // R32UI
uniform float PrefilterRadius; // pixels
uniform bool HasColours;

void add(Splat q, uint index, int at, float r2, float behind)
{
  if (sums[at] > WeightLimit)
  {
    return; // so many splats share this pixel that no further one can be seen
  }
  float weight = max(floor(WeightScale * kernelWeight(r2, KernelSupport) + 0.5), 1.0);
  ivec3 n = ivec3(round(weight * q.normal));
  behind = clamp(behind / DepthUnit, -1.0, 1.0);
  atomicAdd(sums[at], int(weight));
  atomicAdd(sums[at + 1], n.x);
  atomicAdd(sums[at + 2], n.y);
  atomicAdd(sums[at + 3], n.z);
  atomicAdd(sums[at + 4], int(round(DepthScale * weight * behind)));
  if (HasColours)
  {
    ivec3 colour = ivec3(round(weight * unpackUnorm4x8(colours[index]).rgb));
    atomicAdd(sums[at + 5], colour.r);
    atomicAdd(sums[at + 6], colour.g);
    atomicAdd(sums[at + 7], colour.b);
  }
}

void drawPixel(Splat q, uint index, ivec2 pixel)
{
  int at = pixelIndex(pixel);
  uint nearest = texelFetch(Depths, at).r;
  if (((nearest ^ q.tag) & TagMask) > 1u)
  {
    return;
  }
  float r2;
  float depth;
  if (intersect(q, vec2(pixel) + 0.5, KernelSupport, r2, depth) && sameLayer(q, depth, nearest))
  {
    add(q, index, 8 * at, r2, depth - decodeDepth(nearest));
  }
}

void main()
{
  drawSplats(KernelSupport, PrefilterRadius);
}
