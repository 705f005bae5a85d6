// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatImage.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkTextureUnitManager.h"

#include <algorithm>

namespace
{
struct Format
{
  GLenum Internal;
  GLenum External;
  GLenum Type;
  int Bytes;
};

constexpr Format Formats[] = { { GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT, 16 },
  { GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT, 8 },
  { GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, 4 }, { GL_RGBA32F, GL_RGBA, GL_FLOAT, 16 },
  { GL_RGBA16F, GL_RGBA, GL_FLOAT, 8 }, { GL_R32F, GL_RED, GL_FLOAT, 4 },
  { GL_RG16F, GL_RG, GL_FLOAT, 4 }, { GL_R16F, GL_RED, GL_FLOAT, 2 },
  { GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, 4 },
  { GL_DEPTH_COMPONENT32, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, 4 },
  { GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, 4 },
  { GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, 2 },
  { GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, 4 },
  { GL_DEPTH32F_STENCIL8, GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV, 8 } };

const Format& Find(GLenum internal)
{
  for (const Format& format : Formats)
  {
    if (format.Internal == internal)
    {
      return format;
    }
  }
  return Formats[0];
}

/// Drivers for processors compile a program for each combination of its textures whose sizes are powers of two, and of
/// others: no image has such a size.
int NoPowerOfTwo(int size)
{
  return (size & (size - 1)) == 0 ? std::max(size + 1, 3) : size;
}
}

//------------------------------------------------------------------------------
bool vtkPointSplatImage::Allocate(GLenum internal, const glm::ivec2& size)
{
  if (internal != this->Internal)
  {
    this->Release();
    this->Internal = internal;
  }
  return this->Allocate(size);
}

//------------------------------------------------------------------------------
bool vtkPointSplatImage::Allocate(const glm::ivec2& size, int layers)
{
  if (this->Name.IsMade() && this->Size == size && this->Layers == layers)
  {
    return false;
  }
  this->Release();
  this->Name.Make();
  this->Size = size;
  this->Layers = layers;
  const Format& format = Find(this->Internal);
  // On a unit of its own: render passes have textures bound while mappers draw.
  vtkOpenGLRenderWindow* window = vtkPointSplatContext::Entered().GetWindow();
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglActiveTexture active(state);
  const int unit = window->GetTextureUnitManager()->Allocate();
  state->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned int>(unit));
  const GLenum target = this->GetTarget();
  const GLint internal = static_cast<GLint>(this->Internal);
  glBindTexture(target, this->Name.Get());
  const glm::ivec2 room(NoPowerOfTwo(size.x), NoPowerOfTwo(size.y));
  if (layers > 0)
  {
    glTexImage3D(
      target, 0, internal, room.x, room.y, layers, 0, format.External, format.Type, nullptr);
  }
  else
  {
    glTexImage2D(target, 0, internal, room.x, room.y, 0, format.External, format.Type, nullptr);
  }
  glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(target, GL_TEXTURE_MAX_LEVEL, 0);
  glBindTexture(target, 0);
  window->GetTextureUnitManager()->Free(unit);
  return true;
}

//------------------------------------------------------------------------------
vtkIdType vtkPointSplatImage::GetMemorySize() const
{
  return static_cast<vtkIdType>(Find(this->Internal).Bytes) * this->Size.x * this->Size.y *
    (this->Layers > 0 ? this->Layers : 1);
}

//------------------------------------------------------------------------------
void vtkPointSplatImage::Release()
{
  this->Name.Release();
  this->Size = glm::ivec2(0);
  this->Layers = 0;
}
