// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Coded depths of the layers before, the last one first, as fragment shaders read them.

uniform usampler2D Previous0;
uniform usampler2D Previous1;
uniform usampler2D Previous2;

uvec3 previousDepths(ivec2 pixel)
{
  return uvec3(texelFetch(Previous0, pixel, 0).r, texelFetch(Previous1, pixel, 0).r,
    texelFetch(Previous2, pixel, 0).r);
}
