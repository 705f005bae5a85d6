// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The rays through the pixels of the viewport, in view coordinates.

#include "vtkPointSplatPixels"

uniform float NearDistance;
uniform mat2 PixelInverse; // x w and y w, pixels, to x and y of view coordinates
uniform vec4 PixelOffset;  // of x w and y w, for a step of z; constant
uniform vec4 PixelZ;       // view coordinates to z w, as OpenGL clips it

// The point at this z in view coordinates on the ray through the middle of a pixel.
vec3 pointOfPixel(ivec2 at, float z)
{
  float w = PixelW.z * z + PixelW.w;
  return vec3(
    PixelInverse * ((vec2(at) + 0.5) * w - PixelOffset.xy * z - PixelOffset.zw), z);
}

// As OpenGL has it in the depth buffer, of a point at this z.
float windowDepth(float z)
{
  return clamp(
    0.5 * (PixelZ.z * z + PixelZ.w) / (PixelW.z * z + PixelW.w) + 0.5, 0.0, 1.0);
}

// From the eye to a point, of unit length.
vec3 eyeRay(vec3 positionVC)
{
  return Parallel ? vec3(0.0, 0.0, -1.0) : normalize(positionVC);
}

// Whether a surface shows its back: its splat's plane does, as the tag says, and here, where the splat may bend, its
// normal points away from the viewer. One that leans over from the plane of a front as far as to point away is a front's.
bool isBack(uint tag, vec3 normalVC, vec3 positionVC)
{
  bool away = Parallel ? normalVC.z < 0.0 : dot(normalVC, positionVC) > 0.0;
  return (tag & 1u) != 0u && away;
}
