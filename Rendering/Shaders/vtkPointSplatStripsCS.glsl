// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How compute shaders walk over the pixels of an image with their neighbours: each invocation
// goes up a strip two pixels wide, so that of the twelve pixels that these are or have beside
// them it reads four anew. Needs vtkPointSplatFetch.

layout(local_size_x = 32) in;

const int StripWidth = 2;
const int StripLength = 16;

int pixelIndex(ivec2 pixel)
{
  return pixel.y * ImageWidth + pixel.x;
}

// The first pixel of the invocation's strip.
ivec2 stripPixel(ivec4 window)
{
  return window.xy + ivec2(gl_GlobalInvocationID.xy) * ivec2(StripWidth, StripLength);
}
