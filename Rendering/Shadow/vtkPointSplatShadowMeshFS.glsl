#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Writes a mesh's texels to a shadow map.

#include "vtkPointSplatShadowMap"

in vec3 positionLC;
in float cut;

layout(location = 0) out uint shadow;

void main()
{
  if (cut < 0.0)
  {
    discard;
  }
  vec3 normal = cross(dFdx(positionLC), dFdy(positionLC));
  float l = length(normal);
  normal = l > 0.0 ? normal / l : vec3(0.0, 0.0, 1.0);
  float facing = Parallel ? abs(normal.z) : abs(dot(normal, positionLC)) / positionLC.z;
  shadow = encodeShadow(positionLC.z, facing);
  gl_FragDepth = float(shadow >> 8) / 16777216.0;
}
