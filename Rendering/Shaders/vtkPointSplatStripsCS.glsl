// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How compute shaders walk over the pixels of an image with their neighbours: each invocation
// goes up a strip one pixel wide, so that of the nine pixels it reads three anew. Needs
// vtkPointSplatFetch.

layout(local_size_x = 32) in;

const int StripLength = 16;

int pixelIndex(ivec2 pixel)
{
  return pixel.y * ImageWidth + pixel.x;
}
