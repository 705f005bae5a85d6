// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatSceneDepth.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPointSplatUnits.h"

namespace
{
/**
 * The internal format of the depth that is bound for reading, 0 for none: blits between
 * depth buffers ask for equal formats.
 */
GLenum FormatOfReadDepth()
{
  GLint framebuffer = 0;
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &framebuffer);
  const GLenum depth = framebuffer ? GL_DEPTH_ATTACHMENT : GL_DEPTH;
  const GLenum stencil = framebuffer ? GL_STENCIL_ATTACHMENT : GL_STENCIL;
  GLint type = GL_NONE;
  glGetFramebufferAttachmentParameteriv(
    GL_READ_FRAMEBUFFER, depth, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &type);
  if (type == GL_NONE)
  {
    return 0;
  }
  GLint bits = 0;
  GLint component = 0;
  glGetFramebufferAttachmentParameteriv(
    GL_READ_FRAMEBUFFER, depth, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE, &bits);
  glGetFramebufferAttachmentParameteriv(
    GL_READ_FRAMEBUFFER, depth, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, &component);
  GLint stencilType = GL_NONE;
  glGetFramebufferAttachmentParameteriv(
    GL_READ_FRAMEBUFFER, stencil, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &stencilType);
  const bool both = stencilType != GL_NONE;
  if (component == GL_FLOAT)
  {
    return both ? GL_DEPTH32F_STENCIL8 : GL_DEPTH_COMPONENT32F;
  }
  return both        ? GL_DEPTH24_STENCIL8
    : bits <= 16     ? GL_DEPTH_COMPONENT16
    : bits <= 24     ? GL_DEPTH_COMPONENT24
                     : GL_DEPTH_COMPONENT32;
}
}

//------------------------------------------------------------------------------
bool vtkPointSplatSceneDepth::Capture(
  vtkOpenGLRenderWindow* window, const glm::ivec2& origin, const glm::ivec2& size)
{
  const GLenum format = FormatOfReadDepth();
  if (format == 0)
  {
    return false;
  }
  vtkOpenGLState* state = window->GetState();
  if (!this->Texture || this->Size != size || this->Format != format)
  {
    this->Release();
    this->Size = size;
    this->Format = format;
    const bool both = format == GL_DEPTH24_STENCIL8 || format == GL_DEPTH32F_STENCIL8;
    vtkOpenGLState::ScopedglActiveTexture active(state);
    const int unit = window->GetTextureUnitManager()->Allocate();
    state->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned>(unit));
    glGenTextures(1, &this->Texture);
    glBindTexture(GL_TEXTURE_2D, this->Texture);
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), size.x, size.y, 0,
      both ? GL_DEPTH_STENCIL : GL_DEPTH_COMPONENT,
      format == GL_DEPTH24_STENCIL8      ? GL_UNSIGNED_INT_24_8
        : format == GL_DEPTH32F_STENCIL8 ? GL_FLOAT_32_UNSIGNED_INT_24_8_REV
        : format == GL_DEPTH_COMPONENT32F ? GL_FLOAT
                                          : GL_UNSIGNED_INT,
      nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glBindTexture(GL_TEXTURE_2D, 0);
    window->GetTextureUnitManager()->Free(unit);
    glGenFramebuffers(1, &this->Framebuffer);
  }

  while (glGetError() != GL_NO_ERROR)
  {
    // Somebody else's: what follows asks whether the copy itself succeeds.
  }
  // Only the framebuffer for drawing changes; the depth comes from the one for reading.
  state->PushDrawFramebufferBinding();
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->Framebuffer);
  const bool both = this->Format == GL_DEPTH24_STENCIL8 || this->Format == GL_DEPTH32F_STENCIL8;
  glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER,
    both ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, this->Texture, 0);
  const GLenum none = GL_NONE;
  glDrawBuffers(1, &none);
  {
    vtkOpenGLState::ScopedglEnableDisable scissor(state, GL_SCISSOR_TEST);
    state->vtkglDisable(GL_SCISSOR_TEST);
    glBlitFramebuffer(origin.x, origin.y, origin.x + size.x, origin.y + size.y, 0, 0, size.x,
      size.y, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  }
  const bool good = glGetError() == GL_NO_ERROR;
  state->PopDrawFramebufferBinding();
  return good;
}

//------------------------------------------------------------------------------
void vtkPointSplatSceneDepth::Release()
{
  if (this->Texture)
  {
    glDeleteTextures(1, &this->Texture);
    glDeleteFramebuffers(1, &this->Framebuffer);
  }
  this->Texture = this->Framebuffer = 0;
  this->Size = glm::ivec2(0);
}
