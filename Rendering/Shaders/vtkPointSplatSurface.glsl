// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where a reconstructed surface layer lies and how: the point at a pixel in view
// coordinates, and what was summed up there.

#include "vtkPointSplatDepthCode"
#include "vtkPointSplatFetch"

uniform float NearDistance;
uniform vec4 PixelX;         // view coordinates to x w, in pixels of the images
uniform vec4 PixelY;
uniform vec4 PixelW;
uniform vec4 PixelZ;         // view coordinates to z w, as OpenGL clips it
uniform bool Parallel;

// The point at this z in view coordinates on the ray through the middle of a pixel.
vec4 pointOfPixel(ivec2 at, float z)
{
  float w = PixelW.z * z + PixelW.w;
  vec2 xy = (vec2(at) + 0.5) * w - vec2(PixelX.z, PixelY.z) * z - vec2(PixelX.w, PixelY.w);
  float det = PixelX.x * PixelY.y - PixelX.y * PixelY.x;
  return vec4(vec2(PixelY.y * xy.x - PixelX.y * xy.y,
                PixelX.x * xy.y - PixelY.x * xy.x) / det, z, 1.0);
}

// As OpenGL has it in the depth buffer.
float windowDepth(vec4 positionVC)
{
  float w = PixelW.z * positionVC.z + PixelW.w;
  return clamp(0.5 * dot(PixelZ, positionVC) / w + 0.5, 0.0, 1.0);
}

// The surface point at a pixel with this coded depth, the mean of the normals and of the colours;
// to be called by all fragments of a 2 x 2 block that have the surface.
void fetchSurface(ivec2 at, uint code, out vec4 positionVC, out vec3 normalVC, out vec4 colour)
{
  float behind;
  bool summed = fetchSums(at, normalVC, behind, colour);
  behind = summed ? behind : 0.0;
  positionVC = pointOfPixel(at, -(NearDistance + decodeDepth(code) + behind));

  // Where no kernel reaches the pixel, the nearest disks still tell how the surface lies.
  vec3 facet = cross(dFdx(positionVC.xyz), dFdy(positionVC.xyz));
  normalVC = summed ? normalVC : normalize(facet + vec3(0.0, 0.0, 1e-30));
  colour = summed ? colour : vec4(1.0);
}

// From the eye to a point, of unit length, in view coordinates.
vec3 eyeRay(vec3 positionVC)
{
  return Parallel ? vec3(0.0, 0.0, -1.0) : normalize(positionVC);
}

// Whether a normal points away from the viewer.
bool isBack(vec3 normalVC, vec3 positionVC)
{
  return Parallel ? normalVC.z < 0.0 : dot(normalVC, positionVC) > 0.0;
}
