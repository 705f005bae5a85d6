#version 330
#extension GL_ARB_sample_shading : enable
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Presents a pixel that an outline runs through as vtkPointSplatLayerFS does others: the mean of the
// shaded pixels that its samples take after, and the share that these cover as opacity, at the depth
// of the nearest. In multisampled framebuffers each sample has its own colour and depth, so that
// splats and meshes meet within pixels.
// Hooks as in vtkPointSplatLayerFS.

//PointSplat::Defines

//VTK::CustomUniforms::Dec

//VTK::DepthPeeling::Dec

#include "vtkPointSplatShadedTexel"
#include "vtkPointSplatOutline"

uniform ivec2 ImageOrigin; // the images' first pixel in the framebuffer
uniform int Layer;
uniform int OnlySlot;      // of the cloud that is presented; -1: of all
uniform bool Blends;       // with what the framebuffer has; else pixels are covered or not

void main()
{
  ivec2 at = ivec2(gl_FragCoord.xy) - ImageOrigin;
  vec4 sum = vec4(0.0);
  float covered = 0.0;
  vec3 positionVC = vec3(0.0, 0.0, -3e38);
  vec3 normalVC = vec3(0.0, 0.0, 1.0);
  uint counts = countsAbout();
  ivec2 pixelAt;
  float share;
  while (nextPixel(counts, at, pixelAt, share))
  {
    uvec4 texel = fetchLayer(pixelAt, Layer);
    if (isEmpty(texel) || (OnlySlot >= 0 && int(tagOfTexel(texel) >> 1) != OnlySlot))
    {
      continue;
    }
    Shaded s = shadeTexel(texel, pixelAt, Layer);
    sum += share * vec4(s.colour.a * s.colour.rgb, s.colour.a);
    covered += share;
    bool nearer = s.positionVC.z > positionVC.z;
    normalVC = nearer ? s.normalVC : normalVC;
    positionVC = nearer ? s.positionVC : positionVC;
  }
  if (covered == 0.0 || (!Blends && covered < 0.5))
  {
    discard;
  }
  sum /= Blends ? 1.0 : covered;
  gl_FragDepth = windowDepth(positionVC.z);

  //VTK::DepthPeeling::PreColor

  gl_FragData[0] = vec4(sum.rgb / max(sum.a, 1e-6), sum.a);
  //PointSplat::GeometryBuffer

  //VTK::DepthPeeling::Impl
}
