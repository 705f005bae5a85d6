#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Visibility splatting, by quads: see vtkPointSplatVisibilityCS.
// Writes: the coded depth (R32UI) of the nearest disk, by the depth test.

#include "vtkPointSplatQuadFS"

uniform float DiskReach;

layout(location = 0) out uint nearestDepth;

void main()
{
  Splat q = fragmentSplat();
  float r2;
  float depth;
  if (!intersect(q, gl_FragCoord.xy, DiskReach, r2, depth))
  {
    discard;
  }
  nearestDepth = encodeDepth(depth, q.tag);
  gl_FragDepth = clamp(depth / DepthRange.y, 0.0, 1.0);
}
