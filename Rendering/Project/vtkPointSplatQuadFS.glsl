// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The splat of a fragment, as vtkPointSplatQuadVS projected it.

#include "vtkPointSplatIntersection"

flat in vec4 centreDepthFacing;
flat in vec4 splatSAndLean;
flat in vec4 splatTAndLean;
flat in vec4 splatMAndLayer;
flat in vec3 splatBend;
#ifdef CLIP_LINES
flat in vec4 splatLines;
#endif
flat in vec4 splatNarrow;
flat in vec3 splatTurnS;
flat in vec3 splatTurnT;
flat in vec3 splatNormal;
flat in uvec2 tagAndId;
flat in vec4 splatColour;
#ifdef FACTORS
flat in vec4 splatFactors;
#endif
flat in vec3 positionVC;
flat in vec3 sVC;
flat in vec3 tVC;
flat in vec3 mVC;

Splat fragmentSplat()
{
  Splat q;
  q.centre = centreDepthFacing.xy;
  q.depth = centreDepthFacing.z;
  q.facing = centreDepthFacing.w;
  q.s = splatSAndLean.xyz;
  q.t = splatTAndLean.xyz;
  q.lean = vec2(splatSAndLean.w, splatTAndLean.w);
#ifdef CLIP_LINES
  q.lines = splatLines;
#endif
  q.narrow = splatNarrow;
  q.m = splatMAndLayer.xyz;
  q.layer = splatMAndLayer.w;
  q.bend = splatBend;
  q.turnS = splatTurnS;
  q.turnT = splatTurnT;
  q.normal = splatNormal;
  q.tag = tagAndId.x;
  q.positionVC = positionVC;
  q.sVC = sVC;
  q.tVC = tVC;
  q.mVC = mVC;
  q.box = Window;
  return q;
}
