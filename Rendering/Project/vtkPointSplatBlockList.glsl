// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which splat an invocation has: of the listed blocks of 128 splats, every 2^StrideShift-th.

layout(std430, binding = 7) readonly buffer Blocks { uint blocks[]; };

uniform bool DrawBlocks;   // else all splats, one after the other
uniform uint InvocationCount;
uniform uint SplatCount;   // of the cloud
uniform int StrideShift;

const uint BlockShift = 7u; // as in vtkPointSplatBlocks

// False: the invocation has none.
bool listedSplat(uint invocation, out uint splat)
{
  uint shift = BlockShift - uint(StrideShift);
  uint block = invocation >> shift;
  bool given = invocation < InvocationCount;
  if (DrawBlocks)
  {
    block = blocks[given ? block : 0u];
  }
  splat = block << BlockShift | (invocation & ((1u << shift) - 1u)) << StrideShift;
  given = given && splat < SplatCount;
  splat = given ? splat : 0u;
  return given;
}
