#version 430
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Finds the pixels that an outline runs through: where a layer ends, or belongs to another cloud
// than beside it, or where its depth's second difference, which vanishes on planes, is more than a
// least layer distance of its cloud, so that one surface ends before another.
// An invocation has a tile of TILE_WIDTH x TILE_HEIGHT pixels; with LISTED, one that
// vtkPointSplatOutlineTilesCS listed.
// Reads: LayerTexels, ListedTiles. Writes: OutlinePixels (vtkPointSplatOutlines.h) their
// number and their indices; OutlineFlag of the nearest layer's texels.

#include "vtkPointSplatTexel"
#include "vtkPointSplatItemTable"

layout(local_size_x = 64) in;

uniform usamplerBuffer LayerTexels; // RGBA32UI
uniform ivec2 LayerSize;
uniform int LayerCapacity;
uniform int LayerCount;
uniform ivec4 TileWindow;           // pixels that are looked at: first x, y, last x, y
uniform int FirstRow;               // of pixels that is bound
uniform int RowCount;               // that are
layout(std430, binding = 0) buffer Texels { uint texels[]; };
layout(std430, binding = 4) writeonly buffer OutlinePixels { uint outlinePixels[]; };
layout(std430, binding = 7) buffer OutlineCount { uint outlineCount; };
layout(std430, binding = 6) writeonly buffer OutlineIndices { uint outlineIndices[]; };

const int Across = TILE_WIDTH + 2;
const ivec2 TileSize = ivec2(TILE_WIDTH, TILE_HEIGHT);
const int Looked = Across * (TILE_HEIGHT + 2);

// Of a pixel that has no more layers; and of one of which nobody looked.
const uint NoSlot = 0xffffu;
const uint AnySlot = 0xfffeu;

float depths[Looked];
uint slots[Looked];
bool ends[Looked]; // the light ends with this layer

void startPixels()
{
  for (int k = 0; k < Looked; ++k)
  {
    slots[k] = 0u;
  }
}

bool differs(uint a, uint b)
{
  return a != b && a != AnySlot && b != AnySlot;
}

// Whether the depths of three pixels in a row are no plane's.
bool steps(int before, int at, int after, float leastStep)
{
  bool there = max(max(slots[before], slots[at]), slots[after]) < AnySlot;
  return there && abs(depths[before] - 2.0 * depths[at] + depths[after]) > leastStep;
}

// Lists the pixels of a tile that outlines run through.
void find(ivec2 first, ivec2 low, ivec2 high)
{
  uint found = 0u;
  startPixels();
  for (int layer = 0; layer < LayerCount; ++layer)
  {
    for (int k = 0; k < Looked; ++k)
    {
      // What is not looked at counts as what is beside it.
      ivec2 pixel = clamp(first + ivec2(k % Across - 1, k / Across - 1), low, high);
      uvec4 texel = texelFetch(
        LayerTexels, (pixel.y * LayerCapacity + layer) * LayerSize.x + pixel.x);
      bool ended = slots[k] >= AnySlot;
      slots[k] = ended ? slots[k] : isEmpty(texel) ? NoSlot : tagOfTexel(texel) >> 1;
      depths[k] = uintBitsToFloat(texel.x);
      ends[k] = isLast(texel);
    }
    for (int k = 0; k < TILE_WIDTH * TILE_HEIGHT; ++k)
    {
      int at = (k / TILE_WIDTH + 1) * Across + k % TILE_WIDTH + 1;
      uint slot = slots[at];
      float leastStep = slot < AnySlot ? itemLayer(2u * slot) : 0.0;
      bool outline = differs(slot, slots[at - 1]) || differs(slot, slots[at + 1]) ||
        differs(slot, slots[at - Across]) || differs(slot, slots[at + Across]) ||
        steps(at - 1, at, at + 1, leastStep) || steps(at - Across, at, at + Across, leastStep);
      ivec2 pixel = first + ivec2(k % TILE_WIDTH, k / TILE_WIDTH);
      if (outline && (found >> k & 1u) == 0u && pixel == clamp(pixel, low, high))
      {
        found |= 1u << k;
        uint place = uint(pixel.y * LayerSize.x + pixel.x);
        uint index = atomicAdd(outlineCount, 1u);
        outlinePixels[index] = place | uint(min(layer, 15)) << 28;
        outlineIndices[place] = index;
        texels[4 * ((pixel.y - FirstRow) * LayerCapacity * LayerSize.x + pixel.x) + 2] |=
          OutlineFlag;
      }
    }
#ifdef LAYERS
    bool more = false;
    for (int k = 0; k < Looked; ++k)
    {
      slots[k] = slots[k] < AnySlot && ends[k] ? AnySlot : slots[k];
      more = more || slots[k] < AnySlot;
    }
    if (!more)
    {
      break;
    }
#endif
  }
}

#ifdef LISTED
uniform usamplerBuffer ListedTiles; // R32UI, y times the image's tiles across plus x
uniform int TilesAcross;
uniform int TileCount;
#endif

void main()
{
  int row = max(TileWindow.y, FirstRow);
  ivec2 low = ivec2(TileWindow.x, row);
  ivec2 high = ivec2(TileWindow.z, min(TileWindow.w, FirstRow + RowCount - 1));
  int index =
    int((gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 64u + gl_LocalInvocationID.x);
#ifdef LISTED
  bool looks = index < TileCount;
  int listed = int(texelFetch(ListedTiles, index).r);
  ivec2 tile = ivec2(listed % TilesAcross, listed / TilesAcross);
#else
  ivec2 lowTile = low / TileSize;
  int tilesInRow = high.x / TileSize.x - lowTile.x + 1;
  ivec2 tile = lowTile + ivec2(index % tilesInRow, index / tilesInRow);
  bool looks = tile.y <= high.y / TileSize.y;
#endif
  // A loop, which CPUs leave where none of several invocations goes on.
  while (looks)
  {
    find(tile * TileSize, low, high);
    looks = false;
  }
}
