// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The loops over a tile's triangles (vtkPointSplatRecord). In a layer they weigh what the sum of the
// splats' weights leaves of 1 (Guennebaud, Barthe, Paulin 2006, section 5.1, step 4): at the rim of
// what is drawn as splats this sum falls from more than 1 to 0, so that splats go over into
// triangles. Of several triangles of a layer, as at edges that they share, the mean is taken.

// Pixels by which edges are moved outward, so that rounding leaves no gap between triangles.
const float EdgeSlack = 1.0 / 512.0;

struct Face
{
  vec3 alongX; // changes of the homogeneous barycentric coordinates
  vec3 alongY;
  vec3 slack;
  vec3 depths; // of the corners, less corner 0's
};

Face faceOf(uvec4 r1, uvec4 r2)
{
  vec4 others = uintBitsToFloat(r1);
  vec4 first = uintBitsToFloat(r2);
  vec3 alongX = vec3(first.x, others.xz);
  vec3 alongY = vec3(first.y, others.yw);
  return Face(
    alongX, alongY, EdgeSlack * (abs(alongX) + abs(alongY)), vec3(0.0, first.zw));
}

// d: from corner 0's image to a pixel. shares: the barycentric coordinates, whose sum is 1.
bool meetFace(Face f, vec2 d, out vec3 shares)
{
  vec3 a = vec3(1.0, 0.0, 0.0) + d.x * f.alongX + d.y * f.alongY;
  bool met = all(greaterThanEqual(a, -f.slack));
  a = max(a, vec3(0.0));
  shares = a / max(a.x + a.y + a.z, 1e-30);
  return met;
}

void seeTriangles(inout int begin, int end)
{
  skipPeeled(begin, end);
  int i = begin;
  if (i >= end)
  {
    return;
  }
  do
  {
    uint entry = texelFetch(Lists, i).r;
    if (leastDepth(entry) > farthestHit())
    {
      break;
    }
    int at = recordOf(entry) * RecordTexels;
    Head h = headOf(texelFetch(Records, at));
    Face face = faceOf(texelFetch(Records, at + 1), texelFetch(Records, at + 2));
    cutRays(h.tag);
    for (int k = 0; k < Pixels; ++k)
    {
      vec3 shares;
      bool met = meetFace(face, h.from + offsetOf(k), shares);
      float depth = h.depth + dot(shares, face.depths);
      keepNearest(k, h, met && isWithin(k, depth), depth);
    }
    ++i;
  } while (i < end);
}

#ifndef SAMPLES
#ifdef COLOURS
vec4 cornerColour(uint code, Paint p)
{
#ifdef VALUES
  return p.isValue ? vec4(decodeValue(code), 0.0, 0.0) : unpackColour(code);
#else
  return unpackColour(code);
#endif
}
#endif

void addTriangles(int i, int end, float layerEnd)
{
  if (i >= end)
  {
    return;
  }
  float room[Pixels];
  for (int k = 0; k < Pixels; ++k)
  {
    room[k] = 1.0 - min(weights[k] / WeightScale, 1.0);
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
    Face face = faceOf(texelFetch(Records, at + 1), texelFetch(Records, at + 2));
    uvec4 codes = texelFetch(Records, at + 3);
    mat3 cornerNormals =
      mat3(decodeNormal(codes.x), decodeNormal(codes.y), decodeNormal(codes.z));
    Paint p = paintOf(record, h.tag);
#if defined(COLOURS) || defined(FACTORS) || defined(IDS)
    uvec4 beside = texelFetch(Records, at + 4);
#endif
#ifdef COLOURS
    mat3x4 cornerColours =
      mat3x4(p.colour, cornerColour(beside.x, p), cornerColour(beside.y, p));
#endif
#ifdef FACTORS
    LightFactors factor0 = p.factors;
    LightFactors factor1 = LightFactors(unpackColour(beside.z));
    LightFactors factor2 = LightFactors(unpackColour(beside.w));
#endif
#ifdef IDS
    uint id0 = p.id;
#endif
#ifdef FACETS
    p.facet = decodeNormal(codes.w);
#endif
    cutRays(h.tag);
    for (int k = 0; k < Pixels; ++k)
    {
      vec3 shares;
      bool met = meetFace(face, h.from + offsetOf(k), shares);
      float depth = h.depth + dot(shares, face.depths);
      vec3 normal = cornerNormals * shares;
#ifdef COLOURS
      p.colour = cornerColours * shares;
#endif
#ifdef FACTORS
      p.factors = shares.x * factor0 + shares.y * factor1 + shares.z * factor2;
#endif
#ifdef IDS
      p.id = shares.y > shares.x && shares.y >= shares.z ? beside.z
        : shares.z > shares.x                            ? beside.w
                                                         : id0;
#endif
      float share = met && isWithin(k, depth) ? room[k] : 0.0;
      addToLayer(k, h, p, share, 0.0, depth, normal);
    }
    ++i;
  } while (i < end);
}
#endif
