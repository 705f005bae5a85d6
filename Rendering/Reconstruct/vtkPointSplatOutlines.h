// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The pixels that outlines run through, and what four samples of each show: so outlines are as
// smooth as a multisampled mesh's, at the cost of these pixels alone.
//
// 1. Find. Of tiles whose summaries are known those are listed through which an outline may run
//    (vtkPointSplatOutlineTilesCS.glsl). In these, or in all, a compute shader compares the layers of each
//    pixel with those beside it (vtkPointSplatOutlineCS.glsl), lists the pixels in which one surface ends
//    before another, and flags their texels.
// 2. Choose. The lists of their tiles are walked for the nearest hits of four samples, half a pixel
//    apart (vtkPointSplatOutlineSamplesCS.glsl). Each takes after that of the pixels about it which
//    shows the same surface: surfaces do not change within a pixel, but end there.
// 3. Present. What is shown is the mean of the pixels that the samples take after
//    (vtkPointSplatOutlineMeans.h); in multisampled framebuffers each of their samples gets one of
//    them (vtkPointSplatOutline.glsl).
//
// Buffers: the pixels, R32UI, y times the images' width plus x, and in the upper 4 bits the first
// layer that ends there, in no order; their choices, R32UI, two bits a sample; and of each such pixel
// of the image its index among them, R32UI.
#ifndef vtkPointSplatOutlines_h
#define vtkPointSplatOutlines_h

#include "vtkPointSplatBuffer.h"
#include "vtkPointSplatProgram.h"

#include <map>
#include <string>
#include <vector>

class vtkPointSplatLayers;
class vtkPointSplatUnits;

class vtkPointSplatOutlines
{
public:
  /// Forgets all.
  void Clear() { this->Count = 0; }

  /**
   * Where to look.
   */
  struct Search
  {
    glm::ivec4 Window;      // first pixel's x, y, last one's
    glm::ivec2 TileSize;    // pixels
    int TilesAcross;        // of the image
    GLuint Items;           // vtkPointSplatItemTable
    GLuint Summaries;       // of the tiles (vtkPointSplatTileSummary.glsl), or 0
  };

  /**
   * Finds and flags those in a window; they are appended to what was found before, with no choices
   * yet. False, with GetError(), where the shader does not build.
   */
  bool Find(const vtkPointSplatLayers& layers, const Search& search);

  int GetCount() const { return this->Count; }
  /// The pixels from a number on, without their layers.
  std::vector<uint32_t> DownloadPixels(int first) const;
  vtkPointSplatBuffer& GetChoices() { return this->Choices; }
  /// Binds all of these to a program in use.
  void Bind(vtkPointSplatUnits& units, vtkPointSplatProgram& program) const;

  vtkIdType GetMemorySize() const
  {
    return this->Pixels.GetSize() + this->Choices.GetSize() + this->Indices.GetSize() + this->Tiles.GetSize();
  }
  const std::string& GetError() const { return this->Error; }
  void Release();

private:
  /// Null, with GetError(), where the shader does not build.
  vtkPointSplatProgram* Use(const char* file, const std::string& defines);
  /// Lists and counts those of tiles (first x, y, last x, y) that an outline may run through. size: defines.
  bool ListTiles(
    const Search& search, const std::string& size, const glm::ivec4& tiles, GLuint& listed);

  vtkPointSplatBuffer Pixels{ GL_R32UI };
  vtkPointSplatBuffer Choices{ GL_R32UI };
  vtkPointSplatBuffer Indices{ GL_R32UI };
  vtkPointSplatBuffer Counter;
  vtkPointSplatBuffer Tiles{ GL_R32UI };
  vtkPointSplatBuffer TileCounter;
  std::map<std::string, vtkPointSplatProgram> Programs; // by files and defines
  int Count = 0;
  glm::ivec2 Size = glm::ivec2(0); // of the images
  std::string Error;
};

#endif
