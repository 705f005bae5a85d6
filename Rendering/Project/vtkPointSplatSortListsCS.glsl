#version 430
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sorts each list, nearest bucket first, by a work group (bitonic sorting, with all comparisons in
// one direction, so that what is missing to a power of two counts as last). Short lists are sorted
// in shared memory.
// Reads: Starts. Reads and writes: Lists.

layout(local_size_x = 128) in;

const uint Shared = 2048u;

uniform usamplerBuffer Starts; // R32UI
layout(std430, binding = 0) coherent buffer Lists { uint lists[]; };

uniform uint ListCount;

shared uint entries[Shared];

// Puts two entries into order, of a list that begins at base or of the shared ones.
void order(bool inShared, uint base, uint i, uint j, uint count)
{
  if (inShared)
  {
    uint a = entries[i];
    uint b = entries[j];
    entries[i] = min(a, b);
    entries[j] = max(a, b);
  }
  else if (j < count)
  {
    uint a = lists[base + i];
    uint b = lists[base + j];
    if (a > b)
    {
      lists[base + i] = b;
      lists[base + j] = a;
    }
  }
}

void main()
{
  uint list = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
  if (list >= ListCount)
  {
    return;
  }
  uint base = texelFetch(Starts, int(list)).r;
  uint count = texelFetch(Starts, int(list) + 1).r - base;
  bool inShared = count <= Shared;
  uint size = 2u;
  while (size < count)
  {
    size *= 2u;
  }
  if (count < 2u)
  {
    return;
  }
  uint own = gl_LocalInvocationIndex;
  if (inShared)
  {
    for (uint i = own; i < size; i += 128u)
    {
      entries[i] = i < count ? lists[base + i] : 0xffffffffu;
    }
  }
  for (uint block = 2u; block <= size; block *= 2u)
  {
    for (uint span = block; span >= 2u; span /= 2u)
    {
      barrier();
      memoryBarrierBuffer();
      uint middle = span / 2u;
      for (uint t = own; t < size / 2u; t += 128u)
      {
        uint first = t / middle * span + t % middle;
        uint second = span == block ? t / middle * span + span - 1u - t % middle : first + middle;
        order(inShared, base, first, second, count);
      }
    }
  }
  barrier();
  if (inShared)
  {
    for (uint i = own; i < count; i += 128u)
    {
      lists[base + i] = entries[i];
    }
  }
}
