// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The integer sums of points that compute shaders project. What counts is how many words are added
// to, so two values share one: the upper one is shifted by 16 bits and the lower
// one, which may be negative, is added to the whole.
//   word 0  weight
//   word 1  normal x, normal y
//   word 2  normal z, depth behind the nearest
//   word 3  red, green        (words 3 and 4 only with colours)
//   word 4  blue, opacity; or in their place what a value adds (vtkPointSplatValue)
//   then    the factors of the first and the second light, of the third and the fourth
// each times the weight. FACTORS is defined where there are such, as the number of lights: as many
// words as they fill, from word 3 or 5 on. Each word has to itself what all of a GPU's threads may
// add at once before they take it back.

// A weight of 1. Sums of 127 such fit into 16 bits.
const float WeightScale = 256.0;
// Past this sum of weights a pixel takes no more.
const int WeightLimit = 64 * 256;
#ifdef COLOURS
const int FactorWord = 5;
#else
const int FactorWord = 3;
#endif

int packSums(int upper, int lower)
{
  return (upper << 16) + lower;
}

ivec2 unpackSums(int both)
{
  int lower = (both << 16) >> 16;
  return ivec2((both - lower) >> 16, lower);
}
