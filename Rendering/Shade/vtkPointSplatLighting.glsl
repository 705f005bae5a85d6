// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// VTK's Phong lighting, term by term as vtkOpenGLPolyDataMapper has it for each of its levels,
// since users put clouds and meshes into one scene.
// LIGHT_LEVEL: 0 no light, 1 one headlight, 2 directional lights, 3 positional too. SPECULAR: some
// surface has highlights. UNLIT: some surface is not lit. FACTORS: points have factors of lights.
// PASS_FACTORS: so does the pixel, by a render pass. LIGHT_MAPS: translucent splats cast shadows
// (vtkPointSplatLightMaps).

#include "vtkPointSplatLightMaps"

#if LIGHT_LEVEL > 0
uniform vec4 LightColour[LIGHT_COUNT];      // and whether it is positional
uniform vec4 LightDirection[LIGHT_COUNT];   // view coordinates, from the light; component of
                                            // lightFactors, or -1
uniform vec4 LightPosition[LIGHT_COUNT];    // view coordinates; half angle of the cone, degrees
uniform vec4 LightAttenuation[LIGHT_COUNT]; // constant, linear, quadratic; the cone's exponent
#endif
#ifdef FACTORS
// How much of each light arrives at what is shaded (Dobrev, Rosenthal, Linsen 2010, section 6).
vec4 lightFactors = vec4(1.0);
#endif
#ifdef PASS_FACTORS
// The same of each light, as the render pass has it that draws shadow maps.
float passFactors[LIGHT_COUNT];
#endif

#ifdef LIGHT_MAPS
bool asksLightMaps = true; // whether such shadows fall on the surface
#endif

// How much of the lights' light a surface keeps whose normals contradict one another.
float keptLight = 1.0;

struct Material
{
  vec3 ambient;
  vec3 diffuse;
  vec3 specular;
  float power;
  bool lit;
};

#if LIGHT_LEVEL > 1
// How much of a light arrives at a point; direction: from the light.
float lightAt(int i, vec3 positionVC, out vec3 direction)
{
  direction = LightDirection[i].xyz;
  float attenuation = 1.0;
#if LIGHT_LEVEL > 2
  if (LightColour[i].w > 0.0)
  {
    vec3 from = positionVC - LightPosition[i].xyz;
    float distance = length(from);
    vec3 axis = direction;
    direction = from / distance;
    attenuation = 1.0 / dot(LightAttenuation[i].xyz, vec3(1.0, distance, distance * distance));
    if (LightPosition[i].w < 90.0)
    {
      float coneDot = dot(direction, axis);
      attenuation *= coneDot >= cos(radians(LightPosition[i].w))
        ? pow(coneDot, LightAttenuation[i].w)
        : 0.0;
    }
  }
#endif
#ifdef FACTORS
  int component = int(LightDirection[i].w);
  attenuation *= component < 0 ? 1.0 : lightFactors[component];
#endif
#ifdef PASS_FACTORS
  attenuation *= passFactors[i];
#endif
  return attenuation;
}
#endif

#if LIGHT_LEVEL > 1
// What of a light's colour translucent surfaces let pass to a point.
vec3 colourOfLight(int i, vec3 positionVC, vec3 normalVC)
{
#ifdef LIGHT_MAPS
  vec3 passed = lightPassed(i, positionVC, normalVC);
  return LightColour[i].rgb * (asksLightMaps ? passed : vec3(1.0));
#else
  return LightColour[i].rgb;
#endif
}
#endif

// positionVC, normalVC: view coordinates, the normal of unit length and towards
// the viewer.
vec3 shade(Material m, vec3 positionVC, vec3 normalVC)
{
#if LIGHT_LEVEL == 0
  vec3 colour = m.ambient;
#elif LIGHT_LEVEL == 1
  float df = max(0.0, normalVC.z);
  vec3 colour = df * m.diffuse;
#ifdef SPECULAR
  float sf = df > 0.0 ? pow(df, m.power) : 0.0;
  colour += sf * m.specular;
#endif
  colour = m.ambient + keptLight * colour * LightColour[0].rgb;
#else
  vec3 diffuse = vec3(0.0);
  vec3 specular = vec3(0.0);
  vec3 view = normalize(-positionVC);
  for (int i = 0; i < LIGHT_COUNT; ++i)
  {
    vec3 direction;
    float attenuation = lightAt(i, positionVC, direction);
    vec3 lightColour = colourOfLight(i, positionVC, normalVC);
    float df = max(0.0, attenuation * dot(normalVC, -direction));
    diffuse += df * lightColour;
#ifdef SPECULAR
    float reflected = max(0.0, dot(reflect(direction, normalVC), view));
    float sf = df > 0.0 ? attenuation * pow(reflected, m.power) : 0.0;
    specular += sf * lightColour;
#endif
  }
  vec3 colour = m.ambient + keptLight * (diffuse * m.diffuse + specular * m.specular);
#endif
#ifdef UNLIT
  colour = m.lit ? colour : m.ambient + m.diffuse;
#endif
  return colour;
}
