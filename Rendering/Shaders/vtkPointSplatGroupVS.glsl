#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Projects a splat for the geometry pass of deferred blending: once for the
// kernel, and once more as its bare disk, which tells where the surface is.

#include "vtkPointSplatQuad"

uniform float DiskReach;      // radii
uniform float CoverageRadius; // pixels

flat out vec3 diskS;
flat out vec3 diskT;
flat out vec3 diskSlopeAndReach; // a reach of 0: there is no disk

void main()
{
  if (!spanQuad())
  {
    return;
  }
  Splat disk;
  bool seen = project(positionAndRadius.xyz, normals, axis1MC, axis2MC, positionAndRadius.w,
    DiskReach, CoverageRadius, disk);
  diskS = disk.s;
  diskT = disk.t;
  diskSlopeAndReach = vec3(disk.slope, seen ? DiskReach : 0.0);
}
