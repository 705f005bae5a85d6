// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The splat of a fragment, as vtkPointSplatQuadVS projected it.

#include "vtkPointSplatProjection"

flat in vec4 centreAndDepths;
flat in vec3 splatS;
flat in vec3 splatT;
flat in vec4 slopeFacingLayer;
flat in vec3 splatNormal;
flat in uvec2 tagAndId;
flat in vec4 splatColour;
flat in vec3 positionVC;
flat in vec3 sVC;
flat in vec3 tVC;

Splat fragmentSplat()
{
  Splat q;
  q.centre = centreAndDepths.xy;
  q.w = centreAndDepths.z;
  q.depth = centreAndDepths.w;
  q.s = splatS;
  q.t = splatT;
  q.slope = slopeFacingLayer.xy;
  q.facing = slopeFacingLayer.z;
  q.layer = slopeFacingLayer.w;
  q.normal = splatNormal;
  q.tag = tagAndId.x;
  q.positionVC = positionVC;
  q.sVC = sVC;
  q.tVC = tVC;
  q.box = Window;
  return q;
}
