#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The compositing pass of group-sorted transparency: adds one group's image, by its
// share, to the average of all. DEPTH: its depth, of which blending takes the minimum.

#include "vtkPointSplatRay"

uniform sampler2D GroupDepth;
#ifdef DEPTH
uniform float DepthRange;      // from the near plane to the far one, world units

layout(location = 0) out vec4 nearestDepth;
#else
uniform sampler2D GroupColour; // premultiplied
uniform float Share;           // one over the number of groups

layout(location = 0) out vec4 average;
#ifdef LAYER_COUNT
uniform sampler2D GroupLayerCount;
layout(location = 1) out vec4 layerCount; // and of groups that have some
#endif
#endif

void main()
{
  ivec2 at = ivec2(gl_FragCoord.xy);
  float depth = texelFetch(GroupDepth, at, 0).r;
  if (depth >= 1.0)
  {
    discard;
  }
#ifdef DEPTH
  nearestDepth = vec4(windowDepth(-(depth * DepthRange + NearDistance)));
#else
  average = Share * texelFetch(GroupColour, at, 0);
#ifdef LAYER_COUNT
  float layers = texelFetch(GroupLayerCount, at, 0).r;
  layerCount = vec4(layers, min(layers, 1.0), 0.0, 0.0);
#endif
#endif
}
