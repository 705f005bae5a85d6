#version 430
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Attribute accumulation, by compute: weighted normals, depths and colours of
// all splats in each pixel's nearest layer. Sums are of integers, so that they
// are the same in whatever order the splats come.
// Reads: Depths. Writes: Sums, four ints a pixel or eight with colours: see
// vtkPointSplatFixedPoint.

#include "vtkPointSplatSplatsCS"
#include "vtkPointSplatKernel"
#include "vtkPointSplatSums"
#ifdef PEELING
#include "vtkPointSplatPeel"
#include "vtkPointSplatPreviousCS"
uniform bool Gather;           // all that is behind, weighted by opacity
#else
const bool Gather = false;
#endif

uniform usamplerBuffer Depths; // R32UI
uniform float PrefilterRadius; // pixels

void drawPixel(Splat q, uint index, ivec2 pixel)
{
  int at = pixelIndex(pixel);
  uint nearest = texelFetch(Depths, at).r;
#ifdef PEELING
  if (nearest == NoDepth)
  {
    return;
  }
#else
  if (((nearest ^ q.tag) & TagMask) > 1u)
  {
    return;
  }
#endif
  Hit hit;
  if (!intersect(q, vec2(pixel) + 0.5, KernelSupport, hit))
  {
    return;
  }
  bool mine = Gather || sameLayer(q, hit.depth, nearest);
#ifdef PEELING
  isLeft = isLeft || (!mine && hit.depth > decodeDepth(nearest));
  mine = mine &&
    !(PreviousCount > 0 && isPeeled(q, hit.depth, previousDepths(pixel)));
#endif
  if (mine)
  {
    addToSums(SumStride * at, index, kernelWeight(hit.r2, KernelSupport),
      turnTo(nearest, q.tag) * normalAt(q, hit.uv), hit.depth - decodeDepth(nearest), Gather);
  }
}

void main()
{
  drawSplats(KernelSupport, PrefilterRadius);
}
