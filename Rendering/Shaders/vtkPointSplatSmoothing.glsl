// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Smooths a filled layer (Dobrev, Rosenthal, Linsen 2010, section 3.4): the mean of normal,
// depth, colour and lights' factors over the 3 x 3 pixels with the alleviated Gaussian, 16/28 in
// the middle, 2/28 beside it and 1/28 at the corners; background and other layers are kept out
// of the sums. Each pixel counts as often as there are points in it. Splats that have an extent
// pass as they are.

uniform vec2 RayOffset; // pixels
uniform vec2 RayScale;  // from there to the ray's direction, for a step of 1 in depth

// As in vtkPointSplatProjection.
const float LeastFacing = 0.2;

// What the projection summed up for a pixel.
struct Sum
{
  uint code;            // the pixel's own depth, NoDepth where there is none
  float weight;
  vec4 normalAndBehind; // the latter in units of DepthUnit
#ifdef COLOURS
  vec4 colour;
#endif
#ifdef FACTORS
  vec4 factors;
#endif
};

Sum fetchSum(ivec2 pixel)
{
  Sum s;
  s.code = fetchCode(pixel);
  vec4 colour;
  s.weight = s.code == NoDepth
    ? 0.0
    : fetchRawSums(sourcePixel(fetchSource(pixel)), s.normalAndBehind, colour);
#ifdef COLOURS
  s.colour = colour;
#endif
#ifdef FACTORS
  if (s.code != NoDepth)
  {
    fetchRawFactors(sourcePixel(fetchSource(pixel)), s.factors);
  }
#endif
  return s;
}

// The square of neighbours that are smoothed, half its width and height in pixels: how far
// two depths may differ along the ray. Negative: this pixel is not smoothed.
float smoothingRange(Sum own, ivec2 pixel)
{
  float layer = layerOf(own.code);
  // Along the normal, as everywhere; neighbours are up to 1.4 pixels away.
  vec3 ray = vec3((vec2(pixel) + 0.5 + RayOffset) * RayScale, -1.0);
  vec3 n = own.normalAndBehind.xyz;
  float facing = abs(dot(n, ray)) * inversesqrt(max(dot(n, n), 1e-20));
  return layer < 0.0 ? -1.0 : 1.5 * layer / max(facing, LeastFacing);
}

void addNeighbour(inout Sum mean, uint own, Sum other, float kernel, float range)
{
  float behind = decodeDepth(other.code) - decodeDepth(own);
  if (((own ^ other.code) & TagMask) == 0u && abs(behind) <= range && other.weight > 0.0)
  {
    mean.weight += kernel * other.weight;
    mean.normalAndBehind += kernel * other.normalAndBehind;
    mean.normalAndBehind.w += kernel * other.weight * behind / DepthUnit;
#ifdef COLOURS
    mean.colour += kernel * other.colour;
#endif
#ifdef FACTORS
    mean.factors += kernel * other.factors;
#endif
  }
}

void scaleSum(inout Sum s, float factor)
{
  s.weight *= factor;
  s.normalAndBehind *= factor;
#ifdef COLOURS
  s.colour *= factor;
#endif
#ifdef FACTORS
  s.factors *= factor;
#endif
}

// Silhouettes (section 3.5) are where the Laplacian of the linear depth, which vanishes on any
// plane, is large. codes: beside the pixel; NoDepth: background.
bool isSilhouette(uint own, uint codes[4])
{
  float depth = decodeDepth(own);
  float laplacian = 0.0;
  for (int k = 0; k < 4; ++k)
  {
    laplacian += (codes[k] == NoDepth ? 3e37 : decodeDepth(codes[k])) - depth;
  }
  // DepthUnit is five times the least layer distance.
  return laplacian > DepthUnit;
}

uvec4 texelOf(Sum mean, bool silhouette)
{
  vec4 n = mean.weight > 0.0 ? mean.normalAndBehind / mean.weight : vec4(0.0, 0.0, 1.0, 0.0);
#ifdef COLOURS
  vec4 colour = mean.weight > 0.0 ? mean.colour / mean.weight : vec4(1.0);
#else
  const vec4 colour = vec4(1.0);
#endif
  return packTexel(mean.code, n.xyz, n.w, colour, silhouette);
}

#ifdef FACTORS
uint factorTexelOf(Sum mean)
{
  return packColour(mean.weight > 0.0 ? mean.factors / mean.weight : vec4(1.0));
}
#endif
