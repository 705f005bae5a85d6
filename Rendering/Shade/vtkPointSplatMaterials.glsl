// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a surface looks like: the materials of the actors (vtkPointSplatMaterials.h), and their
// light. ONE_MATERIAL: there is one actor, whose material comes as uniforms. TWO_SIDED: some actor's
// back faces look otherwise. COLOURED: some points have colours of their own. PHYSICAL: some actor's
// interpolation is physically based. LOOKS: some have textures, tangents or edges.

#include "vtkPointSplatLighting"
#include "vtkPointSplatRay"
#ifdef LOOKS
#include "vtkPointSplatShownLook"
#endif
#ifdef PHYSICAL
#include "vtkPointSplatPhysical"

const int MaterialTexels = 16;
#else

const int MaterialTexels = 11;
#endif

#ifdef ONE_MATERIAL
uniform vec4 OneMaterial[MaterialTexels];

vec4 materialTexel(int slot, int k)
{
  return OneMaterial[k];
}
#else
uniform samplerBuffer MaterialTable; // RGBA32F

vec4 materialTexel(int slot, int k)
{
  return texelFetch(MaterialTable, slot * MaterialTexels + k);
}
#endif

// Of a dielectric: index of refraction, its spread from green to blue, the longest way through the
// body (world units), and 1 if it refracts at all.
vec4 mediumOf(int slot)
{
  return materialTexel(slot, 8);
}

// 1 / world units; and the longest way from one dielectric to another, world units.
vec4 absorptionOf(int slot)
{
  return materialTexel(slot, 9);
}

// How bright a mean of unit normals is, by its length, which tells whether they agree: where a
// patch of normals that point outward meets one that points inward they cancel, and a mesh of
// these points is dark, but for ambient light. From the mean of unit normals that stand 53 degrees
// off it on, all is: any crease keeps its light.
const float FullAgreement = 0.6;

// The shaded colour and opacity of a surface point. normalVC: turned where the back is shown, as VTK turns
// the normals of back faces. colour: the points'. own: whether that holds the actor's colour and opacity.
vec4 shadeSurface(
  int slot, vec3 positionVC, inout vec3 normalVC, vec4 colour, bool own, bool back)
{
  normalVC = back ? -normalVC : normalVC;
#ifdef TWO_SIDED
#define SIDE_TEXEL(k) (back ? materialTexel(slot, 4 + k) : materialTexel(slot, k))
#else
#define SIDE_TEXEL(k) materialTexel(slot, k)
#endif
  vec4 ambient = SIDE_TEXEL(0);
  vec4 diffuse = SIDE_TEXEL(1);
  vec4 specular = SIDE_TEXEL(2);
  vec4 plain = SIDE_TEXEL(3);
  Material m = Material(ambient.rgb, diffuse.rgb, specular.rgb, diffuse.w, plain.z > 0.0);
  float opacity = ambient.w;
#ifdef COLOURED
  bool coloured = own || plain.w > 0.0;
  m.ambient = coloured ? plain.x * colour.rgb : m.ambient;
  m.diffuse = coloured ? plain.y * colour.rgb : m.diffuse;
  opacity = own ? colour.a : coloured ? opacity * colour.a : opacity;
#endif
#ifdef LIGHT_MAPS
  asksLightMaps = specular.w > 0.0;
#endif
#ifdef LOOKS
  // Edges are not lit.
  vec3 edgeColour = materialTexel(slot, 10).rgb;
  vec3 smoothNormal = normalVC;
  normalVC = look.isSet ? look.normal : normalVC;
#endif
  vec3 shaded = shade(m, positionVC, normalVC);
#ifdef LOOKS
  bool multiplies = look.isSet;
#endif
#ifdef PHYSICAL
  // These formulas are not for unlit surfaces, nor for scenes without any light.
#if LIGHT_LEVEL > 0 || defined(RADIANCE)
  vec4 physical[3] =
    vec4[3](materialTexel(slot, 11), materialTexel(slot, 12), materialTexel(slot, 13));
  if (physical[0].w > 0.0 && m.lit)
  {
    Physical p = physicalOf(physical);
    vec3 albedo = m.diffuse;
#ifdef LOOKS
    p.coatNormal = smoothNormal;
    if (look.isSet)
    {
      addLook(p, smoothNormal, materialTexel(slot, 14), materialTexel(slot, 15));
      albedo *= look.colour.rgb;
      // As VTK has it, the opacity is that of the texture.
      opacity = materialTexel(slot, 15).y > 0.0 ? look.colour.a : opacity;
    }
    multiplies = false;
#endif
    shaded = shadePhysical(p, albedo, positionVC, normalVC);
  }
#endif
#endif
#ifdef LOOKS
  shaded = mix(shaded, edgeColour, look.edge);
  if (multiplies)
  {
    shaded *= look.colour.rgb;
    opacity *= look.colour.a;
  }
#endif
  return vec4(shaded, opacity);
}
