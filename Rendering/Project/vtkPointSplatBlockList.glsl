// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which splat an invocation has: of the listed runs, in blocks of 2^BlockShift splats, every
// 2^StrideShift-th.

layout(std430, binding = 7) readonly buffer Blocks { uvec2 blocks[]; }; // first, count

uniform bool DrawBlocks;   // else all splats, one after the other
uniform uint InvocationCount;
uniform uint SplatCount;   // of the cloud
uniform int StrideShift;
uniform int BlockShift;

// False: the invocation has none.
bool listedSplat(uint invocation, out uint splat)
{
  uint shift = uint(BlockShift - StrideShift);
  uint block = invocation >> shift;
  uint within = (invocation & ((1u << shift) - 1u)) << StrideShift;
  bool given = invocation < InvocationCount;
  uvec2 run = uvec2(block << BlockShift, 1u << BlockShift);
  if (DrawBlocks)
  {
    run = blocks[given ? block : 0u];
  }
  splat = run.x + within;
  given = given && within < run.y && splat < SplatCount;
  splat = given ? splat : 0u;
  return given;
}
