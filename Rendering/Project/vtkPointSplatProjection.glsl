// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What every stage that projects splats shares: from a splat in the cloud's coordinates to its
// image.
//
// A splat is a centre p, two tangent vectors s and t, a normal m as long as its
// radius, and a symmetric matrix K, the surface's second fundamental form times
// the radius. It is the cap of the osculating paraboloid
//   p + u s + v t + h m,  h = -K(q, q) / 2,  q = (u, v),  u^2 + v^2 <= 1,
// which a flat disk is with K = 0. With rows R that take view coordinates to
// (x w, y w, w), x and y in pixels from the projected centre, the columns R s,
// R t, R m, R p = (0, 0, w), all over the w of the centre, take (u, v, h, 1) to
// the image (Sigg, Weyrich, Botsch, Gross 2006, GPU-based ray-casting of quadratic surfaces, and
// Guennebaud, Barthe, Paulin 2006, equation 3, have such a matrix). So single precision
// suffices however far the window's corner is. Nothing in this needs a perspective: in parallel
// projection all w are 1.
//
// From there on this differs from Guennebaud's section 3, whose splats are disks: the adjoint matrix
// takes pixels back to the disk (equations 4 and 5), and the depth is linear in the image (6 and 7).
// Pixels of a cap have no such matrix: their rays are met with the paraboloid (vtkPointSplatCap.glsl).
// What bends along with the surface has no cracks at silhouettes and needs fewer splats. Where bend and
// perspective move no pixel by more than 1/32 (Flat in vtkPointSplatRecord.glsl) tiles take less than
// the adjoint does: a quadratic form and a linear depth, without a division at each pixel. With 1/10 in the place of
// 1/32 frames of four models took as long (0.93 to 1.07 times), so that it is not worth a kind of its own. Quads meet
// all splats as caps.
//
// A body alone has no plane: its disk is across the ray from the eye, so that it is seen from all
// sides, and with K it is a small ball. Nothing else covers the pixels beside it, so it is never
// smaller than what covers one.

#include "vtkPointSplatOctahedron"
#include "vtkPointSplatPixels"

uniform mat4 MCVC;           // cloud's local coordinates to view coordinates
uniform mat3 NormalMatrix;   // normals likewise
uniform ivec4 Window;        // pixels that may be drawn: first x, y, last x, y
uniform vec2 DepthRange;     // distances of the near plane, and of the far from it
uniform bool Circular;       // one radius a splat, else two axes
uniform float RadiusScale;   // multiplies radii and axes
uniform float UsualRadius;   // of points that have none
uniform int Culling;         // 0 none, 1 back faces, 2 front faces, 3 both
uniform uint Tag;            // the cloud's slot in this frame, times two
uniform float LayerDistance; // the least layer distance: world units,
uniform float LayerRadii;    // and as a fraction of each splat's radius; one of them is 0
#ifdef CLIPPING
uniform int ClipPlaneCount;
uniform vec4 ClipPlanes[6];  // view coordinates; what is negative is cut away
#endif
uniform float KernelSupport; // kernels reach this many radii

// Splats seen at a flatter angle than this count as seen at this one when depths
// along the ray are turned to distances along the normal.
const float LeastFacing = 0.2;
// Splats seen at a flatter angle than this are seen edge-on: distances along the ray tell none along
// the normal. With 0.2 the board of TestSplatsCheckerboard is farther from the exact one near by,
// with 0 far off.
const float EdgeOnFacing = 0.1;
// Splats seen at a flatter angle than this are at silhouettes.
const float SteepFacing = 0.35;
// Splats seen at a flatter angle than this belong to layers of their own side only: large ones
// may reach to a silhouette from where they are seen less flat.
const float OwnSideFacing = 0.7;
// The least layer distance of splats at the edges of flat faces, of the others'. With 0.2 walls that are thin beside their
// faces' triangles are blended, with 0.05 edges are less smooth (Testing/Accuracy/likeness.py channel, cog, slab); if others
// of flat faces have it, too, these do not blend with the round ones that they go over into (part_triangles).
const float FlatLayer = 0.1;

// The strongest bend, as K's eigenvalue: the normal turns 45 degrees at the rim.
const float LargestBend = 1.0;
const float BendSteps = 511.0;
// Bits of K's code: the three elements, and whether the splat is a body alone.
const uint BendMask = 0x3fffffffu;
const uint BodyBit = 0x40000000u;
const uint FlatBit = 0x80000000u; // it is known not to bend
// Pixels, the least radius of a body: times DiskReach (vtkPointSplatReach.h), 1.15, it is half of a
// pixel's diagonal, so that no body falls between the pixels' centres.
const float LeastBody = 0.62;
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
#ifdef CLIP_LINES
  vec4 lines;   // that clip it, in radii (vtkPointSplatClipLines)
#endif
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

// How far a splat bends.
struct Bend
{
  float strongest; // the greatest magnitude of K's eigenvalues
  float lowest;    // the heights between which the cap lies, in radii
  float highest;
};

vec3 decodeBend(uint code)
{
  return vec3(ivec3(int(code << 22) >> 22, int(code << 12) >> 22, int(code << 2) >> 22)) *
    (LargestBend / BendSteps);
}

uint encodeBend(vec3 bend)
{
  uvec3 k = uvec3(ivec3(round(bend * (BendSteps / LargestBend)))) & 1023u;
  return k.x | k.y << 10 | k.z << 20;
}

// How far a splat reaches in depth from its centre.
float depthReach(Splat q, Bend bend, float reach)
{
  return reach * length(vec2(q.sVC.z, q.tVC.z)) +
    max(bend.highest, -bend.lowest) * abs(q.mVC.z);
}

// Places a splat in view coordinates and in the image. False: nothing of it can be seen.
// shape: coded, the normals of the disk's plane and of the surface, which differ
// only where the latter is wrong, and K; reach: how many radii are drawn.
bool placeSplat(vec3 positionMC, uvec3 shape, vec3 axis1MC, vec3 axis2MC, float radius,
  float reach, out Splat q, out Bend bend)
{
  vec4 p = MCVC * vec4(positionMC, 1.0);
  bool body = (shape.z & BodyBit) != 0u;
  // The normal matrix is the inverse of the transposed one that takes a plane's normal back.
  vec3 planeMC = body
    ? normalize((Parallel ? vec3(0.0, 0.0, 1.0) : -p.xyz / max(length(p.xyz), 1e-30)) * mat3(MCVC))
    : decodeNormal(shape.x);
  vec3 n = normalize(NormalMatrix * planeMC);
  radius = radius > 0.0 ? radius : UsualRadius;
  q.positionVC = p.xyz;
  q.depth = -p.z - DepthRange.x;
  float w = dot(PixelW, p);

  // Which side is seen.
  float towards = Parallel ? n.z : -dot(n, p.xyz);
  bool back = towards < 0.0;
  q.tag = Tag | (back ? 1u : 0u);
  q.normal = n;
  if (body ? (shape.z & BendMask) == 0u : shape.x != shape.y)
  {
    q.normal = normalize(NormalMatrix * decodeNormal(shape.y));
    q.normal = body && dot(q.normal, n) < 0.0 ? -q.normal : q.normal;
  }
  q.facing = Parallel ? abs(n.z) : abs(towards) / max(abs(p.z), 1e-30);

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
  q.layer = LayerDistance + LayerRadii * longest;
  if (body)
  {
    float least = LeastBody * w / max(length(PixelX.xyz) * longest, 1e-30);
    float grown = clamp(least, 1.0, 1e6);
    q.sVC *= grown;
    q.tVC *= grown;
    q.mVC *= grown;
  }

  // The larger a splat, the more it bends.
  q.bend = decodeBend(shape.z);
  float mean = 0.5 * (q.bend.x + q.bend.z);
  float root = length(vec2(0.5 * (q.bend.x - q.bend.z), q.bend.y));
  float scale = min(RadiusScale, LargestBend / max(abs(mean) + root, 1e-6));
  q.bend *= scale;
  bend.strongest = scale * (abs(mean) + root);
  bend.lowest = -0.5 * reach * reach * scale * max(mean + root, 0.0);
  bend.highest = -0.5 * reach * reach * scale * min(mean - root, 0.0);
  // The gradient of h + K(q, q) / 2, in terms of the basis that is dual to s, t, m.
  vec3 st = cross(q.sVC, q.tVC);
  float turn = Turn * sign(dot(st, q.mVC)) / max(length(st), 1e-30);
  vec3 dualS = turn * cross(q.tVC, q.mVC);
  vec3 dualT = turn * cross(q.mVC, q.sVC);
  q.turnS = q.bend.x * dualS + q.bend.y * dualT;
  q.turnT = q.bend.y * dualS + q.bend.z * dualT;

  float inverseW = 1.0 / (w == 0.0 ? 1e-30 : w);
  q.centre = vec2(dot(PixelX, p), dot(PixelY, p)) * inverseW;
  q.s = vec3(dot(PixelX.xyz, q.sVC), dot(PixelY.xyz, q.sVC), dot(PixelW.xyz, q.sVC)) * inverseW;
  q.t = vec3(dot(PixelX.xyz, q.tVC), dot(PixelY.xyz, q.tVC), dot(PixelW.xyz, q.tVC)) * inverseW;
  q.m = vec3(dot(PixelX.xyz, q.mVC), dot(PixelY.xyz, q.mVC), dot(PixelW.xyz, q.mVC)) * inverseW;
  q.s.xy -= q.centre * q.s.z;
  q.t.xy -= q.centre * q.t.z;
  q.m.xy -= q.centre * q.m.z;

  // Culled, or wholly before the near plane or behind the far one. Or the centre lies at or behind
  // the eye: what of the disk is in front of the near plane is at the edge of a splat that others
  // cover.
  float deep = depthReach(q, bend, reach);
  return (Culling & (back ? 1 : 2)) == 0 && q.depth + deep > 0.0 && q.depth - deep < DepthRange.y &&
    w >= 1e-6 * longest && w > 0.0;
}

#ifdef CLIP_LINES
bool endsAtLines(Splat q)
{
  return any(notEqual(q.lines, vec4(0.0)));
}

// Clips a splat. What ends at lines ends before another face, which lies no farther off than its radius. If it is known not to
// bend it is of a flat one, whose other splats lie in its plane: so layers need not be as far apart. code: of its bend.
void clipSplat(inout Splat q, vec4 lines, uint code)
{
  q.lines = lines;
  bool isOfFlat = (code & FlatBit) != 0u && endsAtLines(q);
  q.layer = isOfFlat ? mix(LayerDistance, q.layer, FlatLayer) : q.layer;
}
#endif

bool isEdgeOn(float facing)
{
  return facing < EdgeOnFacing;
}

// Whether a splat may belong to a layer that shows the other side. One that ends at lines may not:
// just behind the edge lies the face that is turned away.
bool belongsToBothSides(Splat q)
{
#ifdef CLIP_LINES
  if (endsAtLines(q))
  {
    return false;
  }
#endif
  return q.facing > OwnSideFacing;
}

// Where the body that a splat lies on bends so much that those as narrow make a rim of less than a
// pixel, no gap between them can be seen. turning: what the splat turns away by before its rim,
// times its length in the image; radius: pixels, that it would be widened to.
bool hidesGaps(float turning, float radius)
{
  return turning > 0.5 * radius * radius;
}

// The normal that a splat adds at a point of it.
vec3 normalAt(Splat q, vec2 uv)
{
  return normalize(q.normal + uv.x * q.turnS + uv.y * q.turnT);
}
