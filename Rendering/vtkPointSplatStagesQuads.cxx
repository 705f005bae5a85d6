// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The part of vtkPointSplatStages that draws by the rasteriser.
#include "vtkPointSplatStages.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPointSplatImages.h"
#include "vtkPointSplatUnits.h"

#include <algorithm>

namespace
{
GLsizeiptr Stride(const vtkPointSplatCloud& cloud)
{
  return cloud.IsCircular() ? 32 : 64;
}
}

//------------------------------------------------------------------------------
void vtkPointSplatStages::SetStateForQuads(vtkOpenGLState* state, const glm::ivec2& imageSize)
{
  state->vtkglViewport(0, 0, imageSize.x, imageSize.y);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglDisable(GL_BLEND);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LESS);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

//------------------------------------------------------------------------------
void vtkPointSplatStages::BindQuads(const vtkPointSplatItem& item,
  vtkPointSplatCloud::Buffers& buffers, GLuint idMap, vtkIdType first, GLuint divisor)
{
  const GLsizei stride = static_cast<GLsizei>(Stride(*item.Cloud));
  // Without base instances, which OpenGL 3.3 has not: pointers to the first splat.
  auto at = [first](size_t bytes, GLsizei step) {
    return reinterpret_cast<const void*>(bytes + static_cast<size_t>(first * step));
  };
  glBindVertexArray(buffers.VertexArray);
  glBindBuffer(GL_ARRAY_BUFFER, buffers.Splats);
  glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, stride, at(0, stride));
  glVertexAttribIPointer(1, 3, GL_UNSIGNED_INT, stride, at(16, stride));
  glVertexAttribIPointer(2, 1, GL_UNSIGNED_INT, stride, at(28, stride));
  const bool axes = !item.Cloud->IsCircular();
  if (axes)
  {
    glVertexAttribPointer(4, 3, GL_FLOAT, GL_FALSE, stride, at(32, stride));
    glVertexAttribPointer(5, 3, GL_FLOAT, GL_FALSE, stride, at(48, stride));
  }
  if (idMap)
  {
    glBindBuffer(GL_ARRAY_BUFFER, idMap);
    glVertexAttribIPointer(2, 1, GL_UNSIGNED_INT, 4, at(0, 4));
  }
  const bool colours = item.Cloud->HasColours();
  if (colours)
  {
    glBindBuffer(GL_ARRAY_BUFFER, buffers.Colours);
    glVertexAttribPointer(3, 4, GL_UNSIGNED_BYTE, GL_TRUE, 4, at(0, 4));
  }
  if (item.Factors)
  {
    glBindBuffer(GL_ARRAY_BUFFER, item.Factors);
    glVertexAttribPointer(6, 4, GL_UNSIGNED_BYTE, GL_TRUE, 4, at(0, 4));
  }
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  const bool used[] = { true, true, true, colours, axes, axes, item.Factors != 0 };
  for (GLuint i = 0; i < 7; ++i)
  {
    if (used[i])
    {
      glEnableVertexAttribArray(i);
    }
    else
    {
      glDisableVertexAttribArray(i);
    }
    glVertexAttribDivisor(i, divisor);
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatStages::DrawQuads(const vtkPointSplatItem& item,
  vtkPointSplatCloud::Buffers& buffers, GLuint idMap, vtkIdType first, vtkIdType count)
{
  vtkPointSplatStages::BindQuads(item, buffers, idMap, first);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4,
    static_cast<GLsizei>(count < 0 ? item.Cloud->GetNumberOfSplats() - first : count));
  glBindVertexArray(0);
}

//------------------------------------------------------------------------------
void vtkPointSplatStages::DrawPoints(
  const vtkPointSplatItem& item, vtkPointSplatCloud::Buffers& buffers, GLuint idMap)
{
  vtkPointSplatStages::BindQuads(item, buffers, idMap, 0, 0);
  const vtkIdType count = item.Cloud->GetNumberOfSplats();
  if (item.Batches)
  {
    // Batches that follow each other make one run.
    std::vector<GLint> firsts;
    std::vector<GLsizei> counts;
    for (const uint32_t batch : *item.Batches)
    {
      const vtkIdType first = batch * vtkPointSplatBatches::Size;
      const vtkIdType points = std::min(vtkPointSplatBatches::Size, count - first);
      if (!firsts.empty() && firsts.back() + counts.back() == first)
      {
        counts.back() += static_cast<GLsizei>(points);
      }
      else
      {
        firsts.push_back(static_cast<GLint>(first));
        counts.push_back(static_cast<GLsizei>(points));
      }
    }
    glMultiDrawArrays(
      GL_POINTS, firsts.data(), counts.data(), static_cast<GLsizei>(firsts.size()));
  }
  else
  {
    glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(count));
  }
  glBindVertexArray(0);
}

//------------------------------------------------------------------------------
bool vtkPointSplatStages::ReconstructByQuads(vtkOpenGLRenderWindow* window,
  const vtkPointSplatView& view, const std::vector<vtkPointSplatItem>& items,
  vtkPointSplatImages& images, float depthUnit, const vtkPointSplatPeel* peel, bool* empty)
{
  vtkOpenGLState* state = window->GetState();
  vtkPointSplatUnits units(window);
  vtkPointSplatStages::SetStateForQuads(state, images.GetSize());
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, images.GetFramebuffer());

  // Visibility: the nearest depth of all disks.
  GLenum all[] = { GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2,
    GL_COLOR_ATTACHMENT3 };
  const GLuint none[4] = { 0xffffffffu, 0xffffffffu, 0xffffffffu, 0xffffffffu };
  const GLfloat zero[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
  const GLfloat farthest = 1.0f;
  glFramebufferTexture2D(
    GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, images.GetDepths(), 0);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, 0, 0);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT2, GL_TEXTURE_2D, 0, 0);
  glFramebufferTexture2D(
    GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, images.GetDepthAttachment(), 0);
  state->vtkglDrawBuffers(1, all);
  glClearBufferuiv(GL_COLOR, 0, none);
  glClearBufferfv(GL_DEPTH, 0, &farthest);
  vtkPointSplatProgram* program = nullptr;
  GLuint query = 0;
  if (empty)
  {
    glGenQueries(1, &query);
    glBeginQuery(GL_ANY_SAMPLES_PASSED, query);
  }
  bool good = true;
  auto draw = [&](const vtkPointSplatItem& item) {
    if (item.Points)
    {
      this->DrawPoints(item, item.Cloud->Upload(window), 0);
    }
    else
    {
      this->DrawQuads(item, item.Cloud->Upload(window), 0);
    }
  };
  for (const vtkPointSplatItem& item : items)
  {
    program = this->Use(Visibility, false, item, peel);
    if (!program)
    {
      good = false;
      break;
    }
    SetPeel(*program, units, view, peel, false);
    this->SetItem(*program, view, item, images.GetSize());
    program->Set("Reach", DiskReach);
    program->Set("DiskReach", DiskReach);
    program->Set("MinimumRadius", CoverageRadius);
    draw(item);
  }
  if (empty)
  {
    GLuint any = 0;
    glEndQuery(GL_ANY_SAMPLES_PASSED);
    glGetQueryObjectuiv(query, GL_QUERY_RESULT, &any);
    glDeleteQueries(1, &query);
    *empty = any == 0;
    if (*empty)
    {
      return good;
    }
  }
  if (!good)
  {
    return false;
  }

  // Accumulation: sums over the splats of that layer.
  glFramebufferTexture2D(
    GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, images.GetSums(0), 0);
  glFramebufferTexture2D(
    GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, images.GetSums(1), 0);
  glFramebufferTexture2D(
    GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT2, GL_TEXTURE_2D, images.GetSums(2), 0);
  const int targets = images.GetFactorCount() > 0 ? 4 : 3;
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT3, GL_TEXTURE_2D,
    targets > 3 ? images.GetSums(3) : 0, 0);
  state->vtkglDrawBuffers(static_cast<unsigned int>(targets), all);
  for (GLint k = 0; k < targets; ++k)
  {
    glClearBufferfv(GL_COLOR, k, zero);
  }
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendEquation(GL_FUNC_ADD); // depth peeling takes maxima
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  for (const vtkPointSplatItem& item : items)
  {
    program = this->Use(Accumulation, false, item, peel, &images);
    if (!program)
    {
      return false;
    }
    SetPeel(*program, units, view, peel, false);
    units.Bind(*program, "Depths", GL_TEXTURE_2D, images.GetDepths());
    this->SetItem(*program, view, item, images.GetSize());
    program->Set("Reach", static_cast<float>(item.KernelSupport));
    program->Set("MinimumRadius", PrefilterRadius);
    program->Set("DepthUnit", depthUnit);
    if (peel && peel->Gather)
    {
      program->Set("ItemColour", item.Colour);
    }
    draw(item);
  }
  // The other stages know three colour attachments.
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT3, GL_TEXTURE_2D, 0, 0);
  return true;
}

//------------------------------------------------------------------------------
bool vtkPointSplatStages::IdentifyByQuads(vtkOpenGLRenderWindow* window,
  const vtkPointSplatView& view, const std::vector<vtkPointSplatItem>& items,
  vtkPointSplatImages& images, vtkPointSplatCloud::IdKind kind)
{
  vtkOpenGLState* state = window->GetState();
  vtkPointSplatStages::SetStateForQuads(state, images.GetSize());
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, images.GetFramebuffer());
  GLenum first[] = { GL_COLOR_ATTACHMENT0 };
  const GLuint none[4] = { 0xffffffffu, 0xffffffffu, 0xffffffffu, 0xffffffffu };
  const GLfloat farthest = 1.0f;
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, images.GetIds(), 0);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, 0, 0);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT2, GL_TEXTURE_2D, 0, 0);
  glFramebufferTexture2D(
    GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, images.GetDepthAttachment(), 0);
  state->vtkglDrawBuffers(1, first);
  glClearBufferuiv(GL_COLOR, 0, none);
  glClearBufferfv(GL_DEPTH, 0, &farthest);
  vtkPointSplatUnits units(window);
  for (const vtkPointSplatItem& item : items)
  {
    vtkPointSplatProgram* program = this->Use(Identification, false, item);
    if (!program)
    {
      return false;
    }
    units.Bind(*program, "Depths", GL_TEXTURE_2D, images.GetDepths());
    const GLuint idMap = item.Cloud->UploadIdMap(window, kind);
    this->SetItem(*program, view, item, images.GetSize());
    program->Set("Reach", static_cast<float>(item.KernelSupport));
    program->Set("MinimumRadius", PrefilterRadius);
    if (item.Points)
    {
      this->DrawPoints(item, item.Cloud->Upload(window), idMap);
    }
    else
    {
      this->DrawQuads(item, item.Cloud->Upload(window), idMap);
    }
  }
  return true;
}
