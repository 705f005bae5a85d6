// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// What one layer is summed up to before it is texels (vtkPointSplatSums.glsl).
//   By the rasteriser, textures: coded depths R32UI; sums RGBA32F (weight, normal), RGBA32F (depth
//   behind the nearest, colour), R32F (opacity), RGBA32F (factors of lights); ids R32UI; and a
//   depth attachment, DEPTH_COMPONENT32F.
//   By compute shaders, buffers: coded depths R32UI; sums RGBA32I, one or two texels a pixel
//   (vtkPointSplatFixedPoint.glsl); ids R32UI.
#ifndef vtkPointSplatSums_h
#define vtkPointSplatSums_h

#include "vtkPointSplatBuffer.h"
#include "vtkPointSplatImage.h"

#include <string>

class vtkPointSplatProgram;
class vtkPointSplatUnits;

class vtkPointSplatSums
{
public:
  /// What a layer has.
  struct Content
  {
    glm::ivec2 Size{ 0, 0 };
    bool Colours = false;
    int Factors = 0; // of how many lights
    bool Ids = false;
  };

  void AllocateImages(const Content& content);
  void AllocateBuffers(const Content& content);
  /// Empties rows of the buffers.
  void ClearRows(int first, int last);

  const Content& GetContent() const { return this->Has; }
  bool AreBuffers() const { return this->Buffers; }
  int GetSumStride() const; // words a pixel
  /// Lines for programs that include vtkPointSplatSums.glsl, or write sums.
  std::string GetDefines() const;
  /// Binds what was drawn to a program in use.
  void Bind(vtkPointSplatUnits& units, vtkPointSplatProgram& program) const;
  vtkIdType GetMemorySize() const; // bytes
  void Release();

  vtkPointSplatImage Depths{ GL_R32UI };
  vtkPointSplatImage WeightAndNormal{ GL_RGBA32F };
  vtkPointSplatImage DepthAndColour{ GL_RGBA32F };
  vtkPointSplatImage Opacities{ GL_R32F };
  vtkPointSplatImage Factors{ GL_RGBA32F };
  vtkPointSplatImage Ids{ GL_R32UI };
  vtkPointSplatImage DepthTest{ GL_DEPTH_COMPONENT32F };
  vtkPointSplatBuffer DepthBuffer{ GL_R32UI };
  vtkPointSplatBuffer SumBuffer{ GL_RGBA32I };
  vtkPointSplatBuffer IdBuffer{ GL_R32UI };

private:
  Content Has;
  bool Buffers = false;
};

#endif
