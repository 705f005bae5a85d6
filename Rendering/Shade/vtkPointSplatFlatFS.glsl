#version 330
#extension GL_ARB_sample_shading : enable
#extension GL_ARB_shading_language_packing : enable
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Presents all translucent layers at once, flattened to one colour and opacity a pixel
// at the nearest layer's depth, where there is nothing else translucent that could lie
// between them. With the hooks of VTK's translucent passes, as vtkPointSplatLayerFS.
// OUTLINES (vtkPointSplatOutline): a pixel that an outline runs through gets the mean of those that
// its samples take after. 0: there are none.

//PointSplat::Defines

//VTK::CustomUniforms::Dec

//VTK::DepthPeeling::Dec

#if OUTLINES > 0
#include "vtkPointSplatOutline"
#endif

uniform sampler2D Flattened;   // premultiplied
uniform sampler2D NearestDepths; // less 2 where an outline runs through the pixel
uniform ivec2 ImageOrigin;

void main()
{
  ivec2 at = ivec2(gl_FragCoord.xy) - ImageOrigin;
#if OUTLINES == 3
  at = pixelOfSample(at);
#endif
  vec4 flattened = texelFetch(Flattened, at, 0);
  float depth = texelFetch(NearestDepths, at, 0).r;
  bool sampled = depth < 0.0;
  depth += sampled ? 2.0 : 0.0;
#if OUTLINES == 1
  for (; sampled; sampled = false) // left where no pixel of several goes on
  {
    Mean mean = meanAt(at);
    flattened = mean.colour;
    depth = mean.depth;
  }
#elif OUTLINES == 2
  flattened.a = sampled ? 0.0 : flattened.a;
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
