#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Two triangles for each rectangle of pixels in which there may be layers (vtkPointSplatLayers.h),
// over a viewport of the layers' size.

uniform isamplerBuffer LayerRectangles; // RGBA32I, first pixel's x, y, last one's
uniform ivec2 LayerSize;

void main()
{
  ivec4 rectangle = texelFetch(LayerRectangles, gl_VertexID / 6);
  // Corners 0, 1, 2 and 2, 1, 3; bit 0 is right, bit 1 is up.
  int corner = int(0x312210u >> uint(4 * (gl_VertexID % 6))) & 3;
  ivec2 place = ivec2((corner & 1) != 0 ? rectangle.z + 1 : rectangle.x,
    (corner & 2) != 0 ? rectangle.w + 1 : rectangle.y);
  gl_Position = vec4(2.0 * vec2(place) / vec2(LayerSize) - 1.0, 0.0, 1.0);
}
