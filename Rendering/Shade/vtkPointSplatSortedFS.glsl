#version 330
#extension GL_ARB_shading_language_packing : enable
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The geometry pass of group-sorted transparency (Zhang, Pajarola 2006, section
// 5.2.1, Algorithm 2): one group's splats, drawn from the back, each shaded and blended over what
// is behind it. Of splats of one surface that overlap only the first stays: the depth that is
// tested is rounded to the least layer distance (equation 6), and equal ones fail. What the opaque
// scene hides is left out.
// NEAREST: fragments of the nearest layer are left out, which is drawn exactly (Algorithm 3); or
// kept (KeepNearest) and not counted. LAYER_COUNT: refracting layers are counted.

#include "vtkPointSplatQuadFS"
#include "vtkPointSplatMaterials"
#ifdef NEAREST
#include "vtkPointSplatLayers"

uniform bool KeepNearest;
#endif

uniform bool HasSceneDepth;
uniform sampler2D SceneDepth; // of the opaque scene, as OpenGL has it
uniform float DiskReach;      // radii
uniform float NormalBend;       // 0: a splat has one normal
uniform float CoarseDepth;    // world units: the step of the tested depth

layout(location = 0) out vec4 blended; // premultiplied
#ifdef LAYER_COUNT
layout(location = 1) out vec4 layerCount; // of opacity 0, so that blending adds it up
#endif

void main()
{
  Splat q = fragmentSplat();
  ivec2 at = ivec2(gl_FragCoord.xy);
  Hit hit;
  if (!intersect(q, gl_FragCoord.xy, DiskReach, hit))
  {
    discard;
  }
  if (HasSceneDepth &&
    windowDepth(-(hit.depth + DepthRange.x)) > texelFetch(SceneDepth, at, 0).r)
  {
    discard;
  }
  int slot = int(q.tag >> 1);
  bool behind = true;
#ifdef NEAREST
  uvec4 texel = fetchLayer(at, 0);
  float nearest = uintBitsToFloat(texel.x);
  behind = !isEmpty(texel) && hit.depth > nearest &&
    !sameLayer(q, hit.depth, encodeDepth(nearest, tagOfTexel(texel)));
  if (!behind && !KeepNearest)
  {
    discard;
  }
#endif
  vec3 position = q.positionVC + hit.uv.x * q.sVC + hit.uv.y * q.tVC;
  vec3 normal = normalAt(q, NormalBend * hit.uv);
#ifdef FACTORS
  lightFactors = splatFactors;
#endif
  blended = shadeSurface(
    slot, position, normal, splatColour, false, isBack(q.tag, normal, position));
  blended.rgb *= blended.a;
#ifdef LAYER_COUNT
  layerCount = vec4(behind ? mediumOf(slot).w : 0.0, 0.0, 0.0, 0.0);
#endif
  gl_FragDepth =
    clamp((floor(hit.depth / CoarseDepth) + 0.5) * CoarseDepth / DepthRange.y, 0.0, 0.9999999);
}
