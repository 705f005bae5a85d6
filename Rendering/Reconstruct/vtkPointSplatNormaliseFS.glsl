#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From a layer's sums to its texels (Zhang, Pajarola 2006, equation 1), where no hole needs to be
// filled: what the rasteriser drew.
// Reads: coded depths and sums. Writes: texels (vtkPointSplatTexel), with IDS the ids.

#include "vtkPointSplatSums"
#include "vtkPointSplatTexel"
#if defined(VALUES) || defined(CELL_COLOURS) || defined(FACETS)
#define ITEMS
#include "vtkPointSplatItemTable"
#include "vtkPointSplatValue"
#endif

uniform vec2 PixelSize; // world units: at depth 0, and its growth with the depth

layout(location = 0) out uvec4 texel;
#if defined(FACTORS) && defined(IDS)
layout(location = 1) out uint factorTexel;
layout(location = 2) out uint id;
#elif defined(FACTORS)
layout(location = 1) out uint factorTexel;
#elif defined(IDS)
layout(location = 1) out uint id;
#endif

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  uint code = fetchDepth(pixel);
  bool empty = code == NoDepth;
  Sum s = fetchSum(pixel);
  bool summed = s.weight > 0.0;
  vec4 mean = summed ? s.normalAndBehind / s.weight : vec4(0.0);
  float depth = empty ? 0.0 : decodeDepth(code) + DepthUnit * mean.w;
  if (!summed)
  {
    // No kernel reaches the pixel: the nearest disks still tell how the surface lies.
    vec2 slope = vec2(dFdx(depth), dFdy(depth)) / (PixelSize.x + PixelSize.y * depth);
    mean.xyz = normalize(vec3(slope, 1.0));
  }
  vec4 colour = summed ? s.colour / s.weight : vec4(1.0);
#ifdef ITEMS
  vec4 map = itemValueMap(empty ? 0u : code & TagMask);
#endif
#ifdef VALUES
  colour = summed ? colourOfSum(s.colour, s.weight, map) : colour;
#endif
#ifdef CELL_COLOURS
  colour = summed && hasCellColours(map) ? unpackColour(fetchId(pixel)) : colour;
#endif
#ifdef FACETS
  // Where pixels have colours of cells, the place is taken.
  bool facet = summed && itemIsFlat(empty ? 0u : code & TagMask) && !hasCellColours(map);
  mean.xyz = facet ? decodeNormal(fetchId(pixel)) : mean.xyz;
#endif
  texel = empty ? uvec4(0u) : packTexel(depth, mean.xyz, code & TagMask, 1.0, colour);
#ifdef FACTORS
  factorTexel = packColour(summed ? s.factors / s.weight : vec4(1.0));
#endif
#ifdef IDS
  id = fetchId(pixel);
#endif
}
