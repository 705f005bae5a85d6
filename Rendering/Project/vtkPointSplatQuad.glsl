// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Spans a quad over a splat's box in the image: one instance a splat, four
// vertices. For where there are no compute shaders, or where they do not pay.
// FETCHED: who includes this fetches what else are vertex attributes.

#include "vtkPointSplatIntersection"

#ifdef CLIP_LINES
uniform bool HasClipLines;

flat out vec4 splatLines;
#endif

#ifdef FETCHED
vec4 positionAndRadius;
uvec3 shape;
uint id;
vec4 colour;
vec3 axis1MC;
vec3 axis2MC;
vec4 factorsOfLights;
#ifdef CLIP_LINES
vec4 clipLines;
#endif
#else
layout(location = 0) in vec4 positionAndRadius;
layout(location = 1) in uvec3 shape;
layout(location = 2) in uint id;
layout(location = 3) in vec4 colour;
layout(location = 4) in vec3 axis1MC;
layout(location = 5) in vec3 axis2MC;
#ifdef FACTORS
layout(location = 6) in vec4 factorsOfLights;
#endif
#ifdef CLIP_LINES
layout(location = 7) in vec4 clipLines;
#endif
#endif
#ifdef FACTORS
uniform bool HasFactors;

flat out vec4 splatFactors;
#endif

uniform float Reach;         // radii to draw: 1, or the kernel's support
uniform vec2 LeastRadii; // pixels: of ellipses, of disks (widen())
uniform ivec2 ImageSize;

flat out vec4 centreDepthFacing;
flat out vec4 splatSAndLean;
flat out vec4 splatTAndLean;
flat out vec4 splatMAndLayer;
flat out vec3 splatBend;
flat out vec4 splatNarrow;
flat out vec3 splatTurnS;
flat out vec3 splatTurnT;
flat out vec3 splatNormal;
flat out uvec2 tagAndId;
flat out vec4 splatColour;
flat out vec3 positionVC;
flat out vec3 sVC;
flat out vec3 tVC;
flat out vec3 mVC;

// False: nothing of the splat can be seen.
bool spanQuad()
{
  Splat q;
  if (!project(positionAndRadius.xyz, shape, axis1MC, axis2MC, positionAndRadius.w, Reach,
        LeastRadii, q))
  {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0); // off the screen
    return false;
  }
  vec2 corner = vec2((gl_VertexID & 1) == 0 ? q.box.x : q.box.z + 1,
    (gl_VertexID & 2) == 0 ? q.box.y : q.box.w + 1);
  gl_Position = vec4(2.0 * corner / vec2(ImageSize) - 1.0, 0.0, 1.0);
  centreDepthFacing = vec4(q.centre, q.depth, q.facing);
  splatSAndLean = vec4(q.s, q.lean.x);
  splatTAndLean = vec4(q.t, q.lean.y);
#ifdef CLIP_LINES
  clipSplat(q, HasClipLines ? RadiusScale * clipLines : vec4(0.0), shape.z);
  splatLines = q.lines;
#endif
  splatNarrow = q.narrow;
  splatMAndLayer = vec4(q.m, q.layer);
  splatBend = q.bend;
  splatTurnS = q.turnS;
  splatTurnT = q.turnT;
  splatNormal = q.normal;
  tagAndId = uvec2(q.tag, id);
  splatColour = colour;
#ifdef FACTORS
  splatFactors = HasFactors ? factorsOfLights : vec4(1.0);
#endif
  positionVC = q.positionVC;
  sVC = q.sVC;
  tVC = q.tVC;
  mVC = q.mVC;
  return true;
}
