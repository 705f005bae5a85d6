// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Reconstructs surface layers by tiles of the image, with compute shaders (OpenGL 4.3).
//
// 1. Project. Each splat is projected once, to a record from which its pixels are computed, and a
//    box (vtkPointSplatRecord.glsl).
//    So is each triangle that is drawn in the place of splats (vtkPointSplatTrianglesCS.glsl).
// 2. Bin. Each splat is listed in the tiles that its box touches, nearest first: by the processor,
//    where buffers are in main memory, or on the device.
// 3. Reconstruct. Each tile's list is walked, in registers: the nearest surface, then the sums over
//    what belongs to it (Zhang, Pajarola 2006, equation 1), then the next layer (Guennebaud,
//    Barthe, Paulin 2006, section 6; triangles weigh what splats leave of 1, section 5.1), until
//    nothing is left, or nothing that could change a pixel by the target. There are no atomic
//    operations a pixel. Tiles that the processor lists no splats for are visited by nobody: their texels are
//    emptied, and the layers are told where there are others.
// 4. Smooth outlines: what four samples of each pixel show that one runs through
//    (vtkPointSplatOutlines.h). By the processor's lists only what may hide samples of the pixel is
//    tried on them (vtkPointSplatPixelLists.h).
//
// Buffers: records, RGBA32UI, 5 texels a splat; boxes, RG32UI, 1, or for the processor's outlines 2;
// lists, R32UI, of tiles and of pixels with outlines; the table of either, RGBA32UI, 2 a list; the
// tiles' summaries, RGBA32UI, 1 a tile; beside the records colours, factors of lights and ids, R32UI,
// and clip lines, RGBA32F, where there are some. A splat is a record of 80 bytes and 8 or 16 of its
// box, so that who draws bounds how many are drawn at once (vtkPointSplatSelection.h).
#ifndef vtkPointSplatTiles_h
#define vtkPointSplatTiles_h

#include "vtkPointSplatDeviceLists.h"
#include "vtkPointSplatImage.h"
#include "vtkPointSplatItemTable.h"
#include "vtkPointSplatLayers.h"
#include "vtkPointSplatOutlines.h"
#include "vtkPointSplatPixelLists.h"
#include "vtkPointSplatProgram.h"
#include "vtkPointSplatRequest.h"
#include "vtkPointSplatTileLists.h"

#include <map>
#include <string>

class vtkPointSplatUnits;

class vtkPointSplatTiles
{
public:
  /// Splats that can be drawn at once: as many as an entry of a list can name.
  static constexpr vtkIdType Capacity = vtkIdType(1) << 22;

  /**
   * Made; failed, with GetError(); or not made since a part's splats touch too many tiles.
   */
  enum Result
  {
    Made,
    Failed,
    TooMany
  };

  /// Whether the context has what compute shaders need for images of this size.
  static bool IsSupported(const glm::ivec2& size);

  /// Makes the layers' texels within the parts' windows, and samples their outlines where the request
  /// says so.
  Result Reconstruct(const vtkPointSplatRequest& request,
    const std::vector<vtkPointSplatPart>& parts, vtkPointSplatLayers& layers,
    vtkPointSplatOutlines& outlines);

  const std::string& GetError() const { return this->Error; }
  vtkIdType GetMemorySize() const; // bytes
  void Release();

private:
  /// Which parts of the shaders a request needs.
  struct Variant
  {
    std::string Project;
    std::string Tile;  // without what only some tiles need
    std::string Lines; // where splats that are not flat or bent end at clip lines
    std::string Walk;  // of it what the search for the nearest hits needs
    glm::ivec2 TileSize{ 4, 4 };
    int Lanes = 1;
    size_t BoxWords = 2;
    bool ClipLines = false;
    bool Colours = false;
    int Factors = 0;
    int Looks = 0; // texels
    bool Coordinates = false;
    bool Tangents = false;
    bool Ids = false;
  };
  /// What is kept of each projected splat, in a buffer of its own.
  struct Share
  {
    bool IsWanted;
    vtkPointSplatBuffer* Buffer;
    GLuint Binding;
    GLsizeiptr Bytes; // a splat
  };
  std::vector<Share> SharesOf(const Variant& variant);
  static Variant VariantOf(const vtkPointSplatRequest& request);
  vtkPointSplatProgram* Use(std::map<std::string, vtkPointSplatProgram>& programs,
    const char* file, const std::string& defines);
  Result Prepare(
    const vtkPointSplatRequest& request, const vtkPointSplatPart& part, const Variant& variant);
  void Measure(const vtkPointSplatRequest& request, const vtkPointSplatPart& part);
  bool Project(
    const vtkPointSplatRequest& request, const vtkPointSplatPart& part, const Variant& variant);
  /// To records from this one on.
  bool ProjectTriangles(const vtkPointSplatRequest& request, const vtkPointSplatPart& part,
    const Variant& variant, vtkIdType first);
  void DispatchRecords(
    vtkPointSplatProgram& program, const Variant& variant, vtkIdType first, vtkIdType count);
  Result Bin(const Variant& variant);
  struct Shader
  {
    const char* File;
    std::string Defines;
    std::string Lines; // defines, where splats may end at clip lines
    bool Curved; // whether tiles may have triangles, and curved or clipped splats
  };
  /// The opaque scene's depth; where that is not asked for, of layers, a texture of the same kind: drivers for processors
  /// compile a program for each kind.
  GLuint GetSceneDepth(const vtkPointSplatRequest& request);
  /// One that walks over the lists.
  vtkPointSplatProgram* UseTiles(const vtkPointSplatRequest& request,
    const vtkPointSplatPart& part, vtkPointSplatUnits& units, const Shader& shader);
  /// Tiles of some rows: those without curved or clipped splats and triangles, then those with, in the table or on the device.
  struct Band
  {
    int Row;
    size_t First;
    size_t Plain;
    size_t Curved;
  };
  GLsizeiptr GetSummaryBytes() const
  {
    return 16 * static_cast<GLsizeiptr>(this->Grid.GetCount());
  }
  /// Tells the layers where tiles have splats, and empties the others, which no invocation visits.
  bool Leave(const vtkPointSplatRequest& request, const vtkPointSplatPart& part,
    const Variant& variant, vtkPointSplatLayers& layers);
  std::vector<Band> MakeBands(const Variant& variant, const vtkPointSplatLayers& layers);
  Result DrawLayers(const vtkPointSplatRequest& request, const vtkPointSplatPart& part,
    const Variant& variant, vtkPointSplatLayers& layers);
  /// Of pixels from the first one on, what of the processor's lists their samples are tried with, and
  /// the table of that. Returns where these pixels end; the first one: failed.
  size_t ListOutlines(
    const std::vector<uint32_t>& pixels, size_t first, const Variant& variant, int width);
  Result SampleOutlines(const vtkPointSplatRequest& request, const vtkPointSplatPart& part,
    const Variant& variant, const vtkPointSplatLayers& layers, vtkPointSplatOutlines& outlines);

  std::map<std::string, vtkPointSplatProgram> ProjectPrograms; // by defines
  std::map<std::string, vtkPointSplatProgram> TrianglePrograms;
  std::map<std::string, vtkPointSplatProgram> TilePrograms;
  vtkPointSplatItemTable Items;
  vtkPointSplatBuffer Records{ GL_RGBA32UI };
  vtkPointSplatBuffer Boxes{ GL_RG32UI };
  vtkPointSplatBuffer ClipLines{ GL_RGBA32F };
  vtkPointSplatBuffer Colours{ GL_R32UI };
  vtkPointSplatBuffer Factors{ GL_R32UI };
  vtkPointSplatBuffer Coordinates{ GL_RGBA32UI };
  vtkPointSplatBuffer Tangents{ GL_R32UI };
  vtkPointSplatBuffer Ids{ GL_R32UI };
  vtkPointSplatBuffer Blocks;
  vtkPointSplatBuffer Lists{ GL_R32UI };
  vtkPointSplatBuffer OutlineLists{ GL_R32UI };
  vtkPointSplatBuffer Table{ GL_RGBA32UI };
  vtkPointSplatBuffer Summaries{ GL_RGBA32UI };
  vtkPointSplatBuffer Counts;
  vtkPointSplatImage NoDepth{ GL_DEPTH_COMPONENT24 };
  vtkPointSplatTileLists HostLists;
  vtkPointSplatPixelLists HostOutlineLists;
  vtkPointSplatDeviceLists DeviceLists;
  vtkPointSplatTileGrid Grid;
  vtkIdType Splats = 0; // records
  glm::vec2 BucketScale{ 0.0f };
  float DepthReach = 0.0f;
  bool Curved = false;       // some tiles have curved or clipped splats or triangles ...
  bool CurvedSplats = false; // ... or the former
  bool HasTriangles = false;
  std::string Error;
};

#endif
