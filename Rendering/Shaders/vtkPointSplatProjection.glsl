// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What every stage that projects splats shares: from a splat in the cloud's
// coordinates to its image, and from a pixel back into the splat's plane.
//
// A splat is a centre p and two tangent vectors s, t; q = (u, v) is inside its
// disk where u^2 + v^2 <= 1. With rows R that take view coordinates to
// (x w, y w, w), x and y in pixels, the splat's plane maps to the image by the
// matrix M = [R s, R t, R p] (Guennebaud, Barthe, Paulin 2006, equation 3), and
// back by its adjoint (equations 4 and 5). Here x and y count from the projected
// centre, which makes the third column (0, 0, w): the adjoint loses most of its
// terms, and single precision suffices however far the window's corner is.
// Nothing in this needs a perspective: in parallel projection w is 1.

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
uniform int ClipPlaneCount;
uniform vec4 ClipPlanes[6];  // view coordinates; what is negative is cut away
uniform float KernelSupport; // kernels reach this many radii

// The low bits of a depth name the cloud and the side that was hit.
const uint TagBits = 7u;
const uint TagMask = 127u;
const uint NoDepth = 0xffffffffu;

// Splats seen at a flatter angle than this count as seen at this one when depths
// along the ray are turned to distances along the normal.
const float LeastFacing = 0.2;
// Splats seen at a flatter angle than this belong to layers of their own side only.
const float SteepFacing = 0.35;

struct Splat
{
  vec2 centre;  // pixels
  vec3 s;       // image of the tangents: x w and y w from the centre, w
  vec3 t;
  float w;      // of the centre
  float depth;  // of the centre: distance from the near plane along the view axis
  vec2 slope;   // depth along s and t
  vec3 normal;  // view coordinates, unit length
  float facing; // distance along the normal for a step of 1 in depth along the ray
  float layer;  // least layer distance, world units
  uint tag;     // slot and side
  vec3 positionVC;
  vec3 sVC;
  vec3 tVC;
  ivec4 box;    // pixels that the kernel may touch: first x, y, last x, y
};

// Widens tangents whose image is shorter than the prefilter's radius h, in
// pixels, so that no splat falls between pixels (Guennebaud, section 4). The
// tangents are first turned to the principal axes of the ellipse that they
// span in the image, so that each may be widened for itself whatever the
// splat's shape. A widened tangent is parallel to the screen: its slope is
// dropped (section 4.1), since a splat thinner than a pixel has no use for it.
void widen(inout Splat q, float h)
{
  vec2 a = q.s.xy / q.w;
  vec2 b = q.t.xy / q.w;
  float aa = dot(a, a);
  float ab = dot(a, b);
  float bb = dot(b, b);
  float mean = 0.5 * (aa + bb);
  float diff = 0.5 * (aa - bb);
  float root = sqrt(diff * diff + ab * ab);
  float longest = mean + root;
  float shortest = mean - root;
  if (shortest >= h * h)
  {
    return;
  }
  vec2 e = diff > 0.0 ? vec2(diff + root, ab) : vec2(ab, root - diff);
  float l = length(e);
  e = l > 0.0 ? e / l : vec2(1.0, 0.0);
  q.s = e.x * q.s + e.y * q.t;
  q.sVC = e.x * q.sVC + e.y * q.tVC;
  q.slope.x = dot(e, q.slope);
  vec2 direction = q.s.xy;
  l = length(direction);
  direction = l > 0.0 ? direction / l : vec2(1.0, 0.0);
  if (longest < h * h)
  {
    q.s = vec3(direction * h * q.w, 0.0);
    q.sVC = vec3(0.0);
    q.slope.x = 0.0;
  }
  q.t = vec3(-direction.y * h * q.w, direction.x * h * q.w, 0.0);
  q.tVC = vec3(0.0);
  q.slope.y = 0.0;
}

// The box, in pixels about the centre, of the ellipse u^2 + v^2 <= r^2, from the
// conic's tangents parallel to the axes.
void boundingBox(Splat q, float r, out vec2 low, out vec2 high)
{
  float r2 = r * r;
  float k = r2 * (q.s.z * q.s.z + q.t.z * q.t.z) - q.w * q.w;
  if (k < -1e-4 * q.w * q.w)
  {
    vec2 c = r2 * (q.s.xy * q.s.z + q.t.xy * q.t.z);
    vec2 d = r2 * (q.s.xy * q.s.xy + q.t.xy * q.t.xy);
    vec2 extent = sqrt(max(c * c - k * d, 0.0)) / -k;
    low = c / k - extent;
    high = c / k + extent;
    return;
  }
  // The disk reaches behind the eye, and has no bounded image. Of the square about
  // it, what is beyond the near plane has.
  low = vec2(1e30);
  high = vec2(-1e30);
  for (int i = 0; i < 4; ++i)
  {
    vec2 from = r * vec2(i == 1 || i == 2 ? 1.0 : -1.0, i >= 2 ? 1.0 : -1.0);
    vec2 to = vec2(-from.y, from.x);
    float before = q.depth + dot(from, q.slope);
    float after = q.depth + dot(to, q.slope);
    vec2 crossing = from + (to - from) * before / (before - after);
    for (int end = 0; end < 2; ++end)
    {
      if (end == 0 ? before >= 0.0 : (before >= 0.0) != (after >= 0.0))
      {
        vec2 uv = end == 0 ? from : crossing;
        float w = max(q.w + uv.x * q.s.z + uv.y * q.t.z, 1e-20);
        vec2 pixel = (uv.x * q.s.xy + uv.y * q.t.xy) / w;
        low = min(low, pixel);
        high = max(high, pixel);
      }
    }
  }
}

// A unit vector from the octahedron's two coordinates, 16 bits each (Cigolle et al.
// 2014, A survey of efficient representations for independent unit vectors).
vec3 decodeNormal(uint code)
{
  vec2 f = vec2(ivec2(int(code << 16) >> 16, int(code) >> 16)) / 32767.0;
  vec3 n = vec3(f, 1.0 - abs(f.x) - abs(f.y));
  float fold = max(-n.z, 0.0);
  n.x += n.x >= 0.0 ? -fold : fold;
  n.y += n.y >= 0.0 ? -fold : fold;
  return normalize(n);
}

// Projects a splat. False: nothing of it can be seen.
// normals: coded, of the disk's plane and of the surface, which differ only where
// the latter is wrong; reach: how many radii are drawn; h: the prefilter's radius
// in pixels.
bool project(vec3 positionMC, uvec2 normals, vec3 axis1MC, vec3 axis2MC, float radius,
  float reach, float h, out Splat q)
{
  vec4 p = MCVC * vec4(positionMC, 1.0);
  vec3 planeMC = decodeNormal(normals.x);
  vec3 n = normalize(NormalMatrix * planeMC);
  q.positionVC = p.xyz;
  q.depth = -p.z - DepthRange.x;
  q.w = dot(PixelW, p);

  // Which side is seen.
  float towards = Parallel ? n.z : -dot(n, p.xyz);
  bool back = towards < 0.0;
  if ((back && (Culling & 1) != 0) || (!back && (Culling & 2) != 0))
  {
    return false;
  }
  q.tag = Tag | (back ? 1u : 0u);
  q.normal = normals.x == normals.y ? n : normalize(NormalMatrix * decodeNormal(normals.y));
  q.facing = Parallel ? abs(n.z) : abs(dot(n, p.xyz)) / max(abs(p.z), 1e-30);

  if (Circular)
  {
    // Any two axes across the normal span the disk; in the cloud's coordinates,
    // so that an actor's uneven scale makes the ellipse that it should.
    vec3 other = abs(planeMC.z) < 0.7 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0);
    axis1MC = radius * normalize(cross(planeMC, other));
    axis2MC = cross(planeMC, axis1MC);
  }
  q.sVC = mat3(MCVC) * (RadiusScale * axis1MC);
  q.tVC = mat3(MCVC) * (RadiusScale * axis2MC);
  float longest = sqrt(max(dot(q.sVC, q.sVC), dot(q.tVC, q.tVC)));
  q.layer = LayerDistance < 0.0 ? -LayerDistance * longest : LayerDistance;
  q.slope = vec2(-q.sVC.z, -q.tVC.z);

  // Wholly before the near plane or behind the far one.
  float deep = reach * length(q.slope);
  if (!(q.depth + deep > 0.0 && q.depth - deep < DepthRange.y))
  {
    return false;
  }

  vec2 xy = vec2(dot(PixelX, p), dot(PixelY, p));
  if (q.w < 1e-6 * longest || q.w <= 0.0)
  {
    // The centre lies at or behind the eye. What of the disk is in front of the
    // near plane is at the edge of a splat that others cover.
    return false;
  }
  q.centre = xy / q.w;
  q.s = vec3(dot(PixelX.xyz, q.sVC), dot(PixelY.xyz, q.sVC), dot(PixelW.xyz, q.sVC));
  q.t = vec3(dot(PixelX.xyz, q.tVC), dot(PixelY.xyz, q.tVC), dot(PixelW.xyz, q.tVC));
  q.s.xy -= q.centre * q.s.z;
  q.t.xy -= q.centre * q.t.z;
  widen(q, h);

  vec2 low;
  vec2 high;
  boundingBox(q, reach, low, high);
  // Clamped before the conversion: out of an int's range it is undefined.
  low = clamp(q.centre + low, vec2(Window.xy) - 1.0, vec2(Window.zw) + 2.0);
  high = clamp(q.centre + high, vec2(Window.xy) - 1.0, vec2(Window.zw) + 2.0);
  // The pixels whose centres, at half integers, lie inside.
  q.box = ivec4(max(ivec2(ceil(low - 0.5)), Window.xy), min(ivec2(floor(high - 0.5)), Window.zw));
  return all(lessThanEqual(q.box.xy, q.box.zw));
}

// Where the ray through a pixel's centre meets the splat's plane.
// False: outside the disk of radius reach, outside the depth range, or cut away.
bool intersect(Splat q, vec2 pixel, float reach, out float r2, out float depth)
{
  vec2 d = pixel - q.centre;
  // The adjoint of [s t (0,0,w)], times (d, 1).
  vec2 numerator = q.w * vec2(q.t.y * d.x - q.t.x * d.y, q.s.x * d.y - q.s.y * d.x);
  float denominator = (q.s.y * q.t.z - q.s.z * q.t.y) * d.x +
    (q.s.z * q.t.x - q.s.x * q.t.z) * d.y + (q.s.x * q.t.y - q.s.y * q.t.x);
  vec2 uv = numerator / denominator;
  r2 = dot(uv, uv);
  depth = q.depth + dot(uv, q.slope);
  // Written so that a division by zero fails the test.
  if (!(r2 <= reach * reach) || !(depth > 0.0 && depth < DepthRange.y) ||
    q.w + uv.x * q.s.z + uv.y * q.t.z <= 0.0)
  {
    return false;
  }
  for (int i = 0; i < ClipPlaneCount; ++i)
  {
    vec3 position = q.positionVC + uv.x * q.sVC + uv.y * q.tVC;
    if (dot(ClipPlanes[i], vec4(position, 1.0)) < 0.0)
    {
      return false;
    }
  }
  return true;
}

// Depths as integers of the same order, the tag in their lowest bits.
uint encodeDepth(float depth, uint tag)
{
  return (floatBitsToUint(depth) & ~TagMask) | tag;
}

float decodeDepth(uint code)
{
  return uintBitsToFloat(code & ~TagMask);
}

// Whether a splat's fragment belongs to the surface layer whose nearest depth is
// coded in nearest: the same cloud, and no farther than the least layer distance,
// measured along the normal. For splats seen edge-on the bound along the ray
// stays finite; and they must show the same side, since behind a silhouette lies
// the far side of the same body, close by and lit otherwise. Other splats need
// not: normals that are not consistently oriented are lit all the same.
bool sameLayer(Splat q, float depth, uint nearest)
{
  uint different = (nearest ^ q.tag) & TagMask;
  return (different == 0u || (different == 1u && q.facing > SteepFacing)) &&
    abs(depth - decodeDepth(nearest)) * max(q.facing, LeastFacing) <= q.layer;
}
