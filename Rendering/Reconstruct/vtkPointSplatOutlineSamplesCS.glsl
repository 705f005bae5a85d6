#version 430
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which surfaces the four samples of a pixel see that an outline runs through: the lists of its
// tile are walked for the nearest hits of the first layer that the outline ends, and each sample
// takes after that of the pixels about it whose layer the hit belongs to: its own, the one beside
// it, the one above or below, or the one across the corner.
// Variants: LAYERS (with deeper layers), CURVED, CLIPPING, CLIP_LINES, TRIANGLES, as in vtkPointSplatTileCS.
// Reads: Records, RecordClipLines, Lists, Tiles, SceneDepth, LayerTexels, OutlinePixels. Writes:
// Choices, two bits a sample: 1, the pixel beside it, and 2, the one above or below; 3, the one
// across.

#include "vtkPointSplatTilePixels"
#include "vtkPointSplatTileFlat"
#include "vtkPointSplatTileCaps"
#ifdef TRIANGLES
#include "vtkPointSplatTileTriangles"
#endif
#include "vtkPointSplatTileWalk"
#include "vtkPointSplatLayers"

layout(local_size_x = 64) in;

uniform usamplerBuffer OutlinePixels; // R32UI, see vtkPointSplatOutlines.h
uniform int FirstOutline;             // of this dispatch
uniform int OutlineCount;
uniform ivec4 TileWindow;             // pixels that have layers: first x, y, last x, y
uniform ivec2 TileShift;              // lists are of tiles of 2^TileShift pixels
layout(std430, binding = 0) buffer Choices { uint choices[]; };

// The layers of the pixels about the one with the outline.
float depthsAbout[9];
uint tagsAbout[9];

uint fetchTag(ivec2 pixel, int layer, out float depth)
{
  bool there = true;
  uvec4 texel = uvec4(0u);
  for (int l = 0; l <= layer; ++l)
  {
    there = there && !(l > 0 && isLast(texel));
    texel = fetchLayer(pixel, l);
    there = there && !isEmpty(texel);
  }
  depth = uintBitsToFloat(texel.x);
  return there ? tagOfTexel(texel) : NoTag;
}

// Which of the pixels about it sample k takes after. place: 0 or 1 along x and y.
uint choose(int k, ivec2 place)
{
  uint choice = 0u;
  float least = NoHit;
  for (uint c = 0u; c < 4u; ++c)
  {
    ivec2 step = (2 * place - 1) * ivec2(int(c & 1u), int(c >> 1));
    int at = 4 + step.x + 3 * step.y;
    bool there = tagsAbout[at] != NoTag;
    // Of what sees nothing the farthest, or one that is empty; else what is nearest in depth, of
    // the same cloud if there is one.
    float off = tags[k] == NoTag ? (there ? -depthsAbout[at] : -NoHit)
      : !there                   ? NoHit
      : abs(depthsAbout[at] - nearest[k]) +
        ((tagsAbout[at] ^ tags[k]) > 1u ? 0.5 * NoHit : 0.0);
    bool better = off < least;
    choice = better ? c : choice;
    least = better ? off : least;
  }
  return choice;
}

void main()
{
  int index = int(gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * (64 / LANES) +
    int(gl_LocalInvocationID.x) / LANES;
  if (index >= OutlineCount)
  {
    return;
  }
  int outline = FirstOutline + index;
  uint word = texelFetch(OutlinePixels, outline).r;
  int layer = int(word >> 28);
  int pixel = int(word & 0xfffffffu);
  ivec2 first = ivec2(pixel % LayerSize.x, pixel / LayerSize.x);
  corner = vec2(first) + 0.5;
  Span all;
#if LANES > 1
  ivec2 listed = first >> TileShift;
  spanOf(listed.y * TilesAcross + listed.x, all);
#else
  spanOf(index, all);
#endif
  // Nothing farther off than what is about the pixel is looked for.
  float farthest = -1.0;
  for (int i = 0; i < 9; ++i)
  {
    ivec2 at = clamp(first + ivec2(i % 3 - 1, i / 3 - 1), TileWindow.xy, TileWindow.zw);
    tagsAbout[i] = fetchTag(at, layer, depthsAbout[i]);
    farthest = tagsAbout[i] == NoTag
      ? farthest
      : max(farthest, depthsAbout[i] + 5.0 * itemLayer(tagsAbout[i]));
  }
#ifdef LAYERS
  vec3 own = vec3(-1.0);
  uvec3 ownTags = uvec3(NoTag);
  for (int l = 0; l < layer; ++l)
  {
    uvec4 texel = fetchLayer(first, l);
    peeledTo = uintBitsToFloat(texel.x);
    own = vec3(peeledTo, own.xy);
    ownTags = uvec3(tagOfTexel(texel), ownTags.xy);
  }
  farthest = HasSceneDepth ? min(farthest, sceneDepthAt(first)) : farthest;
#endif
  for (int k = 0; k < Pixels; ++k)
  {
    startPixel(k, farthest);
#ifdef LAYERS
    before[k] = own;
    beforeTags[k] = ownTags;
#endif
  }
  Span left = all;
  see(left, all);
  uint chosen = 0u;
  for (int k = 0; k < Pixels; ++k)
  {
    ivec2 place = placeOf(k);
    chosen |= choose(k, place) << uint(2 * (2 * place.y + place.x));
  }
#if LANES > 1
  atomicOr(choices[outline], chosen);
#else
  choices[outline] = chosen;
#endif
}
