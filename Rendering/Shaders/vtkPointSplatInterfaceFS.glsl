#version 330
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One surface layer as the interface that vtkPointSplatRefractionFS traces rays to.
// Writes a texel of vtkPointSplatInterfaces: nothing where the layer is empty.

//PointSplat::Defines

#include "vtkPointSplatSurface"

void main()
{
  ivec2 at = ivec2(gl_FragCoord.xy);
  uint code = fetchDepth(at);
  if (code == NoDepth)
  {
    discard;
  }
  vec4 positionVC;
  vec3 normalVC;
  vec4 colour;
  fetchSurface(at, code, positionVC, normalVC, colour);
  float l = length(normalVC);
  normalVC = l > 0.0 ? normalVC / l : -eyeRay(positionVC.xyz);
  float tag = float(slotOf(code) + 1) + (isBack(normalVC, positionVC.xyz) ? 64.0 : 0.0);
  gl_FragData[0] = vec4(normalVC.xy, positionVC.z, normalVC.z < 0.0 ? -tag : tag);
}
