#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A point for each pixel that an outline runs through (vtkPointSplatOutlines.h).

uniform usamplerBuffer OutlinePixels;  // R32UI
uniform usamplerBuffer OutlineChoices; // R32UI
uniform ivec2 ImageSize;

flat out uint outlineChoices;

void main()
{
  outlineChoices = texelFetch(OutlineChoices, gl_VertexID).r;
  int pixel = int(texelFetch(OutlinePixels, gl_VertexID).r & 0xfffffffu);
  vec2 place = vec2(pixel % ImageSize.x, pixel / ImageSize.x) + 0.5;
  gl_Position = vec4(2.0 * place / vec2(ImageSize) - 1.0, 0.0, 1.0);
  gl_PointSize = 1.0;
}
