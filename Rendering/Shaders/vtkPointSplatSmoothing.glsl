// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Smooths a filled layer (Dobrev, Rosenthal, Linsen 2010, section 3.4): the mean of normal,
// depth, colour and lights' factors over the 3 x 3 pixels with the alleviated Gaussian, 16/28 in
// the middle, 2/28 beside it and 1/28 at the corners; background and other layers are kept out
// of the sums. Each pixel counts as often as there are points in it. Splats that have an extent
// pass as they are.
//
// And anti-aliases silhouettes (section 3.5). A point marks all of the pixel that it falls in, so
// that a silhouette's pixels are covered by half in the mean: they are blended with the farthest
// of the pixels beside them, or with what is behind the layer.

#include "vtkPointSplatAgreement"

uniform uvec2 SlotSilhouettes; // of the items by their slots, a bit each: whether to blend
uniform vec2 RayOffset; // pixels
uniform vec2 RayScale;  // from there to the ray's direction, for a step of 1 in depth

// As in vtkPointSplatProjection.
const float LeastFacing = 0.2;

// What the projection summed up for a pixel.
struct Sum
{
  uint code;            // the pixel's own depth, NoDepth where there is none
  float weight;
  vec4 normalAndBehind; // the latter in world units
#ifdef COLOURS
  vec4 colour;
#endif
#ifdef FACTORS
  LightFactors factors;
#endif
};

Sum fetchSum(ivec2 pixel)
{
  Sum s;
  uvec2 filled = fetchFilled(pixel);
  s.code = filled.x;
  ivec2 source = sourcePixel(filled.y);
  vec4 colour;
  s.weight = fetchRawSums(source, s.normalAndBehind, colour);
  s.weight = s.code == NoDepth ? 0.0 : s.weight;
  s.normalAndBehind.w *= DepthUnit;
#ifdef COLOURS
  s.colour = colour;
#endif
#ifdef FACTORS
  fetchRawFactors(source, s.factors);
#endif
  return s;
}

// The direction in which a pixel is seen.
vec3 pixelRay(ivec2 pixel)
{
  return vec3((vec2(pixel) + 0.5 + RayOffset) * RayScale, -1.0);
}

// How far two depths of one surface may differ along the ray. Negative: this pixel is not
// smoothed.
float smoothingRange(Sum own, vec3 ray)
{
  float layer = layerOf(own.code);
  // Along the normal, as everywhere; neighbours are up to 1.4 pixels away.
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
    mean.normalAndBehind.w += kernel * other.weight * behind;
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

// Silhouettes are where the Laplacian of the linear depth, which vanishes on any plane, is large.
bool isSilhouette(uint own, Sum beside[4])
{
  float depth = decodeDepth(own);
  float laplacian = 0.0;
  for (int k = 0; k < 4; ++k)
  {
    uint code = beside[k].code;
    laplacian += (code == NoDepth ? 3e37 : decodeDepth(code)) - depth;
  }
  uint slot = uint(slotOf(own));
  // DepthUnit is five times the least layer distance.
  return laplacian > DepthUnit && (SlotSilhouettes[slot >> 5] >> (slot & 31u) & 1u) != 0u;
}

// The normal as long as it is bright, turned to the viewer.
vec3 seenNormal(Sum s, vec3 ray)
{
  vec3 n = s.normalAndBehind.xyz;
  float l = length(n);
  float bright = l > 0.0 && s.weight > 0.0 ? agreementOf(l / s.weight) / l : 0.0;
  return n * (dot(n, ray) > 0.0 ? -bright : bright);
}

// mean: smoothed; beside: the sums of Ring[0, 2, 4, 6].
void smoothPixel(vec3 ray, Sum mean, Sum beside[4], out uvec4 texel, out uint factors)
{
  bool empty = !(mean.weight > 0.0);
  vec4 n = empty ? vec4(0.0, 0.0, 1.0, 0.0) : mean.normalAndBehind / mean.weight;
#ifdef COLOURS
  vec4 colour = empty ? vec4(1.0) : mean.colour / mean.weight;
#else
  vec4 colour = vec4(1.0);
#endif
#ifdef FACTORS
  LightFactors lit = empty ? LightFactors(1.0) : mean.factors / mean.weight;
#endif
  bool silhouette = isSilhouette(mean.code, beside);
  Sum beyond = mean;
  for (int k = 0; k < 4; ++k)
  {
    if (beside[k].code > beyond.code)
    {
      beyond = beside[k];
    }
  }
  bool onto = silhouette && beyond.code != NoDepth && slotOf(beyond.code) == slotOf(mean.code);
  if (onto)
  {
    // Diffuse light is linear in the normal, if that is as long as it is bright.
    vec3 both = 0.5 * FullAgreement * (seenNormal(mean, ray) + seenNormal(beyond, ray));
    n.xyz = dot(n.xyz, ray) > 0.0 ? -both : both;
#ifdef COLOURS
    colour = beyond.weight > 0.0 ? 0.5 * (colour + beyond.colour / beyond.weight) : colour;
#endif
#ifdef FACTORS
    lit = beyond.weight > 0.0 ? 0.5 * (lit + beyond.factors / beyond.weight) : lit;
#endif
  }
  texel = packTexel(mean.code, n.xyz, n.w / DepthUnit, colour, silhouette && !onto);
  factors = 0u;
#ifdef FACTORS
  factors = packColour(vec4(lit));
#endif
}
