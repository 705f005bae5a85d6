#version 330
#extension GL_ARB_sample_shading : enable
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Presents all translucent layers at once, flattened to one colour and opacity a pixel
// at the nearest layer's depth, where there is nothing else translucent that could lie
// between them. With the hooks of VTK's translucent passes, as vtkPointSplatLayerFS.
// Without pixels that outlines run through; OUTLINES: these, each the mean of those that its samples
// take after.

//PointSplat::Defines

//VTK::CustomUniforms::Dec

//VTK::DepthPeeling::Dec

#ifdef OUTLINES
#include "vtkPointSplatOutline"
#endif

uniform sampler2D Flattened;   // premultiplied
uniform sampler2D NearestDepths; // less 2 where an outline runs through the pixel
uniform ivec2 ImageOrigin;

void main()
{
  ivec2 at = ivec2(gl_FragCoord.xy) - ImageOrigin;
#ifdef OUTLINES
  vec4 flattened = vec4(0.0);
  float depth = 1.0;
  uint counts = countsAbout();
  ivec2 pixelAt;
  float share;
  while (nextPixel(counts, at, pixelAt, share))
  {
    flattened += share * texelFetch(Flattened, pixelAt, 0);
    float own = texelFetch(NearestDepths, pixelAt, 0).r;
    depth = min(depth, own < 0.0 ? own + 2.0 : own);
  }
#else
  vec4 flattened = texelFetch(Flattened, at, 0);
  float depth = texelFetch(NearestDepths, at, 0).r;
  flattened.a = depth < 0.0 ? 0.0 : flattened.a;
#endif
  if (flattened.a <= 0.0)
  {
    discard;
  }
  gl_FragDepth = depth;

  //VTK::DepthPeeling::PreColor

  gl_FragData[0] = vec4(flattened.rgb / flattened.a, flattened.a);

  //VTK::DepthPeeling::Impl
}
