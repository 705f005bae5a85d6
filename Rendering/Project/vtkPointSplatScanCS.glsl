#version 430
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sums up counts, by one work group: where each list begins, and after the last one where all end.
// Reads and writes: Counts, which become a copy of the sums. Writes: Starts.

layout(local_size_x = 256) in;

layout(std430, binding = 0) buffer Counts { uint counts[]; };
layout(std430, binding = 1) writeonly buffer Starts { uint starts[]; };

uniform uint ListCount;

shared uint sums[256];

void main()
{
  uint own = gl_LocalInvocationIndex;
  uint each = (ListCount + 255u) / 256u;
  uint begin = min(own * each, ListCount);
  uint end = min(begin + each, ListCount);
  uint sum = 0u;
  for (uint i = begin; i < end; ++i)
  {
    sum += counts[i];
  }
  sums[own] = sum;
  barrier();
  for (uint step = 1u; step < 256u; step *= 2u)
  {
    uint before = own >= step ? sums[own - step] : 0u;
    barrier();
    sums[own] += before;
    barrier();
  }
  uint at = sums[own] - sum;
  for (uint i = begin; i < end; ++i)
  {
    uint count = counts[i];
    counts[i] = at;
    starts[i] = at;
    at += count;
  }
  if (own == 255u)
  {
    starts[ListCount] = sums[255];
  }
}
