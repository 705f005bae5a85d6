#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Attribute accumulation, by quads and additive blending: see
// vtkPointSplatAccumulateCS.
// Reads: the coded depths. Writes: two RGBA32F images: weight and normal; depth
// behind the nearest and colour; each times the weight.

#include "vtkPointSplatQuadFS"
#include "vtkPointSplatKernel"

uniform usampler2D Depths;
uniform float DepthUnit;

layout(location = 0) out vec4 weightAndNormal;
layout(location = 1) out vec4 depthAndColour;

void main()
{
  Splat q = fragmentSplat();
  uint nearest = texelFetch(Depths, ivec2(gl_FragCoord.xy), 0).r;
  Hit hit;
  if (!intersect(q, gl_FragCoord.xy, KernelSupport, hit) ||
    !sameLayer(q, hit.depth, nearest))
  {
    discard;
  }
  // As in the fixed-point sums, a weight never vanishes inside the support.
  float weight = max(kernelWeight(hit.r2, KernelSupport), 1.0 / 4096.0);
  float behind = clamp((hit.depth - decodeDepth(nearest)) / DepthUnit, -1.0, 1.0);
  weightAndNormal = weight * vec4(1.0, normalAt(q, hit.uv));
  depthAndColour = weight * vec4(behind, splatColour);
}
