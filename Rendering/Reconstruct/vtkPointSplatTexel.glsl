// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A pixel of a reconstructed surface layer (RGBA32UI), whatever reconstructed it:
//   x  the surface's depth behind the near plane along the view axis, world units, a float
//   y  the mean normal's direction, view coordinates, two times 16 bits on an octahedron
//   z  upper 16 bits: tag + 1, where the tag is the slot of the cloud and, in bit 0, the side that
//      the nearest splat shows; 0: nothing is here, nor in the layers behind. Then 2 bits: the
//      share of the pixel that is covered, in quarters less one. Then a bit: an outline runs through
//      the pixel, which is drawn by samples. Then a bit that is 0. Then a bit: nothing behind is
//      seen. Then 11 bits: the mean normal's length
//   w  colour and opacity, 8 bits a component
// Where lights cast shadows, beside it (R32UI) the factors of up to four lights, packed as a colour.

#include "vtkPointSplatOctahedron"
#include "vtkPointSplatColourCode"

struct Surface
{
  float depth;
  vec3 normal;
  float agreement; // the length of the mean of unit normals
  uint tag;
  float coverage;
  vec4 colour;
};

// Whether layers behind this one are of no account; whether the pixel is drawn by samples, as the
// texel of the nearest layer says.
const uint LastFlag = 2048u;
const uint OutlineFlag = 8192u;

bool isLast(uvec4 texel)
{
  return (texel.z & LastFlag) != 0u;
}

bool isOutline(uvec4 texel)
{
  return (texel.z & OutlineFlag) != 0u;
}

bool isEmpty(uvec4 texel)
{
  return (texel.z >> 16) == 0u;
}

uint tagOfTexel(uvec4 texel)
{
  return (texel.z >> 16) - 1u;
}

// normal: the mean, whose length is at most 1.
uvec4 packTexel(float depth, vec3 normal, uint tag, float coverage, vec4 colour)
{
  float l = length(normal);
  vec3 n = l > 0.0 ? normal / l : vec3(0.0, 0.0, 1.0);
  uint share = uint(clamp(round(coverage * 4.0), 1.0, 4.0)) - 1u;
  return uvec4(floatBitsToUint(depth), encodeNormal(n),
    (tag + 1u) << 16 | share << 14 | uint(round(clamp(l, 0.0, 1.0) * 2047.0)), packColour(colour));
}

// Of a texel that is not empty.
Surface unpackTexel(uvec4 texel)
{
  return Surface(uintBitsToFloat(texel.x), decodeNormal(texel.y),
    float(texel.z & 2047u) / 2047.0, tagOfTexel(texel),
    float((texel.z >> 14 & 3u) + 1u) / 4.0, unpackColour(texel.w));
}
