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
  Hit hit;
  if (!intersect(q, gl_FragCoord.xy, DiskReach, hit))
  {
    discard;
  }
  nearestDepth = encodeDepth(hit.depth, q.tag);
  gl_FragDepth = clamp(hit.depth / DepthRange.y, 0.0, 1.0);
}
