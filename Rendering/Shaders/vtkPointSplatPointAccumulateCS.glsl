#version 430
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Attribute accumulation of points projected as single pixels, by compute: the
// sums over all points of each pixel's nearest layer, which are the winner's attributes
// smoothed where points are denser than pixels.
// Reads: Depths. Writes: Sums, four ints a pixel or eight with colours: see
// vtkPointSplatFixedPoint.

#include "vtkPointSplatPointsCS"
#include "vtkPointSplatPointWeight"
#include "vtkPointSplatSums"
#ifdef PEELING
#include "vtkPointSplatPeel"
#include "vtkPointSplatPreviousCS"
uniform bool Gather; // all that is behind, weighted by opacity
#else
const bool Gather = false;
#endif

uniform usamplerBuffer Depths; // R32UI

void drawPoint(uint index, Splat q, ivec2 pixel)
{
  int at = pixelIndex(pixel);
  uint nearest = texelFetch(Depths, at).r;
  bool mine = nearest != NoDepth && (Gather || sameLayer(q, q.depth, nearest));
#ifdef PEELING
  if (PreviousCount > 0 && isPeeled(q, q.depth, previousDepths(pixel)))
  {
    return;
  }
  // Those of this layer too: where it is filled with what is before them, they belong
  // to the next one.
  next[atomicAdd(nextCount, 1u)] = index;
#endif
  if (mine)
  {
    addToSums(SumStride * at, index, pointWeight(q), turnTo(nearest, q.tag) * q.normal,
      undelayedDepth(q) - decodeDepth(nearest), Gather);
  }
}

void main()
{
  drawPoints();
}
