#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Attribute accumulation, by quads and additive blending: see
// vtkPointSplatAccumulateCS.
// Reads: the coded depths. Writes: two RGBA32F images, weight and normal, depth
// behind the nearest and colour, one R32F with the opacity, and where lights cast shadows one
// RGBA32F with their factors; each times the weight.

#include "vtkPointSplatQuadFS"
#include "vtkPointSplatKernel"
#ifdef PEELING
#include "vtkPointSplatPeel"
#endif

uniform usampler2D Depths;
uniform float DepthUnit;
#ifdef PEELING
uniform usampler2D Previous0;
uniform usampler2D Previous1;
uniform usampler2D Previous2;
uniform bool Gather;
#else
const bool Gather = false;
#endif
uniform bool HasColours;
uniform vec4 ItemColour;

layout(location = 0) out vec4 weightAndNormal;
layout(location = 1) out vec4 depthAndColour;
layout(location = 2) out float opacity;
#ifdef FACTORS
layout(location = 3) out vec4 factors;
#endif

void main()
{
  Splat q = fragmentSplat();
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  uint nearest = texelFetch(Depths, pixel, 0).r;
  Hit hit;
  if (!intersect(q, gl_FragCoord.xy, KernelSupport, hit) ||
    !(Gather ? nearest != NoDepth : sameLayer(q, hit.depth, nearest)))
  {
    discard;
  }
#ifdef PEELING
  if (PreviousCount > 0 &&
    isPeeled(q, hit.depth,
      uvec3(texelFetch(Previous0, pixel, 0).r, texelFetch(Previous1, pixel, 0).r,
        texelFetch(Previous2, pixel, 0).r)))
  {
    discard;
  }
#endif
  vec4 colour = ItemColour;
  if (HasColours)
  {
    colour *= splatColour;
  }
  // As in the fixed-point sums, a weight never vanishes inside the support.
  float weight =
    max(kernelWeight(hit.r2, KernelSupport) * (Gather ? colour.a : 1.0), 1.0 / 4096.0);
  float behind = clamp((hit.depth - decodeDepth(nearest)) / DepthUnit, -1.0, 1.0);
  // Normals of many surfaces: turned to the viewer, or front and back would cancel.
  float turned = Gather && (q.tag & 1u) != 0u ? -1.0 : 1.0;
  weightAndNormal = weight * vec4(1.0, turned * normalAt(q, hit.uv));
  depthAndColour = weight * vec4(behind, colour.rgb);
  opacity = weight * colour.a;
#ifdef FACTORS
  factors = weight * splatFactors;
#endif
}
