// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where a tile's lists are, and the walk over them that finds the nearest hits.

#if LANES > 1
uniform usamplerBuffer Tiles; // R32UI, where each kind of each tile begins in the lists
#else
uniform usamplerBuffer Tiles; // RGBA32UI, two a tile: where its kinds begin in the lists, and it
#endif
uniform int TilesInAll;
uniform int TilesAcross;
#ifdef LAYERS
uniform bool HasSceneDepth;
uniform sampler2D SceneDepth; // of the opaque scene, as OpenGL has it
uniform vec4 PixelZ;          // view coordinates to z w

// Where the opaque scene hides a pixel.
float sceneDepthAt(ivec2 pixel)
{
  float ndc = 2.0 * texelFetch(SceneDepth, pixel, 0).r - 1.0;
  // (PixelZ.z z + PixelZ.w) / (PixelW.z z + PixelW.w) = ndc
  float z = (ndc * PixelW.w - PixelZ.w) / (PixelZ.z - ndc * PixelW.z);
  return ndc < 1.0 ? -z - DepthRange.x : NoHit;
}
#endif

// Where each kind of splat begins in the lists, and where the last ones end.
struct Span
{
  int flats;
  int bents;
  int curveds;
  int end;
  int wides;
  int wideEnd;
#ifdef TRIANGLES
  int triangles; // where curved ones end
#endif
  int tile;
};

// False: the table has no such tile, but whole work groups.
bool spanOf(int index, out Span s)
{
#if LANES > 1
  // As vtkPointSplatBinCS counts: some kinds a tile, then blocks of 16 x 16 tiles.
#ifdef TRIANGLES
  const int kinds = 4;
#else
  const int kinds = 3;
#endif
  int blocksAcross = (TilesAcross + 15) >> 4;
  int wide = kinds * TilesInAll + (index / TilesAcross >> 4) * blocksAcross +
    (index % TilesAcross >> 4);
  int first = kinds * index;
  s = Span(int(texelFetch(Tiles, first).r), int(texelFetch(Tiles, first + 1).r),
    int(texelFetch(Tiles, first + 2).r), int(texelFetch(Tiles, first + kinds).r),
    int(texelFetch(Tiles, wide).r), int(texelFetch(Tiles, wide + 1).r),
#ifdef TRIANGLES
    int(texelFetch(Tiles, first + 3).r),
#endif
    index);
  return true;
#else
  uvec4 begins = texelFetch(Tiles, 2 * index);
  uvec4 ends = texelFetch(Tiles, 2 * index + 1);
  s = Span(int(begins.x), int(begins.y), int(begins.z), int(ends.x), int(ends.y), int(ends.z),
#ifdef TRIANGLES
    int(ends.w) - 1,
#endif
    int(begins.w));
  return ends.w != 0u;
#endif
}

int curvedEnd(Span s)
{
#ifdef TRIANGLES
  return s.triangles;
#else
  return s.end;
#endif
}

void see(inout Span s, Span all)
{
#ifdef TRIANGLES
  // What is magnified is near, and hides most of what is not.
  seeTriangles(s.triangles, all.end);
#endif
  seeFlat(s.flats, all.bents);
  seeBent(s.bents, all.curveds);
#ifdef CURVED
  seeCurved(s.curveds, curvedEnd(all), s.wides, all.wideEnd);
#endif
}
