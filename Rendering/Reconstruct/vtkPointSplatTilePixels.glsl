// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The pixels of a tile that an invocation has in its registers: the nearest hit of the layer that
// is made, the sums of what belongs to it, and what was made before. Loops over Pixels are unrolled
// by the compiler, so that arrays are registers.
//
// LANES invocations share a tile of TILE_WIDTH x TILE_HEIGHT pixels. On CPUs one has all of it:
// what costs there is to load a splat, not to try it on a pixel. With SAMPLES a tile is the four
// samples of a pixel that an outline runs through.

#include "vtkPointSplatRecord"
#include "vtkPointSplatKernel"
#include "vtkPointSplatItemTable"
#include "vtkPointSplatTexel"
#ifdef CLIP_LINES
#include "vtkPointSplatClipLines"
#endif

const int Pixels = TILE_WIDTH * TILE_HEIGHT / LANES;

uniform usamplerBuffer Records; // RGBA32UI, see vtkPointSplatRecord
uniform usamplerBuffer Lists;   // R32UI
uniform vec2 BucketScale;       // a depth's bucket: (depth - x) y
uniform float DiskReach;        // radii that show where the surface is
uniform float PrefilterRadius;  // pixels
uniform vec4 Kernel;            // of all clouds, but for KERNELS, where they differ
uniform float DepthReach;       // from a splat's nearest depth to its farthest, at most
uniform float DepthUnit;        // five times the largest least layer distance, world units
#if defined(VALUES) || defined(CELL_COLOURS)
#include "vtkPointSplatValue"
#endif
#ifdef CLIP_LINES
uniform samplerBuffer RecordClipLines;
#endif
#ifdef COLOURS
uniform usamplerBuffer RecordColours;
#endif
#ifdef FACTORS
uniform usamplerBuffer RecordFactors;
#endif
#ifdef IDS
uniform usamplerBuffer RecordIds;
#endif

// Where nothing was hit. What is nearer than that is not.
const float NoHit = 3e38;
const uint NoTag = 0xffffu;
// Sums are of whole numbers, below 2^24, so that they are the same in whatever order splats come.
const float WeightScale = 4096.0;
const float DepthScale = 512.0;

vec2 corner = vec2(0.0); // the middle of the tile's first pixel
float nearest[Pixels];   // depth of the nearest hit; at first what hides it
uint tags[Pixels];
float weights[Pixels];
vec3 normals[Pixels];
float behinds[Pixels];
#ifdef COLOURS
vec4 colours[Pixels];
#endif
#ifdef FACTORS
#if FACTORS > 1
#define LightFactors vec4
#else
#define LightFactors float
#endif
LightFactors factors[Pixels];
#endif
#ifdef LOOKS
#include "vtkPointSplatLook"
#include "vtkPointSplatTileLooks"
#endif
#if defined(IDS) || defined(CELL_COLOURS) || defined(FACETS)
#define GREATEST
float greatest[Pixels]; // kernel, and who has it: the id, or the colour
#endif
#if defined(IDS) || defined(CELL_COLOURS)
uint ids[Pixels];
#endif
#ifdef LAYERS
// Of the layers before, the last one first.
vec3 before[Pixels];
uvec3 beforeTags[Pixels];
float light[Pixels]; // what of the light behind comes through them
bool gathering = false; // this layer takes all that is left ...
#ifdef GATHER
float hidden[Pixels];   // ... before the opaque scene
#endif
float peeledTo = -1.0;  // all that lies before this depth is
#endif

// Before a pixel is looked at; farthest: what hides it.
void startPixel(int k, float farthest)
{
  nearest[k] = farthest;
  tags[k] = NoTag;
}

ivec2 placeOf(int k)
{
  int pixel = k * LANES + int(gl_LocalInvocationIndex) % LANES;
  return ivec2(pixel % TILE_WIDTH, pixel / TILE_WIDTH);
}

// From the corner to a pixel, or to a sample: no two of these are in one row or column, as those of
// OpenGL's multisampled framebuffers.
vec2 offsetOf(int k)
{
#ifdef SAMPLES
  vec2 place = vec2(placeOf(k));
  return mat2(0.5, 0.25, -0.25, 0.5) * place - vec2(0.125, 0.375);
#else
  return vec2(placeOf(k));
#endif
}

// What the loops over splats need of each.
struct Head
{
  vec2 from;   // the corner from the centre
  float depth; // of the centre
  uint tag;
  uint sides;  // tags whose bits differ by less than this belong to one layer
  float layer; // least layer distance along the ray
  bool edgeOn;
};

Head headOf(uvec4 texel)
{
  bool edgeOn;
  float layer = decodeLayer(texel.w >> 16, edgeOn);
  return Head(corner - uintBitsToFloat(texel.xy), uintBitsToFloat(texel.z), texel.w & TagBits,
    (texel.w & BothSides) != 0u ? 2u : 1u, layer, edgeOn);
}

int recordOf(uint entry)
{
  return int(entry & ((1u << RecordBits) - 1u));
}

// All that a listed splat, and those listed after it, reach lies behind this depth.
float leastDepth(uint entry)
{
  return BucketScale.x + float(entry >> RecordBits) / BucketScale.y;
}

// Skips what was peeled off with the layers before, for good.
void skipPeeled(inout int begin, int end)
{
#ifdef LAYERS
  while (begin < end && leastDepth(texelFetch(Lists, begin).r) + DepthReach < peeledTo)
  {
    ++begin;
  }
#endif
}

float farthestHit()
{
  float most = nearest[0];
  for (int k = 1; k < Pixels; ++k)
  {
    most = max(most, nearest[k]);
  }
  return most;
}

// Depths up to which hits may belong to the layer.
float layerEnd()
{
  float most = -1.0;
  for (int k = 0; k < Pixels; ++k)
  {
#ifdef GATHER
    float end = gathering ? hidden[k] : nearest[k] + DepthUnit;
#else
    float end = nearest[k] + DepthUnit;
#endif
    most = max(most, tags[k] == NoTag ? -1.0 : end);
  }
  return most;
}

// Whether a hit belongs to the layer of a depth and a tag: the same cloud, no farther than the
// least layer distance. Splats seen flat must show the same side, since behind a silhouette lies
// the far side of the same body, close by and lit otherwise. Others need not: normals that are not
// consistently oriented are turned.
bool sameLayer(Head h, float depth, float otherDepth, uint otherTag)
{
  return (h.tag ^ otherTag) < h.sides && abs(depth - otherDepth) <= h.layer;
}

#ifdef LAYERS
// Whether a hit was drawn with the layers before: it is before the last one, or belongs to one of
// the last three. Surfaces that run closer together than the least layer distance take turns.
bool isPeeled(int k, Head h, float depth)
{
  vec3 b = before[k];
  uvec3 t = beforeTags[k];
  return depth < b.x || (depth == b.x && h.tag <= t.x) || sameLayer(h, depth, b.x, t.x) ||
    sameLayer(h, depth, b.y, t.y) || sameLayer(h, depth, b.z, t.z);
}
#endif

void keepNearest(int k, Head h, bool hit, float depth)
{
#ifdef LAYERS
  hit = hit && !isPeeled(k, h, depth);
#endif
  bool nearer = hit && (depth < nearest[k] || (depth == nearest[k] && h.tag < tags[k]));
  nearest[k] = nearer ? depth : nearest[k];
  tags[k] = nearer ? h.tag : tags[k];
}

// What a splat adds beside its normal and depth, and where it ends.
struct Paint
{
  vec4 kernel;
#ifdef CLIP_LINES
  ClipLines lines; // of caps
#endif
#ifdef COLOURS
  vec4 colour;
#endif
#ifdef VALUES
  bool isValue; // which colour has, and whether it is known
#endif
#ifdef FACTORS
  LightFactors factors;
#endif
#if defined(IDS) || defined(CELL_COLOURS)
  uint id;
#endif
#ifdef FACETS
  bool isFacet; // of one tone, by the normal of its centre, which is set by who knows it
  vec3 facet;
#endif
#ifdef LOOKS
  SplatLook look; // prepared by who knows the splat's form
#endif
};

Paint paintOf(int record, uint tag)
{
  Paint p;
#ifdef KERNELS
  p.kernel = itemKernel(tag);
#else
  p.kernel = Kernel;
#endif
#ifdef COLOURS
  uint code = texelFetch(RecordColours, record).r;
  p.colour = unpackColour(code);
#ifdef VALUES
  vec4 map = itemValueMap(tag);
  vec2 value = decodeValue(code);
  p.isValue = hasValues(map);
#ifdef GATHER
  // What is gathered is of several clouds.
  p.colour = p.isValue && gathering ? mapValue(value, map) : p.colour;
  p.isValue = p.isValue && !gathering;
#endif
  p.colour = p.isValue ? vec4(value, 0.0, 0.0) : p.colour;
#endif
#ifdef CELL_COLOURS
  p.id = code;
#endif
#ifdef GATHER
  p.colour *= gathering ? itemColour(tag) : vec4(1.0);
#endif
#endif
#ifdef FACTORS
  p.factors = LightFactors(unpackColour(texelFetch(RecordFactors, record).r));
#endif
#ifdef IDS
  p.id = texelFetch(RecordIds, record).r;
#endif
#ifdef FACETS
  p.isFacet = itemIsFlat(tag);
#ifdef GATHER
  p.isFacet = p.isFacet && !gathering;
#endif
#endif
#ifdef LOOKS
  p.look = lookOf(record, tag);
#endif
  return p;
}

// share: what of the kernel there is where the pixel's ray meets the splat, 0 where that is cut
// away; r2: the kernel's squared distance; normal: of about unit length.
void addToLayer(int k, Head h, Paint p, float share, float r2, float depth, vec3 normal)
{
  uint different = h.tag ^ tags[k];
  float behind = depth - nearest[k];
  bool mine = share > 0.0 && r2 <= p.kernel.z * p.kernel.z;
#ifdef LAYERS
  bool own = different < h.sides && abs(behind) <= h.layer;
#ifdef GATHER
  own = own || (gathering && tags[k] != NoTag && depth < hidden[k]);
#endif
  mine = mine && own && !isPeeled(k, h, depth);
#else
  mine = mine && different < h.sides && abs(behind) <= h.layer;
#endif
  float kernel = share * kernelWeight(min(r2, p.kernel.z * p.kernel.z), p.kernel);
#ifdef GATHER
  kernel *= gathering ? p.colour.a : layerShare(behind, h.layer, h.edgeOn);
#else
  kernel *= layerShare(behind, h.layer, h.edgeOn);
#endif
  float weight = mine ? max(round(WeightScale * kernel), 1.0) : 0.0;
  // Turned to the side that the nearest splat shows: with those of a thin wall's far side, or that
  // point the wrong way, the sum would cancel.
  float turned = (different & 1u) != 0u ? -weight : weight;
#ifdef GREATEST
  bool names = mine && kernel > greatest[k];
  greatest[k] = names ? kernel : greatest[k];
#endif
  weights[k] += weight;
#ifdef FACETS
  vec3 facet = names ? sign(turned) * p.facet : normals[k];
  normals[k] = p.isFacet ? facet : normals[k] + round(turned * normal);
#else
  normals[k] += round(turned * normal);
#endif
#ifdef LOOKS
  addLook(k, p.look, weight);
#endif
  behinds[k] += round(weight * (mine ? behind : 0.0) * (DepthScale / DepthUnit));
#ifdef COLOURS
#ifdef VALUES
  colours[k] += p.isValue ? weightedValue(weight, p.colour.xy) : round(weight * p.colour);
#else
  colours[k] += round(weight * p.colour);
#endif
#endif
#ifdef FACTORS
  factors[k] += round(weight * p.factors);
#endif
#if defined(IDS) || defined(CELL_COLOURS)
  // Of equal ones the first in the list, which is the same splat whatever kind of id is wanted: a
  // selection asks for a block and for a point in it one after the other.
  ids[k] = names ? p.id : ids[k];
#endif
}

void clearLayer()
{
  for (int k = 0; k < Pixels; ++k)
  {
    weights[k] = 0.0;
    normals[k] = vec3(0.0);
    behinds[k] = 0.0;
#ifdef COLOURS
    colours[k] = vec4(0.0);
#endif
#ifdef FACTORS
    factors[k] = LightFactors(0.0);
#endif
#ifdef GREATEST
    greatest[k] = -1.0;
#endif
#if defined(IDS) || defined(CELL_COLOURS)
    ids[k] = 0xffffffffu;
#endif
#ifdef LOOKS
    clearLooks(k);
#endif
  }
}
