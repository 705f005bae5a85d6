// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Four values from 0 to 1, 8 bits each: what packUnorm4x8 does from GLSL 4.2 on, here for 3.3.

uint packColour(vec4 colour)
{
  uvec4 c = uvec4(round(clamp(colour, 0.0, 1.0) * 255.0));
  return c.r | c.g << 8 | c.b << 16 | c.a << 24;
}

vec4 unpackColour(uint code)
{
  return vec4(uvec4(code, code >> 8, code >> 16, code >> 24) & 255u) / 255.0;
}
