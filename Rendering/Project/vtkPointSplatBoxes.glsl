// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Writes the boxes by which splats and triangles are listed (vtkPointSplatRecord).

#ifdef PIXEL_BOXES
layout(std430, binding = 1) writeonly buffer Boxes { uvec4 boxes[]; };
#else
layout(std430, binding = 1) writeonly buffer Boxes { uvec2 boxes[]; };
#endif

// Pixels from a pixel's middle to its samples, along x or y: offsetOf() in vtkPointSplatTilePixels.
const float SampleReach = 3.0 / 8.0;

// tiles: first x, y, last x, y; pixels: likewise.
void writeBox(uint to, ivec4 tiles, uint bucket, uint kind, vec4 pixels)
{
  uvec4 t = uvec4(tiles);
  uvec2 box = uvec2(t.x | t.y << 12 | (bucket & 127u) << 25,
    t.z | t.w << 12 | (bucket >> 7) << 25 | kind << 28);
  box = kind != NotSeen ? box : uvec2(0u);
#ifdef PIXEL_BOXES
  uvec4 p = uvec4(clamp(pixels, 0.0, 65535.0));
  boxes[to] = uvec4(box, p.xz | p.yw << 16);
#else
  boxes[to] = box;
#endif
}
