#version 430
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Projects each splat once: its record and its box, for the tiles; and its colour, factors of
// lights, texture coordinates, tangent, id or clip lines, beside them.
// Variants: CLIPPING, CLIP_LINES, COLOURS, FACTORS, COORDINATES, TANGENTS, IDS, PIXEL_BOXES.
// Reads: Splats, ClipLineTexels, Colours, Factors, Coordinates, Tangents, Ids. Writes: Records,
// Boxes, RecordClipLines, RecordColours, RecordFactors, RecordCoordinates, RecordTangents, RecordIds.

#include "vtkPointSplatProjection"
#include "vtkPointSplatRecord"
#include "vtkPointSplatBoxes"
#include "vtkPointSplatBlockList"
#ifdef CLIP_LINES
#include "vtkPointSplatClipLines"
#endif

layout(local_size_x = 64) in;

// By texture, not by storage buffer: on CPUs Mesa loads the former for several
// invocations at once, and GPUs do not mind.
uniform usamplerBuffer Splats; // RGBA32UI, two or four a splat: see vtkPointSplatCloud.h
layout(std430, binding = 0) writeonly buffer Records { uvec4 records[]; };
#ifdef COLOURS
uniform usamplerBuffer Colours; // R32UI, where HasColours
uniform bool HasColours;
layout(std430, binding = 2) writeonly buffer RecordColours { uint recordColours[]; };
#endif
#ifdef FACTORS
uniform usamplerBuffer Factors; // R32UI, where HasFactors
uniform bool HasFactors;
layout(std430, binding = 3) writeonly buffer RecordFactors { uint recordFactors[]; };
#endif
#ifdef COORDINATES
uniform usamplerBuffer Coordinates; // RGBA32UI, where HasCoordinates (vtkPointSplatCoordinates.h)
uniform bool HasCoordinates;
const uint NoCoordinates = 0x7fc00000u; // in the first two words
layout(std430, binding = 6) writeonly buffer RecordCoordinates { uvec4 recordCoordinates[]; };
#endif
#ifdef TANGENTS
uniform usamplerBuffer Tangents; // R32UI, coded as normals, where HasTangents
uniform bool HasTangents;
// Where there are ids there are no looks.
layout(std430, binding = 4) writeonly buffer RecordTangents { uint recordTangents[]; };
#endif
#ifdef IDS
uniform usamplerBuffer Ids; // R32UI
layout(std430, binding = 4) writeonly buffer RecordIds { uint recordIds[]; };
#endif
#ifdef CLIP_LINES
uniform samplerBuffer ClipLineTexels; // RGBA32F, where HasClipLines
uniform bool HasClipLines;
layout(std430, binding = 5) writeonly buffer RecordClipLines { vec4 recordClipLines[]; };
#endif

uniform uint FirstInvocation;  // of this dispatch
uniform uint RecordCount;      // whole blocks of them
uniform float DiskReach;       // radii that show where the surface is
uniform float CoverageRadius;  // pixels: a narrower disk might miss every pixel
uniform float CoverageDot;     // pixels: and where that does not matter (widen())
uniform float PrefilterRadius; // pixels
uniform ivec2 TileShift;       // tiles are 2^TileShift pixels wide and high
uniform float TileReach;       // pixels from a tile's middle to its farthest pixel
uniform vec2 BucketScale;      // a depth's bucket: (depth - x) y

// What bend, and what perspective, may move a pixel by where it is left out: no more than what
// an edge is moved by when one of 32 samples changes sides.
const float StillPixels = 1.0 / 32.0;
// Of splats whose centres are farther off than this rounding leaves less of a pixel.
const float FarPixels = 1e5;
// Splats of more tiles than this along a side are listed by blocks of tiles.
const int WideTiles = 64;

// A symmetric form from its axes, the off-diagonal element doubled.
vec3 formOf(vec2 major, vec2 minor)
{
  return vec3(major.x * major.x + minor.x * minor.x,
    2.0 * (major.x * major.y + minor.x * minor.y), major.y * major.y + minor.y * minor.y);
}

void main()
{
  uint invocation = FirstInvocation +
    (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 64u + gl_LocalInvocationID.x;
  if (invocation >= RecordCount)
  {
    return;
  }
  uint splat;
  bool seen = listedSplat(invocation, splat);
  int at = int(splat) * (Circular ? 2 : 4);
  uvec4 a = texelFetch(Splats, at);
  uvec4 b = texelFetch(Splats, at + 1);
  vec3 axis1 = vec3(0.0);
  vec3 axis2 = vec3(0.0);
  if (!Circular)
  {
    axis1 = uintBitsToFloat(texelFetch(Splats, at + 2).xyz);
    axis2 = uintBitsToFloat(texelFetch(Splats, at + 3).xyz);
  }
  Splat q;
  Bend bend;
  seen = placeSplat(uintBitsToFloat(a.xyz), b.xyz, axis1, axis2, uintBitsToFloat(a.w),
           KernelSupport, q, bend) &&
    seen;

  // The ellipse that the tangents span in the image: where its longer axis ends on the splat, the
  // directions of both in the image, their lengths; that of the shorter one with its sign.
  float aa = dot(q.s.xy, q.s.xy);
  float ab = dot(q.s.xy, q.t.xy);
  float bb = dot(q.t.xy, q.t.xy);
  float diff = 0.5 * (aa - bb);
  float root = sqrt(diff * diff + ab * ab);
  float longest = sqrt(0.5 * (aa + bb) + root);
  vec2 end = diff > 0.0 ? vec2(diff + root, ab) : vec2(ab, root - diff);
  float endLength = length(end);
  end = endLength > 0.0 ? end / endLength : vec2(1.0, 0.0);
  vec2 otherEnd = vec2(-end.y, end.x);
  vec2 major = end.x * q.s.xy + end.y * q.t.xy;
  float majorLength = length(major);
  major = majorLength > 0.0 ? major / majorLength : vec2(1.0, 0.0);
  vec2 minor = vec2(-major.y, major.x);
  float shortest = (q.s.x * q.t.y - q.s.y * q.t.x) / max(longest, 1e-30);
  float thin = abs(shortest);
  bool narrow = thin < PrefilterRadius && longest > PrefilterRadius;
  // With the silhouette on it, a widened ellipse would stand out over that.
  bool leans = narrow && thin >= KernelSupport * bend.strongest * longest;

  // The box about the kernel: the cap lies between the ellipses at its least and its greatest
  // height; in perspective what is nearer is larger.
  vec2 extent = KernelSupport * sqrt(q.s.xy * q.s.xy + q.t.xy * q.t.xy);
  vec2 rise = bend.highest * q.m.xy;
  vec2 fall = bend.lowest * q.m.xy;
  float nearer =
    KernelSupport * length(vec2(q.s.z, q.t.z)) +
    max(bend.highest, -bend.lowest) * abs(q.m.z);
  float growth = nearer < 0.9 ? 1.0 / (1.0 - nearer) : 1e9;
  float margin = KernelSupport * PrefilterRadius;
  vec2 beside = leans ? margin * abs(minor) : vec2(0.0);
  // Where the disk is: widened, and seen by samples' rays that are taken for parallel.
  vec2 diskExtent = DiskReach / KernelSupport * extent;
  float diskMargin = DiskReach * CoverageRadius + SampleReach + 2.0 * StillPixels;
  vec2 diskLow = q.centre - max(growth * (diskExtent - min(rise, fall)), vec2(0.0)) - diskMargin;
  vec2 diskHigh = q.centre + max(growth * (diskExtent + max(rise, fall)), vec2(0.0)) + diskMargin;
  vec2 low = max(growth * (extent - min(rise, fall)), vec2(margin));
  vec2 high = max(growth * (extent + max(rise, fall)), vec2(margin));
  low = q.centre - sqrt(low * low + beside * beside);
  high = q.centre + sqrt(high * high + beside * beside);
  // Clamped before the conversion: out of an int's range it is undefined.
  low = clamp(low, vec2(Window.xy) - 1.0, vec2(Window.zw) + 2.0);
  high = clamp(high, vec2(Window.xy) - 1.0, vec2(Window.zw) + 2.0);
  ivec2 first = max(ivec2(ceil(low - 0.5)), Window.xy);
  ivec2 last = min(ivec2(floor(high - 0.5)), Window.zw);
  seen = seen && all(lessThanEqual(first, last));
  first >>= TileShift;
  last >>= TileShift;

  float deep = depthReach(q, bend, KernelSupport);
  bool whole = q.depth - deep > 0.0 && q.depth + deep < DepthRange.y &&
    max(abs(q.centre.x), abs(q.centre.y)) < FarPixels;
#ifdef CLIPPING
  // The splat lies within a ball of this radius.
  float ball = KernelSupport * (length(q.sVC) + length(q.tVC)) +
    max(bend.highest, -bend.lowest) * length(q.mVC);
  for (int i = 0; i < ClipPlaneCount; ++i)
  {
    float off = dot(ClipPlanes[i], vec4(q.positionVC, 1.0));
    float reach = ball * length(ClipPlanes[i].xyz);
    seen = seen && off >= -reach;
    whole = whole && off >= reach;
  }
#endif
#ifdef CLIP_LINES
  clipSplat(q, HasClipLines ? RadiusScale * texelFetch(ClipLineTexels, int(splat)) : vec4(0.0), b.z);
  bool isClipped = endsAtLines(q);
#else
  const bool isClipped = false;
#endif
  // Of rays that are taken for parallel within a tile, and all over the splat. At clip lines two
  // splats meet, and no filter widens what is narrow.
  float perspective = length(vec2(q.s.z, q.t.z)) + abs(q.m.z) * bend.strongest;
  bool isBent = whole &&
    TileReach * TileReach * perspective <=
      StillPixels * (isClipped ? 0.5 * thin : max(thin, PrefilterRadius));
  float shift = KernelSupport * longest * nearer;
  bool isFlat = whole && (!narrow || leans) &&
    shift + max(bend.highest, -bend.lowest) * length(q.m.xy) <= StillPixels;
#ifdef COORDINATES
  // Of flat ones that the filter widens it would not be known how coarse pixels are.
  isFlat = isFlat && thin >= PrefilterRadius;
#endif
  ivec2 tiles = last - first;
  bool isWide = max(tiles.x, tiles.y) >= WideTiles;
  uint kind = !seen        ? NotSeen
    : isWide               ? Wide
    : isFlat && !isClipped ? Flat
    : !isBent              ? Curved
    : isClipped            ? Clipped
                           : Bent;
  uint bucket = uint(clamp((q.depth - deep - BucketScale.x) * BucketScale.y, 0.0,
    float(DepthBuckets - 1u)));
  uint to = invocation - FirstInvocation;
  writeBox(to, ivec4(first, last), bucket, kind, vec4(ceil(diskLow - 0.5), floor(diskHigh - 0.5)));

  uint head = q.tag | (belongsToBothSides(q) ? BothSides : 0u) |
    encodeLayer(q.layer / max(q.facing, LeastFacing), isEdgeOn(q.facing)) << 16;
  uint normal = encodeNormal(q.normal);
  uvec4 r1;
  uvec4 r2;
  uvec4 r3;
  uvec4 r4;
#ifdef COORDINATES
  uvec4 coordinates =
    HasCoordinates ? texelFetch(Coordinates, int(splat)) : uvec4(NoCoordinates);
  vec2 changeS = RadiusScale * unpackHalf2x16(coordinates.z);
  vec2 changeT = RadiusScale * unpackHalf2x16(coordinates.w);
#endif
  if (kind == Flat)
  {
    // Along each axis u and v change by 1 over its length; where the axis is widened, the best
    // guess of where on the splat a pixel lies is by as much less as it is narrower.
    vec2 slopes = -vec2(dot(end, vec2(q.sVC.z, q.tVC.z)), dot(otherEnd, vec2(q.sVC.z, q.tVC.z)));
    float least = hidesGaps(DiskReach * bend.strongest * longest, CoverageRadius) ? CoverageDot
                                                                                  : CoverageRadius;
    float v1 = 1.0 / max(longest, least);
    float v2 = 1.0 / max(thin, least);
    float w1 = 1.0 / max(longest, PrefilterRadius);
    float w2 = 1.0 / max(thin, PrefilterRadius);
    vec2 onMajor = w1 * w1 * longest * major;
    vec2 onMinor = w2 * w2 * shortest * minor;
    vec2 slope = v1 * v1 * longest * slopes.x * major + v2 * v2 * shortest * slopes.y * minor;
    vec2 filtered = slopes.x * onMajor + slopes.y * onMinor;
    vec3 turn1 = end.x * q.turnS + end.y * q.turnT;
    vec3 turn2 = otherEnd.x * q.turnS + otherEnd.y * q.turnT;
    r1 = floatBitsToUint(vec4(formOf(v1 * major, v2 * minor), slope.x));
    r2 = floatBitsToUint(vec4(slope.y, formOf(w1 * major, w2 * minor)));
    r3 = uvec4(floatBitsToUint(filtered), normal, 0u);
    r4 = uvec4(encodeTurns(onMajor.x * turn1 + onMinor.x * turn2,
                 onMajor.y * turn1 + onMinor.y * turn2), 0u);
#ifdef COORDINATES
    vec2 change1 = end.x * changeS + end.y * changeT;
    vec2 change2 = otherEnd.x * changeS + otherEnd.y * changeT;
    changeS = onMajor.x * change1 + onMinor.x * change2;
    changeT = onMajor.y * change1 + onMinor.y * change2;
#endif
  }
  else
  {
    r1 = floatBitsToUint(vec4(q.s.x, q.t.x, q.s.y, q.t.y));
    r2 = uvec4(floatBitsToUint(vec2(q.sVC.z, q.tVC.z)), normal, leans ? packSnorm2x16(end) : 0u);
    r3 = uvec4(floatBitsToUint(vec3(q.m.xy, q.mVC.z)), encodeBend(q.bend));
    r4 = uvec4(encodeTurns(q.turnS, q.turnT), leans ? packHalf2x16(major / longest) : 0u);
  }
  uint record = to * uint(RecordTexels);
  records[record] = uvec4(floatBitsToUint(vec3(q.centre, q.depth)), head);
  records[record + 1u] = r1;
  records[record + 2u] = r2;
  records[record + 3u] = r3;
  records[record + 4u] = r4;
#ifdef CLIP_LINES
  recordClipLines[to] = q.lines;
#endif
#ifdef COLOURS
  recordColours[to] = HasColours ? texelFetch(Colours, int(splat)).r : 0xffffffffu;
#endif
#ifdef FACTORS
  recordFactors[to] = HasFactors ? texelFetch(Factors, int(splat)).r : 0xffffffffu;
#endif
#ifdef COORDINATES
  recordCoordinates[to] = uvec4(coordinates.xy, packHalf2x16(changeS), packHalf2x16(changeT));
#endif
#ifdef TANGENTS
  vec3 tangent =
    NormalMatrix * (HasTangents ? decodeNormal(texelFetch(Tangents, int(splat)).r) : vec3(1.0));
  recordTangents[to] = encodeNormal(normalize(tangent));
#endif
#ifdef IDS
  recordIds[to] = texelFetch(Ids, int(splat)).r;
#endif
}
