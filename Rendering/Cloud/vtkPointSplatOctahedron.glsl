// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How normals are coded, of splats and in images.

// A unit vector from the octahedron's two coordinates, 16 bits each (Cigolle et al.
// 2014, A survey of efficient representations for independent unit vectors).
vec3 decodeNormal(uint code)
{
  vec2 f = vec2(ivec2(int(code << 16) >> 16, int(code) >> 16)) / 32767.0;
  vec3 n = vec3(f, 1.0 - abs(f.x) - abs(f.y));
  float fold = max(-n.z, 0.0);
  n.x += n.x >= 0.0 ? -fold : fold;
  n.y += n.y >= 0.0 ? -fold : fold;
  return normalize(n);
}

uint encodeNormal(vec3 n)
{
  n /= abs(n.x) + abs(n.y) + abs(n.z);
  vec2 f = n.xy;
  if (n.z < 0.0)
  {
    f = (1.0 - abs(n.yx)) * vec2(n.x >= 0.0 ? 1.0 : -1.0, n.y >= 0.0 ? 1.0 : -1.0);
  }
  ivec2 i = ivec2(round(f * 32767.0));
  return (uint(i.x) & 0xffffu) | (uint(i.y) << 16);
}
