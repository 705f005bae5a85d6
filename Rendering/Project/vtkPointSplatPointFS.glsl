// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The point of a fragment, as vtkPointSplatPointVS projected it.

#include "vtkPointSplatIntersection"
#include "vtkPointSplatPointSide"

flat in vec4 normalAndDepth;
flat in vec2 facingAndLayer;
flat in uvec2 tagAndId;
flat in vec4 splatColour;
#ifdef FACTORS
flat in vec4 splatFactors;
#endif

Splat fragmentPoint()
{
  Splat q;
  q.normal = normalAndDepth.xyz;
  q.depth = normalAndDepth.w;
  q.facing = facingAndLayer.x;
  q.layer = facingAndLayer.y;
  q.tag = tagAndId.x;
  return q;
}
