// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What compute shaders add to a pixel's sums: see vtkPointSplatFixedPoint.

#include "vtkPointSplatFixedPoint"

layout(std430, binding = 0) buffer Sums { int sums[]; };
layout(std430, binding = 2) readonly buffer Colours { uint colours[]; };

#ifdef FACTORS
layout(std430, binding = 6) readonly buffer Factors { uint factors[]; };

uniform bool HasFactors;
uniform int FactorWord; // where they begin
#endif
uniform vec4 ItemColour; // multiplies the points' colours
uniform bool HasColours;
uniform int SumStride;   // ints a pixel

// kernel: the weight, at most 1; gather: it is multiplied by the opacity, and colours
// are added whether or not the points have some; behind: the nearest depth, world units.
void addToSums(int at, uint index, float kernel, vec3 normal, float behind, bool gather)
{
#ifdef COLOURS
  vec4 colour = ItemColour;
  if (HasColours)
  {
    colour *= unpackUnorm4x8(colours[index]);
  }
  kernel *= gather ? colour.a : 1.0;
#endif
  float weight = max(floor(WeightScale * kernel + 0.5), 1.0);
  if (atomicAdd(sums[at], int(weight)) > WeightLimit)
  {
    atomicAdd(sums[at], -int(weight));
    return; // so many splats share this pixel that no further one can be seen
  }
  ivec3 n = ivec3(round(weight * normal));
  int depth = int(round(weight * clamp(behind / DepthUnit, -1.0, 1.0)));
  atomicAdd(sums[at + 1], packSums(n.x, n.y));
  atomicAdd(sums[at + 2], packSums(n.z, depth));
#ifdef COLOURS
  if (HasColours || gather)
  {
    ivec4 sum = ivec4(round(weight * colour));
    atomicAdd(sums[at + 3], packSums(sum.r, sum.g));
    atomicAdd(sums[at + 4], packSums(sum.b, sum.a));
  }
#endif
#ifdef FACTORS
  ivec4 lit =
    ivec4(round(weight * (HasFactors ? unpackUnorm4x8(factors[index]) : vec4(1.0))));
  atomicAdd(sums[at + FactorWord], packSums(lit.x, lit.y));
#if FACTORS > 2
  atomicAdd(sums[at + FactorWord + 1], packSums(lit.z, lit.w));
#endif
#endif
}
