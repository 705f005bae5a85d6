// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How compute shaders read points that are projected as single pixels: some points an
// invocation, since on CPUs uniforms cost as much as what they are for.

#include "vtkPointSplatPoint"

layout(local_size_x = 64) in;

uniform usamplerBuffer Splats; // RGBA32UI, two or four a splat: see vtkPointSplatCloud.h
#ifdef PEELING
// Points that may still have a part in this layer, and those that may in the next one.
layout(std430, binding = 4) readonly buffer Listed { uint listedCount; uint listed[]; };
layout(std430, binding = 5) buffer Next { uint nextCount; uint next[]; };

uniform bool DrawListed;
#endif

// The batches of points that are in view.
layout(std430, binding = 7) readonly buffer Batches { uint batches[]; };

const uint BatchSize = 128u; // as in vtkPointSplatBatches
const uint PointsPerInvocation = 8u;

uniform bool DrawBatches;
uniform uint BatchCount;
uniform uint SplatCount;
uniform int ImageWidth;

int pixelIndex(ivec2 pixel)
{
  return pixel.y * ImageWidth + pixel.x;
}

uint pointId(uint index)
{
  return texelFetch(Splats, int(index) * (Circular ? 2 : 4) + 1).w;
}

// What a stage does with a point.
void drawPoint(uint index, Splat q, ivec2 pixel);

void drawPoints()
{
  Projector projector = makeProjector();
  uint texels = Circular ? 2u : 4u;
  uint count = DrawBatches ? BatchCount * BatchSize : SplatCount;
  uint first = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) *
      gl_WorkGroupSize.x * PointsPerInvocation + gl_LocalInvocationID.x;
  for (uint k = 0u; k < PointsPerInvocation; ++k)
  {
    uint index = first + k * gl_WorkGroupSize.x;
    bool given = index < count;
    if (DrawBatches)
    {
      index = given ? batches[index / BatchSize] * BatchSize + index % BatchSize : 0u;
      given = given && index < SplatCount;
    }
#ifdef PEELING
    index = given && DrawListed ? listed[index] : index;
#endif
    int at = int(given ? index * texels : 0u);
    Splat q;
    ivec2 pixel;
    if (projectPoint(projector, uintBitsToFloat(texelFetch(Splats, at).xyz),
          texelFetch(Splats, at + 1).y, q, pixel) && given)
    {
      drawPoint(index, q, pixel);
    }
  }
}
