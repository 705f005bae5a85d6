#version 430
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The mean of what the four samples of a pixel show that an outline runs through: of the shaded
// pixels of a layer that they take after (vtkPointSplatOutlines.h), with the share that these cover
// as opacity, at the depth of the nearest; FLAT: of what all layers were flattened to.
// An invocation has a pixel. Writes: Means (vtkPointSplatOutlineMeans.h).

#ifndef FLAT
#include "vtkPointSplatShadedTexel"
#include "vtkPointSplatShownTexel"
#endif
#include "vtkPointSplatOutline"

layout(local_size_x = 64) in;

uniform usamplerBuffer OutlinePixels; // R32UI, see vtkPointSplatOutlines.h
uniform int OutlineCount;
layout(std430, binding = 0) writeonly buffer Means { uvec4 means[]; };
#ifdef FLAT
uniform sampler2D Flattened;     // premultiplied
uniform sampler2D NearestDepths; // less 2 where an outline runs through the pixel
#else
uniform int Layer;
uniform bool Blends; // with what the framebuffer has; else pixels are covered or not
#endif

// What a pixel shows: premultiplied colour, depth (FLAT: in the window; else behind the near plane),
// coded normal. False: nothing.
bool shownAt(ivec2 at, out vec4 colour, out float depth, out uint normal)
{
#ifdef FLAT
  colour = texelFetch(Flattened, at, 0);
  depth = texelFetch(NearestDepths, at, 0).r;
  depth += depth < 0.0 ? 2.0 : 0.0;
  normal = 0u;
  return colour.a > 0.0;
#else
  uvec4 texel = fetchLayer(at, Layer);
  Shaded s = shadeTexel(texel, at, Layer);
  colour = vec4(s.colour.a * s.colour.rgb, s.colour.a);
  depth = uintBitsToFloat(texel.x);
  normal = encodeNormal(s.normalVC);
  return isShown(texel);
#endif
}

void main()
{
  int index = int(gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 64 +
    int(gl_LocalInvocationID.x);
  if (index >= OutlineCount)
  {
    return;
  }
  int place = int(texelFetch(OutlinePixels, index).r & 0xfffffffu);
  ivec2 pixel = ivec2(place % OutlineImage.x, place / OutlineImage.x);
  uint counts = countsOf(texelFetch(OutlineChoices, index).r);
  vec4 sum = vec4(0.0);
  float covered = 0.0;
  float nearest = 3e38;
  uint nearestNormal = 0u;
  ivec2 at;
  float share;
  while (nextPixel(counts, pixel, at, share))
  {
    vec4 colour;
    float depth;
    uint normal;
    bool shown = shownAt(at, colour, depth, normal);
    sum += shown ? share * colour : vec4(0.0);
    covered += shown ? share : 0.0;
    bool nearer = shown && depth < nearest;
    nearest = nearer ? depth : nearest;
    nearestNormal = nearer ? normal : nearestNormal;
  }
#ifndef FLAT
  sum *= Blends ? 1.0 : covered < 0.5 ? 0.0 : 1.0 / covered;
#endif
  means[index] = uvec4(packHalf2x16(sum.rg), packHalf2x16(sum.ba), floatBitsToUint(nearest),
    nearestNormal);
}
