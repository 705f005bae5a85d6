// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What fragment shaders add to a pixel's sums, by additive blending: two RGBA32F images,
// weight and normal, depth behind the nearest and colour, one R32F with the opacity, and where
// lights cast shadows one RGBA32F with their factors; each times the weight.

uniform float DepthUnit;
uniform bool HasColours;
uniform vec4 ItemColour;

layout(location = 0) out vec4 weightAndNormal;
layout(location = 1) out vec4 depthAndColour;
layout(location = 2) out float opacity;
#ifdef FACTORS
layout(location = 3) out vec4 factors;

vec4 factorsGiven = vec4(1.0); // what addToSums() takes
#endif

// As addToSums() of vtkPointSplatSums.
void addToSums(vec4 given, float kernel, vec3 normal, float behind, bool gather)
{
  vec4 colour = ItemColour;
  if (HasColours)
  {
    colour *= given;
  }
  // As in the fixed-point sums, a weight never vanishes inside the support.
  float weight = max(kernel * (gather ? colour.a : 1.0), 1.0 / 4096.0);
  weightAndNormal = weight * vec4(1.0, normal);
  depthAndColour = weight * vec4(clamp(behind / DepthUnit, -1.0, 1.0), colour.rgb);
  opacity = weight * colour.a;
#ifdef FACTORS
  factors = weight * factorsGiven;
#endif
}
