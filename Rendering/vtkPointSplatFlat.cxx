// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatFlat.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkPointSplatImages.h"
#include "vtkPointSplatSavedState.h"
#include "vtkPointSplatUnits.h"
#include "vtkRenderer.h"

//------------------------------------------------------------------------------
void vtkPointSplatFlat::Allocate(vtkOpenGLRenderWindow* window, const glm::ivec2& size)
{
  if (this->Framebuffer && this->Size == size)
  {
    return;
  }
  this->Release();
  this->Size = size;
  vtkOpenGLState::ScopedglActiveTexture active(window->GetState());
  const int unit = window->GetTextureUnitManager()->Allocate();
  window->GetState()->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned>(unit));
  this->Colour = vtkPointSplatImages::MakeTexture(size, GL_RGBA16F, GL_RGBA, GL_FLOAT);
  this->Depth = vtkPointSplatImages::MakeTexture(size, GL_R32F, GL_RED, GL_FLOAT);
  window->GetTextureUnitManager()->Free(unit);
  glGenFramebuffers(1, &this->Framebuffer);
}

//------------------------------------------------------------------------------
void vtkPointSplatFlat::ClearLayerCount(vtkOpenGLRenderWindow* window)
{
  if (!this->LayerCount)
  {
    vtkOpenGLState::ScopedglActiveTexture active(window->GetState());
    const int unit = window->GetTextureUnitManager()->Allocate();
    window->GetState()->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned>(unit));
    this->LayerCount = vtkPointSplatImages::MakeTexture(this->Size, GL_RG16F, GL_RG, GL_FLOAT);
    glBindTexture(GL_TEXTURE_2D, 0);
    window->GetTextureUnitManager()->Free(unit);
  }
  glFramebufferTexture2D(
    GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT2, GL_TEXTURE_2D, this->LayerCount, 0);
  GLenum third = GL_COLOR_ATTACHMENT2;
  const GLfloat nothing[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
  glDrawBuffers(1, &third);
  window->GetState()->vtkglDisable(GL_SCISSOR_TEST);
  window->GetState()->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glClearBufferfv(GL_COLOR, 0, nothing);
}

//------------------------------------------------------------------------------
bool vtkPointSplatFlat::Blend(vtkRenderer* renderer, const std::vector<Part>& parts,
  vtkPointSplatLayers& layers, vtkPointSplatResolve& resolve, SortedLayers sorted,
  vtkPointSplatRefraction& refraction, const vtkPointSplatEnvironment* environment)
{
  auto window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  const vtkPointSplatLayersRequest& request = layers.GetRequest();
  this->Allocate(window, request.View.Size);
  const bool refracts = environment && vtkPointSplatRefraction::IsNeeded(layers);
  const bool countLayers = refracts && sorted != None;

  vtkOpenGLState* state = window->GetState();
  const vtkPointSplatSavedState saved(state);
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->Framebuffer);
  glFramebufferTexture2D(
    GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, this->Colour, 0);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, this->Depth, 0);
  glFramebufferTexture2D(
    GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, request.SceneDepth, 0);
  GLenum both[] = { GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1 };
  if (countLayers)
  {
    this->ClearLayerCount(window);
  }
  glDrawBuffers(2, both); // past the state, which takes another framebuffer's second one for this
  state->vtkglViewport(0, 0, this->Size.x, this->Size.y);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglDepthFunc(GL_LEQUAL);
  const GLfloat nothing[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
  const GLfloat farthest[4] = { 1.0f, 1.0f, 1.0f, 1.0f };
  glClearBufferfv(GL_COLOR, 0, nothing);
  glClearBufferfv(GL_COLOR, 1, farthest);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendEquation(GL_FUNC_ADD); // depth peeling takes maxima
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  // Depths are not blended: the last, nearest layer's stays.
  glDisablei(GL_BLEND, 1);

  bool good = true;
  if (sorted != None)
  {
    std::vector<vtkActor*> actors;
    for (const Part& part : parts)
    {
      actors.push_back(part.Actor);
    }
    good = this->Sorted.Draw(renderer, actors, request,
      layers.GetNumberOfLayers() > 0 ? &layers.GetImages(0) : nullptr, sorted == All,
      layers.GetDepthUnit() / 5.0f, this->Framebuffer, countLayers);
    glDisablei(GL_BLEND, 1);
  }

  vtkPointSplatView view = request.View;
  view.Origin = glm::ivec2(0);
  // Where all layers are sorted, there is one for what it reflects and refracts.
  const vtkPointSplatResolve::Output output =
    sorted == All ? vtkPointSplatResolve::Reflected : vtkPointSplatResolve::Flattened;
  for (int layer = layers.GetNumberOfLayers() - 1; layer >= 0; --layer)
  {
    for (size_t i = 0; i < parts.size(); ++i)
    {
      good = resolve.Present(renderer, parts[i].Actor, parts[i].Mapper, view, request.Items[i],
               layers.GetImages(layer), layers.GetDepthUnit(), output, 0,
               layers.IsGathered(layer)) &&
        good;
    }
  }
  glEnablei(GL_BLEND, 1);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, 0, 0);
  if (refracts)
  {
    // Under all that is there; the depth stays the nearest layer's.
    std::vector<vtkPointSplatMapper*> mappers;
    for (const Part& part : parts)
    {
      mappers.push_back(part.Mapper);
    }
    glDrawBuffers(1, both);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT2, GL_TEXTURE_2D, 0, 0); // is read
    state->vtkglDisable(GL_DEPTH_TEST);
    state->vtkglDisable(GL_CULL_FACE);
    state->vtkglBlendFuncSeparate(GL_ONE_MINUS_DST_ALPHA, GL_ONE, GL_ONE_MINUS_DST_ALPHA, GL_ONE);
    good = refraction.Draw(renderer, mappers, layers, *environment,
             countLayers ? this->LayerCount : 0) &&
      good;
  }
  return good;
}

//------------------------------------------------------------------------------
bool vtkPointSplatFlat::Present(vtkRenderer* renderer, vtkActor* actor,
  vtkPointSplatMapper* mapper, const vtkPointSplatView& view, vtkPointSplatResolve& resolve)
{
  return resolve.PresentFlat(renderer, actor, mapper, view, this->Colour, this->Depth);
}

//------------------------------------------------------------------------------
void vtkPointSplatFlat::Release()
{
  if (this->Framebuffer)
  {
    const GLuint textures[] = { this->Colour, this->Depth, this->LayerCount };
    glDeleteTextures(3, textures);
    glDeleteFramebuffers(1, &this->Framebuffer);
  }
  this->Colour = this->Depth = this->LayerCount = this->Framebuffer = 0;
  this->Sorted.Release();
  this->Size = glm::ivec2(0);
}
