// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How compute shaders read points that are projected as single pixels: one
// invocation a point, two work groups a batch.

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

uniform bool DrawBatches;
uniform uint BatchCount;
uniform uint SplatCount;
uniform int ImageWidth;

int pixelIndex(ivec2 pixel)
{
  return pixel.y * ImageWidth + pixel.x;
}

// False: no point for this invocation, or nothing of it can be seen.
bool loadPoint(out uint index, out Splat q, out ivec2 pixel)
{
  index = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 64u + gl_LocalInvocationID.x;
  if (DrawBatches)
  {
    uint batch = index / BatchSize;
    if (batch >= BatchCount)
    {
      return false;
    }
    index = batches[batch] * BatchSize + index % BatchSize;
  }
  if (index >= SplatCount)
  {
    return false;
  }
#ifdef PEELING
  index = DrawListed ? listed[index] : index;
#endif
  int at = int(index) * (Circular ? 2 : 4);
  uvec4 a = texelFetch(Splats, at);
  return projectPoint(uintBitsToFloat(a.xyz), texelFetch(Splats, at + 1).xy,
    uintBitsToFloat(a.w), q, pixel);
}

uint pointId(uint index)
{
  return texelFetch(Splats, int(index) * (Circular ? 2 : 4) + 1).w;
}
