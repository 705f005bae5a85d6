// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatDeferred.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkPointSplatImages.h"
#include "vtkPointSplatSavedState.h"

#include <algorithm>

namespace
{
constexpr vtkIdType BytesPerTexel = 16 + 4;

GLuint MakeArray(const glm::ivec2& size, int layers, GLenum internal, GLenum format, GLenum type)
{
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
  glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, static_cast<GLint>(internal), size.x, size.y, layers, 0,
    format, type, nullptr);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, 0);
  glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
  return texture;
}
}

//------------------------------------------------------------------------------
bool vtkPointSplatDeferred::Fits(const glm::ivec2& size, int groups, vtkIdType bytes)
{
  GLint layers = 0;
  glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &layers);
  const vtkIdType wanted = BytesPerTexel * size.x * size.y * groups;
  return groups <= layers && (bytes == 0 || wanted <= bytes);
}

//------------------------------------------------------------------------------
vtkIdType vtkPointSplatDeferred::GetMemorySize() const
{
  return (BytesPerTexel + (this->Factors ? 4 : 0)) * this->Size.x * this->Size.y * this->Groups;
}

//------------------------------------------------------------------------------
void vtkPointSplatDeferred::Allocate(const glm::ivec2& size, int groups, bool factors)
{
  if (this->Texels && this->Size == size && this->Groups == groups &&
    (this->Factors != 0) == factors)
  {
    return;
  }
  this->ReleaseImages();
  this->Size = size;
  this->Groups = groups;
  this->Texels = MakeArray(size, groups, GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT);
  this->Depths = MakeArray(size, groups, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT);
  if (factors)
  {
    this->Factors = MakeArray(size, groups, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT);
  }
  glGenFramebuffers(1, &this->Framebuffer);
  if (!this->VertexArray)
  {
    glGenVertexArrays(1, &this->VertexArray);
  }
}

//------------------------------------------------------------------------------
bool vtkPointSplatDeferred::BuildPrograms(bool factors)
{
  const std::string defines = factors ? "#define FACTORS\n" : "";
  vtkPointSplatProgram& geometry = this->Geometry[factors ? 1 : 0];
  vtkPointSplatProgram& compositing = this->Compositing[factors ? 1 : 0];
  if ((!geometry.IsBuilt() &&
        !geometry.Build({ { GL_VERTEX_SHADER, "vtkPointSplatGroupVS" },
                          { GL_FRAGMENT_SHADER, "vtkPointSplatGroupFS" } },
          defines + "#define CLIPPING\n")) ||
    (!compositing.IsBuilt() &&
      !compositing.Build({ { GL_VERTEX_SHADER, "vtkPointSplatResolveVS" },
                           { GL_FRAGMENT_SHADER, "vtkPointSplatCompositeFS" } },
        defines)))
  {
    this->Error = geometry.GetLog() + compositing.GetLog();
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkPointSplatDeferred::Reconstruct(vtkOpenGLRenderWindow* window,
  const vtkPointSplatView& view, const std::vector<vtkPointSplatItem>& items,
  vtkPointSplatImages& images, float depthUnit, float voronoiScale)
{
  const bool factors = images.GetFactorCount() > 0;
  if (!this->BuildPrograms(factors))
  {
    return false;
  }
  vtkPointSplatProgram& geometry = this->Geometry[factors ? 1 : 0];
  vtkPointSplatProgram& compositing = this->Compositing[factors ? 1 : 0];
  int groups = 1;
  for (const vtkPointSplatItem& item : items)
  {
    groups = std::max(groups, item.Cloud->GetNumberOfGroups());
  }
  this->Allocate(images.GetSize(), groups, factors);

  window->GetShaderCache()->ReleaseCurrentShader();
  vtkOpenGLState* state = window->GetState();
  const vtkPointSplatSavedState saved(state);
  vtkPointSplatStages::SetStateForQuads(state, images.GetSize());

  // Geometry
  GLenum all[] = { GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2,
    GL_COLOR_ATTACHMENT3, GL_COLOR_ATTACHMENT4 };
  const GLfloat farthest = 1.0f;
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->Framebuffer);
  geometry.Use();
  for (int group = 0; group < groups; ++group)
  {
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, this->Texels, 0, group);
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, this->Depths, 0, group);
    if (factors)
    {
      glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, this->Factors, 0, group);
    }
    state->vtkglDrawBuffers(factors ? 2 : 1, all);
    glClearBufferfv(GL_DEPTH, 0, &farthest);
    for (const vtkPointSplatItem& item : items)
    {
      vtkPointSplatCloud::Buffers& buffers = item.Cloud->Upload(window);
      const std::pair<vtkIdType, vtkIdType> range = item.Cloud->GetGroup(group);
      if (range.second > 0)
      {
        vtkPointSplatStages::SetItem(geometry, view, item, images.GetSize());
        geometry.Set("Reach", static_cast<float>(item.KernelSupport));
        geometry.Set("MinimumRadius", vtkPointSplatStages::PrefilterRadius);
        geometry.Set("DiskReach", vtkPointSplatStages::DiskReach);
        geometry.Set("CoverageRadius", vtkPointSplatStages::CoverageRadius);
        geometry.Set("DepthUnit", depthUnit);
        geometry.Set("VoronoiScale", voronoiScale);
        vtkPointSplatStages::DrawQuads(item, buffers, 0, range.first, range.second);
      }
    }
  }

  // Compositing
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, images.GetFramebuffer());
  const GLuint targets[] = { images.GetDepths(), images.GetSums(0), images.GetSums(1),
    images.GetSums(2), images.GetSums(3) };
  const GLenum count = factors ? 5 : 4;
  for (GLenum k = 0; k < count; ++k)
  {
    glFramebufferTexture2D(
      GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + k, GL_TEXTURE_2D, targets[k], 0);
  }
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, 0, 0);
  state->vtkglDrawBuffers(count, all);
  const GLuint none[4] = { 0xffffffffu, 0xffffffffu, 0xffffffffu, 0xffffffffu };
  glClearBufferuiv(GL_COLOR, 0, none);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_FALSE);
  compositing.Use();
  compositing.Set("DepthUnit", depthUnit);
  compositing.Set("GroupCount", groups);
  compositing.Set("Texels", 0);
  compositing.Set("GroupDepths", 1);
  {
    vtkOpenGLState::ScopedglActiveTexture unit(state);
    state->vtkglActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, this->Texels);
    state->vtkglActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D_ARRAY, this->Depths);
    if (factors)
    {
      compositing.Set("FactorTexels", 2);
      state->vtkglActiveTexture(GL_TEXTURE2);
      glBindTexture(GL_TEXTURE_2D_ARRAY, this->Factors);
    }
    glBindVertexArray(this->VertexArray);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    for (const unsigned int unit : { GL_TEXTURE2, GL_TEXTURE1, GL_TEXTURE0 })
    {
      state->vtkglActiveTexture(unit);
      glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
    }
  }
  // The other stages know three colour attachments.
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT3, GL_TEXTURE_2D, 0, 0);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT4, GL_TEXTURE_2D, 0, 0);
  glUseProgram(0);
  return true;
}

//------------------------------------------------------------------------------
void vtkPointSplatDeferred::ReleaseImages()
{
  const GLuint textures[] = { this->Texels, this->Depths, this->Factors };
  if (this->Texels)
  {
    glDeleteTextures(3, textures);
    glDeleteFramebuffers(1, &this->Framebuffer);
  }
  this->Texels = this->Depths = this->Factors = this->Framebuffer = 0;
  this->Size = glm::ivec2(0);
  this->Groups = 0;
}

//------------------------------------------------------------------------------
void vtkPointSplatDeferred::Release()
{
  this->ReleaseImages();
  if (this->VertexArray)
  {
    glDeleteVertexArrays(1, &this->VertexArray);
    this->VertexArray = 0;
  }
  for (int factors = 0; factors < 2; ++factors)
  {
    this->Geometry[factors].Release();
    this->Compositing[factors].Release();
  }
}
