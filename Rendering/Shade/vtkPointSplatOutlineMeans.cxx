// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatOutlineMeans.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkPointSplatFlat.h"
#include "vtkPointSplatLayers.h"
#include "vtkPointSplatOutlines.h"
#include "vtkPointSplatShading.h"
#include "vtkPointSplatUnits.h"

namespace
{
constexpr GLsizeiptr MeanBytes = 16;
}

//------------------------------------------------------------------------------
bool vtkPointSplatOutlineMeans::Use(const std::string& defines, vtkPointSplatUnits& units,
  const vtkPointSplatOutlines& outlines, vtkPointSplatProgram*& program)
{
  program = &this->Programs[defines];
  if (!program->Build({ { GL_COMPUTE_SHADER, "vtkPointSplatOutlineMeanCS" } }, defines))
  {
    this->Error = program->GetLog();
    return false;
  }
  // Else VTK takes its program of the layer before for the current one, and nothing is drawn.
  vtkPointSplatContext::Entered().GetWindow()->GetShaderCache()->ReleaseCurrentShader();
  program->Use();
  this->Means.Reserve(MeanBytes * outlines.GetCount()); // binds its texture: before others are bound
  this->Means.BindStorage(0);
  outlines.Bind(units, *program);
  program->Set("OutlineCount", outlines.GetCount());
  return true;
}

//------------------------------------------------------------------------------
bool vtkPointSplatOutlineMeans::Shade(const vtkPointSplatShading& shading,
  const vtkPointSplatLayers& layers, const vtkPointSplatOutlines& outlines, const Wanted& wanted)
{
  vtkPointSplatUnits units(vtkPointSplatContext::Entered().GetWindow());
  vtkPointSplatProgram* program = nullptr;
  if (!this->Use(layers.GetDefines() + shading.GetDefines(layers.GetGathered() >= 0), units,
        outlines, program))
  {
    return false;
  }
  layers.Bind(units, *program);
  shading.Bind(units, *program, layers.GetFactorCount());
  program->Set("Layer", wanted.Layer);
  program->Set("OnlySlot", wanted.Slot);
  program->Set("Blends", wanted.Blends);
  vtkPointSplatProgram::Dispatch(outlines.GetCount());
  shading.Unbind();
  glUseProgram(0);
  return true;
}

//------------------------------------------------------------------------------
bool vtkPointSplatOutlineMeans::Flatten(
  const vtkPointSplatFlatImages& images, const vtkPointSplatOutlines& outlines)
{
  vtkPointSplatUnits units(vtkPointSplatContext::Entered().GetWindow());
  vtkPointSplatProgram* program = nullptr;
  if (!this->Use("#define FLAT\n", units, outlines, program))
  {
    return false;
  }
  units.Bind(*program, "Flattened", GL_TEXTURE_2D, images.Colour.Get());
  units.Bind(*program, "NearestDepths", GL_TEXTURE_2D, images.Depth.Get());
  vtkPointSplatProgram::Dispatch(outlines.GetCount());
  glUseProgram(0);
  return true;
}

//------------------------------------------------------------------------------
void vtkPointSplatOutlineMeans::Bind(
  vtkPointSplatUnits& units, vtkPointSplatProgram& program) const
{
  units.Bind(program, "OutlineMeans", GL_TEXTURE_BUFFER, this->Means.GetTexture());
}

//------------------------------------------------------------------------------
void vtkPointSplatOutlineMeans::Release()
{
  this->Means.Release();
  this->Programs.clear();
}
