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
#ifdef LOOKS
  vec3 coatNormal;
  vec3 emission;
  float occlusion;  // of what there would be
  bool anisotropic;
  float anisotropy;
  vec3 tangent;
  vec3 bitangent;
#endif
};

Physical physicalOf(vec4 texels[3])
{
  return Physical(texels[0].x, texels[0].y, texels[0].z, texels[1].rgb, texels[1].w, texels[2].w,
    texels[0].w - 1.0, texels[2].rgb
#ifdef LOOKS
    , vec3(0.0), vec3(0.0), 1.0, false, 0.0, vec3(0.0), vec3(0.0)
#endif
  );
}

#ifdef LOOKS
// What textures and tangents say. smoothNormal: before it was turned by a map; first, second: texels
// 14 and 15 of the material.
void addLook(inout Physical p, vec3 smoothNormal, vec4 first, vec4 second)
{
  p.roughness *= look.factors.y;
  p.metallic *= look.factors.z;
  p.occlusion = mix(1.0, look.factors.x, first.w);
  p.emission = first.rgb * look.emission;
  p.anisotropy = second.x * look.factors.w;
#if LOOKS > 1
  p.coatNormal = look.coatNormal;
  p.anisotropic = second.z > 0.0;
  p.tangent = look.tangent;
  p.bitangent = cross(smoothNormal, look.tangent);
#endif
}

// The lobe of a roughness along the tangent and another one along the bitangent (Burley 2012,
// Physically based shading at Disney, with VTK's aspect).
// n: dot products of the normal with the other three.
float anisotropicLobe(Physical p, vec3 halfway, vec3 light, vec3 view, vec3 n)
{
  float r2 = p.roughness * p.roughness;
  float aspect = sqrt(1.0 - 0.9 * p.anisotropy);
  float at = max(r2 / aspect, 0.001);
  float ab = max(r2 * aspect, 0.001);
  float a2 = at * ab;
  vec3 d = vec3(ab * dot(p.tangent, halfway), at * dot(p.bitangent, halfway), a2 * n.x);
  float b2 = a2 / dot(d, d);
  float lambdaV = n.z * length(vec3(at * dot(p.tangent, view), ab * dot(p.bitangent, view), n.y));
  float lambdaL =
    n.y * length(vec3(at * dot(p.tangent, light), ab * dot(p.bitangent, light), n.z));
  return a2 * b2 * b2 / Pi * 0.5 / (lambdaV + lambdaL);
}
#endif

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

// What of a light's radiance the surface's lobes turn to the eye.
struct Lobes
{
  float NdL;
  float HdL;
  float own;
  float coatNdL;
  float coat;
};

// light: to the light; halfway: between that and view.
Lobes lobesOf(Physical p, vec3 normalVC, vec3 view, vec3 light, vec3 halfway)
{
  float NdV = clamp(dot(normalVC, view), 1e-5, 1.0);
  float NdL = clamp(dot(normalVC, light), 1e-5, 1.0);
  float NdH = clamp(dot(normalVC, halfway), 1e-5, 1.0);
  Lobes l;
  l.NdL = NdL;
  l.HdL = clamp(dot(halfway, light), 1e-5, 1.0);
  l.own = lobe(NdH, NdV, NdL, p.roughness);
#ifdef LOOKS
  vec3 n = p.coatNormal;
  l.own =
    p.anisotropic ? anisotropicLobe(p, halfway, light, view, vec3(NdH, NdV, NdL)) : l.own;
  l.coatNdL = clamp(dot(n, light), 1e-5, 1.0);
  l.coat = lobe(clamp(dot(n, halfway), 1e-5, 1.0), clamp(dot(n, view), 1e-5, 1.0), l.coatNdL,
    p.coatRoughness);
#else
  l.coatNdL = NdL;
  l.coat = lobe(NdH, NdV, NdL, p.coatRoughness);
#endif
  return l;
}

// What of a light's radiance arrives at the eye.
vec3 reflectedLight(Physical p, vec3 albedo, vec3 f0, vec3 f90, Lobes l, vec3 radiance)
{
  vec3 f = fresnel(f0, f90, l.HdL);
  vec3 specular = l.own * f;
  vec3 diffuse = (1.0 - p.metallic) * (1.0 - f) * albedo / Pi;
  vec3 fc = fresnel(vec3(p.coatF0), vec3(1.0), l.HdL);
  vec3 coat = l.coat * fc * p.coat;
  fc *= p.coat;
  specular *= (1.0 - fc) * (1.0 - fc);
  diffuse *= 1.0 - fc;
  vec3 tint = mix(vec3(1.0), p.coatColour, p.coat);
  return radiance * (l.coatNdL * coat + l.NdL * tint * (diffuse + specular));
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
  vec3 bent = normalVC;
  vec3 coatNormal = normalVC;
#ifdef LOOKS
  coatNormal = p.coatNormal;
  vec3 across = cross(cross(p.bitangent, view), p.bitangent);
  bent = p.anisotropic ? normalize(mix(normalVC, across, p.anisotropy)) : normalVC;
#endif
  vec3 mirrored = normalize(RadianceFromView * reflect(-view, bent));
  vec3 coatMirrored = normalize(RadianceFromView * reflect(-view, coatNormal));
  float coatNdV = clamp(dot(coatNormal, view), 1e-5, 1.0);
  vec2 split = texture(RadianceTable, vec2(NdV, p.roughness)).rg;
  vec3 specular = prefilteredAlong(mirrored, p.roughness);
  vec3 diffuse = irradianceAlong(RadianceFromView * normalVC);
#ifdef MULTIPLE_SCATTERING
  // What is scattered once, and, about alike to all sides, more than once (Fdez-Aguera 2019, A
  // Multiple-Scattering Microfacet Model for Real-Time Image-Based Lighting).
  vec3 grazing = max(vec3(1.0 - p.roughness), f0) - f0;
  vec3 once = (f0 + grazing * pow(1.0 - NdV, 5.0)) * split.r + f90 * split.g;
  float rest = 1.0 - (split.r + split.g);
  vec3 mean = f0 + (1.0 - f0) / 21.0;
  vec3 more = rest * once * mean / max(1.0 - mean * rest, vec3(1e-5));
  specular *= once;
  diffuse *= more + (1.0 - p.metallic) * 0.96 * albedo * (1.0 - once - more);
#else
  specular *= f0 * split.r + f90 * split.g;
  diffuse *= (1.0 - f0) * (1.0 - p.metallic) * albedo;
#endif
  vec2 coatSplit = texture(RadianceTable, vec2(coatNdV, p.coatRoughness)).rg;
  vec3 fc = fresnel(vec3(p.coatF0), vec3(1.0), coatNdV) * p.coat;
  vec3 coat =
    prefilteredAlong(coatMirrored, p.coatRoughness) * (p.coatF0 * coatSplit.r + coatSplit.g) * fc;
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
  vec3 colour = vec3(0.0);
#if LIGHT_LEVEL == 1
  // The light is where the eye is.
  colour += keptLight *
    reflectedLight(p, albedo, f0, f90, lobesOf(p, normalVC, view, view, view), LightColour[0].rgb);
#elif LIGHT_LEVEL > 1
  for (int i = 0; i < LIGHT_COUNT; ++i)
  {
    vec3 direction;
    float attenuation = lightAt(i, positionVC, direction);
#if LIGHT_LEVEL > 2 && !defined(PHYSICAL_DIRECTIONS)
    // Beside positional lights VTK 9.1 takes directional ones too from where they stand.
    direction = normalize(positionVC - LightPosition[i].xyz);
#endif
    Lobes l = lobesOf(p, normalVC, view, -direction, normalize(view - direction));
    colour += keptLight *
      reflectedLight(p, albedo, f0, f90, l, attenuation * colourOfLight(i, positionVC, normalVC));
  }
#endif
#ifdef RADIANCE
  colour += reflectedRadiance(p, albedo, f0, f90, normalVC, view);
#endif
#ifdef LOOKS
  colour = p.occlusion * colour + p.emission;
#endif
  return pow(colour, vec3(1.0 / 2.2));
}
