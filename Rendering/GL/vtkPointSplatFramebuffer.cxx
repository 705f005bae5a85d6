// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatFramebuffer.h"

#include "vtkOpenGLState.h"

#include <algorithm>

namespace
{
void Attach(GLenum attachment, const vtkPointSplatFramebuffer::Target& target)
{
  if (target.Image->GetLayers() > 0)
  {
    glFramebufferTextureLayer(
      GL_FRAMEBUFFER, attachment, target.Image->Get(), 0, target.Layer);
  }
  else
  {
    glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, target.Image->Get(), 0);
  }
}
}

//------------------------------------------------------------------------------
void vtkPointSplatFramebuffer::Bind(vtkOpenGLState* state, const std::vector<Target>& colours)
{
  this->BindColours(state, colours);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, 0, 0);
}

//------------------------------------------------------------------------------
void vtkPointSplatFramebuffer::Bind(vtkOpenGLState* state, const std::vector<Target>& colours,
  const Target& depth, GLenum attachment)
{
  this->BindColours(state, colours);
  Attach(attachment, depth);
}

//------------------------------------------------------------------------------
void vtkPointSplatFramebuffer::BindColours(
  vtkOpenGLState* state, const std::vector<Target>& colours)
{
  if (this->Name.Make())
  {
    this->Count = -1;
    this->Attached = 0;
  }
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->Name.Get());
  GLsizei count = 0;
  GLenum all[8];
  for (const Target& colour : colours)
  {
    all[count] = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(count);
    Attach(all[count], colour);
    ++count;
  }
  for (GLsizei i = count; i < this->Attached; ++i)
  {
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i),
      GL_TEXTURE_2D, 0, 0);
  }
  if (count != this->Count)
  {
    // VTK's cache has to know, and may leave out the call: of other framebuffers' buffers it keeps
    // all but the first.
    if (count > 0)
    {
      state->vtkglDrawBuffers(static_cast<unsigned int>(count), all);
      glDrawBuffers(count, all);
    }
    else
    {
      state->vtkglDrawBuffer(GL_NONE);
      glDrawBuffer(GL_NONE);
    }
  }
  this->Count = count;
  this->Attached = count;
}

//------------------------------------------------------------------------------
GLenum vtkPointSplatFramebuffer::GetReadDepthFormat()
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
