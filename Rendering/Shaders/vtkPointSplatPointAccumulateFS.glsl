#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Attribute accumulation of points projected as single pixels, by the rasteriser: see
// vtkPointSplatPointAccumulateCS.
// Reads: the coded depths. Writes: see vtkPointSplatBlendedSums.

#include "vtkPointSplatPointFS"
#include "vtkPointSplatPointWeight"
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
  Splat q = fragmentPoint();
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  uint nearest = texelFetch(Depths, pixel, 0).r;
  if (!(Gather ? nearest != NoDepth : sameLayer(q, q.depth, nearest)))
  {
    discard;
  }
#ifdef PEELING
  if (PreviousCount > 0 && isPeeled(q, q.depth, previousDepths(pixel)))
  {
    discard;
  }
#endif
#ifdef FACTORS
  factorsGiven = pointFactors;
#endif
  addToSums(pointColour, pointWeight(q), turnTo(nearest, q.tag) * q.normal,
    undelayedDepth(q) - decodeDepth(nearest), Gather);
}
