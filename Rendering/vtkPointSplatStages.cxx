// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatStages.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkPointSplatImages.h"
#include "vtkPointSplatSavedState.h"
#include "vtkPointSplatUnits.h"

#include <algorithm>

namespace
{
constexpr GLuint GroupSize = 64;      // as in vtkPointSplatSplatsCS.glsl
constexpr GLuint MostGroups = 32768;  // in one dimension; OpenGL promises 65535
constexpr GLuint LargeGroups = 256;   // share the listed splats of many pixels

/**
 * What the layers before and the scene are to a stage.
 */
void SetPeel(vtkPointSplatProgram& program, vtkPointSplatUnits& units,
  const vtkPointSplatView& view, const vtkPointSplatPeel* peel)
{
  static const char* const names[] = { "Previous0", "Previous1", "Previous2" };
  if (!peel)
  {
    return;
  }
  const size_t count = peel->Previous.size();
  program.Set("PreviousCount", static_cast<int>(count));
  for (size_t k = 0; k < 3; ++k)
  {
    const vtkPointSplatImages* images = count ? peel->Previous[std::min(k, count - 1)] : nullptr;
    const bool compute = images && images->IsCompute();
    units.Bind(program, names[k], compute ? GL_TEXTURE_BUFFER : GL_TEXTURE_2D,
      !images ? 0 : compute ? images->GetDepthTexture() : images->GetDepths());
  }
  program.Set("HasSceneDepth", peel->SceneDepth != 0);
  units.Bind(program, "SceneDepth", GL_TEXTURE_2D, peel->SceneDepth);
  program.Set("PixelZ", view.PixelZ);
  program.Set("Gather", peel->Gather);
}

/// Sets the count at a buffer's beginning to 0.
void ClearCount(GLuint buffer)
{
  const GLuint zero = 0;
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer);
  glClearBufferSubData(
    GL_SHADER_STORAGE_BUFFER, GL_R32UI, 0, 4, GL_RED_INTEGER, GL_UNSIGNED_INT, &zero);
}

GLsizeiptr Stride(const vtkPointSplatCloud& cloud)
{
  return cloud.IsCircular() ? 32 : 64;
}
}

//------------------------------------------------------------------------------
bool vtkPointSplatItem::operator==(const vtkPointSplatItem& other) const
{
  return this->Cloud == other.Cloud && this->MCWC == other.MCWC && this->Slot == other.Slot &&
    this->Culling == other.Culling && this->RadiusScale == other.RadiusScale &&
    this->LayerDistance == other.LayerDistance && this->KernelType == other.KernelType &&
    this->KernelShape == other.KernelShape && this->KernelSupport == other.KernelSupport &&
    this->ClipPlanes == other.ClipPlanes && this->Colour == other.Colour &&
    this->CoveringScale == other.CoveringScale;
}

//------------------------------------------------------------------------------
bool vtkPointSplatStages::ComputeSupported(vtkOpenGLRenderWindow* window)
{
  int major = 0;
  int minor = 0;
  window->GetOpenGLVersion(major, minor);
  return major > 4 || (major == 4 && minor >= 3);
}

//------------------------------------------------------------------------------
vtkPointSplatProgram* vtkPointSplatStages::Use(Program which)
{
  static const struct
  {
    const char* Vertex;
    const char* Other;
    bool Peeling;
  } files[NumberOfPrograms] = { { nullptr, "vtkPointSplatVisibilityCS", false },
    { nullptr, "vtkPointSplatAccumulateCS", false }, { nullptr, "vtkPointSplatIdentifyCS", false },
    { "vtkPointSplatQuadVS", "vtkPointSplatVisibilityFS", false },
    { "vtkPointSplatQuadVS", "vtkPointSplatAccumulateFS", false },
    { "vtkPointSplatQuadVS", "vtkPointSplatIdentifyFS", false },
    { nullptr, "vtkPointSplatVisibilityCS", true }, { nullptr, "vtkPointSplatAccumulateCS", true },
    { "vtkPointSplatQuadVS", "vtkPointSplatVisibilityFS", true },
    { "vtkPointSplatQuadVS", "vtkPointSplatAccumulateFS", true } };
  vtkPointSplatProgram& program = this->Programs[which];
  if (!program.IsBuilt())
  {
    std::vector<std::pair<GLenum, std::string>> stages;
    if (files[which].Vertex)
    {
      stages.emplace_back(GL_VERTEX_SHADER, files[which].Vertex);
      stages.emplace_back(GL_FRAGMENT_SHADER, files[which].Other);
    }
    else
    {
      stages.emplace_back(GL_COMPUTE_SHADER, files[which].Other);
    }
    if (!program.Build(stages, files[which].Peeling ? "#define PEELING\n" : ""))
    {
      this->Error = program.GetLog();
      return nullptr;
    }
  }
  program.Use();
  return &program;
}

//------------------------------------------------------------------------------
void vtkPointSplatStages::SetItem(vtkPointSplatProgram& program, const vtkPointSplatView& view,
  const vtkPointSplatItem& item, const glm::ivec2& imageSize)
{
  const auto& origin = item.Cloud->GetOrigin();
  glm::dmat4 MCVC = view.WCVC * item.MCWC;
  const glm::dmat3 normals = glm::transpose(glm::inverse(glm::dmat3(MCVC)));
  // In double precision up to here: only the product of a far camera and a far
  // cloud is small.
  MCVC[3] = MCVC * glm::dvec4(origin[0], origin[1], origin[2], 1.0);
  std::vector<glm::vec4> planes;
  const glm::dmat4 VCWCTransposed = glm::transpose(glm::inverse(view.WCVC));
  for (const glm::dvec4& plane : item.ClipPlanes)
  {
    planes.emplace_back(VCWCTransposed * plane);
  }
  program.Set("MCVC", glm::mat4(MCVC));
  program.Set("NormalMatrix", glm::mat3(normals));
  program.Set("PixelX", view.PixelX);
  program.Set("PixelY", view.PixelY);
  program.Set("PixelW", view.PixelW);
  program.Set("Window", item.Window);
  program.Set("DepthRange",
    glm::vec2(static_cast<float>(view.Near), static_cast<float>(view.Far - view.Near)));
  program.Set("Parallel", view.Parallel);
  program.Set("Circular", item.Cloud->IsCircular());
  program.Set("RadiusScale", static_cast<float>(item.RadiusScale));
  program.Set("Culling", item.Culling);
  program.Set("Tag", static_cast<unsigned int>(item.Slot) << 1);
  program.Set("LayerDistance", static_cast<float>(item.LayerDistance));
  program.Set("ClipPlaneCount", static_cast<int>(planes.size()));
  program.Set("ClipPlanes", planes);
  program.Set("KernelType", item.KernelType);
  program.Set("KernelShape", item.KernelShape);
  program.Set("KernelSupport", static_cast<float>(item.KernelSupport));
  program.Set("HasColours", item.Cloud->HasColours());
  program.Set("ItemColour", glm::vec4(1.0f));
  program.Set("ImageWidth", imageSize.x);
  program.Set("ImageSize", imageSize);
}

//------------------------------------------------------------------------------
void vtkPointSplatStages::Dispatch(vtkPointSplatProgram& program, vtkPointSplatUnits& units,
  vtkIdType splats, vtkPointSplatCloud::Buffers& buffers)
{
  units.Bind(program, "Splats", GL_TEXTURE_BUFFER, buffers.SplatTexture);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, buffers.Large);
  ClearCount(buffers.Large);
  const GLuint groups = static_cast<GLuint>((splats + GroupSize - 1) / GroupSize);
  program.Set("SplatCount", static_cast<unsigned int>(splats));
  program.Set("ListLarge", true);
  program.Set("DrawLarge", false);
  glDispatchCompute(std::min(groups, MostGroups), (groups + MostGroups - 1) / MostGroups, 1);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  program.Set("DrawLarge", true);
  glDispatchCompute(LargeGroups, 1, 1);
}

//------------------------------------------------------------------------------
void vtkPointSplatStages::PrepareLists(const std::vector<vtkPointSplatItem>& items, int layer)
{
  this->ItemLists.resize(std::max(this->ItemLists.size(), items.size()));
  for (size_t i = 0; i < items.size(); ++i)
  {
    Lists& lists = this->ItemLists[i];
    const vtkIdType splats = items[i].Cloud->GetNumberOfSplats();
    if (lists.Capacity < splats)
    {
      glDeleteBuffers(2, lists.Buffers);
      glGenBuffers(2, lists.Buffers);
      lists.Capacity = splats;
      for (const GLuint buffer : lists.Buffers)
      {
        glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer);
        glBufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(4 * (splats + 1)), nullptr,
          GL_DYNAMIC_COPY);
      }
    }
    lists.Count = splats;
    if (layer > 0)
    {
      GLuint count = 0;
      glBindBuffer(GL_SHADER_STORAGE_BUFFER, lists.Buffers[(layer - 1) % 2]);
      glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, 4, &count);
      lists.Count = static_cast<vtkIdType>(count);
    }
    ClearCount(lists.Buffers[layer % 2]);
  }
}

//------------------------------------------------------------------------------
bool vtkPointSplatStages::ReconstructByCompute(vtkOpenGLRenderWindow* window,
  const vtkPointSplatView& view, const std::vector<vtkPointSplatItem>& items,
  vtkPointSplatImages& images, float depthUnit, const vtkPointSplatPeel* peel, bool* empty)
{
  vtkPointSplatUnits units(window);
  vtkPointSplatProgram* program = this->Use(peel ? PeelVisibilityCompute : VisibilityCompute);
  if (!program)
  {
    return false;
  }
  SetPeel(*program, units, view, peel);
  if (!this->Found)
  {
    glGenBuffers(1, &this->Found);
  }
  const GLuint nothing = 0;
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Found);
  glBufferData(GL_SHADER_STORAGE_BUFFER, 4, &nothing, GL_STREAM_READ);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 3, this->Found);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, images.GetDepths());
  // Draws an item's splats: all of them, or those that earlier layers have left.
  auto draw = [&](size_t i, bool listNext) {
    vtkIdType splats = items[i].Cloud->GetNumberOfSplats();
    program->Set("DrawListed", peel && peel->Layer > 0);
    program->Set("ListNext", peel && listNext);
    if (peel)
    {
      const Lists& lists = this->ItemLists[i];
      splats = lists.Count;
      glBindBufferBase(
        GL_SHADER_STORAGE_BUFFER, 4, lists.Buffers[(peel->Layer + 1) % 2]);
      glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 5, lists.Buffers[peel->Layer % 2]);
    }
    if (splats > 0)
    {
      vtkPointSplatStages::Dispatch(*program, units, splats, items[i].Cloud->Upload(window));
    }
  };
  if (peel)
  {
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    this->PrepareLists(items, peel->Layer);
  }
  for (size_t i = 0; i < items.size(); ++i)
  {
    this->SetItem(*program, view, items[i], images.GetSize());
    program->Set("DiskReach", DiskReach);
    program->Set("CoverageRadius", CoverageRadius);
    draw(i, false);
  }
  if (empty)
  {
    GLuint found = 0;
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Found);
    glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, 4, &found);
    *empty = found == 0;
    if (*empty)
    {
      return true;
    }
  }
  program = this->Use(peel ? PeelAccumulateCompute : AccumulateCompute);
  if (!program)
  {
    return false;
  }
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, images.GetSums());
  SetPeel(*program, units, view, peel);
  units.Bind(*program, "Depths", GL_TEXTURE_BUFFER, images.GetDepthTexture());
  for (size_t i = 0; i < items.size(); ++i)
  {
    const vtkPointSplatItem& item = items[i];
    this->SetItem(*program, view, item, images.GetSize());
    program->Set("PrefilterRadius", PrefilterRadius);
    program->Set("DepthUnit", depthUnit);
    program->Set("SumStride", images.GetSumStride());
    if (peel && peel->Gather)
    {
      program->Set("ItemColour", item.Colour);
    }
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, item.Cloud->Upload(window).Colours);
    draw(i, true);
  }
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
  return true;
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
  vtkPointSplatCloud::Buffers& buffers, GLuint idMap, vtkIdType first)
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
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  const bool used[] = { true, true, true, colours, axes, axes };
  for (GLuint i = 0; i < 6; ++i)
  {
    if (used[i])
    {
      glEnableVertexAttribArray(i);
    }
    else
    {
      glDisableVertexAttribArray(i);
    }
    glVertexAttribDivisor(i, 1);
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
bool vtkPointSplatStages::ReconstructByQuads(vtkOpenGLRenderWindow* window,
  const vtkPointSplatView& view, const std::vector<vtkPointSplatItem>& items,
  vtkPointSplatImages& images, float depthUnit, const vtkPointSplatPeel* peel, bool* empty)
{
  vtkOpenGLState* state = window->GetState();
  vtkPointSplatUnits units(window);
  vtkPointSplatStages::SetStateForQuads(state, images.GetSize());
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, images.GetFramebuffer());

  // Visibility: the nearest depth of all disks.
  GLenum all[] = { GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2 };
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
  vtkPointSplatProgram* program = this->Use(peel ? PeelVisibilityQuads : VisibilityQuads);
  if (!program)
  {
    return false;
  }
  SetPeel(*program, units, view, peel);
  GLuint query = 0;
  if (empty)
  {
    glGenQueries(1, &query);
    glBeginQuery(GL_ANY_SAMPLES_PASSED, query);
  }
  for (const vtkPointSplatItem& item : items)
  {
    this->SetItem(*program, view, item, images.GetSize());
    program->Set("Reach", DiskReach);
    program->Set("DiskReach", DiskReach);
    program->Set("MinimumRadius", CoverageRadius);
    this->DrawQuads(item, item.Cloud->Upload(window), 0);
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
      return true;
    }
  }

  // Accumulation: sums over the splats of that layer.
  glFramebufferTexture2D(
    GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, images.GetSums(0), 0);
  glFramebufferTexture2D(
    GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, images.GetSums(1), 0);
  glFramebufferTexture2D(
    GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT2, GL_TEXTURE_2D, images.GetSums(2), 0);
  state->vtkglDrawBuffers(3, all);
  for (GLint k = 0; k < 3; ++k)
  {
    glClearBufferfv(GL_COLOR, k, zero);
  }
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendEquation(GL_FUNC_ADD); // depth peeling takes maxima
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  program = this->Use(peel ? PeelAccumulateQuads : AccumulateQuads);
  if (!program)
  {
    return false;
  }
  SetPeel(*program, units, view, peel);
  units.Bind(*program, "Depths", GL_TEXTURE_2D, images.GetDepths());
  for (const vtkPointSplatItem& item : items)
  {
    this->SetItem(*program, view, item, images.GetSize());
    program->Set("Reach", static_cast<float>(item.KernelSupport));
    program->Set("MinimumRadius", PrefilterRadius);
    program->Set("DepthUnit", depthUnit);
    if (peel && peel->Gather)
    {
      program->Set("ItemColour", item.Colour);
    }
    this->DrawQuads(item, item.Cloud->Upload(window), 0);
  }
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
  vtkPointSplatProgram* program = this->Use(IdentifyQuads);
  if (!program)
  {
    return false;
  }
  vtkPointSplatUnits units(window);
  units.Bind(*program, "Depths", GL_TEXTURE_2D, images.GetDepths());
  for (const vtkPointSplatItem& item : items)
  {
    const GLuint idMap = item.Cloud->UploadIdMap(window, kind);
    this->SetItem(*program, view, item, images.GetSize());
    program->Set("Reach", static_cast<float>(item.KernelSupport));
    program->Set("MinimumRadius", PrefilterRadius);
    this->DrawQuads(item, item.Cloud->Upload(window), idMap);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkPointSplatStages::Reconstruct(vtkOpenGLRenderWindow* window,
  const vtkPointSplatView& view, const std::vector<vtkPointSplatItem>& items,
  vtkPointSplatImages& images, float depthUnit, const vtkPointSplatPeel* peel, bool* empty)
{
  window->GetShaderCache()->ReleaseCurrentShader();
  bool good = false;
  if (images.IsCompute())
  {
    good = this->ReconstructByCompute(window, view, items, images, depthUnit, peel, empty);
  }
  else
  {
    vtkOpenGLState* state = window->GetState();
    const vtkPointSplatSavedState saved(state);
    good = this->ReconstructByQuads(window, view, items, images, depthUnit, peel, empty);
  }
  glUseProgram(0);
  return good;
}

//------------------------------------------------------------------------------
bool vtkPointSplatStages::Identify(vtkOpenGLRenderWindow* window, const vtkPointSplatView& view,
  const std::vector<vtkPointSplatItem>& items, vtkPointSplatImages& images,
  vtkPointSplatCloud::IdKind kind)
{
  window->GetShaderCache()->ReleaseCurrentShader();
  bool good = false;
  if (images.IsCompute())
  {
    vtkPointSplatUnits units(window);
    images.ClearIdBuffer({ 0, 0, images.GetSize().x - 1, images.GetSize().y - 1 });
    if (vtkPointSplatProgram* program = this->Use(IdentifyCompute))
    {
      glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, images.GetIds());
      units.Bind(*program, "Depths", GL_TEXTURE_BUFFER, images.GetDepthTexture());
      for (const bool findWeight : { true, false })
      {
        for (const vtkPointSplatItem& item : items)
        {
          const GLuint idMap = item.Cloud->UploadIdMap(window, kind);
          this->SetItem(*program, view, item, images.GetSize());
          program->Set("PrefilterRadius", PrefilterRadius);
          program->Set("FindWeight", findWeight);
          program->Set("UseIdMap", idMap != 0);
          glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, idMap);
          program->Set("DrawListed", false);
          program->Set("ListNext", false);
          vtkPointSplatStages::Dispatch(
            *program, units, item.Cloud->GetNumberOfSplats(), item.Cloud->Upload(window));
        }
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
      }
      good = true;
    }
  }
  else
  {
    vtkOpenGLState* state = window->GetState();
    const vtkPointSplatSavedState saved(state);
    good = this->IdentifyByQuads(window, view, items, images, kind);
  }
  glUseProgram(0);
  return good;
}

//------------------------------------------------------------------------------
void vtkPointSplatStages::Release()
{
  for (vtkPointSplatProgram& program : this->Programs)
  {
    program.Release();
  }
  if (this->Found)
  {
    glDeleteBuffers(1, &this->Found);
    this->Found = 0;
  }
  for (Lists& lists : this->ItemLists)
  {
    glDeleteBuffers(2, lists.Buffers);
  }
  this->ItemLists.clear();
}
