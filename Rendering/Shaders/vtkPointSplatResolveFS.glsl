#version 330
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Normalises, shades and presents one cloud's part of a surface layer as
// ordinary geometry: colour, opacity and depth, so that the depth test, depth
// peeling and the passes that work on depth treat it as they treat a mesh.
// Hooks as in VTK's own fragment shaders let render passes add to it; names that
// their code declares (pixel, front, ...) are not used here.
// OUTPUT: 0 shaded, 1 one colour for hardware selection, 2 point ids for it, 3 shaded
// and premultiplied, with the depth, to be flattened with other layers.

//PointSplat::Defines

//VTK::CustomUniforms::Dec

//VTK::DepthPeeling::Dec

#include "vtkPointSplatFetch"
#include "vtkPointSplatLighting"

uniform ivec2 ImageOrigin;   // the images' first pixel in the framebuffer
uniform int Slot;            // of the cloud that is presented
uniform float NearDistance;
uniform vec4 PixelX;         // view coordinates to x w, in pixels of the images
uniform vec4 PixelY;
uniform vec4 PixelW;
uniform vec4 PixelZ;         // view coordinates to z w, as OpenGL clips it

uniform bool Parallel;
uniform bool HasColours;
uniform float Opacity[2];    // of front and of back faces
uniform vec3 Ambient[2];     // intensity times colour; the intensity alone with HasColours
uniform vec3 Diffuse[2];
uniform vec3 Specular[2];
uniform float SpecularPower[2];
uniform vec4 SelectionColour;
uniform int SelectionShift;

// The coded depth's low bits, as in vtkPointSplatProjection.
const uint TagMask = 127u;
const uint NoDepth = 0xffffffffu;
// The mean of unit normals that stand 53 degrees off it: any crease keeps its light.
const float FullAgreement = 0.6;

void main()
{
  ivec2 at = ivec2(gl_FragCoord.xy) - ImageOrigin;
  uint code = fetchDepth(at);
  if (code == NoDepth || int((code & TagMask) >> 1) != Slot)
  {
    discard;
  }
  vec3 normalVC;
  float behind;
  vec4 colour;
  bool summed = fetchSums(at, normalVC, behind, colour);
  behind = summed ? behind : 0.0;

  // The surface point: at this depth on the ray through the pixel's centre.
  float z = -(NearDistance + uintBitsToFloat(code & ~TagMask) + behind);
  float w = PixelW.z * z + PixelW.w;
  vec2 xy = (vec2(at) + 0.5) * w - vec2(PixelX.z, PixelY.z) * z - vec2(PixelX.w, PixelY.w);
  float det = PixelX.x * PixelY.y - PixelX.y * PixelY.x;
  vec4 positionVC = vec4(vec2(PixelY.y * xy.x - PixelX.y * xy.y,
                           PixelX.x * xy.y - PixelY.x * xy.x) / det, z, 1.0);
  gl_FragDepth = clamp(0.5 * dot(PixelZ, positionVC) / w + 0.5, 0.0, 1.0);

  // Where so many splats share a pixel that their sum is lost, the nearest disks
  // still tell how the surface lies.
  vec3 facet = cross(dFdx(positionVC.xyz), dFdy(positionVC.xyz));
  normalVC = summed ? normalVC : normalize(facet + vec3(0.0, 0.0, 1e-30));
  colour = summed ? colour : vec4(1.0);

  //VTK::DepthPeeling::PreColor

#if OUTPUT == 1
  gl_FragData[0] = SelectionColour;
#elif OUTPUT == 2
  uint id = fetchId(at);
  if (id == 0xffffffffu)
  {
    discard;
  }
  id >>= uint(SelectionShift);
  gl_FragData[0] = vec4(uvec4(id, id >> 8, id >> 16, 255u) & 255u) / 255.0;
#else
  // The mean normal, turned to the viewer as VTK turns the normals of back faces.
  // Its length tells whether the splats agree: where a patch of normals that point
  // outward meets one that points inward they cancel, and a mesh of these points
  // is dark.
  float l = length(normalVC);
  float agreement = clamp(l / FullAgreement, 0.0, 1.0);
  normalVC = l > 0.0 ? normalVC / l : vec3(0.0, 0.0, 1.0);
  bool back = Parallel ? normalVC.z < 0.0 : dot(normalVC, positionVC.xyz) > 0.0;
  normalVC = back ? -normalVC : normalVC;
  int side = back ? 1 : 0;
  Material m = Material(Ambient[side], Diffuse[side], Specular[side], SpecularPower[side]);
  if (HasColours)
  {
    m.ambient *= colour.rgb;
    m.diffuse *= colour.rgb;
  }
#ifdef FACTORS
  lightFactors = summed ? fetchFactors(at) : vec4(1.0);
#endif
  gl_FragData[0] = vec4(agreement * shade(m, positionVC.xyz, normalVC),
    Opacity[side] * (HasColours ? colour.a : 1.0));
#if OUTPUT == 3
  gl_FragData[0].rgb *= gl_FragData[0].a;
  gl_FragData[1] = vec4(gl_FragDepth);
#endif
  //PointSplat::GeometryBuffer
#endif

  //VTK::DepthPeeling::Impl
}
