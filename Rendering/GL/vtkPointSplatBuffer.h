// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// A buffer object that grows as it is needed, and the texture by which shaders read it.
#ifndef vtkPointSplatBuffer_h
#define vtkPointSplatBuffer_h

#include "vtkPointSplatHandle.h"

#include <vector>

class vtkPointSplatBuffer
{
public:
  /// format: of the texels as which shaders read it, or 0.
  explicit vtkPointSplatBuffer(GLenum format = 0)
    : Format(format)
  {
  }

  /// Room for so many bytes. True where it was made anew: then nothing is in it.
  bool Reserve(GLsizeiptr bytes);
  /// Puts data in, and no more.
  void Upload(const void* data, GLsizeiptr bytes);
  template <typename T>
  void Upload(const std::vector<T>& data)
  {
    this->Upload(data.data(), static_cast<GLsizeiptr>(sizeof(T) * data.size()));
  }
  /// Reads from the beginning.
  void Download(void* data, GLsizeiptr bytes) const;
  /// Fills bytes from an offset on with a word.
  void Fill(GLsizeiptr offset, GLsizeiptr bytes, GLuint word);
  /// access: as glMapBufferRange() takes it.
  void* Map(GLsizeiptr bytes, GLbitfield access);
  void Unmap();
  /// For shaders that write to it, all of it or a part.
  void BindStorage(GLuint index) const;
  void BindStorage(GLuint index, GLintptr offset, GLsizeiptr bytes) const;

  bool IsMade() const { return this->Name.IsMade(); }
  GLuint Get() const { return this->Name.Get(); }
  GLuint GetTexture() const { return this->Texture.Get(); }
  GLsizeiptr GetSize() const { return this->Get() ? this->Bytes : 0; }
  void Release();

private:
  void Make();

  GLenum Format;
  GLsizeiptr Bytes = 0;
  vtkPointSplatHandle Name{ vtkPointSplatHandle::Buffer };
  vtkPointSplatHandle Texture{ vtkPointSplatHandle::Texture };
};

#endif
