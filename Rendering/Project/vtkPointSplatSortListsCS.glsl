#version 430
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sorts the lists that have something to sort, nearest bucket first, by as many work groups as fill
// the device, each list by one of them (bitonic sorting, with all comparisons in one direction, so
// that what is missing to a power of two counts as last). Short lists are sorted in shared memory.
// Reads: Starts, Sortables. Reads and writes: Lists.

// Common lists have a few dozen entries: more invocations would have nothing to compare.
layout(local_size_x = 32) in;

const uint Shared = 1024u;

uniform usamplerBuffer Starts;    // R32UI
uniform usamplerBuffer Sortables; // R32UI: how many, and which
layout(std430, binding = 0) coherent buffer Lists { uint lists[]; };

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

void sortList(uint base, uint count)
{
  bool inShared = count <= Shared;
  int steps = findMSB(count - 1u) + 1; // of blocks, until one is as large as the list
  uint size = 1u << uint(steps);
  uint own = gl_LocalInvocationIndex;
  if (inShared)
  {
    for (uint i = own; i < size; i += 32u)
    {
      entries[i] = i < count ? lists[base + i] : 0xffffffffu;
    }
  }
  for (int block = 0; block < steps; ++block)
  {
    for (int middle = block; middle >= 0; --middle)
    {
      barrier();
      memoryBarrierBuffer();
      uint within = (1u << uint(middle)) - 1u;
      // The first of a block's steps compares what lies alike from both of its ends.
      uint mirror = middle == block ? 2u * within + 1u : 1u << uint(middle);
      for (uint t = own; t < size / 2u; t += 32u)
      {
        uint first = 2u * (t & ~within) + (t & within);
        order(inShared, base, first, first ^ mirror, count);
      }
    }
  }
  barrier();
  if (inShared)
  {
    for (uint i = own; i < count; i += 32u)
    {
      lists[base + i] = entries[i];
    }
  }
  barrier(); // before the next list takes the shared entries' place
}

void main()
{
  int count = int(texelFetch(Sortables, 0).r);
  for (int i = int(gl_WorkGroupID.x); i < count; i += int(gl_NumWorkGroups.x))
  {
    int list = int(texelFetch(Sortables, i + 1).r);
    uint base = texelFetch(Starts, list).r;
    sortList(base, texelFetch(Starts, list + 1).r - base);
  }
}
