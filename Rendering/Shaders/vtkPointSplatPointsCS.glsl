// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How compute shaders read points that are projected as single pixels: one
// invocation a point.

#include "vtkPointSplatPoint"

layout(local_size_x = 64) in;

uniform usamplerBuffer Splats; // RGBA32UI, two or four a splat: see vtkPointSplatCloud.h
#ifdef PEELING
// Points that may still have a part in this layer, and those that may in the next one.
layout(std430, binding = 4) readonly buffer Listed { uint listedCount; uint listed[]; };
layout(std430, binding = 5) buffer Next { uint nextCount; uint next[]; };

uniform bool DrawListed;
#endif

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
