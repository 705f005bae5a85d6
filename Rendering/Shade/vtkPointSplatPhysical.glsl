// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Physically based interpolation as vtkOpenGLPolyDataMapper has it, term by term: a GGX lobe with the
// correlated Smith visibility term and Schlick's Fresnel term, a Lambertian one, a clear coat, and with
// RADIANCE image-based lighting by the renderer's textures (vtkPointSplatRadiance.h).
// SH_RADIANCE: diffuse light comes by spherical harmonics, else by a cube map.

#ifdef RADIANCE
uniform mat3 RadianceFromView;        // view coordinates to the environment's
uniform sampler2D RadianceTable;      // of the split sum: scale and bias of F0, by NdV and roughness
uniform samplerCube Prefiltered;      // a level of detail a roughness
uniform float PrefilteredLevels;      // the last level
#ifdef SH_RADIANCE
uniform vec4 Harmonics[9];
#else
uniform samplerCube Irradiance;
#endif
#endif

const float Pi = 3.14159265359;

struct Physical
{
  float metallic;
  float roughness;
  float f0;          // of what is no metal
  vec3 edgeTint;
  float coat;        // strength
  float coatRoughness;
  float coatF0;
  vec3 coatColour;
};

Physical physicalOf(vec4 texels[3])
{
  return Physical(texels[0].x, texels[0].y, texels[0].z, texels[1].rgb, texels[1].w, texels[2].w,
    texels[0].w - 1.0, texels[2].rgb);
}

vec3 fresnel(vec3 f0, vec3 f90, float HdL)
{
  return f0 + (f90 - f0) * pow(1.0 - HdL, 5.0);
}

// The lobe without its Fresnel term.
float lobe(float NdH, float NdV, float NdL, float roughness)
{
  float a = roughness * roughness;
  float a2 = a * a;
  float d = (NdH * a2 - NdH) * NdH + 1.0;
  // VTK takes the roughness itself for the root of the visibility term's alpha^2.
  float v2 = a;
  float ggxV = NdL * sqrt(v2 + NdV * (NdV - v2 * NdV));
  float ggxL = NdV * sqrt(v2 + NdL * (NdL - v2 * NdL));
  return a2 / (Pi * d * d) * 0.5 / (ggxV + ggxL);
}

struct Dots
{
  float NdV;
  float NdL;
  float NdH;
  float HdL;
};

// What of a light's radiance arrives at the eye.
vec3 reflectedLight(Physical p, vec3 albedo, vec3 f0, vec3 f90, Dots d, vec3 radiance)
{
  vec3 f = fresnel(f0, f90, d.HdL);
  vec3 specular = lobe(d.NdH, d.NdV, d.NdL, p.roughness) * f;
  vec3 diffuse = (1.0 - p.metallic) * (1.0 - f) * albedo / Pi;
  vec3 fc = fresnel(vec3(p.coatF0), vec3(1.0), d.HdL);
  vec3 coat = lobe(d.NdH, d.NdV, d.NdL, p.coatRoughness) * fc * p.coat;
  fc *= p.coat;
  specular *= (1.0 - fc) * (1.0 - fc);
  diffuse *= 1.0 - fc;
  vec3 tint = mix(vec3(1.0), p.coatColour, p.coat);
  return d.NdL * radiance * (coat + tint * (diffuse + specular));
}

#ifdef RADIANCE
vec3 irradianceAlong(vec3 n)
{
#ifdef SH_RADIANCE
  vec4 v = Harmonics[0] + Harmonics[1] * n.y + Harmonics[2] * n.z + Harmonics[3] * n.x +
    Harmonics[4] * n.x * n.y + Harmonics[5] * n.y * n.z + Harmonics[6] * (3.0 * n.z * n.z - 1.0) +
    Harmonics[7] * n.x * n.z + Harmonics[8] * (n.x * n.x - n.y * n.y);
  return max(v.rgb, vec3(0.0));
#else
  return texture(Irradiance, n).rgb;
#endif
}

vec3 prefilteredAlong(vec3 direction, float roughness)
{
  return textureLod(Prefiltered, direction, roughness * PrefilteredLevels).rgb;
}

vec3 reflectedRadiance(Physical p, vec3 albedo, vec3 f0, vec3 f90, vec3 normalVC, vec3 view)
{
  float NdV = clamp(dot(normalVC, view), 1e-5, 1.0);
  vec3 mirrored = normalize(RadianceFromView * reflect(-view, normalVC));
  vec2 split = texture(RadianceTable, vec2(NdV, p.roughness)).rg;
  vec3 specular = prefilteredAlong(mirrored, p.roughness) * (f0 * split.r + f90 * split.g);
  vec3 diffuse =
    (1.0 - f0) * (1.0 - p.metallic) * irradianceAlong(RadianceFromView * normalVC) * albedo;
  vec2 coatSplit = texture(RadianceTable, vec2(NdV, p.coatRoughness)).rg;
  vec3 fc = fresnel(vec3(p.coatF0), vec3(1.0), NdV) * p.coat;
  vec3 coat =
    prefilteredAlong(mirrored, p.coatRoughness) * (p.coatF0 * coatSplit.r + coatSplit.g) * fc;
  vec3 tint = mix(vec3(1.0), p.coatColour, p.coat);
  // As VTK has it, the coat takes nothing of the layer below, whose sum is made before.
  return tint * (specular + diffuse) + coat;
}
#endif

// positionVC, normalVC: as shade() takes them; albedo: times the diffuse intensity.
vec3 shadePhysical(Physical p, vec3 albedo, vec3 positionVC, vec3 normalVC)
{
  vec3 view = normalize(-positionVC);
  vec3 f0 = mix(vec3(p.f0), albedo, p.metallic);
  vec3 f90 = mix(vec3(clamp(dot(f0, vec3(50.0 * 0.33)), 0.0, 1.0)), p.edgeTint, p.metallic);
  float NdV = clamp(dot(normalVC, view), 1e-5, 1.0);
  vec3 colour = vec3(0.0);
#if LIGHT_LEVEL == 1
  // The light is where the eye is.
  colour += keptLight *
    reflectedLight(p, albedo, f0, f90, Dots(NdV, NdV, NdV, 1.0), LightColour[0].rgb);
#elif LIGHT_LEVEL > 1
  for (int i = 0; i < LIGHT_COUNT; ++i)
  {
    vec3 direction;
    float attenuation = lightAt(i, positionVC, direction);
#if LIGHT_LEVEL > 2
    // Beside positional lights VTK takes directional ones too from where they stand.
    direction = normalize(positionVC - LightPosition[i].xyz);
#endif
    vec3 h = normalize(view - direction);
    Dots d = Dots(NdV, clamp(-dot(normalVC, direction), 1e-5, 1.0),
      clamp(dot(normalVC, h), 1e-5, 1.0), clamp(-dot(h, direction), 1e-5, 1.0));
    colour += keptLight *
      reflectedLight(p, albedo, f0, f90, d, attenuation * colourOfLight(i, positionVC, normalVC));
  }
#endif
#ifdef RADIANCE
  colour += reflectedRadiance(p, albedo, f0, f90, normalVC, view);
#endif
  return pow(colour, vec3(1.0 / 2.2));
}
