// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The lines by which a splat ends at creases and borders (Zwicker et al. 2004, Perspective
// accurate splatting). Of each line c, what has dot(c, x) <= 1 is kept, x in radii along s and t or
// in pixels from the centre.
//
// Splats that meet at a crease are each where rounding, and approximations of up to 1/32 pixel, put
// them: between them rays would find nothing. So each goes on for a margin beyond its lines, where
// it weighs so little that other splats are hardly changed by it. At silhouettes the margin of the
// face that is turned away would be seen before that of the other: backs count as a little
// farther there than they are.

// Pixels: what two splats may be moved apart by.
const float ClipMargin = 1.0 / 16.0;
// Of the kernel: with less, the sums of whole numbers of what only margins cover would be coarse.
const float MarginShare = 1.0 / 64.0;
// Least layer distances: less than one, so that the surface stays one.
const float MarginDelay = 0.375;
// Pixels: of disks that are narrower in the image it cannot be told any more where on them a pixel
// lies, and lines across that direction fade out. Of small disks twice as wide they must not yet: faces
// seen at an angle would reach over edges, and be blended with others (part_random, 100 pixels large,
// by Testing/Accuracy/likeness.py).
const float NarrowestClipped = 0.05;

struct ClipLines
{
  vec2 first;
  vec2 second;
  vec2 firstInImage; // in pixels
  vec2 secondInImage;
  vec2 bounds;       // what the products may be with the margin
};

// A line in pixels, from one in radii; s, t: the image of the axes. With J = (s t) it is
// (J J^T + e^2)^-1 J c, which is J^-T c but where J is singular; written such that rounding does no
// harm there.
vec2 clipLineInImage(vec2 line, vec2 s, vec2 t)
{
  const float e2 = NarrowestClipped * NarrowestClipped;
  float area = s.x * t.y - s.y * t.x;
  vec2 across = line.x * vec2(t.y, -t.x) + line.y * vec2(-s.y, s.x);
  return (area * across + e2 * (line.x * s + line.y * t)) /
    (area * area + e2 * (dot(s, s) + dot(t, t) + e2));
}

vec2 clipBounds(vec2 firstInImage, vec2 secondInImage)
{
  return 1.0 + ClipMargin * vec2(length(firstInImage), length(secondInImage));
}

ClipLines clipLinesOf(vec4 lines, vec2 s, vec2 t)
{
  vec2 first = clipLineInImage(lines.xy, s, t);
  vec2 second = clipLineInImage(lines.zw, s, t);
  return ClipLines(lines.xy, lines.zw, first, second, clipBounds(first, second));
}

// The products of a place with the lines.
vec2 clipProducts(ClipLines c, vec2 x)
{
  return vec2(dot(c.first, x), dot(c.second, x));
}

vec2 clipProductsInImage(ClipLines c, vec2 d)
{
  return vec2(dot(c.firstInImage, d), dot(c.secondInImage, d));
}

// Whether a place is not cut away.
bool isKept(ClipLines c, vec2 products)
{
  return products.x <= c.bounds.x && products.y <= c.bounds.y;
}

// What a place has of the kernel.
float clippedShare(ClipLines c, vec2 products)
{
  return isKept(c, products) ? (max(products.x, products.y) <= 1.0 ? 1.0 : MarginShare) : 0.0;
}

// By how much a place counts as farther; layer: the least layer distance.
float marginDelay(vec2 products, uint tag, float layer)
{
  return (tag & 1u) != 0u && max(products.x, products.y) > 1.0 ? MarginDelay * layer : 0.0;
}
