// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatSceneDepth.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

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
  this->Depth.Allocate(format, size);
  while (glGetError() != GL_NO_ERROR)
  {
    // Somebody else's: what follows asks whether the copy itself succeeds.
  }
  const bool hasStencil = format == GL_DEPTH24_STENCIL8 || format == GL_DEPTH32F_STENCIL8;
  // Only the framebuffer for drawing changes; the depth comes from the one for reading.
  vtkOpenGLState* state = window->GetState();
  GLint read = 0;
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read);
  state->PushFramebufferBindings();
  this->Framebuffer.Bind(state, {}, this->Depth,
    hasStencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT);
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read));
  {
    vtkOpenGLState::ScopedglEnableDisable scissor(state, GL_SCISSOR_TEST);
    state->vtkglDisable(GL_SCISSOR_TEST);
    glBlitFramebuffer(origin.x, origin.y, origin.x + size.x, origin.y + size.y, 0, 0, size.x,
      size.y, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  }
  const bool good = glGetError() == GL_NO_ERROR;
  state->PopFramebufferBindings();
  return good;
}
