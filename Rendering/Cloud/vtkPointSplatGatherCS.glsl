#version 430
// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Puts runs of splats one behind another: those, or their parts, that lie in one part of a store. A
// work group copies a run, and its invocations copy words that lie side by side.
// Reads: Runs, Words. Writes: Gathered.

layout(local_size_x = 64) in;

layout(std430, binding = 1) readonly buffer Part { uint words[]; };
layout(std430, binding = 2) writeonly buffer Gathered { uint gathered[]; };
layout(std430, binding = 7) readonly buffer Runs { uvec4 runs[]; }; // first splat, its place, count, 0
uniform uint RunCount;
uniform uint WordsPerSplat;
uniform uint PartFirst; // the splat that the part begins with
uniform uint PartCount; // splats
uniform uint Room;      // splats that Gathered holds

void main()
{
  uint run = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
  if (run >= RunCount)
  {
    return;
  }
  uint first = runs[run].x;
  uint place = runs[run].y;
  // What of the run is here.
  uint begin = max(first, PartFirst);
  uint end = min(first + min(runs[run].z, Room - min(place, Room)), PartFirst + PartCount);
  if (begin >= end)
  {
    return;
  }
  uint from = WordsPerSplat * (begin - PartFirst);
  uint to = WordsPerSplat * (place + begin - first);
  uint count = WordsPerSplat * (end - begin);
  for (uint i = gl_LocalInvocationIndex; i < count; i += 64u)
  {
    gathered[to + i] = words[from + i];
  }
}
