// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The images of a reconstructed surface layer, from whatever made them: buffers of
// integers (COMPUTE_IMAGES), or textures; as the projection left them, or one image of texels
// (FILLED_IMAGES).

#ifdef COMPUTE_IMAGES
#include "vtkPointSplatFixedPoint"
#else
uniform float DepthUnit;
#endif

#if defined(FILLED_IMAGES)

#include "vtkPointSplatTexel"

#ifdef COMPUTE_IMAGES
uniform usamplerBuffer Texels; // RGBA32UI, see vtkPointSplatTexel
uniform usamplerBuffer Filled; // RG32UI: coded depth, and the pixel whose attributes are meant
uniform usamplerBuffer Ids;    // RG32UI, one a projected pixel
uniform int ImageWidth;

uvec4 fetchTexel(ivec2 pixel)
{
  return texelFetch(Texels, pixel.y * ImageWidth + pixel.x);
}

uint fetchId(ivec2 pixel)
{
  uint source = texelFetch(Filled, pixel.y * ImageWidth + pixel.x).g;
  return texelFetch(Ids, int(source >> 16) * ImageWidth + int(source & 0xffffu)).g;
}
#else
uniform usampler2D Texels;
uniform usampler2D Filled;
uniform usampler2D Ids;

uvec4 fetchTexel(ivec2 pixel)
{
  return texelFetch(Texels, pixel, 0);
}

uint fetchId(ivec2 pixel)
{
  uint source = texelFetch(Filled, pixel, 0).g;
  return texelFetch(Ids, ivec2(source & 0xffffu, source >> 16), 0).r;
}
#endif

uint fetchDepth(ivec2 pixel)
{
  return fetchTexel(pixel).r;
}

bool fetchSums(ivec2 pixel, out vec3 normal, out float behind, out vec4 colour)
{
  unpackTexel(fetchTexel(pixel), normal, behind, colour);
  behind *= DepthUnit;
  return true;
}

// The share of the pixel that the layer covers.
float fetchCoverage(ivec2 pixel)
{
  return isHalfCovered(fetchTexel(pixel)) ? 0.5 : 1.0;
}

#elif defined(COMPUTE_IMAGES)

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

// Sums of weights, and of weighted normals, depths in units of DepthUnit, and colours.
float fetchRawSums(ivec2 pixel, out vec4 normalAndBehind, out vec4 colour)
{
  int at = (pixel.y * ImageWidth + pixel.x) * TexelsPerPixel;
  ivec4 a = texelFetch(Sums, at);
  normalAndBehind = vec4(unpackSums(a.y), unpackSums(a.z));
  colour = vec4(float(a.x));
  if (TexelsPerPixel > 1)
  {
    colour = vec4(unpackSums(a.w), unpackSums(texelFetch(Sums, at + 1).r));
  }
  return float(a.x);
}

#else

uniform usampler2D Depths;
uniform sampler2D WeightAndNormal;
uniform sampler2D DepthAndColour;
uniform sampler2D Opacities;
uniform usampler2D Ids;

uint fetchDepth(ivec2 pixel)
{
  return texelFetch(Depths, pixel, 0).r;
}

uint fetchId(ivec2 pixel)
{
  return texelFetch(Ids, pixel, 0).r;
}

float fetchRawSums(ivec2 pixel, out vec4 normalAndBehind, out vec4 colour)
{
  vec4 a = texelFetch(WeightAndNormal, pixel, 0);
  vec4 b = texelFetch(DepthAndColour, pixel, 0);
  normalAndBehind = vec4(a.yzw, b.x);
  colour = vec4(b.yzw, texelFetch(Opacities, pixel, 0).r);
  return a.x;
}

#endif

#ifndef FILLED_IMAGES
// False: nothing was accumulated here.
bool fetchSums(ivec2 pixel, out vec3 normal, out float behind, out vec4 colour)
{
  vec4 sum;
  float w = fetchRawSums(pixel, sum, colour);
  normal = sum.xyz / w;
  behind = DepthUnit * sum.w / w;
  colour /= w;
  return w > 0.0;
}
#endif

#ifdef FACTORS
// The factors of lights, as many as FACTORS says: one is cheaper by itself.
#if FACTORS > 1
#define LightFactors vec4
#else
#define LightFactors float
#endif
#ifdef FILLED_IMAGES
#ifdef COMPUTE_IMAGES
uniform usamplerBuffer FactorTexels; // R32UI, see vtkPointSplatTexel

vec4 fetchFactors(ivec2 pixel)
{
  return unpackColour(texelFetch(FactorTexels, pixel.y * ImageWidth + pixel.x).r);
}
#else
uniform usampler2D FactorTexels;

vec4 fetchFactors(ivec2 pixel)
{
  return unpackColour(texelFetch(FactorTexels, pixel, 0).r);
}
#endif
#else
#ifdef COMPUTE_IMAGES
uniform int FactorWord; // 3, or 5 with colours

// Sums of weights, and of weighted factors.
float fetchRawFactors(ivec2 pixel, out LightFactors factors)
{
  int at = (pixel.y * ImageWidth + pixel.x) * TexelsPerPixel;
  ivec4 a = texelFetch(Sums, at);
  ivec4 b = TexelsPerPixel > 1 ? texelFetch(Sums, at + 1) : ivec4(0);
  ivec2 words = FactorWord == 3 ? ivec2(a.w, b.x) : b.yz;
#if FACTORS > 1
  factors = vec4(unpackSums(words.x), unpackSums(words.y));
#else
  factors = unpackSums(words.x).x;
#endif
  return float(a.x);
}
#else
uniform sampler2D Factors;

float fetchRawFactors(ivec2 pixel, out LightFactors factors)
{
  factors = LightFactors(texelFetch(Factors, pixel, 0));
  return texelFetch(WeightAndNormal, pixel, 0).x;
}
#endif

vec4 fetchFactors(ivec2 pixel)
{
  LightFactors factors;
  float w = fetchRawFactors(pixel, factors);
  return w > 0.0 ? vec4(factors / w) : vec4(1.0);
}
#endif
#endif
