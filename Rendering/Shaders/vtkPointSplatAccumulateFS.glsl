#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Attribute accumulation, by quads and additive blending: see
// vtkPointSplatAccumulateCS.
// Reads: the coded depths. Writes: see vtkPointSplatBlendedSums.

#include "vtkPointSplatQuadFS"
#include "vtkPointSplatKernel"
#include "vtkPointSplatBlendedSums"
#ifdef PEELING
#include "vtkPointSplatPeel"
#include "vtkPointSplatPreviousFS"
uniform bool Gather;
#else
const bool Gather = false;
#endif

uniform usampler2D Depths;

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
  if (PreviousCount > 0 && isPeeled(q, hit.depth, previousDepths(pixel)))
  {
    discard;
  }
#endif
#ifdef FACTORS
  factorsGiven = splatFactors;
#endif
  addToSums(splatColour, kernelWeight(hit.r2, KernelSupport),
    turnTo(nearest, q.tag) * normalAt(q, hit.uv), hit.depth - decodeDepth(nearest), Gather);
}
