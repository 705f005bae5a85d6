#version 430
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Projects splats to a shadow map by compute, as disks: the nearest stays.
// Writes: Map.

#include "vtkPointSplatShadowProjection"

layout(local_size_x = 64) in;
layout(r32ui, binding = 0) uniform uimage2D Map;

void main()
{
  int index = int(
    (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 64u + gl_LocalInvocationID.x);
  if (index >= SplatCount)
  {
    return;
  }
  Seen s = seeSplat(index);
  if (s.inside && !s.cut)
  {
    // The pixels whose centres it may cover, and the one that its own centre is in.
    vec2 reach = reachOf(s);
    ivec2 own = ivec2(s.pixel);
    ivec2 low = max(min(ivec2(ceil(s.pixel - reach - 0.5)), own), ivec2(0));
    ivec2 high = min(max(ivec2(floor(s.pixel + reach - 0.5)), own), MapSize - 1);
    for (int y = low.y; y <= high.y; ++y)
    {
      for (int x = low.x; x <= high.x; ++x)
      {
        uint texel = texelOf(s, ivec2(x, y));
        // What was there a moment ago can only have become nearer: to read it saves most writes.
        if (texel < imageLoad(Map, ivec2(x, y)).r)
        {
          imageAtomicMin(Map, ivec2(x, y), texel);
        }
      }
    }
  }
}
