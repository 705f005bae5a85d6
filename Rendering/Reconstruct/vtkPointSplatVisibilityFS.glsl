#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Visibility splatting, by the rasteriser (Botsch, Kobbelt 2003, section 3, as Guennebaud, Barthe,
// Paulin 2006 have it).
// Writes: the coded depth (R32UI) of the nearest disk or point, by the depth test.

#include "vtkPointSplatFragment"
#ifdef PEELING
#include "vtkPointSplatPeel"
#endif

layout(location = 0) out uint nearestDepth;

void main()
{
  Fragment f;
  if (!findFragment(f))
  {
    discard;
  }
#ifdef PEELING
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  if (isPeeled(f.splat, f.depth, pixel) || isHidden(f.shown, pixel))
  {
    discard;
  }
#endif
  nearestDepth = encodeDepth(f.depth, f.splat.tag);
  gl_FragDepth = clamp(f.depth / DepthRange.y, 0.0, 1.0);
}
