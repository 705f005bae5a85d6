// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What one layer was summed up to (vtkPointSplatSums.h): the rasteriser's textures, or (SUM_BUFFERS)
// compute shaders' buffers of integers.

#include "vtkPointSplatDepthCode"
#include "vtkPointSplatFixedPoint"

uniform float DepthUnit; // of depths in the sums, world units

// Sums of weights, and of weighted attributes.
struct Sum
{
  float weight;
  vec4 normalAndBehind; // the latter in units of DepthUnit
  vec4 colour;
#ifdef FACTORS
  vec4 factors;
#endif
};

#ifdef SUM_BUFFERS
uniform usamplerBuffer Depths; // R32UI, one a pixel
uniform isamplerBuffer Sums;   // RGBA32I, see vtkPointSplatFixedPoint
uniform usamplerBuffer Ids;    // R32UI, one a pixel
uniform int ImageWidth;
uniform int TexelsPerPixel;    // of Sums: 1, or 2

uint fetchDepth(ivec2 pixel)
{
  return texelFetch(Depths, pixel.y * ImageWidth + pixel.x).r;
}

uint fetchId(ivec2 pixel)
{
  return texelFetch(Ids, pixel.y * ImageWidth + pixel.x).r;
}

Sum fetchSum(ivec2 pixel)
{
  int at = (pixel.y * ImageWidth + pixel.x) * TexelsPerPixel;
  ivec4 a = texelFetch(Sums, at);
  Sum s;
  s.weight = float(a.x);
  s.normalAndBehind = vec4(unpackSums(a.y), unpackSums(a.z));
  s.colour = vec4(s.weight);
#if defined(COLOURS) || defined(FACTORS)
  ivec4 b = TexelsPerPixel > 1 ? texelFetch(Sums, at + 1) : ivec4(0);
#endif
#ifdef COLOURS
  s.colour = vec4(unpackSums(a.w), unpackSums(b.x));
#endif
#ifdef FACTORS
  ivec2 words = FactorWord == 3 ? ivec2(a.w, b.x) : b.yz;
  s.factors = vec4(unpackSums(words.x), unpackSums(words.y));
#endif
  return s;
}
#else
uniform usampler2D Depths;
uniform sampler2D WeightAndNormal;
uniform sampler2D DepthAndColour;
uniform sampler2D Opacities;
uniform sampler2D Factors;
uniform usampler2D Ids;

uint fetchDepth(ivec2 pixel)
{
  return texelFetch(Depths, pixel, 0).r;
}

uint fetchId(ivec2 pixel)
{
  return texelFetch(Ids, pixel, 0).r;
}

Sum fetchSum(ivec2 pixel)
{
  vec4 a = texelFetch(WeightAndNormal, pixel, 0);
  vec4 b = texelFetch(DepthAndColour, pixel, 0);
  Sum s;
  s.weight = a.x;
  s.normalAndBehind = vec4(a.yzw, b.x);
  s.colour = vec4(b.yzw, texelFetch(Opacities, pixel, 0).r);
#ifdef FACTORS
  s.factors = texelFetch(Factors, pixel, 0);
#endif
  return s;
}
#endif
