#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Projects a splat for the geometry pass of deferred blending: once for the
// kernel, and once more as its bare disk, which tells where the surface is.

#include "vtkPointSplatQuad"

uniform float DiskReach;      // radii
uniform vec2 CoverageRadii;   // pixels, as LeastRadii

flat out vec4 diskNarrow;
flat out vec3 diskLeanAndReach; // a reach of 0: there is no disk

void main()
{
  if (!spanQuad())
  {
    return;
  }
  Splat disk;
  bool seen = project(positionAndRadius.xyz, shape, axis1MC, axis2MC, positionAndRadius.w,
    DiskReach, CoverageRadii, disk);
  diskNarrow = disk.narrow;
  diskLeanAndReach = vec3(disk.lean, seen ? DiskReach : 0.0);
}
