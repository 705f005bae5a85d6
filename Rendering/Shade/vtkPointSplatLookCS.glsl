#version 430
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Looks up an item's textures, once a pixel of each of its layers, with the changes of the
// coordinates by pixels for derivatives, so that textures are filtered as on meshes; turns normals
// and tangents by vtkOpenGLPolyDataMapper's formulas. An invocation has a pixel of a layer.
// COLOURS: how many textures of colours; ALBEDO, MATERIAL, EMISSIVE, NORMAL_MAP, COAT_NORMAL_MAP,
// ANISOTROPY_MAP: there is one; TANGENTS: points have some, and something needs them.
// Reads: Texels. Reads and writes: Looks (vtkPointSplatLook.glsl).

#include "vtkPointSplatTexel"
#include "vtkPointSplatLook"
#include "vtkPointSplatRay"

layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Texels { uvec4 texels[]; };
layout(std430, binding = 5) buffer Looks { uvec4 looks[]; };

uniform int FirstRow; // that is bound
uniform int RowCount;
uniform ivec2 LookSize;    // of the images
uniform int LookCapacity;  // layers that there is room for
uniform int LookCount;     // layers that there are
uniform int OnlySlot;
uniform mat4 CoordinateTransform;
uniform bool OnBackFaces;  // whether colours are shown there
#ifdef COLOURS
uniform sampler2D ColourTextures[COLOURS];
uniform vec4 ColourKinds[COLOURS]; // components, how it is blended with those before
#endif
#ifdef ALBEDO
uniform sampler2D AlbedoTexture;
#endif
#ifdef MATERIAL
uniform sampler2D MaterialTexture;
#endif
#ifdef EMISSIVE
uniform sampler2D EmissiveTexture;
#endif
#ifdef NORMAL_MAP
uniform sampler2D NormalTexture;
#endif
#ifdef COAT_NORMAL_MAP
uniform sampler2D CoatNormalTexture;
#endif
#ifdef ANISOTROPY_MAP
uniform sampler2D AnisotropyTexture;
#endif
uniform vec2 NormalScales;        // of the maps of normals: the surface's, the coat's
uniform float AnisotropyRotation; // of a whole turn

// Texture coordinates, and their changes by pixels.
struct Place
{
  vec2 at;
  vec2 byX;
  vec2 byY;
};

// As the transform has them, by whose last row they are divided.
Place placeOf(uvec4 code)
{
  vec4 at = CoordinateTransform * vec4(uintBitsToFloat(code.xy), 0.0, 1.0);
  mat2 change = mat2(CoordinateTransform);
  return Place(at.xy / at.w, change * unpackHalf2x16(code.z) / at.w,
    change * unpackHalf2x16(code.w) / at.w);
}

// The sampler filters what lies across, and looks up so often along where the texture is seen at a
// flat angle: one, where it does that by itself.
uniform float MostSamples;

vec4 lookUp(sampler2D map, Place p)
{
  vec2 size = vec2(textureSize(map, 0));
  float x = length(size * p.byX);
  float y = length(size * p.byY);
  vec2 along = x > y ? p.byX : p.byY;
  vec2 across = x > y ? p.byY : p.byX;
  float count = clamp(ceil(max(x, y) / max(min(x, y), 1e-6)), 1.0, MostSamples);
  vec4 sum = vec4(0.0);
  for (float i = 0.5; i < count; i += 1.0)
  {
    sum += textureGrad(map, p.at + (i / count - 0.5) * along, along / count, across);
  }
  return sum / count;
}

#ifdef COLOURS
// Of one component grey, of two grey and opacity.
vec4 colourBy(vec4 value, int components)
{
  return components == 1 ? vec4(value.rrr, 1.0)
    : components == 2    ? value.rrrg
    : components == 3    ? vec4(value.rgb, 1.0)
                         : value;
}

// vtkTexture's modes: replace, modulate, add, add signed, subtract; with others there is no effect.
vec4 blendBy(vec4 below, vec4 value, int mode)
{
  vec3 sum = value.rgb * value.a + below.rgb * below.a;
  return mode == 1 ? vec4(value.rgb * value.a + below.rgb * (1.0 - value.a),
                       value.a + below.a * (1.0 - value.a))
    : mode == 2    ? below * value
    : mode == 3    ? vec4(sum, below.a + value.a)
    : mode == 4    ? vec4(sum - 0.5, below.a + value.a - 0.5)
    : mode == 6    ? vec4(below.rgb - value.rgb * value.a, below.a)
                   : below;
}

vec4 colourAt(Place p)
{
  vec4 colour = vec4(1.0);
  for (int i = 0; i < COLOURS; ++i)
  {
    vec4 value = colourBy(lookUp(ColourTextures[i], p), int(ColourKinds[i].x));
    colour = i == 0 ? value : blendBy(colour, value, int(ColourKinds[i].y));
  }
  return colour;
}
#endif

// A map's normal, in the basis of tangent, bitangent and normal.
vec3 mapNormal(vec3 value, float scale, mat3 basis)
{
  return normalize(basis * normalize((2.0 * value - 1.0) * vec3(scale, scale, 1.0)));
}

void main()
{
  int index = int(gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 64 +
    int(gl_LocalInvocationID.x);
  int x = index % LookSize.x;
  int layer = index / LookSize.x % LookCount;
  int row = index / LookSize.x / LookCount;
  if (row >= RowCount)
  {
    return;
  }
  int texelAt = (row * LookCapacity + layer) * LookSize.x + x;
  uvec4 texel = texels[texelAt];
  if (isEmpty(texel) || int(tagOfTexel(texel) >> 1) != OnlySlot)
  {
    return;
  }
  int at = LOOKS * texelAt;
  uvec4 code = looks[at];
  bool known = hasCoordinates(code);
  Place p = placeOf(known ? code : uvec4(0u));
  Surface s = unpackTexel(texel);
  vec3 positionVC = pointOfPixel(ivec2(x, FirstRow + row), -(NearDistance + s.depth));
  vec3 normal = isBack(s.tag, s.normal, positionVC) ? -s.normal : s.normal;

  vec4 colour = vec4(1.0);
  vec4 factors = vec4(1.0);
#ifdef COLOURS
  colour = known && (OnBackFaces || (s.tag & 1u) == 0u) ? colourAt(p) : colour;
#endif
#ifdef ALBEDO
  colour = known ? lookUp(AlbedoTexture, p) : colour;
#endif
#ifdef MATERIAL
  factors.rgb = known ? lookUp(MaterialTexture, p).rgb : factors.rgb;
#endif
#if LOOKS > 1
  uvec4 surface = looks[at + 1];
  vec3 emission = vec3(0.0);
  vec3 tangent = vec3(1.0, 0.0, 0.0);
  vec3 mapped = normal;
  vec3 coat = normal;
#ifdef EMISSIVE
  emission = known ? lookUp(EmissiveTexture, p).rgb : emission;
#endif
#ifdef TANGENTS
  tangent = decodeNormal(surface.x);
  float turn = AnisotropyRotation;
#ifdef ANISOTROPY_MAP
  vec2 anisotropy = known ? lookUp(AnisotropyTexture, p).rg : vec2(1.0);
  factors.a = anisotropy.x;
  turn *= anisotropy.y;
#endif
  turn *= 2.0 * 3.14159265359;
  tangent = (1.0 - cos(turn)) * dot(tangent, normal) * normal + cos(turn) * tangent +
    sin(turn) * cross(normal, tangent);
  tangent -= dot(tangent, normal) * normal;
  // A tangent along the normal says nothing; any other does.
  tangent = dot(tangent, tangent) > 1e-8
    ? normalize(tangent)
    : normalize(cross(normal, abs(normal.x) < 0.7 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0)));
  mat3 basis = mat3(tangent, cross(normal, tangent), normal);
#ifdef NORMAL_MAP
  mapped = known ? mapNormal(lookUp(NormalTexture, p).xyz, NormalScales.x, basis) : mapped;
  // Without a map of its own the coat is what it lies on, smooth.
#endif
#ifdef COAT_NORMAL_MAP
  coat = known ? mapNormal(lookUp(CoatNormalTexture, p).xyz, NormalScales.y, basis) : coat;
#endif
#endif
  looks[at + 1] = uvec4(encodeNormal(tangent),
    packHalf2x16(vec2(unpackHalf2x16(surface.y).x, emission.b)), packHalf2x16(emission.rg),
    encodeNormal(coat));
#else
  vec3 mapped = normal;
#endif
  looks[at] = uvec4(packHalf2x16(colour.rg), packHalf2x16(colour.ba), packUnorm4x8(factors),
    encodeNormal(mapped));
}
