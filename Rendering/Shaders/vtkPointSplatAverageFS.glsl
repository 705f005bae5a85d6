#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The compositing pass of group-sorted transparency: adds one group's image, by its
// share, to the average of all; and, by the blending's minimum, its depth.

uniform sampler2D GroupColour; // premultiplied
uniform sampler2D GroupDepth;
uniform float Share;           // one over the number of groups
uniform vec2 DepthRange;       // distances of the near plane, and of the far from it
uniform vec4 PixelZ;           // view coordinates to z w
uniform vec4 PixelW;           // view coordinates to w

layout(location = 0) out vec4 average;
layout(location = 1) out float nearestDepth;
#ifdef LAYER_COUNT
uniform sampler2D GroupLayerCount;
layout(location = 2) out vec2 layerCount; // and of groups that have some
#endif

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float depth = texelFetch(GroupDepth, pixel, 0).r;
  if (depth >= 1.0)
  {
    discard;
  }
  average = Share * texelFetch(GroupColour, pixel, 0);
#ifdef LAYER_COUNT
  float layers = texelFetch(GroupLayerCount, pixel, 0).r;
  layerCount = vec2(layers, min(layers, 1.0));
#endif
  float z = -(depth * DepthRange.y + DepthRange.x);
  nearestDepth =
    clamp(0.5 * (PixelZ.z * z + PixelZ.w) / (PixelW.z * z + PixelW.w) + 0.5, 0.0, 1.0);
}
