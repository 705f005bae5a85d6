// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatBuffer.h"

#include <algorithm>

namespace
{
// Buffers of no bytes cannot be bound or mapped.
constexpr GLsizeiptr LeastBytes = 48;

/// So many bytes or a few more. Drivers for processors compile a program for each combination of its textures whose
/// sizes are powers of two, and of others; and, since they take a part of a buffer's size for a texture's last mipmap
/// level, of those whose second lowest byte is 0, as of buffers of less than 256 bytes.
GLsizeiptr LikeMost(GLsizeiptr bytes)
{
  const GLsizeiptr more = (bytes & 0xff00) == 0 ? bytes + 256 : bytes;
  return (more & (more - 1)) == 0 ? more + 16 : more;
}
}

//------------------------------------------------------------------------------
void vtkPointSplatBuffer::Make()
{
  if (this->Name.Make())
  {
    this->Bytes = 0;
    this->Texture.Release();
  }
  glBindBuffer(GL_COPY_WRITE_BUFFER, this->Name.Get());
}

//------------------------------------------------------------------------------
bool vtkPointSplatBuffer::Reserve(GLsizeiptr bytes)
{
  this->Make();
  const bool grows = this->Bytes < std::max(bytes, LeastBytes);
  if (grows)
  {
    // A quarter more, so that a number that creeps up does not make it grow each time.
    this->Bytes =
      LikeMost(std::max(bytes + (this->Bytes > 0 ? bytes / 4 : 0), LeastBytes));
    glBufferData(GL_COPY_WRITE_BUFFER, this->Bytes, nullptr, GL_DYNAMIC_COPY);
    if (this->Format != 0)
    {
      this->Texture.Make();
      glBindTexture(GL_TEXTURE_BUFFER, this->Texture.Get());
      glTexBuffer(GL_TEXTURE_BUFFER, this->Format, this->Name.Get());
      glBindTexture(GL_TEXTURE_BUFFER, 0);
    }
  }
  glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
  return grows;
}

//------------------------------------------------------------------------------
void vtkPointSplatBuffer::Upload(const void* data, GLsizeiptr bytes)
{
  this->Reserve(bytes);
  if (bytes > 0)
  {
    glBindBuffer(GL_COPY_WRITE_BUFFER, this->Name.Get());
    glBufferSubData(GL_COPY_WRITE_BUFFER, 0, bytes, data);
    glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatBuffer::Download(void* data, GLsizeiptr bytes) const
{
  glBindBuffer(GL_COPY_READ_BUFFER, this->Name.Get());
  glGetBufferSubData(GL_COPY_READ_BUFFER, 0, bytes, data);
  glBindBuffer(GL_COPY_READ_BUFFER, 0);
}

//------------------------------------------------------------------------------
void vtkPointSplatBuffer::Fill(GLsizeiptr offset, GLsizeiptr bytes, GLuint word)
{
  if (bytes > 0)
  {
    glBindBuffer(GL_COPY_WRITE_BUFFER, this->Name.Get());
    glClearBufferSubData(
      GL_COPY_WRITE_BUFFER, GL_R32UI, offset, bytes, GL_RED_INTEGER, GL_UNSIGNED_INT, &word);
    glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
  }
}

//------------------------------------------------------------------------------
void* vtkPointSplatBuffer::Map(GLsizeiptr bytes, GLbitfield access)
{
  glBindBuffer(GL_COPY_WRITE_BUFFER, this->Name.Get());
  void* data = glMapBufferRange(GL_COPY_WRITE_BUFFER, 0, std::max(bytes, LeastBytes), access);
  glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
  return data;
}

//------------------------------------------------------------------------------
void vtkPointSplatBuffer::Unmap()
{
  glBindBuffer(GL_COPY_WRITE_BUFFER, this->Name.Get());
  glUnmapBuffer(GL_COPY_WRITE_BUFFER);
  glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
}

//------------------------------------------------------------------------------
void vtkPointSplatBuffer::BindStorage(GLuint index) const
{
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, index, this->Name.Get());
}

//------------------------------------------------------------------------------
void vtkPointSplatBuffer::BindStorage(GLuint index, GLintptr offset, GLsizeiptr bytes) const
{
  glBindBufferRange(GL_SHADER_STORAGE_BUFFER, index, this->Name.Get(), offset, bytes);
}

//------------------------------------------------------------------------------
void vtkPointSplatBuffer::Release()
{
  this->Texture.Release();
  this->Name.Release();
  this->Bytes = 0;
}
