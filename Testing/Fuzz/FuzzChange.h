// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// How two pictures of a good actor before black differ, alone and with a neighbour, in what the
// neighbour does not reach: counted are pixels that differ by more than rounding does.
//
// In pixels at the actor's outline one of four samples may differ, in two of them: a neighbour far
// behind changes the last digits of depths, and with them which of two pixels a sample takes after.
#ifndef FuzzChange_h
#define FuzzChange_h

#include <vector>

struct FuzzChange
{
  /// alone, together: RGB, row by row, of width pixels; of each row the first ones are looked at.
  FuzzChange(const std::vector<unsigned char>& alone, const std::vector<unsigned char>& together,
    int width, int first);

  long Pixels = 0;
  int Worst = 0; // the largest difference, of 255
};

#endif
