// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Depths as integers of the same order, for what must compare and name in one word: the low bits,
// as many as the frame's clouds need, hold a tag, which names the cloud and the side that was hit.

uniform uint TagMask; // the bits of the tag

const uint NoDepth = 0xffffffffu;

uint encodeDepth(float depth, uint tag)
{
  return (floatBitsToUint(depth) & ~TagMask) | tag;
}

// Of a depth there is.
float decodeDepth(uint code)
{
  return uintBitsToFloat(code & ~TagMask);
}

// What turns the normal of a splat with this tag to the side that the nearest one shows: with
// those of a thin wall's far side, or that point the wrong way, the sum would cancel. 1 or -1.
float turnTo(uint nearest, uint tag)
{
  return ((nearest ^ tag) & 1u) != 0u ? -1.0 : 1.0;
}

int slotOf(uint code)
{
  return int((code & TagMask) >> 1);
}
