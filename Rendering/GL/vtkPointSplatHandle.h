// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The name of an OpenGL object, which is deleted with the handle: at once where its context is
// current, else when that is entered the next time (vtkPointSplatContext.h).
#ifndef vtkPointSplatHandle_h
#define vtkPointSplatHandle_h

#include "vtkPointSplatContext.h"

class vtkPointSplatHandle
{
public:
  enum KindType
  {
    Buffer,
    Texture,
    Framebuffer,
    VertexArray,
    Sampler,
    Query
  };

  explicit vtkPointSplatHandle(KindType kind)
    : Kind(kind)
  {
  }
  ~vtkPointSplatHandle() { this->Release(); }
  vtkPointSplatHandle(vtkPointSplatHandle&& other) noexcept;
  vtkPointSplatHandle& operator=(vtkPointSplatHandle&& other) noexcept;
  vtkPointSplatHandle(const vtkPointSplatHandle&) = delete;
  void operator=(const vtkPointSplatHandle&) = delete;

  /// Makes the object, unless the entered context has it. True if it was made.
  bool Make();
  void Release();
  GLuint Get() const { return this->Name; }
  /// Whether the entered context has the object.
  bool IsMade() const
  {
    return this->Name != 0 && this->Context == vtkPointSplatContext::Entered();
  }

private:
  KindType Kind;
  GLuint Name = 0;
  vtkPointSplatContext Context;
};

#endif
