#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Projection of points as single pixels, by the rasteriser: see vtkPointSplatPointDepthCS.
// Writes: the coded depth (R32UI) of the nearest point, by the depth test.

#include "vtkPointSplatPointFS"
#ifdef PEELING
#include "vtkPointSplatPeel"
#include "vtkPointSplatPreviousFS"
#endif

layout(location = 0) out uint nearestDepth;

void main()
{
  Splat q = fragmentPoint();
#ifdef PEELING
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  if ((PreviousCount > 0 && isPeeled(q, q.depth, previousDepths(pixel))) ||
    (HasSceneDepth && isHidden(undelayedDepth(q), pixel)))
  {
    discard;
  }
#endif
  nearestDepth = encodeDepth(q.depth, q.tag);
  gl_FragDepth = clamp(q.depth / DepthRange.y, 0.0, 1.0);
}
