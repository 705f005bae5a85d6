// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Values that splats have in the place of colours (vtkPointSplatCloud.h), their weighted sums, and
// how means are mapped to colours.
// A map tells of a cloud: x its table's first entry; y how many entries there are, behind which
// that of NaN lies, or 0 where splats have colours; z and w from a value to its place, in entries. Where
// there are colours, x is 1 if these are of cells: pixels have that of the splat with the greatest
// weight.

#include "vtkPointSplatColourCode"

uniform usamplerBuffer ValueTables; // R32UI, see vtkPointSplatColourCode

// Sums are of whole numbers. Products of a weight and a value have two, the lower one in this part
// of the upper one: as much as sums of 16 bits have room for (vtkPointSplatFixedPoint), and twelve
// bits of the value even where the weight is a hundredth of a kernel's.
const float ValueParts = 256.0;
// Entries that rounding may move a mean by. What lies on the border of the range belongs to it.
const float ValueMargin = 1.0 / 64.0;

bool hasValues(vec4 map)
{
  return map.y > 0.0;
}

bool hasCellColours(vec4 map)
{
  return map.y == 0.0 && map.x > 0.0;
}

// Of a splat: its value, and 1; or both 0 where it has none.
vec2 decodeValue(uint code)
{
  return code < 0x80000000u ? vec2(uintBitsToFloat(code), 1.0) : vec2(0.0);
}

// value.y: what share of it is known; of less than a half the colour is that of NaN.
vec4 mapValue(vec2 value, vec4 map)
{
  float place = map.z * value.x + map.w;
  float last = map.y - 1.0;
  float greatest = place <= last + ValueMargin ? last - 1.0 : last;
  float entry = clamp(floor(place + ValueMargin), 0.0, greatest);
  return unpackColour(texelFetch(ValueTables, int(map.x + (value.y < 0.5 ? map.y : entry))).r);
}

// What a splat's value adds to a sum of colours: two parts of its product with the weight, and the
// weight of what is known.
vec4 weightedValue(float weight, vec2 value)
{
  float product = weight * value.x;
  float upper = floor(product);
  return vec4(upper, floor((product - upper) * ValueParts + 0.5), weight * value.y, 0.0);
}

// The colour of a sum, of either kind.
vec4 colourOfSum(vec4 sum, float weight, vec4 map)
{
  vec2 mean = vec2((sum.x + sum.y / ValueParts) / max(sum.z, 1e-30), sum.z / weight);
  return hasValues(map) ? mapValue(mean, map) : sum / weight;
}
