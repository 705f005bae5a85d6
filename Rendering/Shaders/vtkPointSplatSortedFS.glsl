#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The geometry pass of group-sorted transparency (Zhang, Pajarola 2006, section
// 5.2.1, Algorithm 2): one group's splats, drawn from the back, each shaded and blended over what
// is behind it. Of splats of one surface that overlap only the first stays: the depth that is
// tested is rounded to the least layer distance (equation 6), and equal ones fail. Fragments of
// the nearest layer, where that is drawn exactly, and what the opaque scene hides are left out
// (Algorithm 3).

//PointSplat::Defines

#include "vtkPointSplatQuadFS"
#include "vtkPointSplatPeel"
#include "vtkPointSplatLighting"

#ifdef COMPUTE_IMAGES
uniform usamplerBuffer Previous0; // the nearest layer's coded depths
uniform int ImageWidth;
#else
uniform usampler2D Previous0;
#endif
uniform float DiskReach;
uniform float CoarseDepth; // world units: the step of the tested depth
uniform bool HasColours;
uniform float Opacity[2];  // of front and of back faces
uniform vec3 Ambient[2];
uniform vec3 Diffuse[2];
uniform vec3 Specular[2];
uniform float SpecularPower[2];

layout(location = 0) out vec4 blended; // premultiplied
#ifdef LAYER_COUNT
uniform bool Refracts;
uniform bool KeepNearest;                  // of the nearest layer: drawn, but not counted
layout(location = 1) out float layerCount; // added up
#endif

void main()
{
  Splat q = fragmentSplat();
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  Hit hit;
  if (!intersect(q, gl_FragCoord.xy, DiskReach, hit))
  {
    discard;
  }
  bool peeled = false;
  if (PreviousCount > 0)
  {
#ifdef COMPUTE_IMAGES
    uint nearest = texelFetch(Previous0, pixel.y * ImageWidth + pixel.x).r;
#else
    uint nearest = texelFetch(Previous0, pixel, 0).r;
#endif
    peeled = isPeeled(q, hit.depth, uvec3(nearest));
  }
#ifdef LAYER_COUNT
  layerCount = Refracts && !peeled ? 1.0 : 0.0;
  peeled = peeled && !KeepNearest;
#endif
  if (peeled)
  {
    discard;
  }
  if (HasSceneDepth && isHidden(hit.depth, pixel))
  {
    discard;
  }
  vec3 position = q.positionVC + hit.uv.x * q.sVC + hit.uv.y * q.tVC;
  vec3 normal = normalAt(q, hit.uv);
  bool back = Parallel ? normal.z < 0.0 : dot(normal, position) > 0.0;
  normal = back ? -normal : normal;
  int side = back ? 1 : 0;
  Material m = Material(Ambient[side], Diffuse[side], Specular[side], SpecularPower[side]);
  float opacity = Opacity[side];
  if (HasColours)
  {
    m.ambient *= splatColour.rgb;
    m.diffuse *= splatColour.rgb;
    opacity *= splatColour.a;
  }
#ifdef FACTORS
  lightFactors = splatFactors;
#endif
  blended = vec4(opacity * shade(m, position, normal), opacity);
  gl_FragDepth =
    clamp((floor(hit.depth / CoarseDepth) + 0.5) * CoarseDepth / DepthRange.y, 0.0, 0.9999999);
}
