#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Counts for each point the samples of a light that reach it, by transform feedback.
// Reads: Map. Writes: count, one uint a splat.

#define TESTS_POINTS
#include "vtkPointSplatShadowProjection"

layout(location = 0) in uint counted;

flat out uint count;

void main()
{
  Seen s = seeSplat(gl_VertexID);
  count = counted + (s.mine && isLit(s) ? 1u : 0u);
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}
