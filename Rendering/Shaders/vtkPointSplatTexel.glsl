// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A pixel of a layer that was reconstructed in image space (RGBA32UI):
//   x  the coded depth, as in encodeDepth
//   y  the mean normal's direction, view coordinates, two times 16 bits on an octahedron
//   z  its length, 15 bits; whether this is a silhouette, 1 bit; the depth behind the coded one,
//      in units of DepthUnit, 16 bits
//   w  colour and opacity, 8 bits a component
// Where lights cast shadows, a second image (R32UI) has the factors of up to four lights, 8 bits
// each, packed as a colour.

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

vec3 decodeNormal(uint code)
{
  vec2 f = vec2(ivec2(int(code << 16) >> 16, int(code) >> 16)) / 32767.0;
  vec3 n = vec3(f, 1.0 - abs(f.x) - abs(f.y));
  float fold = max(-n.z, 0.0);
  n.x += n.x >= 0.0 ? -fold : fold;
  n.y += n.y >= 0.0 ? -fold : fold;
  return normalize(n);
}

uint packColour(vec4 colour)
{
  uvec4 c = uvec4(round(clamp(colour, 0.0, 1.0) * 255.0));
  return c.r | c.g << 8 | c.b << 16 | c.a << 24;
}

vec4 unpackColour(uint code)
{
  return vec4(uvec4(code, code >> 8, code >> 16, code >> 24) & 255u) / 255.0;
}

// behind: in units of DepthUnit, -1 to 1.
uvec4 packTexel(uint code, vec3 normal, float behind, vec4 colour, bool silhouette)
{
  float l = length(normal);
  uint depth = uint(int(round(clamp(behind, -1.0, 1.0) * 32767.0))) << 16;
  return uvec4(code, encodeNormal(l > 0.0 ? normal : vec3(0.0, 0.0, 1.0)),
    uint(round(clamp(l, 0.0, 1.0) * 32767.0)) | (silhouette ? 0x8000u : 0u) | depth,
    packColour(colour));
}

void unpackTexel(uvec4 texel, out vec3 normal, out float behind, out vec4 colour)
{
  normal = float(texel.z & 0x7fffu) / 32767.0 * decodeNormal(texel.y);
  behind = float(int(texel.z) >> 16) / 32767.0;
  colour = unpackColour(texel.w);
}
