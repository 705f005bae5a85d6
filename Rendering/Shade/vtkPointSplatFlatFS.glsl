#version 330
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Presents all translucent layers at once, flattened to one colour and opacity a pixel
// at the nearest layer's depth, where there is nothing else translucent that could lie
// between them. With the hooks of VTK's translucent passes, as vtkPointSplatResolveFS.

//VTK::CustomUniforms::Dec

//VTK::DepthPeeling::Dec

uniform sampler2D Flattened;   // premultiplied
uniform sampler2D NearestDepths;
uniform ivec2 ImageOrigin;

void main()
{
  ivec2 at = ivec2(gl_FragCoord.xy) - ImageOrigin;
  vec4 flattened = texelFetch(Flattened, at, 0);
  if (flattened.a <= 0.0)
  {
    discard;
  }
  gl_FragDepth = texelFetch(NearestDepths, at, 0).r;

  //VTK::DepthPeeling::PreColor

  gl_FragData[0] = vec4(flattened.rgb / flattened.a, flattened.a);

  //VTK::DepthPeeling::Impl
}
