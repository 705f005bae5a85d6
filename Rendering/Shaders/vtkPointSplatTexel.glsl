// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A pixel of a layer that was reconstructed in image space (RGBA32UI):
//   x  the coded depth, as in encodeDepth
//   y  the mean normal's direction, view coordinates, two times 16 bits on an octahedron
//   z  its length, 15 bits; whether half the pixel is covered, 1 bit; the depth behind the coded
//      one, in units of DepthUnit, 16 bits
//   w  colour and opacity, 8 bits a component
// Where lights cast shadows, a second image (R32UI) has the factors of up to four lights, 8 bits
// each, packed as a colour.

#include "vtkPointSplatOctahedron"
#include "vtkPointSplatColourCode"

// behind: in units of DepthUnit, -1 to 1.
uvec4 packTexel(uint code, vec3 normal, float behind, vec4 colour, bool halfCovered)
{
  float l = length(normal);
  uint depth = uint(int(round(clamp(behind, -1.0, 1.0) * 32767.0))) << 16;
  return uvec4(code, encodeNormal(l > 0.0 ? normal : vec3(0.0, 0.0, 1.0)),
    uint(round(clamp(l, 0.0, 1.0) * 32767.0)) | (halfCovered ? 0x8000u : 0u) | depth,
    packColour(colour));
}

bool isHalfCovered(uvec4 texel)
{
  return (texel.z & 0x8000u) != 0u;
}

void unpackTexel(uvec4 texel, out vec3 normal, out float behind, out vec4 colour)
{
  normal = float(texel.z & 0x7fffu) / 32767.0 * decodeNormal(texel.y);
  behind = float(int(texel.z) >> 16) / 32767.0;
  colour = unpackColour(texel.w);
}
