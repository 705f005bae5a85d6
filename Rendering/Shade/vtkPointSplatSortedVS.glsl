#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The quads of splats in an order that is given: four vertices a splat, without instances, so that
// drivers which run on a CPU can take many vertices at once.

#define FETCHED
#include "vtkPointSplatQuad"
#include "vtkPointSplatColourCode"

uniform usamplerBuffer Order;   // R32UI: splats
uniform int FirstEntry;         // that is drawn
uniform usamplerBuffer Splats;  // RGBA32UI, two or four a splat: see vtkPointSplatCloud.h
uniform usamplerBuffer Colours; // R32UI, where HasColours
uniform bool HasColours;
#ifdef CLIP_LINES
uniform samplerBuffer ClipLineTexels; // RGBA32F, where HasClipLines
#endif
#ifdef FACTORS
uniform usamplerBuffer Factors; // R32UI, where HasFactors
#endif

void main()
{
  int splat = int(texelFetch(Order, FirstEntry + (gl_VertexID >> 2)).r);
  int at = splat * (Circular ? 2 : 4);
  uvec4 a = texelFetch(Splats, at);
  uvec4 b = texelFetch(Splats, at + 1);
  positionAndRadius = uintBitsToFloat(a);
  shape = b.xyz;
  id = b.w;
  axis1MC = Circular ? vec3(0.0) : uintBitsToFloat(texelFetch(Splats, at + 2).xyz);
  axis2MC = Circular ? vec3(0.0) : uintBitsToFloat(texelFetch(Splats, at + 3).xyz);
  colour = HasColours ? unpackColour(texelFetch(Colours, splat).r) : vec4(1.0);
#ifdef FACTORS
  factorsOfLights = HasFactors ? unpackColour(texelFetch(Factors, splat).r) : vec4(1.0);
#endif
#ifdef CLIP_LINES
  clipLines = HasClipLines ? texelFetch(ClipLineTexels, splat) : vec4(0.0);
#endif
  spanQuad();
}
