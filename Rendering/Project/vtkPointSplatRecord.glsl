// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What tiles know of a projected splat: a record of five texels (RGBA32UI, 80 bytes), and its box
// (two words), by which it is listed. With d a pixel's offset from the splat's centre:
//   0  centre x and y, pixels; depth; head
// Flat ones, of which all is linear or quadratic in d, go on with
//   1  Vxx, 2 Vxy, Vyy: the disk is where V(d, d) <= reach^2; slope of the depth along x
//   2  slope along y; Wxx, 2 Wxy, Wyy: the kernel's squared distance is W(d, d)
//   3  slopes, along x and y, of the depth that the kernel sees; normal; 0
//   4  change of the normal along x, and along y (six halves); 0
// and all others, which are caps (vtkPointSplatCap), with
//   1  x of the images of s and t, y of the same
//   2  z of s and t in view coordinates; normal; lean (two 16-bit fractions)
//   3  x and y of the image of m; z of m in view coordinates; bend
//   4  change of the normal along s, and along t (six halves); along (two halves)
// A cap that is narrower than the prefilter is widened (vtkPointSplatIntersection): the longer
// axis of its ellipse is `along`, over its squared length, and ends at `lean` on the splat; where
// both are 0 it is a disk.
//
// Triangles, with a_i a pixel's homogeneous barycentric coordinates, of which those of corners 1 and 2
// are 0, and that of corner 0 is 1, at the centre, which is corner 0's image:
//   1  change of a_1 along x and y; of a_2
//   2  change of a_0 along x and y; depth of corners 1 and 2, less that of 0
//   3  normals of the corners, and of the plane
//   4  colours, or values, of corners 1 and 2; factors, or ids, of corners 1 and 2
// Those of corner 0 lie beside the records, as splats'.
//
// Clip lines, where a cloud of the frame has some, lie beside the records (RGBA32F): two vectors,
// of flat splats by pixels, of caps by radii along s and t (vtkPointSplatClipLines).
//
// Head: bits 0 to 14 the tag, which names the cloud and, in bit 0, the side that is seen; bit 15
// whether splats of both sides belong to its layers; above, the least layer distance along the
// ray, 16 bits of a float, negative where the splat is seen edge-on.
//
// Box: first tile x 12 bits, y 13, bucket of the nearest depth 7 lower bits; last tile x and y,
// bucket 3 upper bits, kind. With PIXEL_BOXES two words more, of the pixels of which the disk or the
// triangle may hide a sample: first pixel x and y, 16 bits each; last x and y.

const int RecordTexels = 5;

// The kinds, in the order in which a tile lists them.
const uint NotSeen = 0u;
const uint Flat = 1u;   // neither bend nor perspective moves a pixel
const uint Bent = 2u;   // perspective moves no pixel within a tile
const uint Curved = 3u; // all is computed
const uint Wide = 4u;   // the same, listed once for many tiles
const uint Triangle = 5u;
const uint Clipped = 6u; // as bent, but ends at clip lines: tiles list it among bent ones

// Splats are listed by the bucket of their nearest depth.
const uint DepthBuckets = 1024u;
// An entry of a list: bucket, and record.
const uint RecordBits = 22u;

const uint TagBits = 0x7fffu;
const uint BothSides = 0x8000u;

// A sign, the exponent and 7 bits of the mantissa.
uint encodeLayer(float layer, bool edgeOn)
{
  return (floatBitsToUint(layer) + 0x8000u) >> 16 | (edgeOn ? 0x8000u : 0u);
}

float decodeLayer(uint code, out bool edgeOn)
{
  edgeOn = (code & 0x8000u) != 0u;
  return uintBitsToFloat((code & 0x7fffu) << 16);
}

uvec3 encodeTurns(vec3 first, vec3 second)
{
  return uvec3(packHalf2x16(first.xy), packHalf2x16(vec2(first.z, second.x)),
    packHalf2x16(second.yz));
}

void decodeTurns(uvec3 code, out vec3 first, out vec3 second)
{
  vec2 middle = unpackHalf2x16(code.y);
  first = vec3(unpackHalf2x16(code.x), middle.x);
  second = vec3(middle.y, unpackHalf2x16(code.z));
}
