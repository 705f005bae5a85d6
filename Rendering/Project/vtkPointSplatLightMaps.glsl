// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How much of the lights' light passes to any point, by shadow maps (vtkPointSplatLightMaps.h). Of
// GLSL 1.50, since VTK's mesh shaders take it in too, and by names that these do not have.
// LIGHT_MAPS: the lights that are on. OPAQUE_LIGHT_MAPS: opaque surfaces are in the maps.
// LIGHT_MAP_LAYERS: the layers of translucent ones.

#ifdef LIGHT_MAPS
uniform samplerBuffer LightMapTable;  // RGBA32F, six texels a map
uniform vec4 LightMapsOf[LIGHT_MAPS]; // of each light: first map; samples, or 0; faces of a sample
#ifdef OPAQUE_LIGHT_MAPS
uniform usampler2DArray LightMapDepths; // R32UI
#endif
#ifdef LIGHT_MAP_LAYERS
uniform usampler2DArray LightMapLayers; // RG32UI
#endif

// What passes at a pixel of a map to where depths are less than a bound, as texels have them.
vec3 lightPassedAt(ivec2 pixel, int map, uint bound)
{
  vec3 passed = vec3(1.0);
#ifdef LIGHT_MAP_LAYERS
  for (int k = 0; k < LIGHT_MAP_LAYERS; ++k)
  {
    uvec2 layer = texelFetch(LightMapLayers, ivec3(pixel, map * LIGHT_MAP_LAYERS + k), 0).rg;
    if (layer.x >= bound)
    {
      break;
    }
    passed = vec3(uvec3(layer.y >> 16, layer.y >> 8, layer.y) & 255u) / 255.0;
  }
#endif
#ifdef OPAQUE_LIGHT_MAPS
  passed = texelFetch(LightMapDepths, ivec3(pixel, map), 0).r < bound ? vec3(0.0) : passed;
#endif
  return passed;
}

// False where the map does not have the point. taps: 4 to blend between pixels, or 1.
bool lightPassedMap(int map, int taps, vec4 positionVC, vec3 normalVC, out vec3 passed)
{
  vec4 rowX = texelFetch(LightMapTable, 6 * map);
  vec4 rowY = texelFetch(LightMapTable, 6 * map + 1);
  vec4 rowZ = texelFetch(LightMapTable, 6 * map + 2);
  vec4 place = texelFetch(LightMapTable, 6 * map + 3);
  vec4 size = texelFetch(LightMapTable, 6 * map + 4);
  vec4 kind = texelFetch(LightMapTable, 6 * map + 5);
  vec3 p = vec3(dot(rowX, positionVC), dot(rowY, positionVC), dot(rowZ, positionVC));
  vec3 n = vec3(dot(rowX.xyz, normalVC), dot(rowY.xyz, normalVC), dot(rowZ.xyz, normalVC));
  bool isParallel = kind.x > 0.0;
  vec2 at = place.xy * (isParallel ? p.xy : p.xy / p.z) + place.zw;
  passed = vec3(1.0);
  if (!(isParallel || p.z > 0.0) || any(lessThan(at, vec2(0.0))) ||
    any(greaterThanEqual(at, size.xy)))
  {
    return false;
  }
  // The same surface layer as in vtkPointSplatShadowMap.
  float facing = isParallel ? abs(n.z) : abs(dot(n, p)) / p.z;
  float offset = max(kind.y, kind.z * (isParallel ? size.z : size.z * p.z)) / max(facing, 0.05);
  uint bound = uint(clamp((p.z - offset) / size.w, 0.0, 1.0) * 16777215.0) << 8;
  vec2 low = taps > 1 ? floor(at - 0.5) : floor(at);
  vec2 share = taps > 1 ? at - 0.5 - low : vec2(0.0);
  passed = vec3(0.0);
  for (int tap = 0; tap < taps; ++tap)
  {
    ivec2 step = ivec2(tap & 1, tap >> 1);
    vec2 weight = mix(1.0 - share, share, vec2(step));
    ivec2 pixel = clamp(ivec2(low) + step, ivec2(0), ivec2(size.xy) - 1);
    passed += weight.x * weight.y * lightPassedAt(pixel, map, bound);
  }
  return true;
}

// Of a light that is on, to a point whose normal is of unit length.
vec3 lightPassed(int light, vec3 positionVC, vec3 normalVC)
{
  int first = int(LightMapsOf[light].x);
  int samples = int(LightMapsOf[light].y);
  int faces = int(LightMapsOf[light].z);
  vec3 sum = vec3(0.0);
  for (int i = 0; i < samples; ++i)
  {
    vec3 passed = vec3(1.0);
    bool found = false;
    for (int face = 0; face < faces && !found; ++face)
    {
      found = lightPassedMap(first + i * faces + face, samples > 1 ? 1 : 4,
        vec4(positionVC, 1.0), normalVC, passed);
    }
    sum += passed;
  }
  return samples > 0 ? sum / float(samples) : vec3(1.0);
}
#endif
