#version 430
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lists splats in the tiles that they touch, on the device: first counted, then (FILL) put where
// the sums of the counts (vtkPointSplatScanCS) say. A tile has three lists, one of each kind, four
// where there are triangles, and each block of 16 x 16 tiles has one of wide splats, after those of all tiles.
// Reads: Boxes. Writes: Counts; Lists, in any order, which vtkPointSplatSortListsCS mends.

#include "vtkPointSplatRecord"

layout(local_size_x = 64) in;

uniform usamplerBuffer Boxes; // RG32UI
layout(std430, binding = 0) buffer Counts { uint counts[]; };
#ifdef FILL
layout(std430, binding = 1) writeonly buffer Lists { uint lists[]; };
#endif

uniform uint BoxCount;
uniform int TilesAcross;
uniform int TileCount;
uniform int KindCount; // that have a list in each tile

void main()
{
  uint index =
    (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 64u + gl_LocalInvocationID.x;
  if (index >= BoxCount)
  {
    return;
  }
  uvec2 box = texelFetch(Boxes, int(index)).xy;
  uint kind = box.y >> 28;
  if (kind == NotSeen)
  {
    return;
  }
  ivec2 first = ivec2(box.x & 4095u, box.x >> 12 & 8191u);
  ivec2 last = ivec2(box.y & 4095u, box.y >> 12 & 8191u);
  bool isWide = kind == Wide;
  first = isWide ? first >> 4 : first;
  last = isWide ? last >> 4 : last;
  int across = isWide ? (TilesAcross + 15) >> 4 : TilesAcross;
  int stride = isWide ? 1 : KindCount;
  uint listed = kind == Triangle ? 4u : kind == Clipped ? Bent : kind;
  int base = isWide ? KindCount * TileCount : int(listed) - 1;
  uint entry = index | (box.x >> 25 | (box.y >> 25 & 7u) << 7) << RecordBits;
  for (int y = first.y; y <= last.y; ++y)
  {
    for (int x = first.x; x <= last.x; ++x)
    {
      uint at = atomicAdd(counts[base + stride * (y * across + x)], 1u);
#ifdef FILL
      lists[at] = entry;
#endif
    }
  }
}
