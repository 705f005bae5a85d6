#version 330
#extension GL_ARB_shading_language_packing : enable
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Shades all surface layers of a pixel and blends them, the nearest over those behind it.
// Writes: premultiplied colour and opacity; the nearest layer's depth, less 2 where an outline runs
// through the pixel.
// REFLECTION: some surfaces reflect the environment. REFLECTION_ALONE: the layer is another's to
// draw, but for what it reflects.

#include "vtkPointSplatShadedTexel"
#ifdef REFLECTION
#include "vtkPointSplatReflection"
#endif

layout(location = 0) out vec4 colour;
layout(location = 1) out vec4 nearestDepth; // of opacity 1, so that blending replaces it

void main()
{
  ivec2 at = ivec2(gl_FragCoord.xy);
  uvec4 texel = fetchLayer(at, 0);
  bool there = !isEmpty(texel);
  if (!there && !isOutline(texel))
  {
    discard;
  }
  float depth = there ? windowDepth(-(NearDistance + uintBitsToFloat(texel.x))) : 1.0;
  nearestDepth = vec4(depth - (isOutline(texel) ? 2.0 : 0.0));
  nearestDepth.a = 1.0;
  colour = vec4(0.0);
  for (int layer = 0; layer < LayerCount; ++layer)
  {
    texel = fetchLayer(at, layer);
    there = there && !isEmpty(texel);
#ifndef REFLECTION
    // Reflections have derivatives, which all fragments of a block must take part in.
    if (!there)
    {
      break;
    }
#endif
    Shaded s = shadeTexel(texel, at, layer);
    vec4 shaded = vec4(s.colour.a * s.colour.rgb, s.colour.a);
#ifdef REFLECTION_ALONE
    shaded = vec4(0.0);
#endif
#ifdef REFLECTION
    shaded = addReflection(s.slot, s.positionVC, s.normalVC, s.back, shaded);
#endif
    colour += there ? (1.0 - colour.a) * shaded : vec4(0.0);
    there = there && !isLast(texel);
  }
}
