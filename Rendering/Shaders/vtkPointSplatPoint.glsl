// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A point as image-space reconstruction projects it: the one pixel that it falls
// into (Dobrev, Rosenthal, Linsen 2010, section 3.1). It is a splat without extent, so
// that layers are told apart as those of splats are.

#include "vtkPointSplatProjection"

// The least layer distance of points: the larger of these. Points of one surface in one
// pixel may lie a pixel's width apart along the normal.
uniform float PointLayer;       // world units
uniform float PointLayerPixels; // pixels

// False: nothing can be seen of the point. pixel: where it falls.
bool projectPoint(vec3 positionMC, uvec2 normals, float radius, out Splat q, out ivec2 pixel)
{
  vec4 p = MCVC * vec4(positionMC, 1.0);
  q.positionVC = p.xyz;
  q.depth = -p.z - DepthRange.x;
  float w = dot(PixelW, p);
  vec2 xy = vec2(dot(PixelX, p), dot(PixelY, p)) / w;
  if (!(w > 0.0 && q.depth > 0.0 && q.depth < DepthRange.y) ||
    !(xy.x >= float(Window.x) && xy.y >= float(Window.y) && xy.x < float(Window.z + 1) &&
      xy.y < float(Window.w + 1)))
  {
    return false;
  }
  pixel = ivec2(xy);
  q.centre = xy;
  q.normal = normalize(NormalMatrix * decodeNormal(normals.y));
  float towards = Parallel ? q.normal.z : -dot(q.normal, p.xyz);
  bool back = towards < 0.0;
  if ((back && (Culling & 1) != 0) || (!back && (Culling & 2) != 0))
  {
    return false;
  }
  q.tag = Tag | (back ? 1u : 0u);
  q.facing = Parallel ? abs(q.normal.z) : abs(towards) / max(abs(p.z), 1e-30);
  q.layer = max(PointLayer, PointLayerPixels * w / length(PixelX.xyz));
  for (int i = 0; i < ClipPlaneCount; ++i)
  {
    if (dot(ClipPlanes[i], p) < 0.0)
    {
      return false;
    }
  }
  return true;
}
