// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The pixels that the samples of one take after which an outline runs through
// (vtkPointSplatOutlines.h). MULTISAMPLED: the framebuffer has samples of its own, each of which is
// the nearest of the four.

flat in uint outlineChoices;

const int Samples = 4;

// Of each of the 3 x 3 pixels about the one how many samples take after it, three bits a pixel.
uint countsAbout()
{
  uint counts = 0u;
  for (int k = 0; k < Samples; ++k)
  {
    uint choice = outlineChoices >> uint(2 * k) & 3u;
    ivec2 step = (2 * ivec2(k & 1, k >> 1) - 1) * ivec2(int(choice & 1u), int(choice >> 1));
    uint one = 1u << uint(3 * (4 + step.x + 3 * step.y));
#ifdef MULTISAMPLED
    int nearest = int(gl_SamplePosition.x >= 0.5) + 2 * int(gl_SamplePosition.y >= 0.5);
    counts += k == nearest ? one : 0u;
#else
    counts += one;
#endif
  }
  return counts;
}

// Takes the next of these pixels out; share: of the samples in all. False: there is none.
bool nextPixel(inout uint counts, ivec2 pixel, out ivec2 at, out float share)
{
  if (counts == 0u)
  {
    return false;
  }
  uint lowest = counts & (~counts + 1u);
  int bit = int(log2(float(lowest)) + 0.5) / 3 * 3;
  uint count = counts >> uint(bit) & 7u;
  counts &= ~(7u << uint(bit));
  at = pixel + ivec2(bit / 3 % 3, bit / 9) - 1;
#ifdef MULTISAMPLED
  share = 1.0;
#else
  share = float(count) / float(Samples);
#endif
  return true;
}
