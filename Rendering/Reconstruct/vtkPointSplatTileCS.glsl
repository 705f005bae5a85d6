#version 430
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reconstructs a tile's surface layers from the lists of its splats, nearest buckets first:
// 1. The nearest hit of each pixel, of what is behind the layers before.
// 2. Sums over the splats that belong to its layer: weights, and weighted normals, depths, colours
//    or values, and factors of lights. Their means are the layer's texel; that of values is mapped.
// 3. With LAYERS, the next layer, until each pixel has no further hit, or so little light comes
//    through the layers before that what is behind could not be seen.
// Variants: LAYERS, GATHER (the last layer takes all that is left, weighted by opacity), COLOURS,
// VALUES (of some clouds in the place of colours), CELL_COLOURS (of some), FACETS (some are flat),
// FACTORS, LOOKS (texels of looks) and of these COORDINATES, TANGENTS and EDGES, IDS (names the splat
// of the greatest weight), KERNELS, PLATEAU, CURVED (some splats need exact rays), CLIPPING,
// CLIP_LINES (some splats are clipped), TRIANGLES (there are some).
// Reads: Records, RecordClipLines, Lists, Tiles, SceneDepth. Writes: Texels, FactorTexels,
// LookTexels, IdTexels, Counts.

#include "vtkPointSplatTilePixels"
#include "vtkPointSplatTileFlat"
#include "vtkPointSplatTileCaps"
#ifdef TRIANGLES
#include "vtkPointSplatTileTriangles"
#endif
#include "vtkPointSplatTileWalk"
#ifdef SUMMARIES
#include "vtkPointSplatTileSummary"
#endif

layout(local_size_x = 64) in;

uniform int FirstTile; // that is run
uniform int TileCount;
uniform ivec4 TileWindow; // pixels that are written: first x, y, last x, y
uniform int FirstRow;     // of pixels that is bound
uniform int ImageWidth;
uniform int LayerCapacity; // layers that there is room for
layout(std430, binding = 0) writeonly buffer Texels { uvec4 texels[]; };
#ifdef FACTORS
layout(std430, binding = 1) writeonly buffer FactorTexels { uint factorTexels[]; };
#endif
#ifdef IDS
layout(std430, binding = 2) writeonly buffer IdTexels { uint idTexels[]; };
#endif
#ifdef LOOKS
layout(std430, binding = 5) writeonly buffer LookTexels { uvec4 lookTexels[]; };
#endif
#ifdef LAYERS
layout(std430, binding = 3) buffer Counts { uint layersMade; }; // the most of any pixel
uniform int MaximumLayers;
uniform int LayersToClear;       // that are written even where they are empty
uniform float LeastContribution; // of the light behind
#ifndef GATHER
const bool Gather = false;
#else
const bool Gather = true;
#endif
#endif

void add(Span s, Span all)
{
  float end = layerEnd();
  addFlat(s.flats, all.bents, end);
  addBent(s.bents, all.curveds, end);
#ifdef CURVED
  addCurved(s.curveds, curvedEnd(all), ivec2(s.wides, all.wideEnd), end);
#endif
#ifdef TRIANGLES
  addTriangles(s.triangles, all.end, end);
#endif
}

bool isWritten(ivec2 pixel)
{
  return pixel == clamp(pixel, TileWindow.xy, TileWindow.zw);
}

// Writes a layer's pixels, and finds what of the light behind comes through it. Where nothing
// is hit, a pixel's layers end.
void writeLayer(ivec2 first, int layer)
{
  for (int k = 0; k < Pixels; ++k)
  {
    float share = 1.0 / max(weights[k], 1.0);
    vec4 colour = vec4(1.0);
#ifdef COLOURS
    colour = colours[k] * share;
#endif
    bool hit = tags[k] != NoTag;
#if defined(VALUES) || defined(CELL_COLOURS)
    vec4 map = itemValueMap(hit ? tags[k] : 0u);
#ifdef GATHER
    map = gathering ? vec4(0.0) : map;
#endif
#endif
#ifdef VALUES
    colour = weights[k] > 0.0 ? colourOfSum(colours[k], weights[k], map) : colour;
#endif
#ifdef CELL_COLOURS
    colour = hasCellColours(map) ? unpackColour(ids[k]) : colour;
#endif
    float depth = nearest[k] + behinds[k] * share * (DepthUnit / DepthScale);
    vec3 normal = weights[k] > 0.0 ? normals[k] * share : vec3(0.0, 0.0, 1.0);
#ifdef FACETS
    bool facet = weights[k] > 0.0 && hit && itemIsFlat(tags[k]);
#ifdef GATHER
    facet = facet && !gathering;
#endif
    normal = facet ? normals[k] : normal;
#endif
    uvec4 texel = hit ? packTexel(depth, normal, tags[k], 1.0, colour) : uvec4(0u);
    ivec2 pixel = first + placeOf(k);
    int row = pixel.y - FirstRow;
    int at = (row * LayerCapacity + layer) * ImageWidth + pixel.x;
    bool written = isWritten(pixel);
#ifdef LAYERS
    written =
      written && layer < LayerCapacity && (light[k] >= 0.0 || layer < LayersToClear);
    float opacity = hit ? colour.a * (gathering ? 1.0 : itemOpacity(tags[k])) : 0.0;
    light[k] = hit ? light[k] * (1.0 - opacity) : -1.0;
    texel.z |= hit && light[k] < LeastContribution ? LastFlag : 0u;
#endif
    if (written)
    {
      texels[at] = texel;
#ifdef FACTORS
      factorTexels[at] = packColour(vec4(factors[k] * share));
#endif
#ifdef LOOKS
      uvec4 coordinates = coordinateTexel(k);
#ifdef GATHER
      coordinates = gathering ? uvec4(NoCoordinates) : coordinates;
#endif
      lookTexels[LOOKS * at] = coordinates;
#if LOOKS > 1
      lookTexels[LOOKS * at + 1] = surfaceTexel(k);
#endif
#endif
#ifdef IDS
      idTexels[row * ImageWidth + pixel.x] = ids[k];
#endif
    }
  }
}

#ifdef LAYERS
void writeEmpty(ivec2 first, int layer)
{
  for (int k = 0; k < Pixels; ++k)
  {
    ivec2 pixel = first + placeOf(k);
    if (isWritten(pixel))
    {
      texels[((pixel.y - FirstRow) * LayerCapacity + layer) * ImageWidth + pixel.x] = uvec4(0u);
    }
  }
}
#endif

void main()
{
  int tile = int(gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * (64 / LANES) +
    int(gl_LocalInvocationID.x) / LANES;
  Span all;
  if (tile >= TileCount || !spanOf(FirstTile + tile, all))
  {
    return;
  }
  Span left = all;
  ivec2 first = ivec2(all.tile % TilesAcross, all.tile / TilesAcross) *
    ivec2(TILE_WIDTH, TILE_HEIGHT);
  corner = vec2(first) + 0.5;
#ifdef LAYERS
  for (int k = 0; k < Pixels; ++k)
  {
    before[k] = vec3(-1.0);
    beforeTags[k] = uvec3(NoTag);
    light[k] = 1.0;
  }
  int layer = 0;
  int made = 0;
  bool any;
  do
  {
    gathering = Gather && layer == MaximumLayers - 1;
    for (int k = 0; k < Pixels; ++k)
    {
      float farthest = NoHit;
      if (HasSceneDepth)
      {
        farthest = sceneDepthAt(min(first + placeOf(k), TileWindow.zw));
      }
#ifdef GATHER
      hidden[k] = farthest;
#endif
      // Of a pixel that is done nothing is seen.
      startPixel(k, light[k] < LeastContribution ? -1.0 : farthest);
    }
    see(left, all);
    clearLayer();
    add(left, all);
    writeLayer(first, layer);
#ifdef SUMMARIES
    summarise(layer);
#endif
    any = false;
    peeledTo = NoHit;
    for (int k = 0; k < Pixels; ++k)
    {
      before[k] = vec3(nearest[k], before[k].xy);
      beforeTags[k] = uvec3(tags[k], beforeTags[k].xy);
      bool goesOn = light[k] >= LeastContribution;
      any = any || goesOn;
      peeledTo = goesOn ? min(peeledTo, nearest[k]) : peeledTo;
      made = tags[k] != NoTag ? layer + 1 : made;
    }
    ++layer;
  } while (any && layer < MaximumLayers);
  for (; layer < LayersToClear; ++layer)
  {
    writeEmpty(first, layer);
  }
  atomicMax(layersMade, uint(made));
#else
  for (int k = 0; k < Pixels; ++k)
  {
    startPixel(k, NoHit);
  }
  see(left, all);
  clearLayer();
  add(left, all);
  writeLayer(first, 0);
#ifdef SUMMARIES
  summarise(0);
#endif
#endif
#ifdef SUMMARIES
  writeSummary(all.tile);
#endif
}
