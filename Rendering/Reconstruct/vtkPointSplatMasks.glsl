// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The eight masks of image-space hole filling (Dobrev, Rosenthal, Linsen 2010,
// sections 3.2 and 3.3, figure 3). A pixel's eight neighbours make a ring; each mask
// has five consecutive ones of it, half of the plane as seen from the pixel. Where all
// five of a mask are white, which is background, or not in front of the pixel, the pixel
// lies beyond a silhouette; where no mask matches, it is a hole in a surface about it.
// With fewer than five, holes whose rim is round would never close; with more,
// pixels along straight silhouettes would be filled.

// Neighbours counter-clockwise, from the right one on.
const ivec2 Ring[8] = ivec2[8](ivec2(1, 0), ivec2(1, 1), ivec2(0, 1), ivec2(-1, 1), ivec2(-1, 0),
  ivec2(-1, -1), ivec2(0, -1), ivec2(1, -1));

// white: bit k tells of neighbour k.
bool masksMatch(uint white)
{
  uint run = white | (white << 8);
  uint four = run & (run >> 1) & (run >> 2) & (run >> 3);
  return (four & (run >> 4) & 255u) != 0u;
}
