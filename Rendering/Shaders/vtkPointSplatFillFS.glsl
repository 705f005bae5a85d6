#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One step of filling holes, by fragments: see vtkPointSplatFillStep.
// Reads: the projected depths, or the step before. Writes: see vtkPointSplatFilled.

#ifdef FIRST_FILL
#include "vtkPointSplatFetch"
#endif
#include "vtkPointSplatFilled"
#include "vtkPointSplatFillStep"

layout(location = 0) out uvec2 filled;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  uint codes[8];
  for (int k = 0; k < 8; ++k)
  {
    codes[k] = fetchFilled(pixel + Ring[k]).x;
  }
  filled = fill(pixel, fetchInside(pixel), codes);
}
