// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The images of a reconstructed surface layer, from whichever projection made
// them: buffers of integers (COMPUTE_IMAGES), or textures.

#ifdef COMPUTE_IMAGES

#include "vtkPointSplatFixedPoint"

uniform usamplerBuffer Depths; // R32UI, one a pixel
uniform isamplerBuffer Sums;   // RGBA32I, see vtkPointSplatFixedPoint
uniform usamplerBuffer Ids;    // RG32UI, one a pixel
uniform int ImageWidth;
uniform int TexelsPerPixel;    // of Sums: 1, or 2 with colours

uint fetchDepth(ivec2 pixel)
{
  return texelFetch(Depths, pixel.y * ImageWidth + pixel.x).r;
}

uint fetchId(ivec2 pixel)
{
  return texelFetch(Ids, pixel.y * ImageWidth + pixel.x).g;
}

// False: nothing was accumulated here, or more than can be told.
bool fetchSums(ivec2 pixel, out vec3 normal, out float behind, out vec4 colour)
{
  int at = (pixel.y * ImageWidth + pixel.x) * TexelsPerPixel;
  ivec4 a = texelFetch(Sums, at);
  float w = float(a.x);
  ivec2 nxy = unpackSums(a.y);
  ivec2 nzDepth = unpackSums(a.z);
  normal = vec3(nxy, nzDepth.x) / w;
  behind = DepthUnit * float(nzDepth.y) / w;
  colour = vec4(1.0);
  if (TexelsPerPixel > 1)
  {
    colour = vec4(unpackSums(a.w), unpackSums(texelFetch(Sums, at + 1).r)) / w;
  }
  return a.x > 0 && a.x < WeightOverflow;
}

#ifdef FACTORS
uniform int FactorWord; // 3, or 5 with colours

vec4 fetchFactors(ivec2 pixel)
{
  int at = (pixel.y * ImageWidth + pixel.x) * TexelsPerPixel;
  ivec4 a = texelFetch(Sums, at);
  ivec4 b = TexelsPerPixel > 1 ? texelFetch(Sums, at + 1) : ivec4(0);
  ivec2 words = FactorWord == 3 ? ivec2(a.w, b.x) : b.yz;
  return vec4(unpackSums(words.x), unpackSums(words.y)) / float(a.x);
}
#endif

#else

uniform usampler2D Depths;
uniform sampler2D WeightAndNormal;
uniform sampler2D DepthAndColour;
uniform sampler2D Opacities;
uniform usampler2D Ids;
uniform float DepthUnit;

uint fetchDepth(ivec2 pixel)
{
  return texelFetch(Depths, pixel, 0).r;
}

uint fetchId(ivec2 pixel)
{
  return texelFetch(Ids, pixel, 0).r;
}

bool fetchSums(ivec2 pixel, out vec3 normal, out float behind, out vec4 colour)
{
  vec4 a = texelFetch(WeightAndNormal, pixel, 0);
  vec4 b = texelFetch(DepthAndColour, pixel, 0);
  normal = a.yzw / a.x;
  behind = DepthUnit * b.x / a.x;
  colour = vec4(b.yzw, texelFetch(Opacities, pixel, 0).r) / a.x;
  return a.x > 0.0;
}

#ifdef FACTORS
uniform sampler2D Factors;

vec4 fetchFactors(ivec2 pixel)
{
  return texelFetch(Factors, pixel, 0) / texelFetch(WeightAndNormal, pixel, 0).x;
}
#endif

#endif
