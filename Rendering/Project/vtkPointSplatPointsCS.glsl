// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How compute shaders read points that are projected as single pixels: some points an
// invocation, since on CPUs uniforms cost as much as what they are for.

#include "vtkPointSplatPoint"
#include "vtkPointSplatBlockList"

layout(local_size_x = 64) in;

uniform usamplerBuffer Splats; // RGBA32UI, two or four a splat: see vtkPointSplatCloud.h
#ifdef PEELING
// Points that may still have a part in this layer, and those that may in the next one.
layout(std430, binding = 4) readonly buffer Listed { uint listedCount; uint listed[]; };
layout(std430, binding = 5) buffer Next { uint nextCount; uint next[]; };

uniform bool DrawListed;
#endif

const uint PointsPerInvocation = 8u;

uniform int ImageWidth;

int pixelIndex(ivec2 pixel)
{
  return pixel.y * ImageWidth + pixel.x;
}

// What a stage does with a point.
void drawPoint(uint index, Splat q, ivec2 pixel);

void drawPoints()
{
  Projector projector = makeProjector();
  uint texels = Circular ? 2u : 4u;
  uint first = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) *
      gl_WorkGroupSize.x * PointsPerInvocation + gl_LocalInvocationID.x;
  for (uint k = 0u; k < PointsPerInvocation; ++k)
  {
    uint invocation = first + k * gl_WorkGroupSize.x;
    uint index;
    bool given;
#ifdef PEELING
    if (DrawListed)
    {
      given = invocation < listedCount;
      index = given ? listed[invocation] : 0u;
    }
    else
#endif
    {
      given = listedSplat(invocation, index);
    }
    int at = int(index * texels);
    Splat q;
    ivec2 pixel;
    if (projectPoint(projector, uintBitsToFloat(texelFetch(Splats, at).xyz),
          texelFetch(Splats, at + 1).y, q, pixel) && given)
    {
      drawPoint(index, q, pixel);
    }
  }
}
