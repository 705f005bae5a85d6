// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A point as image-space reconstruction projects it: the one pixel that it falls
// into (Dobrev, Rosenthal, Linsen 2010, section 3.1). It is a splat without extent, so
// that layers are told apart as those of splats are.

#include "vtkPointSplatIntersection"
#include "vtkPointSplatPointSide"

// The least layer distance of points: the larger of these. Points of one surface in one
// pixel may lie a pixel's width apart along the normal.
uniform float PointLayer;       // world units
uniform float PointLayerPixels; // pixels

// The uniforms that projectPoint needs. Who projects many points fetches them once.
struct Projector
{
  mat4 MCVC;
  mat3 normals;
  vec4 x;
  vec4 y;
  vec4 w;
  vec2 depthRange;
  vec4 window; // the pixels' edges
  bool parallel;
  int culling;
  uint tag;
  vec2 layer; // world units, pixels
};

Projector makeProjector()
{
  return Projector(MCVC, NormalMatrix, PixelX, PixelY, PixelW, DepthRange,
    vec4(Window.xy, Window.zw + 1), Parallel, Culling, Tag, vec2(PointLayer, PointLayerPixels));
}

// False: nothing can be seen of the point. normal: coded; pixel: where it falls.
bool projectPoint(Projector u, vec3 positionMC, uint normal, out Splat q, out ivec2 pixel)
{
  vec4 p = u.MCVC * vec4(positionMC, 1.0);
  q.positionVC = p.xyz;
  q.depth = -p.z - u.depthRange.x;
  float w = dot(u.w, p);
  q.centre = vec2(dot(u.x, p), dot(u.y, p)) / w;
  q.normal = normalize(u.normals * decodeNormal(normal));
  float towards = u.parallel ? q.normal.z : -dot(q.normal, p.xyz);
  bool back = towards < 0.0;
  bool seen = w > 0.0 && q.depth > 0.0 && q.depth < u.depthRange.y &&
    (u.culling & (back ? 1 : 2)) == 0 && q.centre.x >= u.window.x && q.centre.y >= u.window.y &&
    q.centre.x < u.window.z && q.centre.y < u.window.w;
  pixel = ivec2(seen ? q.centre : u.window.xy);
  q.tag = u.tag | (back ? 1u : 0u);
  q.facing = u.parallel ? abs(q.normal.z) : abs(towards) / max(abs(p.z), 1e-30);
  q.layer = max(u.layer.x, u.layer.y * w / length(u.x.xyz));
  q.depth += sideDelay(q.tag, q.layer);
#ifdef CLIPPING
  for (int i = 0; i < ClipPlaneCount; ++i)
  {
    seen = seen && dot(ClipPlanes[i], p) >= 0.0;
  }
#endif
  return seen;
}
