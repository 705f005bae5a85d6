// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatImages.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPointSplatProgram.h"
#include "vtkPointSplatUnits.h"
#include "vtkShaderProgram.h"
#include "vtkTextureUnitManager.h"

#include <algorithm>

namespace
{
// Bytes a pixel, compute.
constexpr GLsizeiptr DepthBytes = 4;
constexpr GLsizeiptr LargestSumBytes = 32;
constexpr GLsizeiptr IdBytes = 8;
// Of filled layers.
constexpr GLsizeiptr TexelBytes = 16;
constexpr GLsizeiptr FactorTexelBytes = 4;

void ClearRows(GLuint buffer, GLsizeiptr bytesPerPixel, int width, const glm::ivec4& window,
  GLenum internal, GLenum format, GLenum type, const void* value)
{
  if (window.y > window.w)
  {
    return;
  }
  glBindBuffer(GL_TEXTURE_BUFFER, buffer);
  glClearBufferSubData(GL_TEXTURE_BUFFER, internal, bytesPerPixel * width * window.y,
    bytesPerPixel * width * (window.w - window.y + 1), format, type, value);
  glBindBuffer(GL_TEXTURE_BUFFER, 0);
}
}

//------------------------------------------------------------------------------
GLuint vtkPointSplatImages::MakeTexture(
  const glm::ivec2& size, GLenum internal, GLenum format, GLenum type)
{
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internal), size.x, size.y, 0, format, type,
    nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  glBindTexture(GL_TEXTURE_2D, 0);
  return texture;
}

//------------------------------------------------------------------------------
void vtkPointSplatImages::MakeBuffer(
  GLuint& buffer, GLuint& texture, GLsizeiptr bytes, GLenum format)
{
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_TEXTURE_BUFFER, buffer);
  glBufferData(GL_TEXTURE_BUFFER, bytes, nullptr, GL_DYNAMIC_COPY);
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_BUFFER, texture);
  glTexBuffer(GL_TEXTURE_BUFFER, format, buffer);
  glBindTexture(GL_TEXTURE_BUFFER, 0);
  glBindBuffer(GL_TEXTURE_BUFFER, 0);
}

//------------------------------------------------------------------------------
bool vtkPointSplatImages::FitCompute(const glm::ivec2& size)
{
  GLint block = 0;
  GLint texels = 0;
  glGetIntegerv(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &block);
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &texels);
  const GLint64 pixels = static_cast<GLint64>(size.x) * size.y;
  return pixels * LargestSumBytes <= block && pixels * 2 <= texels;
}

//------------------------------------------------------------------------------
void vtkPointSplatImages::Allocate(
  bool compute, const glm::ivec2& size, bool colours, int factors)
{
  if (this->Depths && !this->Texels && this->Compute == compute && this->Size == size &&
    (this->Colours == colours || !compute) && this->Factors == factors)
  {
    return;
  }
  this->Release();
  this->Compute = compute;
  this->Colours = colours;
  this->Factors = factors;
  this->Size = size;
  if (compute)
  {
    const GLsizeiptr pixels = static_cast<GLsizeiptr>(size.x) * size.y;
    MakeBuffer(this->Depths, this->BufferTextures[0], DepthBytes * pixels, GL_R32UI);
    MakeBuffer(this->Sums[0], this->BufferTextures[1], 4 * this->GetSumStride() * pixels, GL_RGBA32I);
    return;
  }
  this->Depths = MakeTexture(size, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT);
  this->Sums[0] = MakeTexture(size, GL_RGBA32F, GL_RGBA, GL_FLOAT);
  this->Sums[1] = MakeTexture(size, GL_RGBA32F, GL_RGBA, GL_FLOAT);
  this->Sums[2] = MakeTexture(size, GL_R32F, GL_RED, GL_FLOAT);
  if (factors > 0)
  {
    this->Sums[3] = MakeTexture(size, GL_RGBA32F, GL_RGBA, GL_FLOAT);
  }
  this->Ids = MakeTexture(size, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT);
  this->DepthAttachment =
    MakeTexture(size, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT);
  glGenFramebuffers(1, &this->Framebuffer);
}

//------------------------------------------------------------------------------
std::string vtkPointSplatImages::GetDefines() const
{
  return std::string(this->Compute ? "#define COMPUTE_IMAGES\n" : "") +
    (this->Texels ? "#define FILLED_IMAGES\n" : "") +
    (this->Factors ? "#define FACTORS " + std::to_string(this->Factors) + "\n" : "");
}

//------------------------------------------------------------------------------
void vtkPointSplatImages::AllocateFilled(bool compute, const glm::ivec2& size, int factors)
{
  if (this->Texels && this->Compute == compute && this->Size == size &&
    (this->FactorTexels != 0) == (factors > 0))
  {
    this->Factors = factors;
    return;
  }
  this->Release();
  this->Compute = compute;
  this->Factors = factors;
  this->Size = size;
  if (compute)
  {
    MakeBuffer(this->Texels, this->BufferTextures[0],
      static_cast<GLsizeiptr>(TexelBytes) * size.x * size.y, GL_RGBA32UI);
    if (factors > 0)
    {
      MakeBuffer(this->FactorTexels, this->BufferTextures[1],
        static_cast<GLsizeiptr>(FactorTexelBytes) * size.x * size.y, GL_R32UI);
    }
    return;
  }
  this->Texels = MakeTexture(size, GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT);
  if (factors > 0)
  {
    this->FactorTexels = MakeTexture(size, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT);
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatImages::ClearBuffers(const glm::ivec4& window)
{
  const GLuint none = 0xffffffffu;
  const GLint zero[4] = { 0, 0, 0, 0 };
  ClearRows(this->Depths, DepthBytes, this->Size.x, window, GL_R32UI, GL_RED_INTEGER,
    GL_UNSIGNED_INT, &none);
  ClearRows(
    this->Sums[0], 4 * this->GetSumStride(), this->Size.x, window, GL_RGBA32I, GL_RGBA_INTEGER, GL_INT, zero);
}

//------------------------------------------------------------------------------
void vtkPointSplatImages::ClearIdBuffer(const glm::ivec4& window)
{
  if (!this->Ids)
  {
    const GLsizeiptr pixels = static_cast<GLsizeiptr>(this->Size.x) * this->Size.y;
    MakeBuffer(this->Ids, this->BufferTextures[2], IdBytes * pixels, GL_RG32UI);
  }
  const GLuint none[2] = { 0, 0xffffffffu };
  ClearRows(
    this->Ids, IdBytes, this->Size.x, window, GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT, none);
}

//------------------------------------------------------------------------------
vtkIdType vtkPointSplatImages::GetMemorySize() const
{
  const vtkIdType pixels = static_cast<vtkIdType>(this->Size.x) * this->Size.y;
  if (this->Texels)
  {
    return (TexelBytes + (this->FactorTexels ? FactorTexelBytes : 0)) * pixels;
  }
  const vtkIdType ids = this->Ids ? IdBytes : 0;
  return this->Compute ? pixels * (DepthBytes + 4 * this->GetSumStride() + ids) : pixels * (4 + 36 + (this->Sums[3] ? 16 : 0) + 4 + 4);
}

//------------------------------------------------------------------------------
void vtkPointSplatImages::Bind(
  vtkOpenGLRenderWindow* window, vtkShaderProgram* program, bool withIds)
{
  const GLenum usual = this->Compute ? GL_TEXTURE_BUFFER : GL_TEXTURE_2D;
  auto bind = [&](int slot, GLuint texture, const char* name, GLenum target) {
    this->Targets[slot] = target;
    this->Units[slot] = window->GetTextureUnitManager()->Allocate();
    window->GetState()->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned>(this->Units[slot]));
    glBindTexture(target, texture);
    program->SetUniformi(name, this->Units[slot]);
  };
  if (this->Texels)
  {
    bind(0, this->GetDepthTexture(), "Texels", usual);
    if (this->FactorTexels)
    {
      bind(2, this->Compute ? this->BufferTextures[1] : this->FactorTexels, "FactorTexels", usual);
    }
    if (withIds)
    {
      bind(1, this->Filled, "Filled", usual);
      bind(3, this->Compute ? this->Projected->BufferTextures[2] : this->Projected->Ids, "Ids",
        usual);
    }
    if (this->Compute)
    {
      program->SetUniformi("ImageWidth", this->Size.x);
    }
    return;
  }
  bind(0, this->Compute ? this->BufferTextures[0] : this->Depths, "Depths", usual);
  if (this->Compute)
  {
    bind(1, this->BufferTextures[1], "Sums", usual);
    program->SetUniformi("ImageWidth", this->Size.x);
    program->SetUniformi("TexelsPerPixel", this->GetSumStride() / 4);
    if (this->Factors > 0)
    {
      program->SetUniformi("FactorWord", this->GetFactorWord());
    }
  }
  else
  {
    bind(1, this->Sums[0], "WeightAndNormal", usual);
    bind(2, this->Sums[1], "DepthAndColour", usual);
    bind(4, this->Sums[2], "Opacities", usual);
    if (this->Sums[3])
    {
      bind(5, this->Sums[3], "Factors", usual);
    }
  }
  if (withIds)
  {
    bind(3, this->Compute ? this->BufferTextures[2] : this->Ids, "Ids", usual);
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatImages::Bind(vtkPointSplatUnits& units, vtkPointSplatProgram& program)
{
  if (this->Compute)
  {
    units.Bind(program, "Depths", GL_TEXTURE_BUFFER, this->BufferTextures[0]);
    units.Bind(program, "Sums", GL_TEXTURE_BUFFER, this->BufferTextures[1]);
    program.Set("ImageWidth", this->Size.x);
    program.Set("TexelsPerPixel", this->GetSumStride() / 4);
    program.Set("FactorWord", this->GetFactorWord());
    return;
  }
  units.Bind(program, "Depths", GL_TEXTURE_2D, this->Depths);
  units.Bind(program, "WeightAndNormal", GL_TEXTURE_2D, this->Sums[0]);
  units.Bind(program, "DepthAndColour", GL_TEXTURE_2D, this->Sums[1]);
  units.Bind(program, "Opacities", GL_TEXTURE_2D, this->Sums[2]);
  if (this->Sums[3])
  {
    units.Bind(program, "Factors", GL_TEXTURE_2D, this->Sums[3]);
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatImages::Unbind(vtkOpenGLRenderWindow* window)
{
  for (int slot = 0; slot < 6; ++slot)
  {
    int& unit = this->Units[slot];
    if (unit >= 0)
    {
      window->GetState()->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned>(unit));
      glBindTexture(this->Targets[slot], 0);
      window->GetTextureUnitManager()->Free(unit);
      unit = -1;
    }
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatImages::Release()
{
  if (this->Compute)
  {
    const GLuint buffers[] = { this->Depths, this->Sums[0], this->Ids, this->Texels,
      this->FactorTexels };
    glDeleteBuffers(5, buffers);
    glDeleteTextures(3, this->BufferTextures);
  }
  else
  {
    const GLuint textures[] = { this->Depths, this->Sums[0], this->Sums[1], this->Sums[2],
      this->Sums[3], this->Ids, this->DepthAttachment, this->Texels, this->FactorTexels };
    glDeleteTextures(9, textures);
    if (this->Framebuffer)
    {
      glDeleteFramebuffers(1, &this->Framebuffer);
    }
  }
  this->Depths = this->Sums[0] = this->Sums[1] = this->Sums[2] = this->Sums[3] = this->Ids = this->DepthAttachment = 0;
  this->Framebuffer = this->Texels = this->FactorTexels = 0;
  this->Projected = nullptr;
  std::fill_n(this->BufferTextures, 3, 0u);
  this->Size = glm::ivec2(0);
}
