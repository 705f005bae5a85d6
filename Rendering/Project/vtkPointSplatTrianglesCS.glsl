#version 430
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Projects the triangles that are drawn in the place of splats, to the records and boxes of these
// (vtkPointSplatRecord).
//
// With P_i = (x w, y w, w) the images of the corners, a pixel's ray meets the triangle's plane where
// a_0 P_0 + a_1 P_1 + a_2 P_2 = (x, y, 1), and the triangle where none of the a_i is negative (Olano and
// Greer 1997, Triangle Scan Conversion using 2D Homogeneous Coordinates): so nothing has to be
// clipped where corners are behind the eye, and a_i over the sum of all weigh what the corners have,
// correct in perspective. Corner 0 is the farthest one, about whose image single precision suffices.
//
// The side that is seen is that of the corners' normals, as splats' is, whichever way the corners go
// around. Triangles belong to layers that show their own side. Where they meet splats, their least layer
// distance is that of splats; else they are as sharp as depths are.
// Variants: FACETS (some items are flat), COLOURS, FACTORS, IDS, CLIPPING, CLIP_LINES, PIXEL_BOXES, as in vtkPointSplatProjectCS.
// Reads: Splats, Corners, Listed, Colours, Factors, Ids. Writes: Records, Boxes, RecordColours,
// RecordFactors, RecordIds.

#include "vtkPointSplatProjection"
#include "vtkPointSplatRecord"
#include "vtkPointSplatBoxes"

layout(local_size_x = 64) in;

uniform usamplerBuffer Splats;
uniform usamplerBuffer Corners; // RGBA32UI, a triangle: three splats, cell
// Triangles to draw; bit 31: splats may lie beside.
layout(std430, binding = 7) readonly buffer Listed { uint listed[]; };
layout(std430, binding = 0) writeonly buffer Records { uvec4 records[]; };
#ifdef COLOURS
uniform usamplerBuffer Colours;
uniform bool HasColours;
layout(std430, binding = 2) writeonly buffer RecordColours { uint recordColours[]; };
#endif
#ifdef FACTORS
uniform usamplerBuffer Factors;
uniform bool HasFactors;
layout(std430, binding = 3) writeonly buffer RecordFactors { uint recordFactors[]; };
#endif
#ifdef IDS
uniform usamplerBuffer Ids;
uniform bool NamesCells; // Corners has them
layout(std430, binding = 4) writeonly buffer RecordIds { uint recordIds[]; };
#endif

uniform uint FirstInvocation;
uniform uint RecordCount;
uniform uint TriangleCount;
uniform ivec2 TileShift;
uniform vec2 BucketScale;

const uint BesideSplats = 0x80000000u;
// Of the splats' least layer distance, what triangles have that meet none: their depths are exact but
// for rounding.
const float SharpShare = 1.0 / 16.0;
// Of the farthest corner's w: corners that are nearer to the eye's plane than that have no image.
const float LeastW = 1e-4;

uvec4 fetchSplat(uint splat, int texel)
{
  return texelFetch(Splats, int(splat) * (Circular ? 2 : 4) + texel);
}

void main()
{
  uint invocation = FirstInvocation +
    (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 64u + gl_LocalInvocationID.x;
  if (invocation >= RecordCount)
  {
    return;
  }
  bool seen = invocation < TriangleCount;
  uint entry = listed[seen ? invocation : 0u];
  uvec4 corners = texelFetch(Corners, int(entry & ~BesideSplats));
  vec4 a0 = uintBitsToFloat(fetchSplat(corners.x, 0));
  vec3 a1 = uintBitsToFloat(fetchSplat(corners.y, 0).xyz);
  vec3 a2 = uintBitsToFloat(fetchSplat(corners.z, 0).xyz);
  vec3 axis = PixelW.xyz * mat3(MCVC);
  vec3 ws = vec3(dot(axis, a0.xyz), dot(axis, a1), dot(axis, a2));
  bool second = ws.y > ws.x && ws.y >= ws.z;
  bool third = !second && ws.z > ws.x;
  corners.xyz = second ? corners.yzx : third ? corners.zxy : corners.xyz;
  vec3 origin = second ? a1 : third ? a2 : a0.xyz;
  vec3 edge1MC = (second ? a2 : third ? a0.xyz : a1) - origin;
  vec3 edge2MC = (second ? a0.xyz : third ? a1 : a2) - origin;
  vec4 p = MCVC * vec4(origin, 1.0);
  vec3 edge1 = mat3(MCVC) * edge1MC;
  vec3 edge2 = mat3(MCVC) * edge2MC;
  float w = dot(PixelW, p);
  float inverseW = 1.0 / (w == 0.0 ? 1e-30 : w);
  vec2 centre = vec2(dot(PixelX, p), dot(PixelY, p)) * inverseW;
  // The images of the other corners, over corner 0's w, from its image.
  vec3 q1 =
    vec3(dot(PixelX.xyz, edge1), dot(PixelY.xyz, edge1), dot(PixelW.xyz, edge1)) * inverseW;
  vec3 q2 =
    vec3(dot(PixelX.xyz, edge2), dot(PixelY.xyz, edge2), dot(PixelW.xyz, edge2)) * inverseW;
  q1.xy -= centre * q1.z;
  q2.xy -= centre * q2.z;
  float w1 = 1.0 + q1.z;
  float w2 = 1.0 + q2.z;
  float area = q1.x * q2.y - q2.x * q1.y;
  seen = seen && w > 0.0 && area != 0.0;
  float inverseArea = 1.0 / (area == 0.0 ? 1.0 : area);
  vec2 along1 = inverseArea * vec2(q2.y, -q2.x);
  vec2 along2 = inverseArea * vec2(-q1.y, q1.x);
  vec2 along0 = -w1 * along1 - w2 * along2;

  vec3 depths = vec3(0.0, -edge1.z, -edge2.z);
  float depth = -p.z - DepthRange.x;
  float nearest = depth + min(min(depths.x, depths.y), depths.z);
  float farthest = depth + max(max(depths.x, depths.y), depths.z);
  seen = seen && farthest > 0.0 && nearest < DepthRange.y;

  // All of the window, where a corner has no image. With a margin for the pixels' samples.
  bool whole = min(w1, w2) > LeastW;
  vec2 other1 = q1.xy / max(w1, LeastW);
  vec2 other2 = q2.xy / max(w2, LeastW);
  vec2 low = centre + min(min(other1, other2), vec2(0.0)) - (0.5 + SampleReach);
  vec2 high = centre + max(max(other1, other2), vec2(0.0)) - (0.5 - SampleReach);
  low = whole ? clamp(low, vec2(Window.xy) - 1.0, vec2(Window.zw) + 2.0) : vec2(Window.xy);
  high = whole ? clamp(high, vec2(Window.xy) - 1.0, vec2(Window.zw) + 2.0) : vec2(Window.zw);
  ivec2 first = max(ivec2(ceil(low)), Window.xy);
  ivec2 last = min(ivec2(floor(high)), Window.zw);
  seen = seen && all(lessThanEqual(first, last));
  ivec4 tiles = ivec4(first >> TileShift, last >> TileShift);

  uvec3 normals = uvec3(fetchSplat(corners.x, 1).y, fetchSplat(corners.y, 1).y,
    fetchSplat(corners.z, 1).y);
  // Of any length: their code is of the direction.
  vec3 n0 = NormalMatrix * decodeNormal(normals.x);
  vec3 n1 = NormalMatrix * decodeNormal(normals.y);
  vec3 n2 = NormalMatrix * decodeNormal(normals.z);
  vec3 face = cross(edge1, edge2);
  float inverseLength = inversesqrt(max(dot(face, face), 1e-37));
  face *= dot(face, n0 + n1 + n2) < 0.0 ? -inverseLength : inverseLength;
  float towards = Parallel ? face.z : -dot(face, p.xyz);
  bool back = towards < 0.0;
  float facing = Parallel ? abs(face.z) : abs(towards) / max(abs(p.z), 1e-30);
  seen = seen && (Culling & (back ? 1 : 2)) == 0;
#ifdef CLIPPING
  for (int i = 0; i < ClipPlaneCount; ++i)
  {
    vec3 off = vec3(dot(ClipPlanes[i], p), dot(ClipPlanes[i].xyz, edge1),
      dot(ClipPlanes[i].xyz, edge2));
    seen = seen && off.x + max(max(off.y, off.z), 0.0) >= 0.0;
  }
#endif

  float radius = a0.w > 0.0 ? a0.w : UsualRadius;
  float stretch = length(edge1) / max(length(edge1MC), 1e-30);
  float share = (entry & BesideSplats) != 0u ? 1.0 : SharpShare;
  float layer = LayerDistance + share * LayerRadii * RadiusScale * radius * stretch;
  uint head = Tag | (back ? 1u : 0u) |
    encodeLayer(layer / max(facing, LeastFacing), isEdgeOn(facing)) << 16;

  uint bucket = uint(clamp((nearest - BucketScale.x) * BucketScale.y, 0.0,
    float(DepthBuckets - 1u)));
  uint to = invocation - FirstInvocation;
  writeBox(to, tiles, bucket, seen ? Triangle : NotSeen, vec4(first, last));
  uvec4 beside = uvec4(0xffffffffu);
#ifdef COLOURS
  recordColours[to] = HasColours ? texelFetch(Colours, int(corners.x)).r : 0xffffffffu;
  beside.x = HasColours ? texelFetch(Colours, int(corners.y)).r : 0xffffffffu;
  beside.y = HasColours ? texelFetch(Colours, int(corners.z)).r : 0xffffffffu;
#endif
#ifdef FACTORS
  recordFactors[to] = HasFactors ? texelFetch(Factors, int(corners.x)).r : 0xffffffffu;
  beside.z = HasFactors ? texelFetch(Factors, int(corners.y)).r : 0xffffffffu;
  beside.w = HasFactors ? texelFetch(Factors, int(corners.z)).r : 0xffffffffu;
#endif
#ifdef IDS
  // Of ids alone, factors are of no account.
  recordIds[to] = NamesCells ? corners.w : texelFetch(Ids, int(corners.x)).r;
  beside.z = NamesCells ? corners.w : texelFetch(Ids, int(corners.y)).r;
  beside.w = NamesCells ? corners.w : texelFetch(Ids, int(corners.z)).r;
#endif
  uint record = to * uint(RecordTexels);
  records[record] = uvec4(floatBitsToUint(vec3(centre, depth)), head);
  records[record + 1u] = floatBitsToUint(vec4(along1, along2));
  records[record + 2u] = floatBitsToUint(vec4(along0, depths.yz));
#ifdef FACETS
  uint facet = encodeNormal(face);
#else
  const uint facet = 0u;
#endif
  records[record + 3u] = uvec4(encodeNormal(n0), encodeNormal(n1), encodeNormal(n2), facet);
  records[record + 4u] = beside;
}
