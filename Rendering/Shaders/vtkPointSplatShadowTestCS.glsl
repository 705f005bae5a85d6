#version 430
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Counts for each point the samples of a light that reach it, by compute.
// Reads: Map. Writes: Counts, one uint a splat.

#define TESTS_POINTS
#include "vtkPointSplatShadowProjection"

layout(local_size_x = 64) in;
layout(std430, binding = 0) buffer Counts { uint counts[]; };

uniform uint SplatCount;

void main()
{
  uint index =
    (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 64u + gl_LocalInvocationID.x;
  if (index >= SplatCount)
  {
    return;
  }
  Seen s = seeSplat(int(index));
  if (s.mine && isLit(s))
  {
    counts[index] += 1u;
  }
}
