// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What stages ask of the cloud that a tag names, by its slot (RGBA32F, see
// vtkPointSplatItemTable.h).

uniform samplerBuffer ItemTable;

const int ItemTexels = 12;

vec4 itemTexel(uint tag, int texel)
{
  return texelFetch(ItemTable, int(tag >> 1) * ItemTexels + texel);
}

// Of the side that is seen.
float itemOpacity(uint tag)
{
  vec4 head = itemTexel(tag, 0);
  return (tag & 1u) != 0u ? head.y : head.x;
}

int itemClipPlaneCount(uint tag)
{
  return int(itemTexel(tag, 0).z);
}

// Whether it is projected as points, without an extent.
bool itemIsPoints(uint tag)
{
  return itemTexel(tag, 0).w > 0.0;
}

vec4 itemColour(uint tag)
{
  return itemTexel(tag, 1);
}

// As kernelWeight() takes it.
vec4 itemKernel(uint tag)
{
  return itemTexel(tag, 2);
}

// The least layer distance, world units; of splats, whose own may be less, the largest.
float itemLayer(uint tag)
{
  return itemTexel(tag, 3).x;
}

// Of points: the least layer distance, world units, and in pixels; spacing, world units; and
// whether silhouettes are anti-aliased.
vec4 itemPoints(uint tag)
{
  return itemTexel(tag, 3);
}

// View coordinates; what is negative is cut away.
vec4 itemClipPlane(uint tag, int plane)
{
  return itemTexel(tag, 4 + plane);
}

// Whether each splat has one tone.
bool itemIsFlat(uint tag)
{
  return itemTexel(tag, 11).x > 0.0;
}

// Of its look: whether each splat has one tone; how wide its edges are, pixels; whether texture
// coordinates that differ by whole numbers mean the same; 0.
vec4 itemLook(uint tag)
{
  return itemTexel(tag, 11);
}

// How its values are mapped, as mapValue() takes it.
vec4 itemValueMap(uint tag)
{
  return itemTexel(tag, 10);
}
