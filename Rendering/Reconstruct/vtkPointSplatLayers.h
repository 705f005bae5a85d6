// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The surface layers of a frame, nearest first: what all ways to reconstruct them write, and all
// that follows reads. A layer has a texel a pixel (RGBA32UI, vtkPointSplatTexel.glsl); where lights
// cast shadows beside it the factors of up to four of them (R32UI); where some actor has textures
// or edges one or two of its look (RGBA32UI, vtkPointSplatLook.glsl), in buffers only; the first layer,
// for hardware selection, the ids of the splats of the greatest weight (R32UI). A pixel's layers end
// with the first that is empty there.
//
// Rectangles tell where there may be any layers (RGBA32I, first pixel's x, y, last one's); beside them
// all is empty, and need not be presented.
//
// Compute shaders write buffers, which have all layers of a row of pixels side by side, so that
// some rows can be bound where a driver bounds storage blocks; the rasteriser writes array textures.
// vtkPointSplatLayers.glsl reads either.
#ifndef vtkPointSplatLayers_h
#define vtkPointSplatLayers_h

#include "vtkPointSplatBuffer.h"
#include "vtkPointSplatImage.h"

#include <string>
#include <vector>

class vtkPointSplatProgram;
class vtkPointSplatUnits;

class vtkPointSplatLayers
{
public:
  ///@{
  /**
   * Room for so many layers; what was in them is lost if there was less, or of another kind.
   * factors: of how many lights; looks: their texels; ids: whether there are some.
   */
  void AllocateBuffers(const glm::ivec2& size, int layers, int factors, int looks, bool ids);
  void AllocateImages(const glm::ivec2& size, int layers, int factors, bool ids);
  ///@}
  static vtkIdType BytesPerLayer(const glm::ivec2& size, int factors, int looks)
  {
    return static_cast<vtkIdType>(size.x) * size.y * (16 + (factors > 0 ? 4 : 0) + 16 * looks);
  }

  ///@{ How many layers there are; the last one that gathers what is behind the others, or -1.
  void SetNumberOfLayers(int count) { this->Count = count; }
  int GetNumberOfLayers() const { return this->Count; }
  void SetGathered(int layer) { this->Gathered = layer; }
  int GetGathered() const { return this->Gathered; }
  ///@}

  ///@{
  /**
   * The rectangles outside which all is empty: pixels, apart from one another. Those that were known
   * are forgotten when room is made.
   */
  void AddCovered(const std::vector<glm::ivec4>& rectangles);
  int GetNumberOfRectangles() const { return static_cast<int>(this->Covered.size()); }
  ///@}

  /**
   * Empties so many layers of pixels in rectangles, of buffers that the processor may write to. False
   * where it cannot.
   */
  bool Clear(const std::vector<glm::ivec4>& rectangles, int layers);

  bool AreBuffers() const { return this->Buffers; }
  int GetCapacity() const { return this->Capacity; }
  int GetFactorCount() const { return this->Factors; }
  int GetLookTexels() const { return this->Looks; }
  const glm::ivec2& GetSize() const { return this->Size; }

  ///@{
  /**
   * Of buffers: how many rows of pixels are bound at once, and to bind those from a row on, a
   * multiple of that, as storage 0, 1, 2 and 5: texels, factors, ids, looks.
   */
  int GetRowsPerBand() const;
  void BindRows(int row) const;
  ///@}
  vtkIdType GetMemorySize() const; // bytes

  ///@{ What is written to, of images.
  vtkPointSplatImage& GetTexelImage() { return this->TexelImage; }
  vtkPointSplatImage& GetFactorImage() { return this->FactorImage; }
  vtkPointSplatImage& GetIdImage() { return this->IdImage; }
  ///@}

  /// Lines for programs that include vtkPointSplatLayers.glsl.
  std::string GetDefines() const;
  /// Binds the layers to a program in use.
  void Bind(vtkPointSplatUnits& units, vtkPointSplatProgram& program) const;

  void Release();

private:
  bool Buffers = true;
  glm::ivec2 Size{ 0, 0 };
  int Capacity = 0;
  int Count = 0;
  int Gathered = -1;
  int Factors = 0;
  int Looks = 0;
  bool Ids = false;
  std::vector<glm::ivec4> Covered;
  vtkPointSplatBuffer TexelBuffer{ GL_RGBA32UI };
  vtkPointSplatBuffer FactorBuffer{ GL_R32UI };
  vtkPointSplatBuffer LookBuffer{ GL_RGBA32UI };
  vtkPointSplatBuffer IdBuffer{ GL_R32UI };
  vtkPointSplatBuffer Rectangles{ GL_RGBA32I };
  vtkPointSplatImage TexelImage{ GL_RGBA32UI };
  vtkPointSplatImage FactorImage{ GL_R32UI };
  vtkPointSplatImage IdImage{ GL_R32UI };
};

#endif
