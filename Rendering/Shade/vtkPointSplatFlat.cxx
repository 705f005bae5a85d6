// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatFlat.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkPointSplatSavedState.h"
#include "vtkPointSplatUnits.h"

namespace
{
vtkOpenGLState* State()
{
  return vtkPointSplatContext::Entered().GetWindow()->GetState();
}
}

//------------------------------------------------------------------------------
void vtkPointSplatFlat::Begin(const vtkPointSplatRequest& request,
  const vtkPointSplatSavedState& saved, vtkPointSplatFlatImages& to)
{
  vtkOpenGLState* state = State();
  to.Colour.Allocate(request.View.Size);
  to.Depth.Allocate(request.View.Size);
  this->Framebuffer.Bind(state, { to.Colour, to.Depth });
  saved.SetForImages(request.View.Size);
  // Nobody looks at what is beside the window.
  const glm::ivec4 window = request.GetWindow();
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(
    window.x, window.y, window.z - window.x + 1, window.w - window.y + 1);
  const GLfloat nothing[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
  const GLfloat farthest[4] = { 1.0f, 1.0f, 1.0f, 1.0f };
  glClearBufferfv(GL_COLOR, 0, nothing);
  glClearBufferfv(GL_COLOR, 1, farthest);
}

//------------------------------------------------------------------------------
bool vtkPointSplatFlat::Blend(const vtkPointSplatShading& shading,
  const vtkPointSplatRequest& request, const vtkPointSplatLayers& layers, SortedLayers sorted,
  vtkPointSplatFlatImages& to)
{
  const vtkPointSplatSavedState saved(State());
  const bool hasLayers = layers.GetNumberOfLayers() > 0;
  const bool refracts = hasLayers && shading.Reflects();
  const bool counts = refracts && sorted != None;
  this->Begin(request, saved, to);
  bool good = sorted == None ||
    this->DrawSorted(
      { shading, request, hasLayers ? &layers : nullptr, sorted == All, counts }, to);
  if (hasLayers)
  {
    // Where all layers are sorted, there is one for what it reflects and refracts.
    good = this->DrawLayers(shading, layers, sorted == All) && good;
  }
  if (refracts)
  {
    // Depths, whose opacity is 1, stay as they are.
    State()->vtkglBlendFuncSeparate(
      GL_ONE_MINUS_DST_ALPHA, GL_ONE, GL_ONE_MINUS_DST_ALPHA, GL_ONE);
    good = this->DrawRefracted(
             shading, request, layers, counts ? &this->Sorted.GetLayerCount() : nullptr) &&
      good;
  }
  return good;
}

//------------------------------------------------------------------------------
bool vtkPointSplatFlat::Refract(const vtkPointSplatShading& shading,
  const vtkPointSplatRequest& request, const vtkPointSplatLayers& layers,
  vtkPointSplatFlatImages& to)
{
  const vtkPointSplatSavedState saved(State());
  this->Begin(request, saved, to);
  return this->DrawRefracted(shading, request, layers, nullptr);
}

//------------------------------------------------------------------------------
bool vtkPointSplatFlat::DrawSorted(
  const vtkPointSplatSorted::Scene& scene, const vtkPointSplatFlatImages& to)
{
  const bool good = this->Sorted.Draw(scene, to.Colour, to.Depth);
  this->Error = good ? this->Error : this->Sorted.GetError();
  this->Framebuffer.Bind(State(), { to.Colour, to.Depth });
  return good;
}

//------------------------------------------------------------------------------
bool vtkPointSplatFlat::DrawLayers(const vtkPointSplatShading& shading,
  const vtkPointSplatLayers& layers, bool reflectionAlone)
{
  const std::string defines = layers.GetDefines() +
    shading.GetDefines(layers.GetGathered() >= 0) +
    (reflectionAlone ? "#define REFLECTION_ALONE\n" : "");
  vtkPointSplatProgram& program = this->Programs[defines];
  if (!program.Build({ { GL_VERTEX_SHADER, "vtkPointSplatLayersVS" },
                       { GL_FRAGMENT_SHADER, "vtkPointSplatFlattenFS" } },
        defines))
  {
    this->Error = program.GetLog();
    return false;
  }
  State()->vtkglEnable(GL_BLEND);
  State()->vtkglBlendEquation(GL_FUNC_ADD); // depth peeling takes maxima
  State()->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  program.Use();
  {
    vtkPointSplatUnits units(vtkPointSplatContext::Entered().GetWindow());
    layers.Bind(units, program);
    shading.Bind(units, program, layers.GetFactorCount());
    this->Screen.DrawRectangles(layers.GetNumberOfRectangles());
    shading.Unbind();
  }
  glUseProgram(0);
  return true;
}

//------------------------------------------------------------------------------
bool vtkPointSplatFlat::DrawRefracted(const vtkPointSplatShading& shading,
  const vtkPointSplatRequest& request, const vtkPointSplatLayers& layers,
  const vtkPointSplatImage* layerCounts)
{
  const bool good = this->Refraction.Draw(shading, request, layers, layerCounts);
  this->Error = good ? this->Error : this->Refraction.GetError();
  return good;
}

//------------------------------------------------------------------------------
void vtkPointSplatFlat::Release()
{
  this->Sorted.Release();
  this->Refraction.Release();
  this->Programs.clear();
  this->Screen.Release();
  this->Framebuffer.Release();
}
