#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Names the splat of the greatest weight at each pixel of the nearest layer, by
// quads: the depth test keeps the greatest weight.
// Reads: the coded depths. Writes: the id (R32UI).

#include "vtkPointSplatQuadFS"
#include "vtkPointSplatKernel"

uniform usampler2D Depths;

layout(location = 0) out uint nearestId;

void main()
{
  Splat q = fragmentSplat();
  uint nearest = texelFetch(Depths, ivec2(gl_FragCoord.xy), 0).r;
  Hit hit;
  if (!intersect(q, gl_FragCoord.xy, KernelSupport, hit) || !sameLayer(q, hit.depth, nearest))
  {
    discard;
  }
  nearestId = tagAndId.y;
  gl_FragDepth = 1.0 - clamp(kernelWeight(hit.r2, KernelSupport), 0.0, 1.0);
}
