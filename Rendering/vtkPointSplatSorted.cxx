// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatSorted.h"

#include "vtkActor.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkPointSplatImages.h"
#include "vtkPointSplatSavedState.h"
#include "vtkPointSplatUnits.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <map>

namespace
{
struct Command // as glMultiDrawArraysIndirect reads it
{
  GLuint Vertices;
  GLuint Instances;
  GLuint FirstVertex;
  GLuint FirstInstance;
};
}

//------------------------------------------------------------------------------
void vtkPointSplatSorted::Allocate(vtkOpenGLRenderWindow* window, const glm::ivec2& size)
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
  const struct
  {
    GLuint* Texture;
    GLenum Internal;
    GLenum Format;
  } images[] = { { &this->Colour, GL_RGBA16F, GL_RGBA },
    { &this->Depth, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT },
    { &this->LayerCount, GL_R16F, GL_RED } };
  for (const auto& image : images)
  {
    *image.Texture =
      vtkPointSplatImages::MakeTexture(size, image.Internal, image.Format, GL_FLOAT);
  }
  window->GetTextureUnitManager()->Free(unit);
  glGenFramebuffers(1, &this->Framebuffer);
  glGenVertexArrays(1, &this->VertexArray);
  glGenBuffers(1, &this->Commands);
}

//------------------------------------------------------------------------------
std::vector<vtkPointSplatSorted::Batch> vtkPointSplatSorted::Order(
  const vtkPointSplatLayersRequest& request, int group)
{
  struct Entry
  {
    double Depth;
    size_t Item;
    const vtkPointSplatCloud::Leaf* Leaf;
  };
  std::vector<Entry> entries;
  for (size_t i = 0; i < request.Items.size(); ++i)
  {
    const vtkPointSplatItem& item = request.Items[i];
    const glm::dmat4 MCVC = request.View.WCVC * item.MCWC;
    for (const vtkPointSplatCloud::Leaf& leaf : item.Cloud->GetLeaves(group))
    {
      const glm::dvec4 p =
        MCVC * glm::dvec4(leaf.Centre[0], leaf.Centre[1], leaf.Centre[2], 1.0);
      entries.push_back({ -p.z, i, &leaf });
    }
  }
  std::stable_sort(entries.begin(), entries.end(),
    [](const Entry& a, const Entry& b) { return a.Depth > b.Depth; });
  std::vector<Batch> batches;
  for (const Entry& entry : entries)
  {
    if (batches.empty() || batches.back().Item != entry.Item)
    {
      batches.push_back({ entry.Item, {} });
    }
    batches.back().Ranges.emplace_back(entry.Leaf->First, entry.Leaf->Count);
  }
  return batches;
}

//------------------------------------------------------------------------------
bool vtkPointSplatSorted::DrawGroup(vtkRenderer* renderer, const std::vector<vtkActor*>& actors,
  const vtkPointSplatLayersRequest& request, const vtkPointSplatImages* nearest,
  bool keepNearest, float coarseDepth, int group, bool countLayers)
{
  auto window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  const std::vector<Batch> batches = vtkPointSplatSorted::Order(request, group);
  const bool indirect = vtkPointSplatStages::ComputeSupported(window);
  std::vector<Command> commands;
  for (const Batch& batch : batches)
  {
    for (const auto& range : batch.Ranges)
    {
      commands.push_back({ 4, static_cast<GLuint>(range.second), 0,
        static_cast<GLuint>(range.first) });
    }
  }
  if (indirect)
  {
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, this->Commands);
    glBufferData(GL_DRAW_INDIRECT_BUFFER,
      static_cast<GLsizeiptr>(commands.size() * sizeof(Command)), commands.data(),
      GL_STREAM_DRAW);
  }

  size_t command = 0;
  // Looking a shader up by its text takes longer than drawing a leaf: once for each kind.
  struct Shader
  {
    vtkShaderProgram* Ready = nullptr;
    vtkPointSplatProgram Program;
  };
  std::map<std::string, Shader> shaders;
  std::vector<Shader*> ofItems(request.Items.size(), nullptr);
  vtkPointSplatUnits units(window);
  for (const Batch& batch : batches)
  {
    const vtkPointSplatItem& item = request.Items[batch.Item];
    vtkActor* actor = actors[batch.Item];
    Shader*& shader = ofItems[batch.Item];
    if (!shader)
    {
      std::string defines = vtkPointSplatResolve::LightDefines(renderer, actor);
      const std::string quads = std::string(item.Factors ? "#define FACTORS\n" : "") +
        (item.ClipPlanes.empty() ? "" : "#define CLIPPING\n");
      defines += quads;
      if (nearest && nearest->IsCompute())
      {
        defines += "#define COMPUTE_IMAGES\n";
      }
      if (countLayers)
      {
        defines += "#define LAYER_COUNT\n";
      }
      shader = &shaders[defines];
      if (!shader->Ready)
      {
        std::string fragment = vtkPointSplatProgram::Source("vtkPointSplatSortedFS");
        vtkShaderProgram::Substitute(fragment, "//PointSplat::Defines", defines);
        std::string vertex = vtkPointSplatProgram::Source("vtkPointSplatQuadVS");
        vertex.insert(vertex.find('\n') + 1, quads);
        shader->Ready = window->GetShaderCache()->ReadyShaderProgram(
          vertex.c_str(), fragment.c_str(), "");
        if (!shader->Ready)
        {
          this->Error = "the shaders of sorted transparency do not build.";
          return false;
        }
        shader->Program.Borrow(static_cast<GLuint>(shader->Ready->GetHandle()));
      }
    }
    window->GetShaderCache()->ReadyShaderProgram(shader->Ready);
    vtkPointSplatProgram& program = shader->Program;
    vtkPointSplatStages::SetItem(program, request.View, item, this->Size);
    program.Set("RadiusScale", static_cast<float>(item.RadiusScale * item.CoveringScale));
    program.Set("Reach", 1.0f);
    program.Set("DiskReach", 1.0f);
    program.Set("MinimumRadius", vtkPointSplatStages::PrefilterRadius);
    program.Set("CoarseDepth", coarseDepth);
    program.Set("PreviousCount", nearest ? 1 : 0);
    const bool buffer = nearest && nearest->IsCompute();
    units.Bind(program, "Previous0", buffer ? GL_TEXTURE_BUFFER : GL_TEXTURE_2D,
      !nearest ? 0 : buffer ? nearest->GetDepthTexture() : nearest->GetDepths());
    program.Set("HasSceneDepth", request.SceneDepth != 0);
    units.Bind(program, "SceneDepth", GL_TEXTURE_2D, request.SceneDepth);
    program.Set("PixelZ", request.View.PixelZ);
    program.Set("Refracts", item.Refracts);
    program.Set("KeepNearest", keepNearest);
    vtkPointSplatResolve::SetShading(
      renderer, actor, request.View, item.Cloud->HasColours(), shader->Ready, item.FactorCount);

    vtkPointSplatCloud::Buffers& buffers = item.Cloud->Upload(window);
    if (indirect)
    {
      vtkPointSplatStages::BindQuads(item, buffers, 0, 0);
      glMultiDrawArraysIndirect(GL_TRIANGLE_STRIP,
        reinterpret_cast<const void*>(command * sizeof(Command)),
        static_cast<GLsizei>(batch.Ranges.size()), 0);
      glBindVertexArray(0);
    }
    else
    {
      for (const auto& range : batch.Ranges)
      {
        vtkPointSplatStages::DrawQuads(item, buffers, 0, range.first, range.second);
      }
    }
    command += batch.Ranges.size();
  }
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
  window->GetShaderCache()->ReleaseCurrentShader();
  return true;
}

//------------------------------------------------------------------------------
bool vtkPointSplatSorted::Draw(vtkRenderer* renderer, const std::vector<vtkActor*>& actors,
  const vtkPointSplatLayersRequest& request, const vtkPointSplatImages* nearest,
  bool keepNearest, float coarseDepth, GLuint framebuffer, bool countLayers)
{
  auto window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  this->Allocate(window, request.View.Size);
  vtkPointSplatProgram& average = countLayers ? this->AverageAndCount : this->Average;
  if (!average.IsBuilt() &&
    !average.Build({ { GL_VERTEX_SHADER, "vtkPointSplatResolveVS" },
                     { GL_FRAGMENT_SHADER, "vtkPointSplatAverageFS" } },
      countLayers ? "#define LAYER_COUNT\n" : ""))
  {
    this->Error = average.GetLog();
    return false;
  }
  int groups = 1;
  for (const vtkPointSplatItem& item : request.Items)
  {
    groups = std::max(groups, item.Cloud->GetNumberOfGroups());
  }

  vtkOpenGLState* state = window->GetState();
  const vtkPointSplatSavedState saved(state);
  GLenum attachments[] = { GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2 };
  const GLfloat nothing[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
  const GLfloat farthest = 1.0f;
  bool good = true;
  for (int group = 0; group < groups && good; ++group)
  {
    state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->Framebuffer);
    glFramebufferTexture2D(
      GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, this->Colour, 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, this->Depth, 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D,
      countLayers ? this->LayerCount : 0, 0);
    // Not through the state: of several draw buffers it takes those of the framebuffer that was
    // bound before for this one's.
    glDrawBuffers(countLayers ? 2 : 1, attachments);
    vtkPointSplatStages::SetStateForQuads(state, this->Size);
    glClearBufferfv(GL_COLOR, 0, nothing);
    glClearBufferfv(GL_DEPTH, 0, &farthest);
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendEquation(GL_FUNC_ADD);
    state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    if (countLayers)
    {
      glClearBufferfv(GL_COLOR, 1, nothing);
      glEnablei(GL_BLEND, 1);
      glBlendFunci(1, GL_ONE, GL_ONE);
    }
    good = this->DrawGroup(
      renderer, actors, request, nearest, keepNearest, coarseDepth, group, countLayers);

    state->vtkglBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glDrawBuffers(countLayers ? 3 : 2, attachments);
    state->vtkglDisable(GL_DEPTH_TEST);
    state->vtkglDepthMask(GL_FALSE);
    state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
    glEnablei(GL_BLEND, 1);
    glBlendEquationi(1, GL_MIN);
    {
      vtkPointSplatUnits units(window);
      average.Use();
      units.Bind(average, "GroupColour", GL_TEXTURE_2D, this->Colour);
      units.Bind(average, "GroupDepth", GL_TEXTURE_2D, this->Depth);
      if (countLayers)
      {
        units.Bind(average, "GroupLayerCount", GL_TEXTURE_2D, this->LayerCount);
      }
      average.Set("Share", 1.0f / static_cast<float>(groups));
      average.Set("DepthRange", glm::vec2(request.View.Near, request.View.Far - request.View.Near));
      average.Set("PixelZ", request.View.PixelZ);
      average.Set("PixelW", request.View.PixelW);
      glBindVertexArray(this->VertexArray);
      glDrawArrays(GL_TRIANGLES, 0, 3);
      glBindVertexArray(0);
      glUseProgram(0);
    }
    glBlendEquationi(1, GL_FUNC_ADD);
  }
  return good;
}

//------------------------------------------------------------------------------
void vtkPointSplatSorted::Release()
{
  if (this->Framebuffer)
  {
    const GLuint textures[] = { this->Colour, this->Depth, this->LayerCount };
    glDeleteTextures(3, textures);
    glDeleteFramebuffers(1, &this->Framebuffer);
    glDeleteVertexArrays(1, &this->VertexArray);
    glDeleteBuffers(1, &this->Commands);
  }
  this->Colour = this->Depth = this->LayerCount = this->Framebuffer = this->VertexArray =
    this->Commands = 0;
  this->Size = glm::ivec2(0);
  this->Average.Release();
  this->AverageAndCount.Release();
}
