#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From the surface layers that a light sees to a layer of a map of how much light passes them
// (vtkPointSplatLightMaps.h).

#include "vtkPointSplatLayers"

uniform samplerBuffer SlotColours; // RGBA32F, of the clouds: colour and opacity, times the points'
uniform int Layer;
uniform ivec4 Window; // beside which nothing is in the layers: first x, y, last x, y
uniform bool IsLastLayer; // which takes in what is behind
uniform float DepthOffset; // of depths behind the near plane to the light's, world units
uniform float DepthRange;

layout(location = 0) out uvec2 depthAndPassed;

void main()
{
  // Rows of the layers run the other way, so that the light's coordinates are not mirrored in them.
  ivec2 at = ivec2(gl_FragCoord.x, float(LayerSize.y) - gl_FragCoord.y);
  bool inside = at == clamp(at, Window.xy, Window.zw);
  int last = inside ? min(IsLastLayer ? LayerCount : Layer + 1, LayerCount) : 0;
  vec3 passed = vec3(1.0);
  uint depth = 0xffffffffu;
  for (int k = 0; k < last; ++k)
  {
    uvec4 texel = fetchLayer(at, k);
    if (isEmpty(texel))
    {
      break;
    }
    Surface s = unpackTexel(texel);
    vec4 colour = s.colour * texelFetch(SlotColours, int(s.tag >> 1));
    float opacity = s.coverage * colour.a;
    passed *= (1.0 - opacity) * (1.0 + opacity * colour.rgb);
    if (k == Layer)
    {
      depth = uint(clamp((s.depth + DepthOffset) / DepthRange, 0.0, 1.0) * 16777215.0) << 8;
    }
    if (isLast(texel))
    {
      break;
    }
  }
  uvec3 parts = uvec3(round(clamp(passed, 0.0, 1.0) * 255.0));
  depthAndPassed = uvec2(depth, parts.r << 16 | parts.g << 8 | parts.b);
}
