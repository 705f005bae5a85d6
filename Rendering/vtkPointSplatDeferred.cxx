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
  return BytesPerTexel * this->Size.x * this->Size.y * this->Groups;
}

//------------------------------------------------------------------------------
void vtkPointSplatDeferred::Allocate(const glm::ivec2& size, int groups)
{
  if (this->Texels && this->Size == size && this->Groups == groups)
  {
    return;
  }
  this->ReleaseImages();
  this->Size = size;
  this->Groups = groups;
  this->Texels = MakeArray(size, groups, GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT);
  this->Depths = MakeArray(size, groups, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT);
  glGenFramebuffers(1, &this->Framebuffer);
  if (!this->VertexArray)
  {
    glGenVertexArrays(1, &this->VertexArray);
  }
}

//------------------------------------------------------------------------------
bool vtkPointSplatDeferred::Reconstruct(vtkOpenGLRenderWindow* window,
  const vtkPointSplatView& view, const std::vector<vtkPointSplatItem>& items,
  vtkPointSplatImages& images, float depthUnit, float voronoiScale)
{
  if ((!this->Geometry.IsBuilt() &&
        !this->Geometry.Build({ { GL_VERTEX_SHADER, "vtkPointSplatGroupVS" },
          { GL_FRAGMENT_SHADER, "vtkPointSplatGroupFS" } })) ||
    (!this->Compositing.IsBuilt() &&
      !this->Compositing.Build({ { GL_VERTEX_SHADER, "vtkPointSplatResolveVS" },
        { GL_FRAGMENT_SHADER, "vtkPointSplatCompositeFS" } })))
  {
    this->Error = this->Geometry.GetLog() + this->Compositing.GetLog();
    return false;
  }
  int groups = 1;
  for (const vtkPointSplatItem& item : items)
  {
    groups = std::max(groups, item.Cloud->GetNumberOfGroups());
  }
  this->Allocate(images.GetSize(), groups);

  window->GetShaderCache()->ReleaseCurrentShader();
  vtkOpenGLState* state = window->GetState();
  const vtkPointSplatSavedState saved(state);
  vtkPointSplatStages::SetStateForQuads(state, images.GetSize());

  // Geometry
  GLenum all[] = { GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2,
    GL_COLOR_ATTACHMENT3 };
  const GLfloat farthest = 1.0f;
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->Framebuffer);
  this->Geometry.Use();
  for (int group = 0; group < groups; ++group)
  {
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, this->Texels, 0, group);
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, this->Depths, 0, group);
    state->vtkglDrawBuffers(1, all);
    glClearBufferfv(GL_DEPTH, 0, &farthest);
    for (const vtkPointSplatItem& item : items)
    {
      vtkPointSplatCloud::Buffers& buffers = item.Cloud->Upload(window);
      const std::pair<vtkIdType, vtkIdType> range = item.Cloud->GetGroup(group);
      if (range.second > 0)
      {
        vtkPointSplatStages::SetItem(this->Geometry, view, item, images.GetSize());
        this->Geometry.Set("Reach", static_cast<float>(item.KernelSupport));
        this->Geometry.Set("MinimumRadius", vtkPointSplatStages::PrefilterRadius);
        this->Geometry.Set("DiskReach", vtkPointSplatStages::DiskReach);
        this->Geometry.Set("CoverageRadius", vtkPointSplatStages::CoverageRadius);
        this->Geometry.Set("DepthUnit", depthUnit);
        this->Geometry.Set("VoronoiScale", voronoiScale);
        vtkPointSplatStages::DrawQuads(item, buffers, 0, range.first, range.second);
      }
    }
  }

  // Compositing
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, images.GetFramebuffer());
  const GLuint targets[] = { images.GetDepths(), images.GetSums(0), images.GetSums(1),
    images.GetSums(2) };
  for (GLenum k = 0; k < 4; ++k)
  {
    glFramebufferTexture2D(
      GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + k, GL_TEXTURE_2D, targets[k], 0);
  }
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, 0, 0);
  state->vtkglDrawBuffers(4, all);
  const GLuint none[4] = { 0xffffffffu, 0xffffffffu, 0xffffffffu, 0xffffffffu };
  glClearBufferuiv(GL_COLOR, 0, none);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_FALSE);
  this->Compositing.Use();
  this->Compositing.Set("DepthUnit", depthUnit);
  this->Compositing.Set("GroupCount", groups);
  this->Compositing.Set("Texels", 0);
  this->Compositing.Set("GroupDepths", 1);
  {
    vtkOpenGLState::ScopedglActiveTexture unit(state);
    state->vtkglActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, this->Texels);
    state->vtkglActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D_ARRAY, this->Depths);
    glBindVertexArray(this->VertexArray);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
    state->vtkglActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
  }
  // The other stages know three colour attachments.
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT3, GL_TEXTURE_2D, 0, 0);
  glUseProgram(0);
  return true;
}

//------------------------------------------------------------------------------
void vtkPointSplatDeferred::ReleaseImages()
{
  const GLuint textures[] = { this->Texels, this->Depths };
  if (this->Texels)
  {
    glDeleteTextures(2, textures);
    glDeleteFramebuffers(1, &this->Framebuffer);
  }
  this->Texels = this->Depths = this->Framebuffer = 0;
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
  this->Geometry.Release();
  this->Compositing.Release();
}
