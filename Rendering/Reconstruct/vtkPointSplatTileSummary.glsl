// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What tells that no outline runs through a tile, for vtkPointSplatOutlineTilesCS: its pixels have as
// many layers, each of one cloud and smooth. A texel (RGBA32UI) a tile: the nearest layer's depths at
// the first pixel, the last of its row and the first of the last row, floats; that layer's tag with
// bit 0 set, and the number of further layers from bit 16 on. Of a tile that is none such all bits
// of the last component are set.

layout(std430, binding = 4) writeonly buffer Summaries { uvec4 summaries[]; };

vec3 cornerDepths;
uint layersOfAll;
bool isSmooth;

// depths: of three pixels in a row.
bool isPlane(float a, float b, float c, float leastStep)
{
  return abs(a - 2.0 * b + c) <= leastStep;
}

void summarise(int layer)
{
  if (layer == 0)
  {
    isSmooth = true;
    cornerDepths =
      vec3(nearest[0], nearest[TILE_WIDTH - 1], nearest[TILE_WIDTH * (TILE_HEIGHT - 1)]);
    layersOfAll = tags[0] | 1u;
  }
  else if (tags[0] != NoTag)
  {
    layersOfAll += 1u << 16;
  }
  bool empty = tags[0] == NoTag;
  float leastStep = empty ? 0.0 : itemLayer(tags[0]);
  for (int k = 0; k < Pixels; ++k)
  {
    isSmooth = isSmooth && (tags[k] | 1u) == (tags[0] | 1u) &&
      (empty || k % TILE_WIDTH < 2 || isPlane(nearest[k - 2], nearest[k - 1], nearest[k], leastStep)) &&
      (empty || k / TILE_WIDTH < 2 ||
        isPlane(nearest[k - 2 * TILE_WIDTH], nearest[k - TILE_WIDTH], nearest[k], leastStep));
  }
}

void writeSummary(int tile)
{
  summaries[tile] = uvec4(floatBitsToUint(cornerDepths), isSmooth ? layersOfAll : 0xffffffffu);
}
