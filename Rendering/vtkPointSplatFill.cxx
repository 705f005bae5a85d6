// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatFill.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkPointSplatImages.h"
#include "vtkPointSplatSavedState.h"
#include "vtkPointSplatUnits.h"

#include <algorithm>
#include <cmath>

namespace
{
// As in vtkPointSplatStripsCS.glsl and vtkPointSplatPushPullCS.glsl.
constexpr int StripsPerGroup = 32;
constexpr int StripLength = 16;
constexpr int StripWidth = 2;

// Points this far apart, in pixels, or closer leave only holes that one step closes.
constexpr double DensePixels = 0.7;
// Beyond this, rims of holes are not closed, and coarser levels are needed: up to that on which
// points are twice DensePixels apart ...
constexpr double SparsePixels = 1.2;
// ... and beyond this, one more. Each costs silhouettes some of their sharpness, but in close-ups
// gaps of random samplings are larger than that.
constexpr double CloseUpPixels = 4.0;
constexpr int MostLevels = 7;
// What lies closer than this, in a level's pixels, has too few holes by chance to be filled from
// above, where that would cost its silhouettes: exp(-5) of its pixels.
constexpr double FilledPixels = 0.45;
}

//------------------------------------------------------------------------------
void vtkPointSplatFill::Allocate(bool compute, const glm::ivec2& size, int levels)
{
  if (this->Compute != compute || this->Levels.empty() || this->Levels[0].Size != size)
  {
    this->ReleaseImages();
  }
  this->Compute = compute;
  // Coarser levels stay, for frames that need them again.
  while (static_cast<int>(this->Levels.size()) < levels)
  {
    Level level;
    level.Size = this->Levels.empty() ? size : (this->Levels.back().Size + 1) / 2;
    const GLsizeiptr pixels = static_cast<GLsizeiptr>(level.Size.x) * level.Size.y;
    for (int i = 0; i < 2; ++i)
    {
      if (compute)
      {
        vtkPointSplatImages::MakeBuffer(
          level.Targets[i], level.Textures[i], 8 * pixels, GL_RG32UI);
      }
      else
      {
        level.Textures[i] = vtkPointSplatImages::MakeTexture(
          level.Size, GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT);
        level.Targets[i] = level.Textures[i];
      }
    }
    this->Levels.push_back(level);
  }
  if (!compute && !this->Framebuffer)
  {
    glGenFramebuffers(1, &this->Framebuffer);
    glGenVertexArrays(1, &this->VertexArray);
  }
  if (compute && !this->Changed)
  {
    glGenBuffers(1, &this->Changed);
  }
}

//------------------------------------------------------------------------------
vtkPointSplatProgram* vtkPointSplatFill::Use(Stage stage, const vtkPointSplatImages& projected)
{
  static const char* const files[] = { "vtkPointSplatFill", "vtkPointSplatFill",
    "vtkPointSplatPushPull", "vtkPointSplatPushPull", "vtkPointSplatSmooth" };
  static const char* const own[] = { "#define FIRST_FILL\n", "", "", "#define PUSH\n", "" };
  std::string defines = own[stage];
  if (stage == Smoothing)
  {
    defines += projected.GetDefines() + (projected.HasColours() ? "#define COLOURS\n" : "");
  }
  else if (this->Compute)
  {
    defines += "#define COMPUTE_IMAGES\n";
  }
  vtkPointSplatProgram& program =
    this->Programs[(this->Compute ? "CS" : "FS") + std::string(files[stage]) + defines];
  if (!program.IsBuilt())
  {
    std::vector<std::pair<GLenum, std::string>> sources;
    if (this->Compute)
    {
      sources.emplace_back(GL_COMPUTE_SHADER, std::string(files[stage]) + "CS");
    }
    else
    {
      sources.emplace_back(GL_VERTEX_SHADER, "vtkPointSplatResolveVS");
      sources.emplace_back(GL_FRAGMENT_SHADER, std::string(files[stage]) + "FS");
    }
    if (!program.Build(sources, defines))
    {
      this->Error = program.GetLog();
      return nullptr;
    }
  }
  program.Use();
  return &program;
}

//------------------------------------------------------------------------------
bool vtkPointSplatFill::Draw(vtkOpenGLRenderWindow* window, Stage stage, size_t index,
  vtkPointSplatImages& projected, GLuint to, GLuint factors)
{
  vtkPointSplatProgram* program = this->Use(stage, projected);
  if (!program)
  {
    return false;
  }
  const Level& level = this->Levels[index];
  const float scale = std::ldexp(1.0f, static_cast<int>(index));
  vtkPointSplatUnits units(window);
  const GLenum kind = this->Compute ? GL_TEXTURE_BUFFER : GL_TEXTURE_2D;
  program->Set("FilledWindow", level.Window);
  program->Set("LastPixel", level.Size - 1);
  program->Set("SlotLayers", this->Given.Layers);
  program->Set("SlotLayerPixels", this->Given.LayerPixels);
  program->Set("SlotSpacings", this->Given.Spacings);
  program->Set("PixelSize", scale * this->Given.PixelSize);
  program->Set("PixelsNeeded", static_cast<float>(FilledPixels));
  program->Set("LevelScale", scale);
  program->Set("SlotSilhouettes", this->Given.Silhouettes);
  program->Set("RayOffset", this->Given.RayOffset);
  program->Set("RayScale", this->Given.RayScale);
  program->Set("DepthUnit", this->Given.DepthUnit);
  if (stage != FirstStep)
  {
    units.Bind(*program, "Filled", kind, level.Textures[level.Now]);
  }
  if (stage == FirstStep || stage == Smoothing)
  {
    projected.Bind(units, *program);
  }
  const Level* result = &level;
  if (stage == Pull)
  {
    result = &this->Levels[index + 1];
  }
  if (stage == Push)
  {
    const Level& coarse = this->Levels[index + 1];
    units.Bind(*program, "Coarse", kind, coarse.Textures[coarse.Now]);
    program->Set("CoarseWindow", coarse.Window);
    program->Set("CoarseLastPixel", coarse.Size - 1);
    program->Set("CoarseWidth", coarse.Size.x);
  }
  program->Set("ImageWidth", level.Size.x);
  program->Set("ResultWindow", result->Window);
  program->Set("ResultWidth", result->Size.x);
  const glm::ivec4& w = result->Window;
  if (this->Compute)
  {
    const glm::ivec2 strip = stage == Pull ? glm::ivec2(1) : glm::ivec2(StripWidth, StripLength);
    // Of the pixels that strips may begin with: of the pushed those that have a parent.
    const glm::ivec2 first = glm::ivec2(w.x, w.y) & (stage == Push ? ~1 : ~0);
    const glm::ivec2 groups =
      (glm::ivec2(w.z, w.w) - first + strip * glm::ivec2(StripsPerGroup, 1)) /
      (strip * glm::ivec2(StripsPerGroup, 1));
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, to);
    if (factors)
    {
      glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, factors);
    }
    glDispatchCompute(static_cast<GLuint>(groups.x), static_cast<GLuint>(groups.y), 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
    return true;
  }
  vtkOpenGLState* state = window->GetState();
  state->vtkglViewport(0, 0, result->Size.x, result->Size.y);
  state->vtkglScissor(w.x, w.y, w.z - w.x + 1, w.w - w.y + 1);
  const GLenum both[] = { GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1 };
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, to, 0);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, factors, 0);
  // Past the state, which takes another framebuffer's second one for this.
  glDrawBuffers(factors ? 2 : 1, both);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  return true;
}

//------------------------------------------------------------------------------
bool vtkPointSplatFill::DrawStep(vtkOpenGLRenderWindow* window, size_t index, bool first,
  vtkPointSplatImages& projected, bool* changed)
{
  if (changed)
  {
    const GLuint no = 0;
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Changed);
    glBufferData(GL_SHADER_STORAGE_BUFFER, 4, &no, GL_STREAM_READ);
  }
  if (this->Compute)
  {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, this->Changed);
  }
  Level& level = this->Levels[index];
  const int next = 1 - level.Now;
  if (!this->Draw(window, first ? FirstStep : NextStep, index, projected, level.Targets[next]))
  {
    return false;
  }
  level.Now = next;
  if (changed)
  {
    GLuint any = 0;
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Changed);
    glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, 4, &any);
    *changed = any != 0;
  }
  return true;
}

//------------------------------------------------------------------------------
int vtkPointSplatFill::LevelsFor(double spacing)
{
  int levels = 1;
  for (double s = 0.5 * spacing; s > DensePixels && levels < MostLevels; s *= 0.5)
  {
    ++levels;
  }
  levels += spacing > CloseUpPixels && levels < MostLevels ? 1 : 0;
  return spacing > SparsePixels ? levels : 1;
}

//------------------------------------------------------------------------------
bool vtkPointSplatFill::Reconstruct(vtkOpenGLRenderWindow* window,
  const vtkPointSplatView& view, const std::vector<vtkPointSplatItem>& items,
  vtkPointSplatImages& projected, const glm::ivec4& rectangle, int steps, float depthUnit,
  vtkPointSplatImages& images)
{
  this->Steps = 0;
  Parameters& given = this->Given;
  given.Layers.assign(vtkPointSplatStages::MaximumSlots, -1.0f);
  given.LayerPixels.assign(vtkPointSplatStages::MaximumSlots, 0.0f);
  given.Spacings.assign(vtkPointSplatStages::MaximumSlots, 0.0f);
  given.Silhouettes = glm::uvec2(0u);
  int levels = 1;
  for (const vtkPointSplatItem& item : items)
  {
    if (item.Points)
    {
      const size_t slot = static_cast<size_t>(item.Slot);
      given.Layers[slot] = static_cast<float>(item.PointLayer);
      given.LayerPixels[slot] = static_cast<float>(item.PointLayerPixels);
      given.Spacings[slot] = static_cast<float>(item.Spacing);
      given.Silhouettes[item.Slot / 32] |= (item.Silhouettes ? 1u : 0u) << (item.Slot % 32);
      levels = std::max(levels, vtkPointSplatFill::LevelsFor(item.SpacingPixels));
    }
  }
  const float near = static_cast<float>(view.Near);
  given.PixelSize = glm::vec2(view.PixelW.w - view.PixelW.z * near, -view.PixelW.z) /
    glm::length(glm::vec3(view.PixelX));
  given.RayOffset = glm::vec2(view.PixelX.z, view.PixelY.z);
  given.RayScale =
    view.Parallel ? glm::vec2(0.0f) : 1.0f / glm::vec2(view.PixelX.x, view.PixelY.y);
  given.DepthUnit = depthUnit;
  this->Allocate(projected.IsCompute(), projected.GetSize(), levels);
  if (rectangle.x > rectangle.z || rectangle.y > rectangle.w)
  {
    return true; // off the screen
  }
  for (int k = 0; k < levels; ++k)
  {
    this->Levels[static_cast<size_t>(k)].Window = rectangle >> k;
  }

  window->GetShaderCache()->ReleaseCurrentShader();
  vtkOpenGLState* state = window->GetState();
  const vtkPointSplatSavedState saved(state);
  if (!this->Compute)
  {
    vtkPointSplatStages::SetStateForQuads(state, projected.GetSize());
    state->vtkglDisable(GL_DEPTH_TEST);
    state->vtkglDepthMask(GL_FALSE);
    state->vtkglEnable(GL_SCISSOR_TEST);
    state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->Framebuffer);
    glBindVertexArray(this->VertexArray);
  }
  bool good = this->DrawStep(window, 0, true, projected, nullptr);
  const size_t top = static_cast<size_t>(levels - 1);
  for (size_t k = 0; good && k < top; ++k)
  {
    this->Levels[k + 1].Now = 0;
    good = this->Draw(window, Pull, k, projected, this->Levels[k + 1].Targets[0]);
  }
  // Whether there is more to do is asked only where compute shaders can tell at no cost.
  bool changed = true;
  for (this->Steps = 1; good && changed && this->Steps < steps; ++this->Steps)
  {
    good = this->DrawStep(window, top, false, projected,
      this->Compute && this->Steps + 1 < steps ? &changed : nullptr);
  }
  for (size_t k = top; good && k > 0; --k)
  {
    Level& level = this->Levels[k - 1];
    good = this->Draw(window, Push, k - 1, projected, level.Targets[1 - level.Now]);
    level.Now = 1 - level.Now;
  }
  good = good &&
    this->Draw(
      window, Smoothing, 0, projected, images.GetTexels(), images.GetFactorTexels());
  images.SetIdSource(&projected, this->Levels[0].Textures[this->Levels[0].Now]);

  if (!this->Compute)
  {
    glBindVertexArray(0);
  }
  glUseProgram(0);
  return good;
}

//------------------------------------------------------------------------------
vtkIdType vtkPointSplatFill::GetMemorySize() const
{
  vtkIdType bytes = 0;
  for (const Level& level : this->Levels)
  {
    bytes += vtkIdType(2 * 8) * level.Size.x * level.Size.y;
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkPointSplatFill::ReleaseImages()
{
  for (const Level& level : this->Levels)
  {
    glDeleteTextures(2, level.Textures);
    if (this->Compute)
    {
      glDeleteBuffers(2, level.Targets);
    }
  }
  this->Levels.clear();
}

//------------------------------------------------------------------------------
void vtkPointSplatFill::Release()
{
  this->ReleaseImages();
  if (this->Framebuffer)
  {
    glDeleteFramebuffers(1, &this->Framebuffer);
    glDeleteVertexArrays(1, &this->VertexArray);
  }
  if (this->Changed)
  {
    glDeleteBuffers(1, &this->Changed);
  }
  this->Framebuffer = this->VertexArray = this->Changed = 0;
  for (auto& program : this->Programs)
  {
    program.second.Release();
  }
}
