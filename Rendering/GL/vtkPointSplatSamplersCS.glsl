#version 430
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reads a texel of a texture at each place that compute programs have, so that the driver binds a
// sampler there: see Dispatch() in vtkPointSplatProgram.h. The sum is 0 and is written nowhere, which the driver
// cannot know.

layout(local_size_x = 1) in;

uniform sampler2D Textures[PLACES];
layout(std430, binding = 0) writeonly buffer Nothing { float nothing[]; };

void main()
{
  float sum = 0.0;
  for (int i = 0; i < PLACES; ++i)
  {
    sum += texelFetch(Textures[i], ivec2(0), 0).r;
  }
  if (sum < 0.0)
  {
    nothing[0] = sum;
  }
}
