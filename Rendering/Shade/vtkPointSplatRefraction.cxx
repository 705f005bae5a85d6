// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatRefraction.h"

#include "vtkPointSplatUnits.h"

#include <algorithm>

//------------------------------------------------------------------------------
bool vtkPointSplatRefraction::Draw(const vtkPointSplatShading& shading,
  const vtkPointSplatRequest& request, const vtkPointSplatLayers& layers,
  const vtkPointSplatImage* layerCounts)
{
  const std::string defines = layers.GetDefines() + shading.GetDefines(false) +
    (shading.Materials->Disperses() ? "#define DISPERSION\n" : "") +
    (layerCounts ? "#define LAYER_COUNT\n" : "");
  vtkPointSplatProgram& program = this->Programs[defines];
  if (!program.BuildScreen("vtkPointSplatRefractionFS", defines))
  {
    this->Error = program.GetLog();
    return false;
  }
  // A layer of all that is left has no one normal.
  const int count = layers.GetNumberOfLayers();
  const bool gathered = count > 1 && layers.GetGathered() == count - 1;
  program.Use();
  {
    vtkPointSplatUnits units(vtkPointSplatContext::Entered().GetWindow());
    layers.Bind(units, program);
    shading.Bind(units, program, 0);
    units.Bind(program, "SceneDepth", GL_TEXTURE_2D, request.SceneDepth);
    units.Bind(program, "LayerCounts", GL_TEXTURE_2D, layerCounts ? layerCounts->Get() : 0);
    program.Set("HasSceneDepth", request.SceneDepth != 0);
    program.Set("InterfaceCount", std::min(gathered ? count - 1 : count, MaximumInterfaces));
    program.Set("LayerWindow", request.GetWindow());
    this->Screen.Draw();
    shading.Unbind();
  }
  glUseProgram(0);
  return true;
}

//------------------------------------------------------------------------------
void vtkPointSplatRefraction::Release()
{
  this->Programs.clear();
  this->Screen.Release();
}
