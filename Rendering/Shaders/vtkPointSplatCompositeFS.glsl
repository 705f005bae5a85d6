#version 330
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The compositing pass of deferred blending (Zhang, Pajarola 2006, figure 5): what
// of the groups' images lies within the least layer distance of the nearest
// disk is summed up.
// Reads: the groups' texels and depths. Writes: the images that two-pass
// accumulation writes: coded depths (R32UI); weight and normal, depth behind the
// nearest and colour (RGBA32F each); opacity (R32F).

#include "vtkPointSplatProjection"
#include "vtkPointSplatGroupTexel"

uniform usampler2DArray Texels;
uniform sampler2DArray GroupDepths;
uniform int GroupCount;

layout(location = 0) out uint nearestDepth;
layout(location = 1) out vec4 weightAndNormal;
layout(location = 2) out vec4 depthAndColour;
layout(location = 3) out float opacity;
#ifdef FACTORS
uniform usampler2DArray FactorTexels;

layout(location = 4) out vec4 factors;
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
      uvec4 texel = texelFetch(Texels, ivec3(pixel, k), 0);
      bool onDisk = (texel.z & 0x8000u) == 0u;
      disk = onDisk ? min(disk, texel.x) : disk;
      tail = onDisk ? tail : min(tail, texel.x);
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
      if (other == clamp(other, ivec2(0), textureSize(Texels, 0).xy - 1))
      {
        nearestDepths(other, disk, unused);
        disks += disk != NoDepth ? 1 : 0;
      }
    }
    nearest = disks >= 3 ? tail : NoDepth;
  }
  if (nearest == NoDepth)
  {
    discard;
  }
  vec4 a = vec4(0.0);
  vec4 b = vec4(0.0);
  float c = 0.0;
#ifdef FACTORS
  factors = vec4(0.0);
#endif
  for (int k = 0; k < GroupCount; ++k)
  {
    if (texelFetch(GroupDepths, ivec3(pixel, k), 0).r < 1.0)
    {
      uvec4 texel = texelFetch(Texels, ivec3(pixel, k), 0);
      uint different = (nearest ^ texel.x) & TagMask;
      bool steep = (texel.z & 0x80000000u) != 0u;
      float behind = decodeDepth(texel.x) - decodeDepth(nearest);
      if ((different == 0u || (different == 1u && !steep)) &&
        abs(behind) <= DepthUnit * decodeHalf(texel.z >> 16))
      {
        float weight = decodeHalf(texel.z);
        a += weight * vec4(1.0, turnTo(nearest, texel.x) * decodeNormal(texel.y));
        vec4 colour = unpackColour(texel.w);
        b += weight * vec4(clamp(behind / DepthUnit, -1.0, 1.0), colour.rgb);
        c += weight * colour.a;
#ifdef FACTORS
        factors += weight * unpackColour(texelFetch(FactorTexels, ivec3(pixel, k), 0).r);
#endif
      }
    }
  }
  nearestDepth = nearest;
  weightAndNormal = a;
  depthAndColour = b;
  opacity = c;
}
