#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Copies a shadow map, its holes filled.

#include "vtkPointSplatShadowFilled"

layout(location = 0) out uint shadow;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  uint own = texelFetch(Map, pixel, 0).r;
  shadow = min(own, filled(pixel, own)); // what fills an occluded pixel is nearer
}
