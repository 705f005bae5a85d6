// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which side of a rough surface is seen at its outlines. Normals there scatter about the
// direction across, so that some of the points that are seen show their backs; where one of them is
// the nearest, it would keep those out that show the front. Backs are therefore taken for a little
// farther than they are: less than a layer, so that where there are no fronts nothing changes.

const float BackDelay = 0.375; // least layer distances

float sideDelay(uint tag, float layer)
{
  return (tag & 1u) != 0u ? BackDelay * layer : 0.0;
}

// Where the point is: its depth less the delay.
float undelayedDepth(Splat q)
{
  return q.depth - sideDelay(q.tag, q.layer);
}
