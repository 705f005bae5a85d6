#version 330
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
// of the pixels beside them, or with what is behind the layer. The paper has two thresholds, a high one
// where only silhouettes before the background are meant, a low one for those before other surfaces.
// Here background is infinitely far, so that one threshold, five least layer distances, finds both, and
// both are blended. Of a body (clouds.body_mesh of Testing/Benchmark/papers, 400 000 points, 300 x 300
// pixels, four views) pictures are like the supersampled mesh's to 36.25 dB in the mean; before the
// background alone to 36.02, with five times the threshold to 36.10, with a fifth of it to 36.30.
// Reads: the filled layer and the projection's sums. Writes: texels (vtkPointSplatTexel), the coded
// depths that the next layers are peeled by, with IDS the ids.

#include "vtkPointSplatSums"
#include "vtkPointSplatTexel"
#include "vtkPointSplatFilled"
#include "vtkPointSplatMasks"
#if defined(VALUES) || defined(CELL_COLOURS) || defined(FACETS)
#define ITEMS
#include "vtkPointSplatValue"
#endif

uniform vec2 RayOffset; // pixels
uniform vec2 RayScale;  // from there to the ray's direction, for a step of 1 in depth

layout(location = 0) out uvec4 texel;
layout(location = 1) out uint code;
#if defined(FACTORS) && defined(IDS)
layout(location = 2) out uint factorTexel;
layout(location = 3) out uint id;
#elif defined(FACTORS)
layout(location = 2) out uint factorTexel;
#elif defined(IDS)
layout(location = 2) out uint id;
#endif

// As in vtkPointSplatProjection.
const float LeastFacing = 0.2;
// As in vtkPointSplatMaterials.
const float FullAgreement = 0.6;

// What stands for a pixel: its own coded depth, or NoDepth, and the sums that are meant.
struct Stand
{
  uint code;
  Sum sum;
};

Stand fetchStand(ivec2 pixel)
{
  uvec2 filled = fetchFilled(pixel);
  Stand stand = Stand(filled.x, fetchSum(sourcePixel(filled.y)));
  stand.sum.weight = stand.code == NoDepth ? 0.0 : stand.sum.weight;
  stand.sum.normalAndBehind.w *= DepthUnit;
  return stand;
}

void addScaled(inout Sum mean, Sum other, float scale)
{
  mean.weight += scale * other.weight;
  mean.normalAndBehind += scale * other.normalAndBehind;
  mean.colour += scale * other.colour;
#ifdef FACTORS
  mean.factors += scale * other.factors;
#endif
}

void addNeighbour(inout Sum mean, uint own, Stand other, float kernel, float range)
{
  float behind = depthOf(other.code) - decodeDepth(own);
  if (((own ^ other.code) & TagMask) == 0u && abs(behind) <= range && other.sum.weight > 0.0)
  {
    addScaled(mean, other.sum, kernel);
    mean.normalAndBehind.w += kernel * other.sum.weight * behind;
  }
}

// The normal as long as it is bright, turned to the viewer.
vec3 seenNormal(Sum s, vec3 ray)
{
  vec3 n = s.normalAndBehind.xyz;
  float l = length(n);
  float bright =
    l > 0.0 && s.weight > 0.0 ? min(l / s.weight / FullAgreement, 1.0) / l : 0.0;
  return n * (dot(n, ray) > 0.0 ? -bright : bright);
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  uvec2 filled = fetchInside(pixel);
  code = filled.x;
  texel = uvec4(0u);
#ifdef FACTORS
  factorTexel = 0u;
#endif
#ifdef IDS
  id = code == NoDepth ? 0xffffffffu : fetchId(sourcePixel(filled.y));
#endif
  if (code == NoDepth)
  {
    return;
  }
  Stand own = fetchStand(pixel);
  Sum mean = own.sum;
  float coverage = 1.0;
  vec3 ray = vec3((vec2(pixel) + 0.5 + RayOffset) * RayScale, -1.0);
  Stand beyond = own;
  bool onto = false;
  if (isPoint(code))
  {
    // How far two depths of one surface may differ along the ray; neighbours are up to 1.4 pixels
    // away.
    vec3 n = mean.normalAndBehind.xyz;
    float facing = abs(dot(n, ray)) * inversesqrt(max(dot(n, n), 1e-20));
    float range = 1.5 * layerOf(code) / max(facing, LeastFacing);
    addScaled(mean, mean, 15.0);
    // Silhouettes are where the Laplacian of the linear depth, which vanishes on any plane, is
    // large.
    float laplacian = 0.0;
    for (int k = 0; k < 8; ++k)
    {
      Stand other = fetchStand(pixel + Ring[k]);
      addNeighbour(mean, code, other, (k & 1) == 0 ? 2.0 : 1.0, range);
      if ((k & 1) == 0)
      {
        laplacian += min(depthOf(other.code), 3e37) - decodeDepth(code);
        if (other.code > beyond.code)
        {
          beyond = other;
        }
      }
    }
    // DepthUnit is five times the least layer distance.
    bool silhouette = laplacian > DepthUnit && itemPoints(code & TagMask).w > 0.0;
    onto = silhouette && beyond.code != NoDepth && slotOf(beyond.code) == slotOf(code);
    coverage = silhouette && !onto ? 0.5 : 1.0;
  }
  bool empty = !(mean.weight > 0.0);
  vec4 n = empty ? vec4(0.0, 0.0, 1.0, 0.0) : mean.normalAndBehind / mean.weight;
  vec4 colour = empty ? vec4(1.0) : mean.colour / mean.weight;
#ifdef ITEMS
  vec4 map = itemValueMap(code & TagMask);
  bool single = hasValues(map) || hasCellColours(map);
#else
  const bool single = false;
#endif
#ifdef VALUES
  colour = empty ? colour : colourOfSum(mean.colour, mean.weight, map);
#endif
#ifdef CELL_COLOURS
  colour = hasCellColours(map) ? unpackColour(fetchId(sourcePixel(filled.y))) : colour;
#endif
#ifdef FACETS
  // As in vtkPointSplatNormaliseFS: of splats beside points.
  bool facet = !empty && itemIsFlat(code & TagMask) && !hasCellColours(map);
  n.xyz = facet ? decodeNormal(fetchId(sourcePixel(filled.y))) : n.xyz;
#endif
#ifdef FACTORS
  vec4 lit = empty ? vec4(1.0) : mean.factors / mean.weight;
#endif
  if (onto)
  {
    // Diffuse light is linear in the normal, if that is as long as it is bright.
    vec3 both = 0.5 * FullAgreement * (seenNormal(mean, ray) + seenNormal(beyond.sum, ray));
    n.xyz = dot(n.xyz, ray) > 0.0 ? -both : both;
    float share = beyond.sum.weight > 0.0 ? 0.5 : 0.0;
    // Between the colours of two surfaces a table may have others, or none.
    colour =
      mix(colour, beyond.sum.colour / max(beyond.sum.weight, 1e-30), single ? 0.0 : share);
#ifdef FACTORS
    lit = mix(lit, beyond.sum.factors / max(beyond.sum.weight, 1e-30), share);
#endif
  }
  texel = packTexel(decodeDepth(code) + n.w, n.xyz, code & TagMask, coverage, colour);
#ifdef FACTORS
  factorTexel = packColour(lit);
#endif
}
