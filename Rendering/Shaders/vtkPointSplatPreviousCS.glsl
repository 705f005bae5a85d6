// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Coded depths of the layers before, the last one first, as compute shaders read them: the
// buffers of splatted layers, or the texels of filled ones.

uniform usamplerBuffer Previous0;
uniform usamplerBuffer Previous1;
uniform usamplerBuffer Previous2;

uvec3 previousDepths(ivec2 pixel)
{
  int at = pixelIndex(pixel);
  return uvec3(
    texelFetch(Previous0, at).r, texelFetch(Previous1, at).r, texelFetch(Previous2, at).r);
}
