#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Projects the triangles of a mesh that stands in the light, or, with CORNERS, of a cloud. There is no far plane, and of
// parallel light no near one: what lies in front of all points casts on them too.

#include "vtkPointSplatShadowMap"

#ifdef CORNERS
uniform usamplerBuffer Splats;  // RGBA32UI: see vtkPointSplatCloud.h
uniform usamplerBuffer Corners; // RGBA32UI, a triangle: three splats, cell
uniform int TexelsPerSplat;
#else
layout(location = 0) in vec3 positionMC;
#endif

uniform mat4 MCLC;
uniform vec2 MapScale;
uniform vec2 MapOffset;
uniform float NearDistance;  // world units
uniform int ClipPlaneCount;
uniform vec4 ClipPlanes[6];  // mesh's local coordinates

out vec3 positionLC;
out float cut;

void main()
{
#ifdef CORNERS
  int splat = int(texelFetch(Corners, gl_VertexID / 3)[gl_VertexID % 3]);
  vec3 positionMC = uintBitsToFloat(texelFetch(Splats, splat * TexelsPerSplat).xyz);
#endif
  vec3 p = (MCLC * vec4(positionMC, 1.0)).xyz;
  if (Face >= 0)
  {
    p = toFace(p, Face);
  }
  cut = 1.0;
  for (int i = 0; i < ClipPlaneCount; ++i)
  {
    cut = min(cut, dot(ClipPlanes[i], vec4(positionMC, 1.0)));
  }
  positionLC = p;
  float w = Parallel ? 1.0 : p.z;
  vec2 pixel = MapScale * p.xy + MapOffset * w;
  gl_Position = vec4(2.0 * pixel / vec2(MapSize) - w, Parallel ? 0.0 : w - 2.0 * NearDistance, w);
}
