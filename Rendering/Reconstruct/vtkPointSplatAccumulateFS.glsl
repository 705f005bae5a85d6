#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Attribute accumulation, by the rasteriser and additive blending (Zhang, Pajarola 2006, equation
// 1): sums over all that belongs to the layer of the nearest disk or point. GATHER: over all that
// is behind the layers so far, weighted by opacity.
// Reads: the coded depths. Writes: two RGBA32F images, weight and normal, depth behind the nearest
// and colour, one R32F with the opacity, and where lights cast shadows one RGBA32F with their
// factors; each times the weight.

#include "vtkPointSplatFragment"
#ifdef PEELING
#include "vtkPointSplatPeel"
#endif

uniform usampler2D Depths;
uniform float DepthUnit; // of depths in the sums, world units
uniform bool HasColours;
uniform vec4 ItemColour; // multiplies the points' colours
#ifdef VALUES
#include "vtkPointSplatValue"

uniform vec4 ValueMap;
#endif

layout(location = 0) out vec4 weightAndNormal;
layout(location = 1) out vec4 depthAndColour;
layout(location = 2) out float opacity;
#ifdef FACTORS
layout(location = 3) out vec4 factors;
#endif

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  uint nearest = texelFetch(Depths, pixel, 0).r;
  Fragment f;
  if (nearest == NoDepth || !findFragment(f))
  {
    discard;
  }
#ifdef GATHER
  bool belongs = true;
#else
  bool belongs = sameLayer(f.splat, f.depth, nearest);
#endif
#ifdef PEELING
  belongs = belongs && !isPeeled(f.splat, f.depth, pixel);
#ifdef GATHER
  belongs = belongs && !isHidden(f.shown, pixel);
#endif
#endif
  if (!belongs)
  {
    discard;
  }
  vec4 colour = HasColours ? ItemColour * splatColour : ItemColour;
#ifdef VALUES
  vec2 value = decodeValue(packColour(splatColour));
#ifdef GATHER
  // What is gathered is of several clouds.
  colour = ItemColour * mapValue(value, ValueMap);
#else
  // As weightedValue(), but floats need no second part.
  colour = vec4(value.x, 0.0, value.y, 0.0);
#endif
#endif
#ifdef GATHER
  f.weight *= colour.a;
#elif !defined(POINTS)
  f.weight *= shareInLayer(f, nearest);
#endif
  // A weight never vanishes inside the support.
  float weight = max(f.weight, 1.0 / 4096.0);
  float behind = clamp((f.shown - decodeDepth(nearest)) / DepthUnit, -1.0, 1.0);
  weightAndNormal = weight * vec4(1.0, turnTo(nearest, f.splat.tag) * f.normal);
  depthAndColour = weight * vec4(behind, colour.rgb);
  opacity = weight * colour.a;
#ifdef FACTORS
  factors = weight * splatFactors;
#endif
}
