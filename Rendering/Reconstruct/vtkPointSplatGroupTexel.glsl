// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a group's image holds at a pixel (RGBA32UI):
//   x  the coded depth, as in encodeDepth
//   y  the normal, view coordinates, two times 16 bits on an octahedron
//   z  two halves: the weight, negative where the pixel is off the splat's disk;
//      the least layer distance along the ray, world units, negative where the
//      splat stands so steep that only splats of its own side belong to its layer,
//      with bit 14 set where it is seen edge-on
//   w  colour and opacity, 8 bits a component, or a value (vtkPointSplatValue)
// Where lights cast shadows, a second image (R32UI) has their factors, 8 bits each.
// Layer distances are in units of DepthUnit: like weights they are 1 at most, so that bit 14, of the
// exponent, is free.

#include "vtkPointSplatOctahedron"
#include "vtkPointSplatColourCode"

uniform float DepthUnit; // world units

const uint EdgeOnLayer = 0x4000u;

// Two positive floats up to 1 as halves, 16 bits of which the uppermost is a flag. What
// packHalf2x16 does from GLSL 4.2 on: here for 3.3, rounded down.
uint encodeHalf(float value, bool flag)
{
  uint bits = floatBitsToUint(clamp(value, 6.2e-5, 1.0));
  uint h = ((bits >> 23) - 112u) << 10 | ((bits >> 13) & 0x3ffu);
  return h | (flag ? 0x8000u : 0u);
}

float decodeHalf(uint h)
{
  return uintBitsToFloat((((h >> 10) & 15u) + 112u) << 23 | (h & 0x3ffu) << 13);
}
