// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatSorted.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPointSplatReach.h"
#include "vtkPointSplatSavedState.h"
#include "vtkPointSplatUnits.h"

#include <algorithm>

namespace
{
// Splats that are drawn by one call: their vertices are named by 16 bits.
constexpr int QuadsAtOnce = 1 << 14;

vtkOpenGLRenderWindow* Window()
{
  return vtkPointSplatContext::Entered().GetWindow();
}

std::vector<GLushort> CornersOfQuads()
{
  std::vector<GLushort> corners;
  corners.reserve(6 * QuadsAtOnce);
  for (int i = 0; i < 4 * QuadsAtOnce; i += 4)
  {
    for (const int corner : { 0, 1, 2, 2, 1, 3 })
    {
      corners.push_back(static_cast<GLushort>(i + corner));
    }
  }
  return corners;
}

/// Sets the uniforms of vtkPointSplatSortedVS and vtkPointSplatSortedFS that are an item's group's.
void SetItem(vtkPointSplatProgram& program, vtkPointSplatUnits& units,
  const vtkPointSplatItem& item, const vtkPointSplatView& view, int group)
{
  item.SetUniforms(program, view);
  program.Set("RadiusScale",
    static_cast<float>(item.RadiusScale * item.Cloud->GetGroups().GetScale(group)));
  vtkPointSplatCloud::Buffers& buffers = item.Cloud->Upload();
  const bool colours = item.Cloud->HasColours();
  units.Bind(program, "Splats", GL_TEXTURE_BUFFER, buffers.Splats.GetTexture());
  units.Bind(
    program, "Colours", GL_TEXTURE_BUFFER, colours ? buffers.Colours.GetTexture() : 0);
  units.Bind(
    program, "Factors", GL_TEXTURE_BUFFER, item.Factors ? item.Factors->GetTexture() : 0);
  units.Bind(program, "ValueTables", GL_TEXTURE_BUFFER,
    item.Cloud->HasValues() ? buffers.ValueTable.GetTexture() : 0);
  program.Set("ValueMap", item.GetValueMap());
  const bool lines = item.Cloud->HasClipLines();
  units.Bind(
    program, "ClipLineTexels", GL_TEXTURE_BUFFER, lines ? buffers.ClipLines.GetTexture() : 0);
  program.Set("HasClipLines", lines);
  program.Set("HasColours", colours);
  program.Set("HasFactors", item.Factors != nullptr);
}
}

//------------------------------------------------------------------------------
vtkPointSplatProgram* vtkPointSplatSorted::Use(
  const char* vertex, const char* fragment, const std::string& defines)
{
  vtkPointSplatProgram& program = this->Programs[fragment + defines];
  if (!program.Build({ { GL_VERTEX_SHADER, vertex }, { GL_FRAGMENT_SHADER, fragment } }, defines))
  {
    this->Error = program.GetLog();
    return nullptr;
  }
  program.Use();
  return &program;
}

//------------------------------------------------------------------------------
std::vector<vtkPointSplatSorted::Batch> vtkPointSplatSorted::Sort(
  const vtkPointSplatRequest& request, int group, std::vector<uint32_t>& order)
{
  struct Entry
  {
    double Z; // in view coordinates: the farthest has the least
    size_t Item;
    const vtkPointSplatGroups::Leaf* Leaf;
  };
  std::vector<Entry> entries;
  for (size_t i = 0; i < request.Items.size(); ++i)
  {
    const vtkPointSplatItem& item = request.Items[i];
    const glm::dmat4 MCVC = request.View.WCVC * item.MCWC;
    for (const vtkPointSplatGroups::Leaf& leaf : item.Cloud->GetGroups().GetLeaves(group))
    {
      const glm::dvec4 p =
        MCVC * glm::dvec4(leaf.Centre[0], leaf.Centre[1], leaf.Centre[2], 1.0);
      entries.push_back({ p.z, i, &leaf });
    }
  }
  std::stable_sort(entries.begin(), entries.end(),
    [](const Entry& a, const Entry& b) { return a.Z < b.Z; });
  std::vector<Batch> batches;
  order.clear();
  for (const Entry& entry : entries)
  {
    const vtkPointSplatGroups::Leaf& leaf = *entry.Leaf;
    if (batches.empty() || batches.back().Item != entry.Item)
    {
      batches.push_back({ entry.Item, static_cast<int>(order.size()), 0 });
    }
    batches.back().Count += static_cast<int>(leaf.Count);
    const auto first =
      request.Items[entry.Item].Cloud->GetGroups().GetOrder().begin() + leaf.First;
    order.insert(order.end(), first, first + leaf.Count);
  }
  return batches;
}

//------------------------------------------------------------------------------
bool vtkPointSplatSorted::DrawGroup(const Scene& scene, int group)
{
  const vtkPointSplatRequest& request = scene.Request;
  const vtkPointSplatView& view = request.View;
  const int factors = request.GetFactorCount();
  const bool clips = std::any_of(request.Items.begin(), request.Items.end(),
    [](const vtkPointSplatItem& item) { return !item.ClipPlanes.empty(); });
  vtkPointSplatProgram* program = this->Use("vtkPointSplatSortedVS", "vtkPointSplatSortedFS",
    scene.Shading.GetDefines(false) +
      (scene.Nearest ? "#define NEAREST\n" + scene.Nearest->GetDefines()
          : factors > 0 ? "#define FACTORS\n"
                        : "") +
      (clips ? "#define CLIPPING\n" : "") + (request.HasValues() ? "#define VALUES\n" : "") +
        (request.HasClipLines() ? "#define CLIP_LINES\n" : "") +
        (scene.CountLayers ? "#define LAYER_COUNT\n" : ""));
  if (!program)
  {
    return false;
  }
  std::vector<uint32_t> order;
  const std::vector<Batch> batches = vtkPointSplatSorted::Sort(request, group, order);
  this->Order.Upload(order);
  vtkPointSplatUnits units(Window());
  scene.Shading.Bind(units, *program, factors);
  if (scene.Nearest)
  {
    scene.Nearest->Bind(units, *program);
  }
  units.Bind(*program, "Order", GL_TEXTURE_BUFFER, this->Order.GetTexture());
  units.Bind(*program, "SceneDepth", GL_TEXTURE_2D, request.SceneDepth);
  program->Set("HasSceneDepth", request.SceneDepth != 0);
  program->Set("KeepNearest", scene.KeepNearest);
  program->Set("TagMask", request.GetTagMask());
  program->Set("ImageSize", view.Size);
  program->Set("Reach", 1.0f);
  program->Set("DiskReach", 1.0f);
  program->Set("LeastRadii", glm::vec2(vtkPointSplatReach::Prefilter));
  program->Set("CoarseDepth", static_cast<float>(request.GetDepthUnit() / 5.0));
  glBindVertexArray(this->VertexArray.Get());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, this->Corners.Get());
  for (const Batch& batch : batches)
  {
    SetItem(*program, units, request.Items[batch.Item], view, group);
    for (int first = 0; first < batch.Count; first += QuadsAtOnce)
    {
      program->Set("FirstEntry", batch.First + first);
      glDrawElements(GL_TRIANGLES, 6 * std::min(batch.Count - first, QuadsAtOnce),
        GL_UNSIGNED_SHORT, nullptr);
    }
  }
  glBindVertexArray(0);
  scene.Shading.Unbind();
  return true;
}

//------------------------------------------------------------------------------
bool vtkPointSplatSorted::DrawAverage(const Scene& scene, int groups)
{
  vtkPointSplatProgram* program = this->Use("vtkPointSplatScreenVS", "vtkPointSplatAverageFS",
    scene.CountLayers ? "#define LAYER_COUNT\n" : "");
  if (!program)
  {
    return false;
  }
  vtkPointSplatUnits units(Window());
  units.Bind(*program, "GroupColour", GL_TEXTURE_2D, this->GroupColour.Get());
  units.Bind(*program, "GroupDepth", GL_TEXTURE_2D, this->GroupDepth.Get());
  units.Bind(*program, "GroupLayerCount", GL_TEXTURE_2D,
    scene.CountLayers ? this->GroupLayerCount.Get() : 0);
  program->Set("Share", 1.0f / static_cast<float>(groups));
  this->Screen.Draw();
  return true;
}

//------------------------------------------------------------------------------
bool vtkPointSplatSorted::DrawDepth(const Scene& scene)
{
  vtkPointSplatProgram* program =
    this->Use("vtkPointSplatScreenVS", "vtkPointSplatAverageFS", "#define DEPTH\n");
  if (!program)
  {
    return false;
  }
  const vtkPointSplatView& view = scene.Request.View;
  vtkPointSplatUnits units(Window());
  units.Bind(*program, "GroupDepth", GL_TEXTURE_2D, this->GroupDepth.Get());
  vtkPointSplatShading::SetRay(view, *program);
  program->Set("DepthRange", static_cast<float>(view.Far - view.Near));
  this->Screen.Draw();
  return true;
}

//------------------------------------------------------------------------------
bool vtkPointSplatSorted::Draw(
  const Scene& scene, const vtkPointSplatImage& colour, const vtkPointSplatImage& depth)
{
  const glm::ivec2& size = scene.Request.View.Size;
  this->GroupColour.Allocate(size);
  this->GroupDepth.Allocate(size);
  if (this->VertexArray.Make())
  {
    this->Corners.Upload(CornersOfQuads());
  }
  vtkOpenGLState* state = Window()->GetState();
  const GLfloat nothing[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
  const GLfloat farthest = 1.0f;
  std::vector<vtkPointSplatFramebuffer::Target> sums{ colour };
  std::vector<vtkPointSplatFramebuffer::Target> ofGroup{ this->GroupColour };
  if (scene.CountLayers)
  {
    this->GroupLayerCount.Allocate(size);
    this->LayerCount.Allocate(size);
    sums.emplace_back(this->LayerCount);
    ofGroup.emplace_back(this->GroupLayerCount);
    this->Sums.Bind(state, sums);
    glClearBufferfv(GL_COLOR, 1, nothing);
  }
  int groups = 1;
  for (const vtkPointSplatItem& item : scene.Request.Items)
  {
    groups = std::max(groups, item.Cloud->GetGroups().GetNumberOfGroups());
  }
  state->vtkglEnable(GL_BLEND);
  state->vtkglDepthFunc(GL_LESS);
  bool good = true;
  for (int group = 0; group < groups && good; ++group)
  {
    this->Groups.Bind(state, ofGroup, this->GroupDepth);
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglDepthMask(GL_TRUE);
    for (size_t k = 0; k < ofGroup.size(); ++k)
    {
      glClearBufferfv(GL_COLOR, static_cast<GLint>(k), nothing);
    }
    glClearBufferfv(GL_DEPTH, 0, &farthest);
    state->vtkglBlendEquation(GL_FUNC_ADD);
    state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    good = this->DrawGroup(scene, group);

    state->vtkglDisable(GL_DEPTH_TEST);
    state->vtkglDepthMask(GL_FALSE);
    state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
    this->Sums.Bind(state, sums);
    good = good && this->DrawAverage(scene, groups);
    this->Depths.Bind(state, { depth });
    state->vtkglBlendEquation(GL_MIN);
    good = good && this->DrawDepth(scene);
  }
  state->vtkglBlendEquation(GL_FUNC_ADD);
  glUseProgram(0);
  return good;
}

//------------------------------------------------------------------------------
void vtkPointSplatSorted::Release()
{
  this->Programs.clear();
  this->Order.Release();
  this->Corners.Release();
  this->VertexArray.Release();
  for (vtkPointSplatImage* image :
    { &this->GroupColour, &this->GroupDepth, &this->GroupLayerCount, &this->LayerCount })
  {
    image->Release();
  }
  for (vtkPointSplatFramebuffer* framebuffer : { &this->Groups, &this->Sums, &this->Depths })
  {
    framebuffer->Release();
  }
  this->Screen.Release();
}
