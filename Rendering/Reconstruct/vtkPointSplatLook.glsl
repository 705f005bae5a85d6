// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Beside the texel of a layer at a pixel, where some actor has textures or edges: LOOKS texels
// (RGBA32UI), one or two. When layers are made they hold
//   0  texture coordinates, two floats, or NaN; their changes by pixels along x and y, two halves
//      each
//   1  the tangent, coded as a normal; what of the pixel edges cover, a half; 0; 0
// and where textures were looked up (vtkPointSplatLooks.h), in their place
//   0  colour and opacity, four halves; of physically based interpolation the factors of
//      occlusion, roughness, metallic, anisotropy, 8 bits each; the normal, by its map, coded
//   1  the tangent, rotated; edges as before, and emission: blue, red and green, halves; the coat's
//      normal, by its map, coded

const uint NoCoordinates = 0x7fc00000u;

bool hasCoordinates(uvec4 texel)
{
  return (texel.x & 0x7fffffffu) <= 0x7f800000u;
}
