// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// VTK's Phong lighting, term by term as vtkOpenGLPolyDataMapper has it for
// each of its levels, since users put clouds and meshes into one scene.
// LIGHT_LEVEL: 0 unlit, 1 one headlight, 2 directional lights, 3 positional too.

#if LIGHT_LEVEL > 0
uniform vec3 LightColour[LIGHT_COUNT];
#endif
#if LIGHT_LEVEL > 1
uniform vec3 LightDirection[LIGHT_COUNT]; // view coordinates, from the light
#endif
#if LIGHT_LEVEL > 2
uniform vec3 LightPosition[LIGHT_COUNT];    // view coordinates
uniform vec3 LightAttenuation[LIGHT_COUNT]; // constant, linear, quadratic
uniform vec2 LightCone[LIGHT_COUNT];        // half angle in degrees, exponent
uniform int LightPositional[LIGHT_COUNT];
#endif
#if defined(FACTORS) && LIGHT_LEVEL > 1
uniform int LightFactor[LIGHT_COUNT]; // the light's component of lightFactors, or -1
#endif
#ifdef FACTORS
// How much of each light arrives at what is shaded (Dobrev, Rosenthal, Linsen 2010, section 6).
vec4 lightFactors = vec4(1.0);
#endif

struct Material
{
  vec3 ambient;
  vec3 diffuse;
  vec3 specular;
  float power;
};

// positionVC, normalVC: view coordinates, the normal of unit length and towards
// the viewer.
vec3 shade(Material m, vec3 positionVC, vec3 normalVC)
{
#if LIGHT_LEVEL == 0
  return m.ambient + m.diffuse;
#elif LIGHT_LEVEL == 1
  float df = max(0.0, normalVC.z);
  float sf = df > 0.0 ? pow(df, m.power) : 0.0;
  return m.ambient + (df * m.diffuse + sf * m.specular) * LightColour[0];
#else
  vec3 diffuse = vec3(0.0);
  vec3 specular = vec3(0.0);
  vec3 view = normalize(-positionVC);
  for (int i = 0; i < LIGHT_COUNT; ++i)
  {
    vec3 direction = LightDirection[i];
    float attenuation = 1.0;
#if LIGHT_LEVEL > 2
    if (LightPositional[i] != 0)
    {
      vec3 from = positionVC - LightPosition[i];
      float distance = length(from);
      vec3 axis = direction;
      direction = from / distance;
      attenuation = 1.0 / dot(LightAttenuation[i], vec3(1.0, distance, distance * distance));
      if (LightCone[i].x < 90.0)
      {
        float coneDot = dot(direction, axis);
        attenuation *=
          coneDot >= cos(radians(LightCone[i].x)) ? pow(coneDot, LightCone[i].y) : 0.0;
      }
    }
#endif
#ifdef FACTORS
    attenuation *= LightFactor[i] < 0 ? 1.0 : lightFactors[LightFactor[i]];
#endif
    float df = max(0.0, attenuation * dot(normalVC, -direction));
    float reflected = max(0.0, dot(reflect(direction, normalVC), view));
    float sf = df > 0.0 ? attenuation * pow(reflected, m.power) : 0.0;
    diffuse += df * LightColour[i];
    specular += sf * LightColour[i];
  }
  return m.ambient + diffuse * m.diffuse + specular * m.specular;
#endif
}
