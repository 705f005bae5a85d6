#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Names the splat of the greatest weight at each pixel of the nearest layer, or the nearest point,
// of equals the one of the least id; by the rasteriser: the depth test keeps it. Where ids are
// colours of cells (vtkPointSplatCloud.h) also of further layers, with PEELING.
// Reads: the coded depths. Writes: the id (R32UI).

#include "vtkPointSplatFragment"
#ifdef PEELING
#include "vtkPointSplatPeel"
#endif

#ifdef FACETS
#include "vtkPointSplatOctahedron"
#endif

uniform usampler2D Depths;

layout(location = 0) out uint nearestId;

void main()
{
  uint nearest = texelFetch(Depths, ivec2(gl_FragCoord.xy), 0).r;
  Fragment f;
  if (!findFragment(f) || !sameLayer(f.splat, f.depth, nearest))
  {
    discard;
  }
#ifdef PEELING
  if (isPeeled(f.splat, f.depth, ivec2(gl_FragCoord.xy)))
  {
    discard;
  }
#endif
#ifdef FACETS
  nearestId = encodeNormal(turnTo(nearest, f.splat.tag) * normalAt(f.splat, vec2(0.0)));
#else
  nearestId = tagAndId.y;
#endif
#ifdef POINTS
  if (encodeDepth(f.depth, f.splat.tag) != nearest)
  {
    discard;
  }
  gl_FragDepth = float(tagAndId.y) / 4294967296.0;
#else
  // A weight never vanishes inside the support.
  gl_FragDepth = 1.0 - clamp(f.weight * shareInLayer(f, nearest), 1.0 / 4096.0, 1.0);
#endif
}
