#version 330
#extension GL_ARB_shading_language_packing : enable
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How much a pixel would differ if its layers ended where less than some share of the light is left:
// a fragment has one of the image's pixels, which lie on a grid.
// 1. Blends all layers, as vtkPointSplatFlattenFS does, and as many as there are for each share.
// 2. Both over what is behind; where that is not known, over all greys, for which squares are averaged.
// Writes: for each share the mean square of the differences of red, green and blue; -1 where there
// is no layer. BLEND: the colour of all layers over what is behind, and 1 where there is a layer.

#include "vtkPointSplatShadedTexel"

const int Shares = 16;

uniform float EndLights[Shares];
uniform ivec2 GridSize;
uniform ivec4 GridWindow; // pixels that it lies on: first x, y, last x, y
uniform bool HasBehind;
uniform sampler2D Behind; // colours of background and opaque scene

layout(location = 0) out vec4 errors0;
#ifndef BLEND
layout(location = 1) out vec4 errors1;
layout(location = 2) out vec4 errors2;
layout(location = 3) out vec4 errors3;
#endif

void main()
{
  vec2 across = vec2(GridWindow.zw - GridWindow.xy + 1);
  ivec2 at = GridWindow.xy + ivec2(gl_FragCoord.xy / vec2(GridSize) * across);
  uvec4 texel = fetchLayer(at, 0);
  vec4 colour = vec4(0.0);
  vec4 ended[Shares];
  for (int k = 0; k < Shares; ++k)
  {
    ended[k] = colour;
  }
  bool there = !isEmpty(texel);
  bool any = there;
  for (int layer = 0; there && layer < LayerCount; ++layer)
  {
    Shaded s = shadeTexel(texel, at, layer);
    colour += (1.0 - colour.a) * vec4(s.colour.a * s.colour.rgb, s.colour.a);
    for (int k = 0; k < Shares; ++k)
    {
      ended[k] = 1.0 - ended[k].a >= EndLights[k] ? colour : ended[k];
    }
    there = !isLast(texel) && layer + 1 < LayerCount;
    texel = there ? fetchLayer(at, layer + 1) : uvec4(0u);
    there = there && !isEmpty(texel);
  }
  vec3 behind = HasBehind ? texelFetch(Behind, at, 0).rgb : vec3(0.5);
#ifdef BLEND
  errors0 = vec4(colour.rgb + (1.0 - colour.a) * behind, any ? 1.0 : 0.0);
#else
  float errors[Shares];
  for (int k = 0; k < Shares; ++k)
  {
    vec4 lost = colour - ended[k];
    vec3 difference = lost.rgb - lost.a * behind;
    float square = dot(difference, difference) / 3.0 + (HasBehind ? 0.0 : lost.a * lost.a / 12.0);
    errors[k] = any ? square : -1.0;
  }
  errors0 = vec4(errors[0], errors[1], errors[2], errors[3]);
  errors1 = vec4(errors[4], errors[5], errors[6], errors[7]);
  errors2 = vec4(errors[8], errors[9], errors[10], errors[11]);
  errors3 = vec4(errors[12], errors[13], errors[14], errors[15]);
#endif
}
