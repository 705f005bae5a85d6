#version 430
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Attribute accumulation, by compute: weighted normals, depths and colours of
// all splats in each pixel's nearest layer. Sums are of integers, so that they
// are the same in whatever order the splats come.
// Reads: Depths. Writes: Sums, four ints a pixel or eight with colours: see
// vtkPointSplatFixedPoint.

#include "vtkPointSplatSplatsCS"
#include "vtkPointSplatKernel"
#include "vtkPointSplatFixedPoint"
#ifdef PEELING
#include "vtkPointSplatPeel"
#endif

layout(std430, binding = 0) buffer Sums { int sums[]; };
layout(std430, binding = 2) readonly buffer Colours { uint colours[]; };

uniform usamplerBuffer Depths; // R32UI
#ifdef PEELING
uniform usamplerBuffer Previous0;
uniform usamplerBuffer Previous1;
uniform usamplerBuffer Previous2;
uniform bool Gather;           // all that is behind, weighted by opacity
#else
const bool Gather = false;
#endif
#ifdef FACTORS
layout(std430, binding = 6) readonly buffer Factors { uint factors[]; };

uniform bool HasFactors;
uniform int FactorWord;        // where they begin
uniform int FactorWords;       // 1 or 2
#endif
uniform vec4 ItemColour;       // multiplies the points' colours
uniform float PrefilterRadius; // pixels
uniform bool HasColours;
uniform int SumStride;         // ints a pixel

void add(Splat q, uint index, int at, Hit hit, float behind)
{
  vec4 colour = ItemColour;
  if (HasColours)
  {
    colour *= unpackUnorm4x8(colours[index]);
  }
  if (sums[at] > WeightLimit)
  {
    return; // so many splats share this pixel that no further one can be seen
  }
  float kernel = kernelWeight(hit.r2, KernelSupport) * (Gather ? colour.a : 1.0);
  float weight = max(floor(WeightScale * kernel + 0.5), 1.0);
  // Normals of many surfaces: turned to the viewer, or front and back would cancel.
  float turned = Gather && (q.tag & 1u) != 0u ? -1.0 : 1.0;
  ivec3 n = ivec3(round(turned * weight * normalAt(q, hit.uv)));
  int depth = int(round(weight * clamp(behind / DepthUnit, -1.0, 1.0)));
  atomicAdd(sums[at], int(weight));
  atomicAdd(sums[at + 1], packSums(n.x, n.y));
  atomicAdd(sums[at + 2], packSums(n.z, depth));
  if (HasColours || Gather)
  {
    ivec4 sum = ivec4(round(weight * colour));
    atomicAdd(sums[at + 3], packSums(sum.r, sum.g));
    atomicAdd(sums[at + 4], packSums(sum.b, sum.a));
  }
#ifdef FACTORS
  ivec4 lit =
    ivec4(round(weight * (HasFactors ? unpackUnorm4x8(factors[index]) : vec4(1.0))));
  atomicAdd(sums[at + FactorWord], packSums(lit.x, lit.y));
  if (FactorWords > 1)
  {
    atomicAdd(sums[at + FactorWord + 1], packSums(lit.z, lit.w));
  }
#endif
}

void drawPixel(Splat q, uint index, ivec2 pixel)
{
  int at = pixelIndex(pixel);
  uint nearest = texelFetch(Depths, at).r;
#ifdef PEELING
  if (nearest == NoDepth)
  {
    return;
  }
#else
  if (((nearest ^ q.tag) & TagMask) > 1u)
  {
    return;
  }
#endif
  Hit hit;
  if (!intersect(q, vec2(pixel) + 0.5, KernelSupport, hit))
  {
    return;
  }
  bool mine = Gather || sameLayer(q, hit.depth, nearest);
#ifdef PEELING
  isLeft = isLeft || (!mine && hit.depth > decodeDepth(nearest));
  mine = mine &&
    !(PreviousCount > 0 &&
      isPeeled(q, hit.depth,
        uvec3(texelFetch(Previous0, at).r, texelFetch(Previous1, at).r,
          texelFetch(Previous2, at).r)));
#endif
  if (mine)
  {
    add(q, index, SumStride * at, hit, hit.depth - decodeDepth(nearest));
  }
}

void main()
{
  drawSplats(KernelSupport, PrefilterRadius);
}
