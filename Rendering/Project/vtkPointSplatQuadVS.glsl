#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A splat's quad, for the stages that draw one image.

#include "vtkPointSplatQuad"

void main()
{
  spanQuad();
}
