#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Writes a splat's texels; the depth test keeps the nearest one.

#include "vtkPointSplatShadowProjection"

flat in vec3 positionLC;
flat in vec3 normalLC;
flat in vec4 pixelRadiusFacing;
#ifdef CLIP_LINES
flat in vec3 firstLine;
flat in vec3 secondLine;
#endif

layout(location = 0) out uint shadow;

void main()
{
  Seen s;
  s.position = positionLC;
  s.normal = normalLC;
  s.pixel = pixelRadiusFacing.xy;
  s.radius = pixelRadiusFacing.z;
  s.facing = pixelRadiusFacing.w;
  s.depth = positionLC.z;
#ifdef CLIP_LINES
  s.lines[0] = firstLine;
  s.lines[1] = secondLine;
#endif
  shadow = texelOf(s, ivec2(gl_FragCoord.xy));
  // A disk seen edge-on is met by rays beyond it, as numbers are rounded.
  bool beyond = any(greaterThan(abs(gl_FragCoord.xy - s.pixel), reachOf(s))) &&
    ivec2(gl_FragCoord.xy) != ivec2(s.pixel);
  if (shadow == Nothing || beyond)
  {
    discard;
  }
  gl_FragDepth = float(shadow >> 8) / 16777216.0;
}
