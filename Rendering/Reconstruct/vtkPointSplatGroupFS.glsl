#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The geometry pass of deferred blending (Zhang, Pajarola 2006, Algorithm 1, lines
// 5 to 10): one group's splats to that group's image. Within a group the depth
// test decides, by a Voronoi depth: what is coarsely at the same depth
// is told apart by the distance from the splat's centre, so that splats which
// overlap meet halfway instead of one lying over the other as a flap.
// Equation 10 rounds the depth to steps, and adds to it the ratio of distance and radius, times a step.
// Here the depth is not rounded: the ratio times the greatest layer distance is added to it. Of two
// splats of one surface that lie on both sides of a step, rounding lets the nearer one win whatever
// the ratio is, so that flaps stay along each step; without, they meet nearly halfway everywhere.
// Writes one RGBA32UI texel (see vtkPointSplatCompositeFS) and the depth.

#include "vtkPointSplatQuadFS"
#include "vtkPointSplatKernel"
#include "vtkPointSplatGroupTexel"

flat in vec4 diskNarrow;
flat in vec3 diskLeanAndReach;

uniform vec4 Kernel;        // as kernelWeight() takes it
uniform float NormalBend;     // 0: a splat has one normal
uniform float VoronoiScale; // world units; 0: plain depth

layout(location = 0) out uvec4 texel;
#ifdef FACTORS
layout(location = 1) out uint factorTexel; // 8 bits each
#endif

void main()
{
  Splat q = fragmentSplat();
  Hit hit;
  if (!intersect(q, gl_FragCoord.xy, KernelSupport, hit))
  {
    discard;
  }
  Splat disk = q;
  disk.narrow = diskNarrow;
  disk.lean = diskLeanAndReach.xy;
  Hit onto;
  bool onDisk = intersect(disk, gl_FragCoord.xy, diskLeanAndReach.z, onto);
  if (!onDisk && q.facing < SteepFacing)
  {
    // At a silhouette the kernel's tail would hide what is behind, which has only
    // one place in this group's image.
    discard;
  }
  // A weight never vanishes inside the support.
  float weight = max(hit.share * kernelWeight(hit.r2, Kernel), 1.0 / 4096.0);
  float along = q.layer / max(q.facing, LeastFacing);
  uint layer = encodeHalf(along / DepthUnit, !belongsToBothSides(q)) |
    (isEdgeOn(q.facing) ? EdgeOnLayer : 0u);
  texel = uvec4(encodeDepth(onDisk ? onto.depth : hit.depth, q.tag),
    encodeNormal(normalAt(q, NormalBend * hit.uv)),
    encodeHalf(weight, !onDisk) | layer << 16,
    packColour(splatColour));
#ifdef FACTORS
  factorTexel = packColour(splatFactors);
#endif
  // Off the disk comes last: a widened splat's tail would else hide the disk that
  // tells where the surface is.
  float rim = sqrt(hit.r2) / KernelSupport + (onDisk ? 0.0 : 1.0);
  gl_FragDepth = clamp(
    (hit.depth + VoronoiScale * rim) / (DepthRange.y + 2.0 * VoronoiScale), 0.0, 0.9999999);
}
