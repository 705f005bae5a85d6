#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Names the nearest point of each pixel, for hardware selection, by the rasteriser; of equals
// the one with the least id, which the depth test finds.
// Reads: the coded depths. Writes: ids (R32UI).

#include "vtkPointSplatPointFS"

uniform usampler2D Depths;

layout(location = 0) out uint nearestId;

void main()
{
  Splat q = fragmentPoint();
  if (encodeDepth(q.depth, q.tag) != texelFetch(Depths, ivec2(gl_FragCoord.xy), 0).r)
  {
    discard;
  }
  nearestId = tagAndId.y;
  gl_FragDepth = float(tagAndId.y) / 4294967296.0;
}
