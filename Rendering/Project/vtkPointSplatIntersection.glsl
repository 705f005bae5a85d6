// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The exact box of a splat, and where a pixel's ray meets it: for stages that draw splats by quads.

#include "vtkPointSplatProjection"
#include "vtkPointSplatDepthCode"
#include "vtkPointSplatCap"
#ifdef CLIP_LINES
#include "vtkPointSplatClipLines"
#endif

struct Hit
{
  vec2 uv;      // in radii from the centre, along s and t
  float r2;     // the distance that the kernel sees, squared, in radii
  float depth;
  float share;  // of the kernel
};

// What a splat is beside itself where its image is narrower than the prefilter's
// radius, in pixels, so that it does not fall between pixels: the ellipse that its
// tangents span in the image, turned to its principal axes so that each may be widened
// to that radius for itself; a widened axis is parallel to the screen (Guennebaud, section 4; its
// equations 8 to 10 widen the tangents of circles as they lie, which need not be orthogonal in the
// image; principal axes are, and serve ellipses as well). But where a splat turns away from the viewer before its rim (turning:
// how far the normal turns until there), it has the silhouette on it, and such an
// ellipse would stand out over that: there it is a disk about the centre; and so are disks that show
// where the surface is, whose radius is less, where no gap can be seen.
// radii: of the ellipse, of the disk.
// along, across: how far the ellipse's axes reach along x and y.
void widen(inout Splat q, vec2 radii, float turning, out vec2 along, out vec2 across)
{
  float aa = dot(q.s.xy, q.s.xy);
  float ab = dot(q.s.xy, q.t.xy);
  float bb = dot(q.t.xy, q.t.xy);
  float diff = 0.5 * (aa - bb);
  float root = sqrt(diff * diff + ab * ab);
  float longest = 0.5 * (aa + bb) + root;
  float shortest = max(0.5 * (aa + bb) - root, 0.0);
  float radius = radii.x;
  q.narrow = vec4(1.0, 0.0, 0.0, 1.0) / radii.y;
  q.lean = vec2(0.0);
  along = vec2(0.0);
  across = vec2(0.0);
  if (shortest >= radius * radius || longest <= radius * radius ||
    shortest < turning * turning * longest ||
    (radii.y < radius && hidesGaps(turning * sqrt(longest), radius)))
  {
    return;
  }
  vec2 e = diff > 0.0 ? vec2(diff + root, ab) : vec2(ab, root - diff);
  float l = length(e);
  q.lean = l > 0.0 ? e / l : vec2(1.0, 0.0);
  vec2 axis = normalize(q.lean.x * q.s.xy + q.lean.y * q.t.xy);
  q.narrow = vec4(axis * inversesqrt(longest), vec2(-axis.y, axis.x) / radius);
  along = abs(axis) * sqrt(longest);
  across = abs(axis.yx) * radius;
}

// Widens a box, in pixels about the centre, by that of the ellipse u^2 + v^2 <= r^2
// at a height h, from the conic's tangents parallel to the axes.
void addDisk(Splat q, float h, float r, inout vec2 low, inout vec2 high)
{
  float r2 = r * r;
  float w = 1.0 + h * q.m.z;
  float k = r2 * (q.s.z * q.s.z + q.t.z * q.t.z) - w * w;
  if (w > 0.0 && k < -1e-4 * w * w)
  {
    vec2 centre = h * q.m.xy / w;
    vec2 s = q.s.xy - centre * q.s.z;
    vec2 t = q.t.xy - centre * q.t.z;
    vec2 c = r2 * (s * q.s.z + t * q.t.z);
    vec2 d = r2 * (s * s + t * t);
    vec2 extent = sqrt(max(c * c - k * d, 0.0)) / -k;
    low = min(low, centre + c / k - extent);
    high = max(high, centre + c / k + extent);
    return;
  }
  // The disk reaches behind the eye, and has no bounded image. Of the square about
  // it, what is beyond the near plane has.
  float depth = q.depth - h * q.mVC.z;
  for (int i = 0; i < 4; ++i)
  {
    vec2 from = r * vec2(i == 1 || i == 2 ? 1.0 : -1.0, i >= 2 ? 1.0 : -1.0);
    vec2 to = vec2(-from.y, from.x);
    float before = depth - dot(from, vec2(q.sVC.z, q.tVC.z));
    float after = depth - dot(to, vec2(q.sVC.z, q.tVC.z));
    bool crosses = (before >= 0.0) != (after >= 0.0);
    vec2 crossing = from + (to - from) * (crosses ? before / (before - after) : 0.0);
    for (int end = 0; end < 2; ++end)
    {
      if (end == 0 ? before >= 0.0 : crosses)
      {
        vec2 uv = end == 0 ? from : crossing;
        vec3 image = uv.x * q.s + uv.y * q.t + h * q.m;
        vec2 pixel = image.xy / max(1.0 + image.z, 1e-20);
        low = min(low, pixel);
        high = max(high, pixel);
      }
    }
  }
}

// Projects a splat. False: nothing of it can be seen. As placeSplat(); least: the radii
// in pixels by which it is widened.
bool project(vec3 positionMC, uvec3 shape, vec3 axis1MC, vec3 axis2MC, float radius,
  float reach, vec2 least, out Splat q)
{
  Bend bend;
  if (!placeSplat(positionMC, shape, axis1MC, axis2MC, radius, reach, q, bend))
  {
    return false;
  }
  vec2 along;
  vec2 across;
  widen(q, least, reach * bend.strongest, along, across);
  vec2 low = vec2(-max(least.x, least.y) * reach);
  vec2 high = -low;
  // The cap lies between the disks at its least and its greatest height.
  addDisk(q, bend.lowest, reach, low, high);
  addDisk(q, bend.highest, reach, low, high);
  // In perspective an end of the ellipse may reach farther than the other.
  along *= reach;
  across *= reach * reach * across;
  low = max(-low, along);
  high = max(high, along);
  low = -sqrt(low * low + across);
  high = sqrt(high * high + across);
  // Clamped before the conversion: out of an int's range it is undefined.
  low = clamp(q.centre + low, vec2(Window.xy) - 1.0, vec2(Window.zw) + 2.0);
  high = clamp(q.centre + high, vec2(Window.xy) - 1.0, vec2(Window.zw) + 2.0);
  // The pixels whose centres, at half integers, lie inside.
  q.box = ivec4(max(ivec2(ceil(low - 0.5)), Window.xy), min(ivec2(floor(high - 0.5)), Window.zw));
  return all(lessThanEqual(q.box.xy, q.box.zw));
}

// Where the ray through a pixel's centre meets the splat.
// The kernel sees the lesser of the distances on the splat and on its widened
// ellipse.
// False: outside the cap of radius reach, beyond its clip lines, outside the depth range, or cut
// away.
bool intersect(Splat q, vec2 pixel, float reach, out Hit hit)
{
  vec2 d = pixel - q.centre;
  vec3 x;
  bool met = meetCap(vec3(q.s.x, q.t.x, q.m.x), vec3(q.s.y, q.t.y, q.m.y),
    vec3(q.s.z, q.t.z, q.m.z), q.bend, d, x);
  hit.r2 = dot(x.xy, x.xy);
  vec2 onEllipse = vec2(dot(d, q.narrow.xy), dot(d, q.narrow.zw));
  float w = 1.0 - onEllipse.x * dot(q.lean, vec2(q.s.z, q.t.z));
  onEllipse.x = w > 0.0 ? onEllipse.x / w : 1e9;
  float narrow = dot(onEllipse, onEllipse);
  bool misses = !met || hit.r2 > reach * reach;
#ifdef CLIP_LINES
  ClipLines lines = clipLinesOf(q.lines, q.s.xy, q.t.xy);
  vec2 products = misses ? clipProductsInImage(lines, d) : clipProducts(lines, x.xy);
#endif
  if (misses)
  {
    x = vec3(onEllipse.x * q.lean, 0.0);
    hit.r2 = narrow;
  }
  hit.r2 = min(hit.r2, narrow);
  hit.uv = x.xy;
  hit.depth = q.depth - dot(x, vec3(q.sVC.z, q.tVC.z, q.mVC.z));
  hit.share = 1.0;
#ifdef CLIP_LINES
  hit.share = clippedShare(lines, products);
  hit.depth += marginDelay(products, q.tag, q.layer);
  if (hit.share == 0.0)
  {
    return false;
  }
#endif
  if (hit.r2 > reach * reach || hit.depth <= 0.0 || hit.depth >= DepthRange.y ||
    dot(x, vec3(q.s.z, q.t.z, q.m.z)) <= -1.0)
  {
    return false;
  }
#ifdef CLIPPING
  // From the pixel, not from the splat: of one that is huge, rounding would leave nothing.
  float z = -(hit.depth + DepthRange.x);
  vec2 across = pixel * (PixelW.z * z + PixelW.w) -
    vec2(PixelX.z * z + PixelX.w, PixelY.z * z + PixelY.w);
  vec3 position = vec3(inverse(mat2(PixelX.x, PixelY.x, PixelX.y, PixelY.y)) * across, z);
  for (int i = 0; i < ClipPlaneCount; ++i)
  {
    if (dot(ClipPlanes[i], vec4(position, 1.0)) < 0.0)
    {
      return false;
    }
  }
#endif
  return true;
}

// Whether a splat's fragment belongs to the surface layer whose nearest depth is
// coded in nearest: the same cloud, and no farther than the least layer distance,
// measured along the normal. For splats seen edge-on the bound along the ray
// stays finite; and they must show the same side, since behind a silhouette lies
// the far side of the same body, close by and lit otherwise. Other splats need
// not: normals that are not consistently oriented are lit all the same, by turnTo().
bool sameLayer(Splat q, float depth, uint nearest)
{
  uint different = (nearest ^ q.tag) & TagMask;
  return nearest != NoDepth &&
    (different == 0u || (different == 1u && belongsToBothSides(q))) &&
    abs(depth - decodeDepth(nearest)) * max(q.facing, LeastFacing) <= q.layer;
}
