#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A point for each pixel that an outline runs through (vtkPointSplatOutlines.h).

uniform usamplerBuffer OutlinePixels; // R32UI
uniform ivec2 OutlineImage; // its size

void main()
{
  int pixel = int(texelFetch(OutlinePixels, gl_VertexID).r & 0xfffffffu);
  vec2 place = vec2(pixel % OutlineImage.x, pixel / OutlineImage.x) + 0.5;
  gl_Position = vec4(2.0 * place / vec2(OutlineImage) - 1.0, 0.0, 1.0);
  gl_PointSize = 1.0;
}
