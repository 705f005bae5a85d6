#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Projection of points as single pixels, by the rasteriser, for where there are no compute
// shaders: one vertex a point, in the middle of its pixel.

#include "vtkPointSplatPoint"

layout(location = 0) in vec4 positionAndRadius;
layout(location = 1) in uvec3 shape;
layout(location = 2) in uint id;
layout(location = 3) in vec4 colour;

#ifdef FACTORS
layout(location = 6) in vec4 factorsOfLights;

uniform bool HasFactors;

flat out vec4 splatFactors;
#endif

uniform ivec2 ImageSize;

flat out vec4 normalAndDepth;
flat out vec2 facingAndLayer;
flat out uvec2 tagAndId;
flat out vec4 splatColour;

void main()
{
  Splat q;
  ivec2 pixel;
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0); // off the screen
  gl_PointSize = 1.0;
  if (projectPoint(makeProjector(), positionAndRadius.xyz, shape.y, q, pixel))
  {
    gl_Position = vec4(2.0 * (vec2(pixel) + 0.5) / vec2(ImageSize) - 1.0, 0.0, 1.0);
    normalAndDepth = vec4(q.normal, q.depth);
    facingAndLayer = vec2(q.facing, q.layer);
    tagAndId = uvec2(q.tag, id);
    splatColour = colour;
#ifdef FACTORS
    splatFactors = HasFactors ? factorsOfLights : vec4(1.0);
#endif
  }
}
