#version 430
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Attribute accumulation of points projected as single pixels, by compute: the
// sums over all points of each pixel's nearest layer, which are the winner's attributes
// smoothed where points are denser than pixels. GATHER: over all that is behind, weighted by
// opacity.
// Reads: Depths. Writes: Sums, four ints a pixel or eight with colours: see
// vtkPointSplatFixedPoint.

#include "vtkPointSplatPointsCS"
#include "vtkPointSplatPointWeight"
#include "vtkPointSplatColourCode"
#include "vtkPointSplatFixedPoint"
#ifdef PEELING
#include "vtkPointSplatPeel"
#endif

uniform usamplerBuffer Depths;  // R32UI
uniform usamplerBuffer Colours; // R32UI, one a splat
uniform bool HasColours;
uniform vec4 ItemColour;        // multiplies the points' colours
#ifdef VALUES
#include "vtkPointSplatValue"

uniform vec4 ValueMap;
#endif
uniform float DepthUnit;        // of depths in the sums, world units
uniform int SumStride;          // ints a pixel
#ifdef FACTORS
uniform usamplerBuffer Factors; // R32UI, one a splat
uniform bool HasFactors;
#endif

layout(std430, binding = 0) buffer Sums { int sums[]; };

void addToSums(int at, uint index, float kernel, vec3 normal, float behind)
{
#ifdef COLOURS
  vec4 colour = ItemColour;
  if (HasColours)
  {
    colour *= unpackColour(texelFetch(Colours, int(index)).r);
  }
#ifdef VALUES
  vec2 value = decodeValue(texelFetch(Colours, int(index)).r);
#ifdef GATHER
  // What is gathered is of several clouds.
  colour = ItemColour * mapValue(value, ValueMap);
#endif
#endif
#ifdef GATHER
  kernel *= colour.a;
#endif
#endif
  float weight = max(floor(WeightScale * kernel + 0.5), 1.0);
  if (atomicAdd(sums[at], int(weight)) > WeightLimit)
  {
    atomicAdd(sums[at], -int(weight));
    return; // so many points share this pixel that no further one can be seen
  }
  ivec3 n = ivec3(round(weight * normal));
  int depth = int(round(weight * clamp(behind / DepthUnit, -1.0, 1.0)));
  atomicAdd(sums[at + 1], packSums(n.x, n.y));
  atomicAdd(sums[at + 2], packSums(n.z, depth));
#ifdef COLOURS
#if defined(VALUES) && !defined(GATHER)
  ivec4 sum = ivec4(weightedValue(weight, value));
#else
  ivec4 sum = ivec4(round(weight * colour));
#endif
  atomicAdd(sums[at + 3], packSums(sum.r, sum.g));
  atomicAdd(sums[at + 4], packSums(sum.b, sum.a));
#endif
#ifdef FACTORS
  ivec4 lit = ivec4(round(
    weight * (HasFactors ? unpackColour(texelFetch(Factors, int(index)).r) : vec4(1.0))));
  atomicAdd(sums[at + FactorWord], packSums(lit.x, lit.y));
#if FACTORS > 2
  atomicAdd(sums[at + FactorWord + 1], packSums(lit.z, lit.w));
#endif
#endif
}

void drawPoint(uint index, Splat q, ivec2 pixel)
{
  int at = pixelIndex(pixel);
  uint nearest = texelFetch(Depths, at).r;
#ifdef PEELING
  if (isPeeled(q, q.depth, pixel))
  {
    return;
  }
  // Those of this layer too: where it is filled with what is before them, they belong
  // to the next one.
  next[atomicAdd(nextCount, 1u)] = index;
#endif
#ifdef GATHER
  bool belongs = nearest != NoDepth;
#ifdef PEELING
  belongs = belongs && !isHidden(undelayedDepth(q), pixel);
#endif
#else
  bool belongs = sameLayer(q, q.depth, nearest);
#endif
  if (belongs)
  {
    addToSums(SumStride * at, index, pointWeight(q), turnTo(nearest, q.tag) * q.normal,
      undelayedDepth(q) - decodeDepth(nearest));
  }
}

void main()
{
  drawPoints();
}
