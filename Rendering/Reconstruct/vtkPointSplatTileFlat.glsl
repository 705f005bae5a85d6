// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The loops over a tile's flat splats (vtkPointSplatRecord): of each that lies before what hides
// it the nearest hits are kept; then of each that may belong to the layer what it adds.

void seeFlat(inout int begin, int end)
{
  skipPeeled(begin, end);
  int i = begin;
  if (i >= end)
  {
    return;
  }
  float reach = DiskReach * DiskReach;
  do
  {
    uint entry = texelFetch(Lists, i).r;
    if (leastDepth(entry) > farthestHit())
    {
      break;
    }
    int record = recordOf(entry);
    int at = record * RecordTexels;
    Head h = headOf(texelFetch(Records, at));
    vec4 form = uintBitsToFloat(texelFetch(Records, at + 1));
    float slope = uintBitsToFloat(texelFetch(Records, at + 2).x);
    for (int k = 0; k < Pixels; ++k)
    {
      vec2 d = h.from + offsetOf(k);
      float r2 = (form.x * d.x + form.y * d.y) * d.x + form.z * d.y * d.y;
      keepNearest(k, h, r2 <= reach, h.depth + form.w * d.x + slope * d.y);
    }
    ++i;
  } while (i < end);
}

void addFlat(int i, int end, float layerEnd)
{
  if (i >= end)
  {
    return;
  }
  do
  {
    uint entry = texelFetch(Lists, i).r;
    if (leastDepth(entry) > layerEnd)
    {
      break;
    }
    int record = recordOf(entry);
    int at = record * RecordTexels;
    Head h = headOf(texelFetch(Records, at));
    vec3 form = uintBitsToFloat(texelFetch(Records, at + 2).yzw);
    uvec4 shape = texelFetch(Records, at + 3);
    vec2 slope = uintBitsToFloat(shape.xy);
    vec3 normal = decodeNormal(shape.z);
    vec3 turnX;
    vec3 turnY;
    decodeTurns(texelFetch(Records, at + 4).xyz, turnX, turnY);
    Paint p = paintOf(record, h.tag);
#ifdef FACETS
    p.facet = normal;
#endif
#ifdef LOOKS
    prepareFlatLook(p.look, form);
#endif
    for (int k = 0; k < Pixels; ++k)
    {
      vec2 d = h.from + offsetOf(k);
      float r2 = (form.x * d.x + form.y * d.y) * d.x + form.z * d.y * d.y;
#ifdef LOOKS
      placeFlatLook(p.look, form, d, r2);
#endif
      addToLayer(k, h, p, 1.0, r2, h.depth + slope.x * d.x + slope.y * d.y,
        normal + d.x * turnX + d.y * turnY);
    }
    ++i;
  } while (i < end);
}
