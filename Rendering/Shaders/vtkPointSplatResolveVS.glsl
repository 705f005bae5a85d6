//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A triangle over the whole viewport; the scissor test confines it to what the
// cloud's bounds cover.

in vec2 vertexDC;

void main()
{
  gl_Position = vec4(vertexDC, 0.0, 1.0);
}
