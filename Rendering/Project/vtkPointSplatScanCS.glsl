#version 430
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sums up counts in three runs, so that they take the whole device:
// 1. PARTS: each work group sums up its part of the counts.
// 2. SUMS: one work group sums up those sums, before each part.
// 3. Each work group does so within its part: where each list begins, and after the last one where
//    all end. Lists of more than one entry are to be sorted.
// Reads and writes: Sums; Counts, which become a copy of where lists begin. Writes: Starts,
// Sortables (how many, and which: in any order).

layout(local_size_x = 256) in;

#ifndef SUMS
const uint Each = 8u; // counts of an invocation
layout(std430, binding = 0) buffer Counts { uint counts[]; };
uniform uint ListCount;
#endif
#if !defined(PARTS) && !defined(SUMS)
layout(std430, binding = 1) writeonly buffer Starts { uint starts[]; };
layout(std430, binding = 3) buffer Sortables
{
  uint sortableCount;
  uint sortables[];
};
#endif
layout(std430, binding = 2) buffer Sums { uint sums[]; };
uniform uint PartCount;

shared uint upTo[256];

// The sum of what the invocations of the group up to this one have.
uint sumUp(uint own, uint mine)
{
  upTo[own] = mine;
  barrier();
  for (uint step = 1u; step < 256u; step *= 2u)
  {
    uint before = own >= step ? upTo[own - step] : 0u;
    barrier();
    upTo[own] += before;
    barrier();
  }
  return upTo[own];
}

void main()
{
  uint own = gl_LocalInvocationIndex;
#ifdef SUMS
  uint each = (PartCount + 255u) / 256u;
  uint begin = min(own * each, PartCount);
  uint end = min(begin + each, PartCount);
#else
  uint part = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
  uint begin = min((part * 256u + own) * Each, ListCount);
  uint end = min(begin + Each, ListCount);
#endif
  uint mine = 0u;
  for (uint i = begin; i < end; ++i)
  {
#ifdef SUMS
    mine += sums[i];
#else
    mine += counts[i];
#endif
  }
  uint at = sumUp(own, mine) - mine;
#ifdef SUMS
  for (uint i = begin; i < end; ++i)
  {
    uint sum = sums[i];
    sums[i] = at;
    at += sum;
  }
#elif defined(PARTS)
  if (own == 255u && part < PartCount)
  {
    sums[part] = upTo[255];
  }
#else
  at += part < PartCount ? sums[part] : 0u;
  for (uint i = begin; i < end; ++i)
  {
    uint count = counts[i];
    counts[i] = at;
    starts[i] = at;
    at += count;
    if (count > 1u)
    {
      sortables[atomicAdd(sortableCount, 1u)] = i;
    }
    if (i + 1u == ListCount)
    {
      starts[ListCount] = at;
    }
  }
#endif
}
