// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The texels of a shadow map (R32UI), which sort by depth: above, 24 bits of the depth
// from the light as a fraction of DepthRange; below, 8 bits of the facing, which is how far one
// comes along the surface's normal for a step of 1 in depth along the light's ray: |n_z|
// of the light's coordinates (Dobrev, Rosenthal, Linsen 2010, section 6), and of a ray that is
// not parallel to the axis likewise.

const uint Nothing = 0xffffffffu;
// The bound on 1 / |n_z|.
const float LeastFacing = 0.05;

uniform ivec2 MapSize;
uniform int Face;            // of the cube about the light; -1: there is none
uniform bool Parallel;
uniform float DepthRange;    // world units
uniform float LayerDistance; // d~, world units
uniform float LayerPixels;   // and at least so many pixels
uniform float PixelSize;     // world units: of a pixel; at a depth of 1, if not parallel

uint encodeShadow(float depth, float facing)
{
  uint d = uint(clamp(depth / DepthRange, 0.0, 1.0) * 16777215.0);
  return d << 8 | uint(clamp(facing, 0.0, 1.0) * 254.0);
}

float shadowDepth(uint texel)
{
  return float(texel >> 8) * (DepthRange / 16777215.0);
}

float shadowFacing(uint texel)
{
  return float(texel & 255u) / 254.0;
}

// How much farther than a depth the same surface layer may reach along the light's ray:
// d~ / |n_z|, bounded.
float layerOffset(float depth, float facing)
{
  float pixel = Parallel ? PixelSize : PixelSize * depth;
  return max(LayerDistance, LayerPixels * pixel) / max(facing, LeastFacing);
}

// From the light's coordinates to those of a face: z is away from the light through it.
vec3 toFace(vec3 v, int face)
{
  vec3 w = face < 2 ? v.yzx : face < 4 ? v.zxy : v;
  return (face & 1) == 0 ? w : vec3(w.xy, -w.z);
}
