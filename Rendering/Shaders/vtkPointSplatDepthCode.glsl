// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Coded depths, and what they name.

// The low bits of a depth name the cloud and the side that was hit.
const uint TagMask = 127u;
const uint NoDepth = 0xffffffffu;

// Depths as integers of the same order, the tag in their lowest bits.
uint encodeDepth(float depth, uint tag)
{
  return (floatBitsToUint(depth) & ~TagMask) | tag;
}

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
