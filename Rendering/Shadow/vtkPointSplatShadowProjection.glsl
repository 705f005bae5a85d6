// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A splat as a light sees it. The light's coordinates have x and y across and z
// away from it; about a light that stands among the points are the six faces of a cube.

#include "vtkPointSplatOctahedron"
#include "vtkPointSplatShadowMap"

uniform usamplerBuffer Splats; // RGBA32UI: see vtkPointSplatCloud.h
uniform int TexelsPerSplat;
uniform int SplatCount;
uniform mat4 MCLC;             // cloud's local coordinates to the light's
uniform mat3 NormalMatrix;
uniform vec2 MapScale;         // pixels = MapScale xy + MapOffset; of xy / z, if not parallel
uniform vec2 MapOffset;
uniform float UsualRadius;     // of points without one, the light's coordinates
uniform float RadiusScale;     // of the cloud's coordinates to the light's
uniform int ClipPlaneCount;
uniform vec4 ClipPlanes[6];    // cloud's local coordinates; what is negative is cut away

#ifdef CLIP_LINES
uniform samplerBuffer ClipLineTexels; // RGBA32F: see vtkPointSplatCloud.h

// Pixels, by which disks go on beyond their clip lines, so that no ray falls between them.
const float ClipMargin = 1.0 / 16.0;
#endif

// The most pixels of a disk's radius.
const float LargestReach = 16.0;
// Disks of a smaller radius, in pixels, cover the pixel of their centre in any case, or they might
// fall between pixels; larger ones cover their neighbours' centres, and would stand out over
// outlines by half a pixel.
const float SmallDisk = 1.2;

// Of a splat's bend (vtkPointSplatProjection): it is a body alone.
const uint BodyBit = 0x40000000u;

struct Seen
{
  bool inside;  // the map
  bool mine;    // this face is the one to ask
  bool cut;     // away by a clipping plane
  vec2 pixel;
  vec3 position; // in the light's coordinates
  vec3 normal;
  float radius;
  float depth;
  float facing;
#ifdef CLIP_LINES
  vec3 lines[2]; // of a place d about the centre is kept what has dot(lines, d) <= 1
#endif
};

// Which of the cube's faces a direction goes through: one only, whatever rounding does.
int faceOf(vec3 v)
{
  vec3 a = abs(v);
  int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
  return 2 * axis + (v[axis] < 0.0 ? 1 : 0);
}

#ifdef CLIP_LINES
// A clip line in the cloud's coordinates, from one in terms of the axes.
vec3 clipLineOf(vec2 line, vec3 s, vec3 t)
{
  vec3 n = cross(s, t);
  return (line.x * cross(t, n) + line.y * cross(n, s)) / max(dot(n, n), 1e-37);
}

// In the light's coordinates. plane: coded, the normal of the disk's plane.
void clipLinesOf(int index, uint plane, float radius, out vec3 lines[2])
{
  // Of the length of the radius, so that its square is in the range of floats.
  vec3 s;
  vec3 t;
  float scale = radius;
  if (TexelsPerSplat > 2)
  {
    s = uintBitsToFloat(texelFetch(Splats, index * TexelsPerSplat + 2).xyz) / scale;
    t = uintBitsToFloat(texelFetch(Splats, index * TexelsPerSplat + 3).xyz) / scale;
  }
  else
  {
    // As in placeSplat() in vtkPointSplatProjection.
    vec3 n = decodeNormal(plane);
    s = normalize(cross(n, abs(n.z) < 0.7 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0)));
    t = cross(n, s);
  }
  vec4 coded = texelFetch(ClipLineTexels, index) / scale;
  lines[0] = NormalMatrix * clipLineOf(coded.xy, s, t);
  lines[1] = NormalMatrix * clipLineOf(coded.zw, s, t);
}

#endif
Seen seeSplat(int index)
{
  uvec4 a = texelFetch(Splats, index * TexelsPerSplat);
  vec4 positionMC = vec4(uintBitsToFloat(a.xyz), 1.0);
  uvec3 shape = texelFetch(Splats, index * TexelsPerSplat + 1).xyz;
  uint plane = shape.x;
  vec3 p = (MCLC * positionMC).xyz;
  // A body alone faces the light, as it does the eye (vtkPointSplatProjection).
  vec3 normal = TexelsPerSplat == 2 && (shape.z & BodyBit) != 0u
    ? (Parallel ? vec3(0.0, 0.0, -1.0) : -p / max(length(p), 1e-30))
    : normalize(NormalMatrix * decodeNormal(plane));
  Seen s;
  s.cut = false;
  for (int i = 0; i < ClipPlaneCount; ++i)
  {
    s.cut = s.cut || dot(ClipPlanes[i], positionMC) < 0.0;
  }
  float radius = uintBitsToFloat(a.w);
#ifdef CLIP_LINES
  clipLinesOf(index, plane, max(radius, 1e-37), s.lines);
#endif
  s.mine = true;
  if (Face >= 0)
  {
#ifdef CLIP_LINES
    s.lines[0] = toFace(s.lines[0], Face);
    s.lines[1] = toFace(s.lines[1], Face);
#endif
    s.mine = faceOf(p) == Face;
    p = toFace(p, Face);
    normal = toFace(normal, Face);
  }
  s.position = p;
  s.normal = normal;
  s.radius = radius > 0.0 ? RadiusScale * radius : UsualRadius;
  s.depth = p.z;
  s.facing = Parallel ? abs(normal.z) : abs(dot(normal, p)) / max(abs(p.z), 1e-30);
  s.pixel = MapScale * (Parallel ? p.xy : p.xy / p.z) + MapOffset;
  s.inside = (Parallel || p.z > 0.0) && all(greaterThanEqual(s.pixel, vec2(0.0))) &&
    all(lessThan(s.pixel, vec2(MapSize)));
  return s;
}

// How far from its centre the splat's disk may reach, pixels.
vec2 reachOf(Seen s)
{
  vec3 reach = s.radius * sqrt(max(1.0 - s.normal * s.normal, vec3(0.0)));
  vec2 pixels = Parallel ? MapScale * reach.xy
                         : MapScale * (reach.xy + abs(s.position.xy / s.depth) * reach.z) /
      max(s.depth - reach.z, 1e-30);
  return min(pixels + 0.01, vec2(LargestReach)); // and what rounding may take away
}

// The texel that a splat gives a pixel: where the light's ray meets its disk, if it does.
uint texelOf(Seen s, ivec2 pixel)
{
  if (pixel == ivec2(s.pixel) &&
    s.radius < SmallDisk * (Parallel ? PixelSize : PixelSize * s.depth))
  {
    return encodeShadow(s.depth, s.facing);
  }
  vec2 xy = (vec2(pixel) + 0.5 - MapOffset) / MapScale;
  vec3 q = Parallel
    ? vec3(xy, s.position.z - dot(s.normal.xy, xy - s.position.xy) / s.normal.z)
    : vec3(xy, 1.0) * (dot(s.normal, s.position) / dot(s.normal, vec3(xy, 1.0)));
  vec3 d = q - s.position;
  // Written so that a division by zero fails the test.
  bool hit = dot(d, d) <= s.radius * s.radius && (Parallel || q.z > 0.0);
#ifdef CLIP_LINES
  float margin = ClipMargin * (Parallel ? PixelSize : PixelSize * s.depth);
  for (int k = 0; k < 2; ++k)
  {
    hit = hit && dot(s.lines[k], d) <= 1.0 + margin * length(s.lines[k]);
  }
#endif
  return hit ? encodeShadow(q.z, s.facing) : Nothing;
}
