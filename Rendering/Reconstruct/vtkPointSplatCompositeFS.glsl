#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The compositing pass of deferred blending (Zhang, Pajarola 2006, figure 5): what
// of the groups' images lies within the least layer distance of the nearest
// disk is summed up, the less of it the farther off it is.
// Reads: the groups' texels and depths. Writes: see vtkPointSplatTexel.

#include "vtkPointSplatProjection"
#include "vtkPointSplatDepthCode"
#include "vtkPointSplatGroupTexel"
#include "vtkPointSplatKernel"
#include "vtkPointSplatTexel"
#if defined(VALUES) || defined(CELL_COLOURS) || defined(FACETS)
#define ITEMS
#include "vtkPointSplatItemTable"
#include "vtkPointSplatValue"
#endif

uniform usampler2DArray Texels;
uniform sampler2DArray GroupDepths;
uniform int GroupCount;
uniform ivec2 LastPixel; // of Texels

layout(location = 0) out uvec4 texel;
#ifdef FACTORS
uniform usampler2DArray FactorTexels;

layout(location = 1) out uint factorTexel;
#endif

// The nearest disk's coded depth at a pixel, and the nearest of the kernels' tails.
void nearestDepths(ivec2 pixel, out uint disk, out uint tail)
{
  disk = NoDepth;
  tail = NoDepth;
  for (int k = 0; k < GroupCount; ++k)
  {
    // Texels are not cleared: where the depth is, nothing was drawn.
    if (texelFetch(GroupDepths, ivec3(pixel, k), 0).r < 1.0)
    {
      uvec4 splat = texelFetch(Texels, ivec3(pixel, k), 0);
      bool onDisk = (splat.z & 0x8000u) == 0u;
      disk = onDisk ? min(disk, splat.x) : disk;
      tail = onDisk ? tail : min(tail, splat.x);
    }
  }
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  uint nearest;
  uint tail;
  nearestDepths(pixel, nearest, tail);
  if (nearest == NoDepth && tail != NoDepth)
  {
    // The disk that was here may be hidden by the tail of a splat of its own group.
    // Where most of the pixels around have disks, this one is no outline's.
    const ivec2 around[4] = ivec2[4](ivec2(1, 0), ivec2(-1, 0), ivec2(0, 1), ivec2(0, -1));
    int disks = 0;
    for (int i = 0; i < 4; ++i)
    {
      ivec2 other = pixel + around[i];
      uint disk;
      uint unused;
      if (other == clamp(other, ivec2(0), LastPixel))
      {
        nearestDepths(other, disk, unused);
        disks += disk != NoDepth ? 1 : 0;
      }
    }
    nearest = disks >= 3 ? tail : NoDepth;
  }
  texel = uvec4(0u);
#ifdef FACTORS
  factorTexel = 0u;
#endif
  if (nearest == NoDepth)
  {
    return;
  }
#ifdef ITEMS
  vec4 map = itemValueMap(nearest & TagMask);
#endif
#if defined(CELL_COLOURS) || defined(FACETS)
  float greatest = 0.0;
  uint ofGreatest = 0u; // its colour
#endif
#ifdef FACETS
  vec3 facet = vec3(0.0, 0.0, 1.0);
#endif
  float weights = 0.0;
  vec4 normalAndBehind = vec4(0.0);
  vec4 colours = vec4(0.0);
#ifdef FACTORS
  vec4 factors = vec4(0.0);
#endif
  for (int k = 0; k < GroupCount; ++k)
  {
    if (texelFetch(GroupDepths, ivec3(pixel, k), 0).r < 1.0)
    {
      uvec4 splat = texelFetch(Texels, ivec3(pixel, k), 0);
      uint different = (nearest ^ splat.x) & TagMask;
      bool steep = (splat.z & 0x80000000u) != 0u;
      float behind = decodeDepth(splat.x) - decodeDepth(nearest);
      float layer = DepthUnit * decodeHalf(splat.z >> 16);
      bool edgeOn = (splat.z >> 16 & EdgeOnLayer) != 0u;
      if ((different == 0u || (different == 1u && !steep)) && abs(behind) <= layer)
      {
        float weight = decodeHalf(splat.z) * layerShare(behind, layer, edgeOn);
        weights += weight;
        normalAndBehind +=
          weight * vec4(turnTo(nearest, splat.x) * decodeNormal(splat.y), behind);
#ifdef VALUES
        // As weightedValue(), but floats need no second part.
        vec2 value = decodeValue(splat.w);
        colours += weight *
          (hasValues(map) ? vec4(value.x, 0.0, value.y, 0.0) : unpackColour(splat.w));
#else
        colours += weight * unpackColour(splat.w);
#endif
#if defined(CELL_COLOURS) || defined(FACETS)
        ofGreatest = weight > greatest ? splat.w : ofGreatest;
#ifdef FACETS
        facet = weight > greatest ? turnTo(nearest, splat.x) * decodeNormal(splat.y) : facet;
#endif
        greatest = max(greatest, weight);
#endif
#ifdef FACTORS
        factors += weight * unpackColour(texelFetch(FactorTexels, ivec3(pixel, k), 0).r);
#endif
      }
    }
  }
  normalAndBehind /= weights;
  vec4 colour = colours / weights;
#ifdef VALUES
  colour = colourOfSum(colours, weights, map);
#endif
#ifdef CELL_COLOURS
  colour = hasCellColours(map) ? unpackColour(ofGreatest) : colour;
#endif
#ifdef FACETS
  normalAndBehind.xyz = itemIsFlat(nearest & TagMask) ? facet : normalAndBehind.xyz;
#endif
  texel = packTexel(decodeDepth(nearest) + normalAndBehind.w, normalAndBehind.xyz,
    nearest & TagMask, 1.0, colour);
#ifdef FACTORS
  factorTexel = packColour(factors / weights);
#endif
}
