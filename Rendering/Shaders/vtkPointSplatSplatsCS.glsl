// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How compute shaders read splats and share them out: one invocation a splat,
// but for splats of many pixels, which a first dispatch lists and a second one
// draws with a whole work group each.

#include "vtkPointSplatProjection"

layout(local_size_x = 64) in;

// By texture, not by storage buffer: on CPUs Mesa loads the former for several
// invocations at once, and GPUs do not mind.
uniform usamplerBuffer Splats; // RGBA32UI, two or four a splat: see vtkPointSplatCloud.h
layout(std430, binding = 1) buffer Large { uint largeCount; uint large[]; };
#ifdef PEELING
// Splats that may still have a part in this layer, and those that may in the next one.
layout(std430, binding = 4) readonly buffer Listed { uint listedCount; uint listed[]; };
layout(std430, binding = 5) buffer Next { uint nextCount; uint next[]; };

uniform bool DrawListed;
uniform bool ListNext;
#endif

uniform uint SplatCount;     // of the listed ones, where these are drawn
uniform bool DrawLarge;      // this dispatch draws the listed splats
uniform bool ListLarge;      // this dispatch makes the list
uniform int ImageWidth;

// Splats whose box has more pixels than this are large.
const int LargeArea = 256;

bool loadSplat(uint index, float reach, float least, out Splat q)
{
  int at = int(index) * (Circular ? 2 : 4);
  uvec4 a = texelFetch(Splats, at);
  uvec4 b = texelFetch(Splats, at + 1);
  vec3 axis1 = vec3(0.0);
  vec3 axis2 = vec3(0.0);
  if (!Circular)
  {
    axis1 = uintBitsToFloat(texelFetch(Splats, at + 2).xyz);
    axis2 = uintBitsToFloat(texelFetch(Splats, at + 3).xyz);
  }
  return project(uintBitsToFloat(a.xyz), b.xyz, axis1, axis2,
    uintBitsToFloat(a.w), reach, least, q);
}

uint splatId(uint index)
{
  return texelFetch(Splats, int(index) * (Circular ? 2 : 4) + 1).w;
}

int pixelIndex(ivec2 pixel)
{
  return pixel.y * ImageWidth + pixel.x;
}

// What a stage does with one pixel of a splat's box.
void drawPixel(Splat q, uint index, ivec2 pixel);

#ifdef PEELING
// Set by drawPixel where a splat lies behind the layer that is drawn.
bool isLeft;
shared bool isLeftAnywhere;
#endif

void drawSplats(float reach, float least)
{
  Splat q;
  if (DrawLarge)
  {
    for (uint i = gl_WorkGroupID.x; i < largeCount; i += gl_NumWorkGroups.x)
    {
      uint index = large[i];
#ifdef PEELING
      isLeft = false;
#endif
      if (loadSplat(index, reach, least, q))
      {
        ivec2 size = q.box.zw - q.box.xy + 1;
        for (int k = int(gl_LocalInvocationID.x); k < size.x * size.y; k += 64)
        {
          drawPixel(q, index, q.box.xy + ivec2(k % size.x, k / size.x));
        }
      }
#ifdef PEELING
      if (ListNext)
      {
        isLeftAnywhere = false;
        barrier();
        if (isLeft)
        {
          isLeftAnywhere = true;
        }
        barrier();
        if (isLeftAnywhere && gl_LocalInvocationID.x == 0u)
        {
          next[atomicAdd(nextCount, 1u)] = index;
        }
        barrier();
      }
#endif
    }
    return;
  }
  uint index =
    (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 64u + gl_LocalInvocationID.x;
  if (index >= SplatCount)
  {
    return;
  }
#ifdef PEELING
  index = DrawListed ? listed[index] : index;
  isLeft = false;
#endif
  if (!loadSplat(index, reach, least, q))
  {
    return;
  }
  ivec2 size = q.box.zw - q.box.xy + 1;
  if (size.x * size.y > LargeArea)
  {
    if (ListLarge)
    {
      large[atomicAdd(largeCount, 1u)] = index;
    }
    return;
  }
  // One loop, not two: invocations that go in lockstep would wait for the widest box in
  // each row of the highest.
  for (ivec2 pixel = q.box.xy; pixel.y <= q.box.w;)
  {
    drawPixel(q, index, pixel);
    bool last = pixel.x == q.box.z;
    pixel = last ? ivec2(q.box.x, pixel.y + 1) : pixel + ivec2(1, 0);
  }
#ifdef PEELING
  if (ListNext && isLeft)
  {
    next[atomicAdd(nextCount, 1u)] = index;
  }
#endif
}
