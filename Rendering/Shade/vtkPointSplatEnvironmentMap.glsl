// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The renderer's environment, and how much of it a dielectric reflects.
// ENVIRONMENT_CUBE: a cube map; else an equirectangular picture, u = atan(z, x) / 2 pi + 1/2,
// v = asin(y) / pi + 1/2 with x to the environment's right and y up, as image-based lighting
// has it. ENVIRONMENT_LINEAR: its colours are linear and are encoded for display.

#ifdef ENVIRONMENT_CUBE
uniform samplerCube Environment;
#else
uniform sampler2D Environment;
#endif
uniform mat3 EnvironmentFromView; // view coordinates to right, up and right x up

vec3 displayed(vec3 colour)
{
#ifdef ENVIRONMENT_LINEAR
  return pow(max(colour, vec3(0.0)), vec3(1.0 / 2.2));
#else
  return colour;
#endif
}

// Of the level of detail that shows each texel, of a change in texels from pixel to pixel.
float levelOf(vec2 dx, vec2 dy)
{
  float q = max(dot(dx, dx), dot(dy, dy));
  return q > 1.0 && q < 1e12 ? 0.5 * log2(q) : 0.0;
}

// Of a unit direction and its change from pixel to pixel: angles jump by a turn on the picture's
// seam, their derivatives do not.
vec3 environmentAlong(vec3 direction, vec3 dx, vec3 dy)
{
  vec3 e = EnvironmentFromView * direction;
  // Neighbours that are about to be discarded have no direction, but look one up.
  e = dot(e, e) > 0.5 && dot(e, e) < 2.0 ? e : vec3(0.0, 0.0, 1.0);
#ifdef ENVIRONMENT_CUBE
  float size = float(textureSize(Environment, 0).x);
  float level = levelOf(0.5 * size * vec2(length(dx), 0.0), 0.5 * size * vec2(length(dy), 0.0));
  return displayed(textureLod(Environment, e, level).rgb);
#else
  const float pi = 3.14159265358979;
  vec2 size = vec2(textureSize(Environment, 0));
  vec3 ex = EnvironmentFromView * dx;
  vec3 ey = EnvironmentFromView * dy;
  float q = max(e.x * e.x + e.z * e.z, 1e-12);
  vec2 texels = size * vec2(0.5 / q, inversesqrt(q)) / pi;
  float level = levelOf(texels * vec2(e.x * ex.z - e.z * ex.x, ex.y),
    texels * vec2(e.x * ey.z - e.z * ey.x, ey.y));
  vec2 uv = vec2(0.5 * atan(e.z, e.x), asin(clamp(e.y, -1.0, 1.0))) / pi + 0.5;
  return displayed(textureLod(Environment, uv, level).rgb);
#endif
}

// To be called by all fragments of a 2 x 2 block.
vec3 environment(vec3 direction)
{
  return environmentAlong(direction, dFdx(direction), dFdy(direction));
}

// The reflected share of unpolarised light that passes from index n1 to n2, by Fresnel's
// equations; of the cosines against the normal before and behind the interface.
float fresnel(float n1, float n2, float cos1, float cos2)
{
  if (n1 == n2)
  {
    return 0.0;
  }
  float s = (n1 * cos1 - n2 * cos2) / (n1 * cos1 + n2 * cos2);
  float p = (n2 * cos1 - n1 * cos2) / (n2 * cos1 + n1 * cos2);
  return 0.5 * (s * s + p * p);
}

// That of light from the air that meets index n at this cosine.
float fresnelOfAir(float n, float cosine)
{
  cosine = clamp(cosine, 0.0, 1.0);
  return fresnel(1.0, n, cosine, sqrt(max(1.0 - (1.0 - cosine * cosine) / (n * n), 0.0)));
}
