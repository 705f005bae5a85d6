#version 430
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lists the tiles that an outline may run through, for vtkPointSplatOutlineCS: those that are not smooth (of which
// vtkPointSplatTileSummary tells), or do not continue one beside them. On a CPU all of several invocations take as long
// as the one that looks at its pixels: so those that do are gathered first.
// An invocation has a tile of TILE_WIDTH x TILE_HEIGHT pixels.
// Reads: Summaries. Writes: ListedTiles, in no order, and their number.

#include "vtkPointSplatItemTable"

layout(local_size_x = 64) in;

uniform usamplerBuffer Summaries; // RGBA32UI
uniform ivec4 Tiles;              // that are looked at: first x, y, last x, y
uniform ivec4 TileWindow;         // of all that have summaries, likewise
uniform int TilesAcross;          // of the image
layout(std430, binding = 0) writeonly buffer ListedTiles { uint listedTiles[]; };
layout(std430, binding = 7) buffer ListedCount { uint listedCount; };

const uint NoSlot = 0xffffu; // of a tile with nothing in it

// Whether a tile continues what another is: step: from that to this, in tiles.
bool continues(uvec4 from, uvec4 to, ivec2 step)
{
  vec3 a = uintBitsToFloat(from.xyz);
  vec3 b = uintBitsToFloat(to.xyz);
  float next = step.x != 0
    ? a.x + (a.y - a.x) * (float(TILE_WIDTH) / float(TILE_WIDTH - 1)) - b.x
    : a.x + (a.z - a.x) * (float(TILE_HEIGHT) / float(TILE_HEIGHT - 1)) - b.x;
  return from.w == to.w && from.w != 0xffffffffu &&
    ((from.w & 0xffffu) == NoSlot || abs(next) <= 0.5 * itemLayer(from.w & 0xffffu));
}

bool isPlain(ivec2 tile)
{
  uvec4 own = texelFetch(Summaries, tile.y * TilesAcross + tile.x);
  bool plain = own.w != 0xffffffffu;
  for (int k = 0; k < 4; ++k)
  {
    ivec2 step = (k < 2 ? 1 : -1) * ivec2(k & 1, 1 - (k & 1));
    ivec2 at = clamp(tile + step, TileWindow.xy, TileWindow.zw);
    uvec4 other = texelFetch(Summaries, at.y * TilesAcross + at.x);
    plain = plain &&
      (at == tile || (k < 2 ? continues(own, other, step) : continues(other, own, step)));
  }
  return plain;
}

void main()
{
  int index =
    int((gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 64u + gl_LocalInvocationID.x);
  int tilesInRow = Tiles.z - Tiles.x + 1;
  ivec2 tile = Tiles.xy + ivec2(index % tilesInRow, index / tilesInRow);
  if (tile.y <= Tiles.w && !isPlain(tile))
  {
    listedTiles[atomicAdd(listedCount, 1u)] = uint(tile.y * TilesAcross + tile.x);
  }
}
