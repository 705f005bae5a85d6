// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatRefraction.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkPointSplatImages.h"
#include "vtkPointSplatMapper.h"
#include "vtkPointSplatResolve.h"
#include "vtkPointSplatSavedState.h"
#include "vtkPointSplatUnits.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace
{
using Vectors3 = const float (*)[3];
using Vectors4 = const float (*)[4];

/**
 * A box that grows by the world bounds of items.
 */
struct Box
{
  glm::dvec3 Low{ 1e300 };
  glm::dvec3 High{ -1e300 };
  void Add(const vtkPointSplatItem& item)
  {
    const double* b = item.Cloud->GetBounds().data();
    for (int corner = 0; corner < 8; ++corner)
    {
      const glm::dvec3 p(item.MCWC *
        glm::dvec4(b[corner & 1], b[2 + ((corner >> 1) & 1)], b[4 + ((corner >> 2) & 1)], 1.0));
      this->Low = glm::min(this->Low, p);
      this->High = glm::max(this->High, p);
    }
  }
  float Diagonal() const { return static_cast<float>(glm::length(this->High - this->Low)); }
};

void SetStateForImages(vtkOpenGLState* state, const glm::ivec2& size)
{
  state->vtkglViewport(0, 0, size.x, size.y);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglDisable(GL_BLEND);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}
}

//------------------------------------------------------------------------------
bool vtkPointSplatRefraction::IsNeeded(const vtkPointSplatLayers& layers)
{
  const std::vector<vtkPointSplatItem>& items = layers.GetRequest().Items;
  return layers.GetNumberOfLayers() > 0 &&
    std::any_of(items.begin(), items.end(), [](const vtkPointSplatItem& i) { return i.Refracts; });
}

//------------------------------------------------------------------------------
void vtkPointSplatRefraction::DrawTriangle()
{
  if (!this->VertexArray)
  {
    glGenVertexArrays(1, &this->VertexArray);
  }
  glBindVertexArray(this->VertexArray);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
}

//------------------------------------------------------------------------------
bool vtkPointSplatRefraction::MakeInterfaces(
  vtkOpenGLRenderWindow* window, vtkPointSplatLayers& layers)
{
  if (this->Source == &layers && this->Generation == layers.GetGeneration())
  {
    return true;
  }
  const vtkPointSplatLayersRequest& request = layers.GetRequest();
  int count = std::min(layers.GetNumberOfLayers(), MaximumInterfaces);
  // A layer of all that is left has no one normal.
  count -= count > 1 && layers.IsGathered(count - 1) ? 1 : 0;

  std::string fragment = vtkPointSplatProgram::Source("vtkPointSplatInterfaceFS");
  vtkShaderProgram::Substitute(fragment, "//PointSplat::Defines",
    layers.GetImages(0).GetDefines());
  vtkShaderProgram* program = window->GetShaderCache()->ReadyShaderProgram(
    vtkPointSplatProgram::Source("vtkPointSplatResolveVS").c_str(), fragment.c_str(), "");
  if (!program)
  {
    this->Error = "the shaders of interfaces do not build.";
    return false;
  }

  vtkOpenGLState* state = window->GetState();
  const vtkPointSplatSavedState saved(state);
  const glm::ivec3 size(request.View.Size, count);
  if (this->Size != size)
  {
    glDeleteTextures(1, &this->Interfaces);
    this->Size = size;
    vtkOpenGLState::ScopedglActiveTexture active(state);
    const int unit = window->GetTextureUnitManager()->Allocate();
    state->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned>(unit));
    glGenTextures(1, &this->Interfaces);
    glBindTexture(GL_TEXTURE_2D_ARRAY, this->Interfaces);
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA32F, size.x, size.y, size.z, 0, GL_RGBA, GL_FLOAT,
      nullptr);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, 0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
    window->GetTextureUnitManager()->Free(unit);
  }
  if (!this->InterfaceFramebuffer)
  {
    glGenFramebuffers(1, &this->InterfaceFramebuffer);
  }
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->InterfaceFramebuffer);
  SetStateForImages(state, request.View.Size);
  GLenum first = GL_COLOR_ATTACHMENT0;
  const GLfloat nothing[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
  vtkPointSplatResolve::SetView(request.View, layers.GetDepthUnit(), program);
  // Images hold nothing of worth where no item can be.
  glm::ivec4 covered(request.View.Size, -1, -1);
  for (const vtkPointSplatItem& item : request.Items)
  {
    if (item.Window.x <= item.Window.z && item.Window.y <= item.Window.w)
    {
      covered = glm::ivec4(glm::min(glm::ivec2(covered), glm::ivec2(item.Window)),
        glm::max(glm::ivec2(covered.z, covered.w), glm::ivec2(item.Window.z, item.Window.w)));
    }
  }
  const glm::ivec2 extent =
    glm::max(glm::ivec2(covered.z, covered.w) - glm::ivec2(covered) + 1, 0);
  for (int layer = 0; layer < count; ++layer)
  {
    glFramebufferTextureLayer(
      GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, this->Interfaces, 0, layer);
    glDrawBuffers(1, &first);
    state->vtkglDisable(GL_SCISSOR_TEST);
    glClearBufferfv(GL_COLOR, 0, nothing);
    state->vtkglEnable(GL_SCISSOR_TEST);
    state->vtkglScissor(covered.x, covered.y, extent.x, extent.y);
    vtkPointSplatImages& images = layers.GetImages(layer);
    images.Bind(window, program, false);
    this->DrawTriangle();
    images.Unbind(window);
  }
  this->Count = count;
  this->Source = &layers;
  this->Generation = layers.GetGeneration();
  return true;
}

//------------------------------------------------------------------------------
void vtkPointSplatRefraction::SetMedia(const std::vector<vtkPointSplatMapper*>& mappers,
  const vtkPointSplatLayersRequest& request, vtkShaderProgram* program) const
{
  std::vector<glm::vec4> media;
  std::vector<glm::vec3> absorptions;
  Box all;
  for (size_t i = 0; i < mappers.size(); ++i)
  {
    const vtkPointSplatItem& item = request.Items[i];
    const double index = mappers[i]->GetRefractiveIndex();
    const double* absorption = mappers[i]->GetAbsorption();
    Box own;
    own.Add(item);
    media.emplace_back(
      index, 0.5 * index * mappers[i]->GetDispersion(), own.Diagonal(), item.Refracts ? 1.0 : 0.0);
    absorptions.emplace_back(absorption[0], absorption[1], absorption[2]);
    if (item.Refracts)
    {
      all.Add(item);
    }
  }
  const int count = static_cast<int>(media.size());
  program->SetUniform4fv("Medium", count, reinterpret_cast<Vectors4>(media.data()));
  program->SetUniform3fv("Absorption", count, reinterpret_cast<Vectors3>(absorptions.data()));
  program->SetUniformf("SceneReach", all.Diagonal());
}

//------------------------------------------------------------------------------
bool vtkPointSplatRefraction::Draw(vtkRenderer* renderer,
  const std::vector<vtkPointSplatMapper*>& mappers, vtkPointSplatLayers& layers,
  const vtkPointSplatEnvironment& environment, GLuint layerCounts)
{
  auto window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  if (!this->MakeInterfaces(window, layers))
  {
    return false;
  }
  const vtkPointSplatLayersRequest& request = layers.GetRequest();
  std::string defines = environment.GetDefines();
  for (size_t i = 0; i < mappers.size(); ++i)
  {
    if (request.Items[i].Refracts && mappers[i]->GetDispersion() > 0.0)
    {
      defines += "#define DISPERSION\n";
      break;
    }
  }
  if (layerCounts)
  {
    defines += "#define LAYER_COUNT\n";
  }
  std::string fragment = vtkPointSplatProgram::Source("vtkPointSplatRefractionFS");
  vtkShaderProgram::Substitute(fragment, "//PointSplat::Defines", defines);
  vtkShaderProgram* program = window->GetShaderCache()->ReadyShaderProgram(
    vtkPointSplatProgram::Source("vtkPointSplatResolveVS").c_str(), fragment.c_str(), "");
  if (!program)
  {
    this->Error = "the shaders of refraction do not build.";
    return false;
  }
  vtkPointSplatResolve::SetView(request.View, layers.GetDepthUnit(), program);
  this->SetMedia(mappers, request, program);
  program->SetUniformi("InterfaceCount", this->Count);
  program->SetUniformi("HasSceneDepth", request.SceneDepth ? 1 : 0);
  environment.Bind(request.View, program);
  {
    vtkPointSplatUnits units(window);
    vtkPointSplatProgram borrowed;
    borrowed.Borrow(static_cast<GLuint>(program->GetHandle()));
    units.Bind(borrowed, "Interfaces", GL_TEXTURE_2D_ARRAY, this->Interfaces);
    units.Bind(borrowed, "SceneDepth", GL_TEXTURE_2D, request.SceneDepth);
    if (layerCounts)
    {
      units.Bind(borrowed, "LayerCounts", GL_TEXTURE_2D, layerCounts);
    }
    this->DrawTriangle();
  }
  environment.Unbind();
  return true;
}

//------------------------------------------------------------------------------
bool vtkPointSplatRefraction::DrawImages(vtkRenderer* renderer,
  const std::vector<vtkPointSplatMapper*>& mappers, vtkPointSplatLayers& layers,
  const vtkPointSplatEnvironment& environment)
{
  auto window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  const glm::ivec2 size = layers.GetRequest().View.Size;
  vtkOpenGLState* state = window->GetState();
  const vtkPointSplatSavedState saved(state);
  if (!this->ImageFramebuffer)
  {
    glGenFramebuffers(1, &this->ImageFramebuffer);
  }
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->ImageFramebuffer);
  if (this->ImageSize != size)
  {
    const GLuint old[] = { this->Colour, this->Depth };
    glDeleteTextures(2, old);
    this->ImageSize = size;
    vtkOpenGLState::ScopedglActiveTexture active(state);
    const int unit = window->GetTextureUnitManager()->Allocate();
    state->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned>(unit));
    this->Colour = vtkPointSplatImages::MakeTexture(size, GL_RGBA16F, GL_RGBA, GL_FLOAT);
    this->Depth = vtkPointSplatImages::MakeTexture(size, GL_R32F, GL_RED, GL_FLOAT);
    window->GetTextureUnitManager()->Free(unit);
    glFramebufferTexture2D(
      GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, this->Colour, 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, this->Depth, 0);
  }
  GLenum both[] = { GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1 };
  glDrawBuffers(2, both); // past the state, which takes another framebuffer's second one for this
  SetStateForImages(state, size);
  const GLfloat nothing[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
  const GLfloat farthest[4] = { 1.0f, 1.0f, 1.0f, 1.0f };
  glClearBufferfv(GL_COLOR, 0, nothing);
  glClearBufferfv(GL_COLOR, 1, farthest);
  const bool good = this->Draw(renderer, mappers, layers, environment, 0);
  return good;
}

//------------------------------------------------------------------------------
vtkIdType vtkPointSplatRefraction::GetMemorySize() const
{
  return vtkIdType(16) * this->Size.x * this->Size.y * this->Size.z +
    vtkIdType(12) * this->ImageSize.x * this->ImageSize.y;
}

//------------------------------------------------------------------------------
void vtkPointSplatRefraction::Release()
{
  if (this->VertexArray)
  {
    const GLuint textures[] = { this->Interfaces, this->Colour, this->Depth };
    const GLuint framebuffers[] = { this->InterfaceFramebuffer, this->ImageFramebuffer };
    glDeleteTextures(3, textures);
    glDeleteFramebuffers(2, framebuffers);
    glDeleteVertexArrays(1, &this->VertexArray);
  }
  this->Interfaces = this->Colour = this->Depth = this->InterfaceFramebuffer =
    this->ImageFramebuffer = this->VertexArray = 0;
  this->Size = glm::ivec3(0);
  this->ImageSize = glm::ivec2(0);
  this->Source = nullptr;
}
