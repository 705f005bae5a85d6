// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// A texture of one level that is read texel by texel: two-dimensional, or an array of such. It may be a texel wider and
// higher than it is said to be.
#ifndef vtkPointSplatImage_h
#define vtkPointSplatImage_h

#include "vtkPointSplatHandle.h"

#include <glm/glm.hpp>

#include "vtkType.h"

class vtkPointSplatImage
{
public:
  /// internal: GL_RGBA32UI and the like. layers: of an array, or 0.
  explicit vtkPointSplatImage(GLenum internal)
    : Internal(internal)
  {
  }

  /// Makes it of this size, unless it is. True if it was made.
  bool Allocate(const glm::ivec2& size, int layers = 0);
  /// The same, of another format.
  bool Allocate(GLenum internal, const glm::ivec2& size);
  GLuint Get() const { return this->Name.Get(); }
  GLenum GetTarget() const { return this->Layers > 0 ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D; }
  const glm::ivec2& GetSize() const { return this->Size; }
  int GetLayers() const { return this->Layers; }
  vtkIdType GetMemorySize() const; // bytes
  void Release();

private:
  GLenum Internal;
  glm::ivec2 Size{ 0, 0 };
  int Layers = 0;
  vtkPointSplatHandle Name{ vtkPointSplatHandle::Texture };
};

#endif
