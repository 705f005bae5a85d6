#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Projects splats to a shadow map by the rasteriser: see vtkPointSplatShadowProjectCS.

#include "vtkPointSplatShadowProjection"

flat out vec3 positionLC;
flat out vec3 normalLC;
flat out vec4 pixelRadiusFacing;
#ifdef CLIP_LINES
flat out vec3 firstLine;
flat out vec3 secondLine;
#endif

void main()
{
  Seen s = seeSplat(gl_VertexID);
  positionLC = s.position;
  normalLC = s.normal;
  pixelRadiusFacing = vec4(s.pixel, s.radius, s.facing);
#ifdef CLIP_LINES
  firstLine = s.lines[0];
  secondLine = s.lines[1];
#endif
  vec2 reach = reachOf(s);
  gl_PointSize = 2.0 * ceil(max(reach.x, reach.y)) + 1.0;
  vec2 at = 2.0 * (floor(s.pixel) + 0.5) / vec2(MapSize) - 1.0;
  gl_Position = s.inside && !s.cut ? vec4(at, 0.0, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}
