// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The loops over a tile's splats that are caps (vtkPointSplatRecord): bent ones, whose rays are
// parallel, and curved ones, of which each ray is met exactly, within the depth range and before
// clipping planes; both up to their clip lines.

#include "vtkPointSplatCap"
#include "vtkPointSplatTileRays"

uniform float ZNear;      // distance of the near plane; of parallel projection any
uniform bool Parallel;

// What both kinds have.
struct Cap
{
  vec3 a;     // x of the images of s, t and m
  vec3 b;     // y of the same
  vec3 z;     // z of s, t and m in view coordinates
  vec3 bend;
};

Cap capOf(uvec4 r1, uvec4 r2, uvec4 r3)
{
  vec4 st = uintBitsToFloat(r1);
  vec2 m = uintBitsToFloat(r3.xy);
  vec3 bend =
    vec3(ivec3(int(r3.w << 22) >> 22, int(r3.w << 12) >> 22, int(r3.w << 2) >> 22)) / 511.0;
  return Cap(vec3(st.xy, m.x), vec3(st.zw, m.y),
    vec3(uintBitsToFloat(r2.xy), uintBitsToFloat(r3.z)), bend);
}

// The ellipse by which a cap is widened (widen() in vtkPointSplatIntersection).
struct Widened
{
  vec2 lean;
  vec2 along;  // over their squared lengths
  vec2 across;
#ifdef LOOKS
  vec4 places; // placesByPixels()
#endif
};

Widened widenedOf(Cap q, uvec4 r2, uvec4 r4, float radius)
{
  Widened w;
#ifdef LOOKS
  w.places = placesByPixels(q.a.xy, q.b.xy);
#endif
  w.lean = unpackSnorm2x16(r2.w);
  vec2 along = unpackHalf2x16(r4.w);
  float l = dot(along, along);
  bool leans = r4.w != 0u;
  w.along = leans ? along : vec2(1.0 / radius, 0.0);
  w.across =
    leans ? vec2(-along.y, along.x) * (inversesqrt(l) / radius) : vec2(0.0, 1.0 / radius);
  return w;
}

#ifdef CLIP_LINES
ClipLines clipLinesOf(Cap q, int record)
{
  return clipLinesOf(
    texelFetch(RecordClipLines, record), vec2(q.a.x, q.b.x), vec2(q.a.y, q.b.y));
}
#endif

// The w of the images of s, t and m, over the centre's.
vec3 imageW(Cap q, float depth)
{
  return Parallel ? vec3(0.0) : q.z * (-1.0 / max(depth + ZNear, 1e-30));
}

// Where rays are taken for parallel: about the middle of an invocation's pixels.
vec2 middlePlace()
{
#if LANES > 1
  return offsetOf(0);
#elif defined(SAMPLES)
  return vec2(0.0);
#else
  return 0.5 * vec2(TILE_WIDTH - 1, TILE_HEIGHT - 1);
#endif
}

// The rays of a tile's pixels in a splat's coordinates (u, v, h), parallel to that through the middle.
// For an offset e from there the point nearest to the centre is x + e.x alongX + e.y alongY, and
// what of meetCap() does not depend on e is this:
struct Bundle
{
  vec3 x;
  vec3 alongX;
  vec3 alongY;
  vec3 c;           // the rays' direction
  float alpha;      // four times
  vec3 beta;        // constant, e.x, e.y
  vec3 gammaLinear; // constant, e.x, e.y
  vec3 gamma;       // e.x^2, e.x e.y, e.y^2
  vec3 depth;       // of x, and of a step of e.x, of e.y
  float depthAlong; // of one along c
};

// w: imageW(); d: the middle's offset from the centre. reach: that the cap has, radii.
Bundle bundleOf(Cap q, vec3 w, vec2 d, float reach)
{
  Bundle r;
  vec3 a = q.a - d.x * w;
  vec3 b = q.b - d.y * w;
  vec3 c = cross(a, b);
  float l = inversesqrt(max(dot(c, c), 1e-37));
  r.c = c * l;
  vec3 alongX = cross(b, r.c) * l;
  vec3 alongY = cross(r.c, a) * l;
  r.x = d.x * alongX + d.y * alongY;
  // Pixels are as much farther apart as the cap is nearer: where the middle's ray meets its plane.
  vec3 onPlane = r.x - (r.x.z / (abs(r.c.z) < 1e-3 ? 1e-3 : r.c.z)) * r.c;
  float scale = 1.0 + clamp(dot(w, onPlane), -reach * length(w), reach * length(w));
  r.alongX = scale * alongX;
  r.alongY = scale * alongY;
  vec2 Kc = q.bend.xy * r.c.x + q.bend.yz * r.c.y;
  vec2 K0 = q.bend.xy * r.x.x + q.bend.yz * r.x.y;
  vec2 Kx = q.bend.xy * r.alongX.x + q.bend.yz * r.alongX.y;
  vec2 Ky = q.bend.xy * r.alongY.x + q.bend.yz * r.alongY.y;
  r.alpha = 2.0 * dot(Kc, r.c.xy);
  r.beta = vec3(r.c.z + dot(Kc, r.x.xy), dot(Kc, r.alongX.xy), dot(Kc, r.alongY.xy));
  r.gammaLinear = vec3(r.x.z + 0.5 * dot(K0, r.x.xy), r.alongX.z + dot(K0, r.alongX.xy),
    r.alongY.z + dot(K0, r.alongY.xy));
  r.gamma =
    vec3(0.5 * dot(Kx, r.alongX.xy), dot(Kx, r.alongY.xy), 0.5 * dot(Ky, r.alongY.xy));
  r.depth = -vec3(dot(q.z, r.x), dot(q.z, r.alongX), dot(q.z, r.alongY));
  r.depthAlong = -dot(q.z, r.c);
  return r;
}

// As meetCap(). behind: how much deeper than the centre the point lies.
bool meetBundle(Bundle r, vec2 e, out vec2 uv, out float behind)
{
  float beta = r.beta.x + r.beta.y * e.x + r.beta.z * e.y;
  float gamma = r.gammaLinear.x + (r.gammaLinear.y + r.gamma.x * e.x + r.gamma.y * e.y) * e.x +
    (r.gammaLinear.z + r.gamma.z * e.y) * e.y;
  float discriminant = beta * beta - r.alpha * gamma;
  float root = sqrt(max(discriminant, 0.0));
  float divisor = beta + (beta < 0.0 ? -root : root);
  float tau = -2.0 * gamma / (abs(divisor) < 1e-30 ? 1e-30 : divisor);
  uv = r.x.xy + e.x * r.alongX.xy + e.y * r.alongY.xy + tau * r.c.xy;
  behind = r.depth.x + e.x * r.depth.y + e.y * r.depth.z + tau * r.depthAlong;
  return discriminant >= 0.0;
}

void seeBent(inout int begin, int end)
{
  skipPeeled(begin, end);
  vec2 middle = middlePlace();
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
    Cap cap = capOf(
      texelFetch(Records, at + 1), texelFetch(Records, at + 2), texelFetch(Records, at + 3));
    Bundle rays = bundleOf(cap, imageW(cap, h.depth), h.from + middle, DiskReach);
#ifdef CLIP_LINES
    ClipLines lines = clipLinesOf(cap, record);
#endif
    for (int k = 0; k < Pixels; ++k)
    {
      vec2 uv;
      float behind;
      bool met = meetBundle(rays, offsetOf(k) - middle, uv, behind) && dot(uv, uv) <= reach;
#ifdef CLIP_LINES
      vec2 products = clipProducts(lines, uv);
      met = met && isKept(lines, products);
      behind += marginDelay(products, h.tag, h.layer);
#endif
      keepNearest(k, h, met, h.depth + behind);
    }
    ++i;
  } while (i < end);
}

// The normal of a cap, and its changes along s and t.
struct Normal
{
  vec3 centre;
  vec3 turnS;
  vec3 turnT;
};

Normal normalOf(uvec4 r2, uvec4 r4)
{
  Normal n;
  n.centre = decodeNormal(r2.z);
  decodeTurns(r4.xyz, n.turnS, n.turnT);
  return n;
}

// Where a pixel's ray misses the cap it meets the widened ellipse; the kernel sees the lesser
// distance. cut: whether the point may lie beyond the depth range or a clipping plane.
void addCap(int k, Head h, Paint p, bool met, vec2 uv, float behind, Widened w, vec2 zST, Normal n,
  bool cut)
{
  vec2 d = h.from + offsetOf(k);
  float r2 = dot(uv, uv);
  vec2 onEllipse = vec2(dot(d, w.along), dot(d, w.across));
  float narrow = dot(onEllipse, onEllipse);
  bool misses = !met || r2 > p.kernel.z * p.kernel.z;
  float share = 1.0;
#ifdef CLIP_LINES
  share = clippedShare(
    p.lines, misses ? clipProductsInImage(p.lines, d) : clipProducts(p.lines, uv));
#endif
  uv = misses ? onEllipse.x * w.lean : uv;
  behind = misses ? -dot(uv, zST) : behind;
  r2 = misses ? narrow : min(r2, narrow);
  vec3 normal = n.centre + uv.x * n.turnS + uv.y * n.turnT;
  // One step of Newton's towards unit length: the turn is small.
  normal *= 1.5 - 0.5 * dot(normal, normal);
#ifdef LOOKS
  placeCapLook(p.look, w.places, uv);
#endif
  share = !cut || isWithin(k, h.depth + behind) ? share : 0.0;
#ifdef FACETS
  p.facet = n.centre;
#endif
  addToLayer(k, h, p, share, r2, h.depth + behind, normal);
}

void addBent(int i, int end, float layerEnd)
{
  vec2 middle = middlePlace();
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
    uvec4 r2 = texelFetch(Records, at + 2);
    uvec4 r4 = texelFetch(Records, at + 4);
    Cap cap = capOf(texelFetch(Records, at + 1), r2, texelFetch(Records, at + 3));
    Paint p = paintOf(record, h.tag);
    Bundle rays = bundleOf(cap, imageW(cap, h.depth), h.from + middle, p.kernel.z);
    Widened widened = widenedOf(cap, r2, r4, PrefilterRadius);
    Normal n = normalOf(r2, r4);
#ifdef LOOKS
    prepareCapLook(p.look, widened.places);
#endif
#ifdef CLIP_LINES
    p.lines = clipLinesOf(cap, record);
#endif
    for (int k = 0; k < Pixels; ++k)
    {
      vec2 uv;
      float behind;
      bool met = meetBundle(rays, offsetOf(k) - middle, uv, behind);
      addCap(k, h, p, met, uv, behind, widened, cap.z.xy, n, false);
    }
    ++i;
  } while (i < end);
}

#ifdef CURVED
// The next of two lists, one after the other, each up to its end or to what lies behind a depth; i and
// end are of the one that is walked, next of the other. False: both are done. One loop over both is half of
// the code of two, which drivers for processors take long to compile.
bool nextOf(inout int i, inout int end, inout ivec2 next, float limit, out uint entry)
{
  entry = texelFetch(Lists, i).r;
  if (i >= end || leastDepth(entry) > limit)
  {
    i = next.x;
    end = next.y;
    next = ivec2(0);
    entry = texelFetch(Lists, i).r;
  }
  return i < end && leastDepth(entry) <= limit;
}

// wide: of the block of tiles.
void seeCurved(inout int begin, int end, inout int wideBegin, int wideEnd)
{
  skipPeeled(begin, end);
  skipPeeled(wideBegin, wideEnd);
  int i = begin;
  ivec2 wide = ivec2(wideBegin, wideEnd);
  if (i >= end && wide.x >= wide.y)
  {
    return;
  }
  float reach = DiskReach * DiskReach;
  uint entry;
  while (nextOf(i, end, wide, farthestHit(), entry))
  {
    int record = recordOf(entry);
    int at = record * RecordTexels;
    Head h = headOf(texelFetch(Records, at));
    Cap cap = capOf(
      texelFetch(Records, at + 1), texelFetch(Records, at + 2), texelFetch(Records, at + 3));
#ifdef CLIP_LINES
    ClipLines lines = clipLinesOf(cap, record);
#endif
    vec3 w = imageW(cap, h.depth);
    cutRays(h.tag);
    for (int k = 0; k < Pixels; ++k)
    {
      vec3 x;
      bool met = meetCap(cap.a, cap.b, w, cap.bend, h.from + offsetOf(k), x);
      float depth = h.depth - dot(x, cap.z);
      met = met && dot(x.xy, x.xy) <= reach && dot(x, w) > -1.0 && isWithin(k, depth);
#ifdef CLIP_LINES
      vec2 products = clipProducts(lines, x.xy);
      met = met && isKept(lines, products);
      depth += marginDelay(products, h.tag, h.layer);
#endif
      keepNearest(k, h, met, depth);
    }
    ++i;
  }
}

void addCurved(int i, int end, ivec2 wide, float layerEnd)
{
  if (i >= end && wide.x >= wide.y)
  {
    return;
  }
  uint entry;
  while (nextOf(i, end, wide, layerEnd, entry))
  {
    int record = recordOf(entry);
    int at = record * RecordTexels;
    Head h = headOf(texelFetch(Records, at));
    uvec4 r2 = texelFetch(Records, at + 2);
    uvec4 r4 = texelFetch(Records, at + 4);
    Cap cap = capOf(texelFetch(Records, at + 1), r2, texelFetch(Records, at + 3));
    vec3 w = imageW(cap, h.depth);
    Widened widened = widenedOf(cap, r2, r4, PrefilterRadius);
    Normal n = normalOf(r2, r4);
    Paint p = paintOf(record, h.tag);
#ifdef LOOKS
    prepareCapLook(p.look, widened.places);
#endif
#ifdef CLIP_LINES
    p.lines = clipLinesOf(cap, record);
#endif
    cutRays(h.tag);
    for (int k = 0; k < Pixels; ++k)
    {
      vec3 x;
      bool met = meetCap(cap.a, cap.b, w, cap.bend, h.from + offsetOf(k), x) &&
        dot(x, w) > -1.0;
      addCap(k, h, p, met, x.xy, -dot(x, cap.z), widened, cap.z.xy, n, true);
    }
    ++i;
  }
}
#endif
