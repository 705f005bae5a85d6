// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatSceneDepth.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

//------------------------------------------------------------------------------
bool vtkPointSplatSceneDepth::Capture(
  vtkOpenGLRenderWindow* window, const glm::ivec2& origin, const glm::ivec2& size)
{
  const GLenum format = vtkPointSplatFramebuffer::GetReadDepthFormat();
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
