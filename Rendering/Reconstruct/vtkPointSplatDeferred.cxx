// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatDeferred.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkPointSplatQuads.h"
#include "vtkPointSplatReach.h"
#include "vtkPointSplatSavedState.h"
#include "vtkPointSplatUnits.h"

#include <algorithm>

namespace
{
constexpr vtkIdType BytesPerTexel = 16 + 4;
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
vtkPointSplatProgram* vtkPointSplatDeferred::BuildPrograms(const vtkPointSplatRequest& request)
{
  const bool factors = request.GetFactorCount() > 0;
  const bool lines = request.HasClipLines();
  const std::string defines = factors ? "#define FACTORS\n" : "";
  const std::string colours = request.GetAppearanceDefines(false);
  vtkPointSplatProgram& geometry = this->Geometry[factors ? 1 : 0][lines ? 1 : 0];
  vtkPointSplatProgram& compositing = this->Compositing[defines + colours];
  this->Composite = &compositing;
  const bool built =
    geometry.Build({ { GL_VERTEX_SHADER, "vtkPointSplatGroupVS" },
                     { GL_FRAGMENT_SHADER, "vtkPointSplatGroupFS" } },
      defines + "#define CLIPPING\n#define PLATEAU\n" +
        (lines ? "#define CLIP_LINES\n" : "")) &&
    compositing.BuildScreen("vtkPointSplatCompositeFS", defines + colours);
  this->Error = built ? std::string() : geometry.GetLog() + compositing.GetLog();
  return built ? &geometry : nullptr;
}

//------------------------------------------------------------------------------
void vtkPointSplatDeferred::DrawGroup(
  const vtkPointSplatRequest& request, int group, vtkPointSplatProgram& geometry)
{
  const unsigned int tagMask = request.GetTagMask();
  for (const vtkPointSplatItem& item : request.Items)
  {
    const std::pair<vtkIdType, vtkIdType> range = item.Cloud->GetGroups().GetGroup(group);
    if (range.second == 0 || !item.IsInView())
    {
      continue;
    }
    vtkPointSplatQuads::SetUniforms(geometry, item, request.View, tagMask);
    geometry.Set("Reach", static_cast<float>(item.Kernel.Support));
    geometry.Set("LeastRadii", glm::vec2(vtkPointSplatReach::Prefilter));
    geometry.Set("DiskReach", vtkPointSplatReach::Disk);
    geometry.Set("CoverageRadii",
      glm::vec2(vtkPointSplatReach::Coverage, vtkPointSplatReach::CoverageDot));
    geometry.Set("DepthUnit", static_cast<float>(request.GetDepthUnit()));
    geometry.Set("VoronoiScale", static_cast<float>(request.GetVoronoiScale()));
    vtkPointSplatQuads::DrawRun(item, item.Cloud->UploadGrouped(), range.first, range.second);
  }
}

//------------------------------------------------------------------------------
bool vtkPointSplatDeferred::Reconstruct(
  const vtkPointSplatRequest& request, vtkPointSplatLayers& layers)
{
  const bool factors = request.GetFactorCount() > 0;
  const std::string colours = request.GetAppearanceDefines(false);
  const glm::ivec2& size = request.View.Size;
  vtkPointSplatProgram* geometry = this->BuildPrograms(request);
  if (!geometry)
  {
    return false;
  }
  int groups = 1;
  for (const vtkPointSplatItem& item : request.Items)
  {
    groups = std::max(groups, item.Cloud->GetGroups().GetNumberOfGroups());
  }
  this->Texels.Allocate(size, groups);
  this->Depths.Allocate(size, groups);
  if (factors)
  {
    this->Factors.Allocate(size, groups);
  }
  layers.AllocateImages(size, 1, request.GetFactorCount(), false);
  layers.SetNumberOfLayers(1);
  layers.SetGathered(-1);

  vtkOpenGLRenderWindow* window = vtkPointSplatContext::Entered().GetWindow();
  vtkOpenGLState* state = window->GetState();
  const vtkPointSplatSavedState saved(state);
  saved.SetForImages(size);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LESS);
  state->vtkglDepthMask(GL_TRUE);
  geometry->Use();
  const GLfloat farthest = 1.0f;
  for (int group = 0; group < groups; ++group)
  {
    std::vector<vtkPointSplatFramebuffer::Target> targets{ { this->Texels, group } };
    if (factors)
    {
      targets.emplace_back(this->Factors, group);
    }
    this->GroupFramebuffer.Bind(state, targets, { this->Depths, group });
    glClearBufferfv(GL_DEPTH, 0, &farthest);
    this->DrawGroup(request, group, *geometry);
  }

  std::vector<vtkPointSplatFramebuffer::Target> targets{ layers.GetTexelImage() };
  if (factors)
  {
    targets.emplace_back(layers.GetFactorImage());
  }
  this->Result.Bind(state, targets);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_FALSE);
  vtkPointSplatProgram& compositing = *this->Composite;
  compositing.Use();
  vtkPointSplatUnits units(window);
  units.Bind(compositing, "Texels", GL_TEXTURE_2D_ARRAY, this->Texels.Get());
  units.Bind(compositing, "GroupDepths", GL_TEXTURE_2D_ARRAY, this->Depths.Get());
  units.Bind(
    compositing, "FactorTexels", GL_TEXTURE_2D_ARRAY, factors ? this->Factors.Get() : 0);
  if (!colours.empty())
  {
    this->Items.Upload(request.Items, request.View);
    units.Bind(compositing, "ItemTable", GL_TEXTURE_BUFFER, this->Items.GetTexture());
    units.Bind(compositing, "ValueTables", GL_TEXTURE_BUFFER, this->Items.GetValueTables());
  }
  compositing.Set("DepthUnit", static_cast<float>(request.GetDepthUnit()));
  compositing.Set("GroupCount", groups);
  compositing.Set("LastPixel", size - 1);
  compositing.Set("TagMask", request.GetTagMask());
  this->Screen.Draw();
  return true;
}

//------------------------------------------------------------------------------
vtkIdType vtkPointSplatDeferred::GetMemorySize() const
{
  return this->Texels.GetMemorySize() + this->Depths.GetMemorySize() +
    this->Factors.GetMemorySize();
}

//------------------------------------------------------------------------------
void vtkPointSplatDeferred::Release()
{
  for (vtkPointSplatProgram(&programs)[2] : this->Geometry)
  {
    programs[0].Release();
    programs[1].Release();
  }
  this->Compositing.clear();
  this->Items.Release();
  this->Texels.Release();
  this->Depths.Release();
  this->Factors.Release();
  this->GroupFramebuffer.Release();
  this->Result.Release();
  this->Screen.Release();
}
