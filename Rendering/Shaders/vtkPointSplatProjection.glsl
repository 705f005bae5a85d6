// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What every stage that projects splats shares: from a splat in the cloud's
// coordinates to its image, and from a pixel back to the splat.
//
// A splat is a centre p, two tangent vectors s and t, a normal m as long as its
// radius, and a symmetric matrix K, the surface's second fundamental form times
// the radius. It is the cap of the osculating paraboloid
//   p + u s + v t + h m,  h = -K(q, q) / 2,  q = (u, v),  u^2 + v^2 <= 1,
// which a flat disk is with K = 0. With rows R that take view coordinates to
// (x w, y w, w), x and y in pixels from the projected centre, the columns R s,
// R t, R m, R p = (0, 0, w), all over the w of the centre, take (u, v, h, 1) to
// the image. The ray through the pixel (x, y) is where two planes meet, row 1 =
// x row 3 and row 2 = y row 3 (Sigg, Weyrich, Botsch, Gross 2006, GPU-based ray-
// casting of quadratic surfaces, cast rays at quadrics by such a matrix, and
// Guennebaud, Barthe, Paulin 2006, equations 3 to 5, at disks, by its adjoint):
//   (s.x - x s.z, t.x - x t.z, m.x - x m.z) . (u, v, h) = x, and for y likewise.
// So single precision suffices however far the window's corner is. Nothing in
// this needs a perspective: in parallel projection all w are 1.

#include "vtkPointSplatDepthCode"
#include "vtkPointSplatOctahedron"

uniform mat4 MCVC;           // cloud's local coordinates to view coordinates
uniform mat3 NormalMatrix;   // normals likewise
uniform vec4 PixelX;         // view coordinates to x w, in pixels of the images
uniform vec4 PixelY;         // view coordinates to y w
uniform vec4 PixelW;         // view coordinates to w
uniform ivec4 Window;        // pixels that may be drawn: first x, y, last x, y
uniform vec2 DepthRange;     // distances of the near plane, and of the far from it
uniform bool Parallel;       // parallel projection
uniform bool Circular;       // one radius a splat, else two axes
uniform float RadiusScale;   // multiplies radii and axes
uniform int Culling;         // 0 none, 1 back faces, 2 front faces, 3 both
uniform uint Tag;            // the cloud's slot in this frame, times two
uniform float LayerDistance; // world units; of negative values the magnitude
                             // counts, as a fraction of each splat's radius
#ifdef CLIPPING
uniform int ClipPlaneCount;
uniform vec4 ClipPlanes[6];  // view coordinates; what is negative is cut away
#endif
uniform float KernelSupport; // kernels reach this many radii

// Splats seen at a flatter angle than this count as seen at this one when depths
// along the ray are turned to distances along the normal.
const float LeastFacing = 0.2;
// Splats seen at a flatter angle than this are at silhouettes.
const float SteepFacing = 0.35;
// Splats seen at a flatter angle than this belong to layers of their own side only: large ones
// may reach to a silhouette from where they are seen less flat.
const float OwnSideFacing = 0.7;

// The strongest bend, as K's eigenvalue: the normal turns 45 degrees at the rim.
const float LargestBend = 1.0;
// The part of the normal's first-order change that splats add to the mean. Where
// the normal runs as n(x), the mean over splats at x + d of n(x + d) - a n'(x + d) d
// is n + (1/2 - a) n'' <d^2> to second order: with none of it the kernel smooths,
// with all of it, it sharpens as much, and with half it does neither.
const float Turn = 0.5;

struct Splat
{
  vec2 centre;  // pixels
  vec3 s;       // image of the tangents: x w and y w from the centre, w; over the centre's w
  vec3 t;
  vec3 m;       // image of the normal
  vec3 bend;    // K's elements 11, 12, 22
  vec4 narrow;  // the widened ellipse: its axes in the image, over their squared lengths
  vec2 lean;    // where on the splat the first axis ends; 0 if it is parallel to the screen
  float depth;  // of the centre: distance from the near plane along the view axis
  vec3 normal;  // view coordinates, unit length
  vec3 turnS;   // the normal's change along s and t
  vec3 turnT;
  float facing; // distance along the normal for a step of 1 in depth along the ray
  float layer;  // least layer distance, world units
  uint tag;     // slot and side
  vec3 positionVC;
  vec3 sVC;
  vec3 tVC;
  vec3 mVC;
  ivec4 box;    // pixels that the kernel may touch: first x, y, last x, y
};

struct Hit
{
  vec2 uv;      // in radii from the centre, along s and t
  float r2;     // the distance that the kernel sees, squared, in radii
  float depth;
};

// What a splat is beside itself where its image is narrower than the prefilter's
// radius, in pixels, so that it does not fall between pixels: the ellipse that its
// tangents span in the image, turned to its principal axes so that each may be widened
// to that radius for itself; a widened axis is parallel to the screen (Guennebaud,
// section 4). But where a splat turns away from the viewer before its rim (turning:
// how far the normal turns until there), it has the silhouette on it, and such an
// ellipse would stand out over that: it is a disk of that radius about the centre.
// along, across: how far the ellipse's axes reach along x and y.
void widen(inout Splat q, float radius, float turning, out vec2 along, out vec2 across)
{
  float aa = dot(q.s.xy, q.s.xy);
  float ab = dot(q.s.xy, q.t.xy);
  float bb = dot(q.t.xy, q.t.xy);
  float diff = 0.5 * (aa - bb);
  float root = sqrt(diff * diff + ab * ab);
  float longest = 0.5 * (aa + bb) + root;
  float shortest = max(0.5 * (aa + bb) - root, 0.0);
  q.narrow = vec4(1.0, 0.0, 0.0, 1.0) / radius;
  q.lean = vec2(0.0);
  along = vec2(0.0);
  across = vec2(0.0);
  if (shortest >= radius * radius || longest <= radius * radius ||
    shortest < turning * turning * longest)
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
    vec2 crossing = from + (to - from) * before / (before - after);
    for (int end = 0; end < 2; ++end)
    {
      if (end == 0 ? before >= 0.0 : (before >= 0.0) != (after >= 0.0))
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

// Projects a splat. False: nothing of it can be seen.
// shape: coded, the normals of the disk's plane and of the surface, which differ
// only where the latter is wrong, and K; reach: how many radii are drawn; least:
// the prefilter's radius in pixels.
bool project(vec3 positionMC, uvec3 shape, vec3 axis1MC, vec3 axis2MC, float radius,
  float reach, float least, out Splat q)
{
  vec4 p = MCVC * vec4(positionMC, 1.0);
  vec3 planeMC = decodeNormal(shape.x);
  vec3 n = normalize(NormalMatrix * planeMC);
  q.positionVC = p.xyz;
  q.depth = -p.z - DepthRange.x;
  float w = dot(PixelW, p);

  // Which side is seen.
  float towards = Parallel ? n.z : -dot(n, p.xyz);
  bool back = towards < 0.0;
  if ((back && (Culling & 1) != 0) || (!back && (Culling & 2) != 0))
  {
    return false;
  }
  q.tag = Tag | (back ? 1u : 0u);
  q.normal = shape.x == shape.y ? n : normalize(NormalMatrix * decodeNormal(shape.y));
  q.facing = Parallel ? abs(n.z) : abs(dot(n, p.xyz)) / max(abs(p.z), 1e-30);

  if (Circular)
  {
    // Any two axes across the normal span the disk, but K is in terms of these; in
    // the cloud's coordinates, so that an actor's uneven scale makes the ellipse that
    // it should.
    vec3 other = abs(planeMC.z) < 0.7 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0);
    axis1MC = radius * normalize(cross(planeMC, other));
    axis2MC = cross(planeMC, axis1MC);
  }
  q.sVC = mat3(MCVC) * (RadiusScale * axis1MC);
  q.tVC = mat3(MCVC) * (RadiusScale * axis2MC);
  q.mVC = mat3(MCVC) * (RadiusScale * radius * planeMC);
  float longest = sqrt(max(dot(q.sVC, q.sVC), dot(q.tVC, q.tVC)));
  q.layer = LayerDistance < 0.0 ? -LayerDistance * longest : LayerDistance;

  // The larger a splat, the more it bends.
  q.bend = vec3(ivec3(int(shape.z << 22) >> 22, int(shape.z << 12) >> 22, int(shape.z << 2) >> 22));
  q.bend *= LargestBend / 511.0;
  float mean = 0.5 * (q.bend.x + q.bend.z);
  float root = length(vec2(0.5 * (q.bend.x - q.bend.z), q.bend.y));
  float scale = min(RadiusScale, LargestBend / max(abs(mean) + root, 1e-6));
  q.bend *= scale;
  float lowest = -0.5 * reach * reach * scale * max(mean + root, 0.0);
  float highest = -0.5 * reach * reach * scale * min(mean - root, 0.0);
  // The gradient of h + K(q, q) / 2, in terms of the basis that is dual to s, t, m.
  vec3 st = cross(q.sVC, q.tVC);
  float turn = Turn * sign(dot(st, q.mVC)) / max(length(st), 1e-30);
  vec3 dualS = turn * cross(q.tVC, q.mVC);
  vec3 dualT = turn * cross(q.mVC, q.sVC);
  q.turnS = q.bend.x * dualS + q.bend.y * dualT;
  q.turnT = q.bend.y * dualS + q.bend.z * dualT;

  // Wholly before the near plane or behind the far one.
  float deep = reach * length(vec2(q.sVC.z, q.tVC.z)) + max(highest, -lowest) * abs(q.mVC.z);
  if (!(q.depth + deep > 0.0 && q.depth - deep < DepthRange.y))
  {
    return false;
  }

  if (w < 1e-6 * longest || w <= 0.0)
  {
    // The centre lies at or behind the eye. What of the disk is in front of the
    // near plane is at the edge of a splat that others cover.
    return false;
  }
  q.centre = vec2(dot(PixelX, p), dot(PixelY, p)) / w;
  q.s = vec3(dot(PixelX.xyz, q.sVC), dot(PixelY.xyz, q.sVC), dot(PixelW.xyz, q.sVC)) / w;
  q.t = vec3(dot(PixelX.xyz, q.tVC), dot(PixelY.xyz, q.tVC), dot(PixelW.xyz, q.tVC)) / w;
  q.m = vec3(dot(PixelX.xyz, q.mVC), dot(PixelY.xyz, q.mVC), dot(PixelW.xyz, q.mVC)) / w;
  q.s.xy -= q.centre * q.s.z;
  q.t.xy -= q.centre * q.t.z;
  q.m.xy -= q.centre * q.m.z;

  vec2 along;
  vec2 across;
  widen(q, least, reach * scale * (abs(mean) + root), along, across);
  vec2 low = vec2(-least * reach);
  vec2 high = -low;
  // The cap lies between the disks at its least and its greatest height.
  addDisk(q, lowest, reach, low, high);
  addDisk(q, highest, reach, low, high);
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
// False: outside the cap of radius reach, outside the depth range, or cut away.
bool intersect(Splat q, vec2 pixel, float reach, out Hit hit)
{
  vec2 d = pixel - q.centre;
  vec3 a = vec3(q.s.x, q.t.x, q.m.x) - d.x * vec3(q.s.z, q.t.z, q.m.z);
  vec3 b = vec3(q.s.y, q.t.y, q.m.y) - d.y * vec3(q.s.z, q.t.z, q.m.z);
  // The ray's direction, and its point nearest to the centre, as (u, v, h).
  vec3 c = cross(a, b);
  vec3 x = cross(d.x * b - d.y * a, c) / dot(c, c);
  // h + K(q, q) / 2 = 0 along it: alpha tau^2 + beta tau + gamma = 0. Of two hits
  // the one that tends to the plane's as the bend goes to zero, in the form that is
  // stable there.
  vec2 Kc = q.bend.xy * c.x + q.bend.yz * c.y;
  vec2 Kx = q.bend.xy * x.x + q.bend.yz * x.y;
  float alpha = 0.5 * dot(Kc, c.xy);
  float beta = c.z + dot(Kc, x.xy);
  float gamma = x.z + 0.5 * dot(Kx, x.xy);
  float discriminant = beta * beta - 4.0 * alpha * gamma;
  float root = sqrt(max(discriminant, 0.0));
  x -= 2.0 * gamma / (beta + (beta < 0.0 ? -root : root)) * c;
  hit.r2 = dot(x.xy, x.xy);
  vec2 onEllipse = vec2(dot(d, q.narrow.xy), dot(d, q.narrow.zw));
  float w = 1.0 - onEllipse.x * dot(q.lean, vec2(q.s.z, q.t.z));
  onEllipse.x = w > 0.0 ? onEllipse.x / w : 1e9;
  float narrow = dot(onEllipse, onEllipse);
  // Written so that a division by zero fails the test.
  if (!(discriminant >= 0.0 && hit.r2 <= reach * reach))
  {
    x = vec3(onEllipse.x * q.lean, 0.0);
    hit.r2 = narrow;
  }
  hit.r2 = min(hit.r2, narrow);
  hit.uv = x.xy;
  hit.depth = q.depth - dot(x, vec3(q.sVC.z, q.tVC.z, q.mVC.z));
  if (!(hit.r2 <= reach * reach) || !(hit.depth > 0.0 && hit.depth < DepthRange.y) ||
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
    if (!(dot(ClipPlanes[i], vec4(position, 1.0)) >= 0.0)) // NaN, too, is cut away
    {
      return false;
    }
  }
#endif
  return true;
}

// The normal that a splat adds there.
vec3 normalAt(Splat q, vec2 uv)
{
  return normalize(q.normal + uv.x * q.turnS + uv.y * q.turnT);
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
  return (different == 0u || (different == 1u && q.facing > OwnSideFacing)) &&
    abs(depth - decodeDepth(nearest)) * max(q.facing, LeastFacing) <= q.layer;
}
