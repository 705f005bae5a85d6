// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The pixels that the samples of one take after which an outline runs through
// (vtkPointSplatOutlines.h), and what they show in the mean (vtkPointSplatOutlineMeans.h).
// OUTLINES: 0 there are none; 1 such a pixel gets the mean. In multisampled framebuffers, whose
// samples are each the nearest of the four: 2 such pixels are left out; 3 these alone are drawn, each
// sample by itself.

uniform usamplerBuffer OutlineIndices; // R32UI, a pixel
uniform usamplerBuffer OutlineChoices; // R32UI
uniform usamplerBuffer OutlineMeans;   // RGBA32UI
uniform ivec2 OutlineImage;            // its size, pixels

const int Samples = 4;

// From the pixel to the one that sample k takes after.
ivec2 stepOf(uint choices, int k)
{
  uint choice = choices >> uint(2 * k) & 3u;
  return (2 * ivec2(k & 1, k >> 1) - 1) * ivec2(int(choice & 1u), int(choice >> 1));
}

int indexOf(ivec2 pixel)
{
  return int(texelFetch(OutlineIndices, pixel.y * OutlineImage.x + pixel.x).r);
}

// Of each of the 3 x 3 pixels about the one how many samples take after it, three bits a pixel.
uint countsOf(uint choices)
{
  uint counts = 0u;
  for (int k = 0; k < Samples; ++k)
  {
    ivec2 step = stepOf(choices, k);
    counts += 1u << uint(3 * (4 + step.x + 3 * step.y));
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
  share = float(counts >> uint(bit) & 7u) / float(Samples);
  counts &= ~(7u << uint(bit));
  at = pixel + ivec2(bit / 3 % 3, bit / 9) - 1;
  return true;
}

#if OUTLINES == 1
struct Mean
{
  vec4 colour; // premultiplied
  float depth; // of the nearest
  uint normal; // coded
};

Mean meanAt(ivec2 pixel)
{
  uvec4 mean = texelFetch(OutlineMeans, indexOf(pixel));
  return Mean(
    vec4(unpackHalf2x16(mean.x), unpackHalf2x16(mean.y)), uintBitsToFloat(mean.z), mean.w);
}
#elif OUTLINES == 3
ivec2 pixelOfSample(ivec2 pixel)
{
  return pixel + stepOf(texelFetch(OutlineChoices, indexOf(pixel)).r,
    int(gl_SamplePosition.x >= 0.5) + 2 * int(gl_SamplePosition.y >= 0.5));
}
#endif
