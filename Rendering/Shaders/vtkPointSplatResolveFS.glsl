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
// and premultiplied, with the depth, to be flattened with other layers, 4 as 3 but what the
// surface reflects alone. REFLECTION: it reflects the environment.

//PointSplat::Defines

//VTK::CustomUniforms::Dec

//VTK::DepthPeeling::Dec

#include "vtkPointSplatSurface"
#include "vtkPointSplatAgreement"
#include "vtkPointSplatLighting"
#ifdef REFLECTION
#include "vtkPointSplatEnvironmentMap"
uniform float RefractiveIndex;
#endif

uniform ivec2 ImageOrigin;   // the images' first pixel in the framebuffer
uniform int Slot;            // of the cloud that is presented

uniform bool HasColours;
uniform float Opacity[2];    // of front and of back faces
uniform vec3 Ambient[2];     // intensity times colour; the intensity alone with HasColours
uniform vec3 Diffuse[2];
uniform vec3 Specular[2];
uniform float SpecularPower[2];
uniform vec4 SelectionColour;
uniform int SelectionShift;

// What the pixel's surface looks like. normalVC: the mean normal; it is turned to the viewer.
vec4 shadeSurface(vec3 positionVC, inout vec3 normalVC, vec4 colour, out bool back)
{
  // Turned as VTK turns the normals of back faces.
  float l = length(normalVC);
  normalVC = l > 0.0 ? normalVC / l : vec3(0.0, 0.0, 1.0);
  back = isBack(normalVC, positionVC);
  normalVC = back ? -normalVC : normalVC;
  int side = back ? 1 : 0;
  Material m = Material(Ambient[side], Diffuse[side], Specular[side], SpecularPower[side]);
  if (HasColours)
  {
    m.ambient *= colour.rgb;
    m.diffuse *= colour.rgb;
  }
  return vec4(agreementOf(l) * shade(m, positionVC, normalVC),
    Opacity[side] * (HasColours ? colour.a : 1.0));
}

void main()
{
  ivec2 at = ivec2(gl_FragCoord.xy) - ImageOrigin;
  uint code = fetchDepth(at);
  if (code == NoDepth || slotOf(code) != Slot)
  {
    discard;
  }
  vec4 positionVC;
  vec3 normalVC;
  vec4 colour;
  fetchSurface(at, code, positionVC, normalVC, colour);
  gl_FragDepth = windowDepth(positionVC);

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
#ifdef FACTORS
  lightFactors = fetchFactors(at);
#endif
  bool back;
  vec4 shaded = shadeSurface(positionVC.xyz, normalVC, colour, back);
#ifdef FILLED_IMAGES
  shaded.a *= fetchCoverage(at);
#endif
#if OUTPUT == 4
  gl_FragData[0] = vec4(0.0);
#else
  gl_FragData[0] = shaded;
#endif
#if OUTPUT >= 3
  gl_FragData[0].rgb *= gl_FragData[0].a;
  gl_FragData[1] = vec4(gl_FragDepth);
#endif
#ifdef REFLECTION
  // Light from the air; what meets a translucent body's far side from within is the business of
  // vtkPointSplatRefractionFS.
  vec3 ray = eyeRay(positionVC.xyz);
  vec3 reflected = environment(reflect(ray, normalVC));
  float share = back && gl_FragData[0].a < 1.0 ? 0.0
    : fresnelOfAir(RefractiveIndex, -dot(ray, normalVC));
  float opacity = mix(gl_FragData[0].a, 1.0, share);
#if OUTPUT == 0
  gl_FragData[0].rgb *= gl_FragData[0].a;
#endif
  gl_FragData[0] = vec4(mix(gl_FragData[0].rgb, reflected, share), opacity);
#if OUTPUT == 0
  gl_FragData[0].rgb /= max(opacity, 1e-6);
#endif
#endif
  //PointSplat::GeometryBuffer
#endif

  //VTK::DepthPeeling::Impl
}
