// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A fragment of what the rasteriser draws: of a splat by its quad, or (POINTS) of a point that is
// projected as a single pixel.

#include "vtkPointSplatIntersection"
#ifdef POINTS
#include "vtkPointSplatPointFS"
#include "vtkPointSplatPointWeight"
#else
#include "vtkPointSplatQuadFS"
#include "vtkPointSplatKernel"

uniform float Reach; // radii
uniform vec4 Kernel; // as kernelWeight() takes it
#endif

struct Fragment
{
  Splat splat;
  float depth; // by which layers are told apart
  float shown; // where it is
  vec3 normal;
  float weight;
};

// False: the splat does not cover the pixel.
bool findFragment(out Fragment f)
{
#ifdef POINTS
  f.splat = fragmentPoint();
  f.depth = f.splat.depth;
  f.shown = undelayedDepth(f.splat);
  f.normal = f.splat.normal;
  f.weight = pointWeight(f.splat);
  return true;
#else
  f.splat = fragmentSplat();
  Hit hit;
  bool covers = intersect(f.splat, gl_FragCoord.xy, Reach, hit);
  f.depth = hit.depth;
  f.shown = hit.depth;
  f.normal = normalAt(f.splat, hit.uv);
  f.weight = hit.share * kernelWeight(hit.r2, Kernel);
  return covers;
#endif
}

#ifndef POINTS
// As layerShare(), measured along the normal; nearest: the coded depth.
float shareInLayer(Fragment f, uint nearest)
{
  return layerShare((f.depth - decodeDepth(nearest)) * max(f.splat.facing, LeastFacing),
    f.splat.layer, isEdgeOn(f.splat.facing));
}
#endif
