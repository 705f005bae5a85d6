// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatFill.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkPointSplatSavedState.h"
#include "vtkPointSplatUnits.h"

#include <algorithm>
#include <cmath>

namespace
{
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
constexpr float FilledPixels = 0.45f;
}

//------------------------------------------------------------------------------
vtkPointSplatProgram* vtkPointSplatFill::Use(const char* file, const std::string& defines)
{
  vtkPointSplatProgram& program = this->Programs[file + defines];
  if (!program.BuildScreen(file, defines))
  {
    this->Error = program.GetLog();
    return nullptr;
  }
  program.Use();
  return &program;
}

//------------------------------------------------------------------------------
void vtkPointSplatFill::SetLevel(
  vtkPointSplatProgram& program, vtkPointSplatUnits& units, size_t index) const
{
  const Level& level = this->Levels[index];
  program.Set("FilledWindow", level.Window);
  program.Set("LastPixel", level.Images[0].GetSize() - 1);
  program.Set("PixelSize", std::ldexp(1.0f, static_cast<int>(index)) * this->PixelSize);
  program.Set("TagMask", this->TagMask);
  units.Bind(program, "ItemTable", GL_TEXTURE_BUFFER, this->Items->GetTexture());
}

//------------------------------------------------------------------------------
void vtkPointSplatFill::Draw(const glm::ivec2& size, const glm::ivec4& window)
{
  vtkOpenGLState* state = vtkPointSplatContext::Entered().GetWindow()->GetState();
  state->vtkglViewport(0, 0, size.x, size.y);
  state->vtkglScissor(window.x, window.y, window.z - window.x + 1, window.w - window.y + 1);
  this->Screen.Draw();
}

//------------------------------------------------------------------------------
bool vtkPointSplatFill::Step(const vtkPointSplatSums& sums, size_t index, bool first)
{
  vtkPointSplatProgram* program =
    this->Use("vtkPointSplatFillFS", first ? sums.GetDefines() + "#define FIRST_FILL\n" : "");
  if (!program)
  {
    return false;
  }
  vtkOpenGLRenderWindow* window = vtkPointSplatContext::Entered().GetWindow();
  vtkPointSplatUnits units(window);
  Level& level = this->Levels[index];
  this->SetLevel(*program, units, index);
  if (first)
  {
    sums.Bind(units, *program);
  }
  else
  {
    units.Bind(*program, "Filled", GL_TEXTURE_2D, level.Images[level.Now].Get());
  }
  level.Now = 1 - level.Now;
  this->Framebuffer.Bind(window->GetState(), { level.Images[level.Now] });
  this->Draw(level.Images[0].GetSize(), level.Window);
  return true;
}

//------------------------------------------------------------------------------
bool vtkPointSplatFill::Pull(size_t index)
{
  vtkPointSplatProgram* program = this->Use("vtkPointSplatPushPullFS", "");
  if (!program)
  {
    return false;
  }
  vtkOpenGLRenderWindow* window = vtkPointSplatContext::Entered().GetWindow();
  vtkPointSplatUnits units(window);
  const Level& level = this->Levels[index];
  Level& coarse = this->Levels[index + 1];
  coarse.Now = 0;
  this->SetLevel(*program, units, index);
  units.Bind(*program, "Filled", GL_TEXTURE_2D, level.Images[level.Now].Get());
  this->Framebuffer.Bind(window->GetState(), { coarse.Images[0] });
  this->Draw(coarse.Images[0].GetSize(), coarse.Window);
  return true;
}

//------------------------------------------------------------------------------
bool vtkPointSplatFill::Push(size_t index)
{
  vtkPointSplatProgram* program = this->Use("vtkPointSplatPushPullFS", "#define PUSH\n");
  if (!program)
  {
    return false;
  }
  vtkOpenGLRenderWindow* window = vtkPointSplatContext::Entered().GetWindow();
  vtkPointSplatUnits units(window);
  Level& level = this->Levels[index];
  const Level& coarse = this->Levels[index + 1];
  this->SetLevel(*program, units, index);
  units.Bind(*program, "Filled", GL_TEXTURE_2D, level.Images[level.Now].Get());
  units.Bind(*program, "Coarse", GL_TEXTURE_2D, coarse.Images[coarse.Now].Get());
  program->Set("CoarseWindow", coarse.Window);
  program->Set("CoarseLastPixel", coarse.Images[0].GetSize() - 1);
  program->Set("PixelsNeeded", FilledPixels);
  program->Set("LevelScale", std::ldexp(1.0f, static_cast<int>(index)));
  level.Now = 1 - level.Now;
  this->Framebuffer.Bind(window->GetState(), { level.Images[level.Now] });
  this->Draw(level.Images[0].GetSize(), level.Window);
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
bool vtkPointSplatFill::Reconstruct(const vtkPointSplatRequest& request,
  const vtkPointSplatItemTable& items, const vtkPointSplatSums& sums, vtkPointSplatLayers& layers,
  int layer, const vtkPointSplatImage& codes)
{
  const vtkPointSplatView& view = request.View;
  int count = 1;
  for (const vtkPointSplatItem& item : request.Items)
  {
    count = std::max(
      count, item.IsPoints ? vtkPointSplatFill::LevelsFor(item.Points.SpacingPixels) : 1);
  }
  // Coarser levels stay, for frames that need them again.
  this->Levels.resize(std::max(this->Levels.size(), static_cast<size_t>(count)));
  const glm::ivec4 window = request.GetWindow();
  glm::ivec2 size = view.Size;
  for (int k = 0; k < count; ++k)
  {
    Level& level = this->Levels[static_cast<size_t>(k)];
    level.Images[0].Allocate(size);
    level.Images[1].Allocate(size);
    level.Window = window >> k;
    size = (size + 1) / 2;
  }
  this->Items = &items;
  this->TagMask = request.GetTagMask();
  this->PixelSize = view.GetPixelSize();

  vtkOpenGLRenderWindow* own = vtkPointSplatContext::Entered().GetWindow();
  vtkOpenGLState* state = own->GetState();
  const vtkPointSplatSavedState saved(state);
  saved.SetForImages(view.Size);
  state->vtkglEnable(GL_SCISSOR_TEST);
  bool good = this->Step(sums, 0, true);
  const size_t top = static_cast<size_t>(count - 1);
  for (size_t k = 0; good && k < top; ++k)
  {
    good = this->Pull(k);
  }
  for (this->Steps = 1; good && this->Steps < request.FillSteps; ++this->Steps)
  {
    good = this->Step(sums, top, false);
  }
  for (size_t k = top; good && k > 0; --k)
  {
    good = this->Push(k - 1);
  }
  const bool ids = request.HasIds && layer == 0;
  const bool factors = layers.GetFactorCount() > 0;
  const std::string colours =
    request.GetAppearanceDefines(request.Gather && layer == request.MaximumLayers - 1);
  vtkPointSplatProgram* program = good
    ? this->Use("vtkPointSplatSmoothFS",
        sums.GetDefines() + colours + (ids ? "#define IDS\n" : ""))
    : nullptr;
  if (!program)
  {
    return false;
  }
  const Level& filled = this->Levels[0];
  vtkPointSplatUnits units(own);
  this->SetLevel(*program, units, 0);
  sums.Bind(units, *program);
  if (!colours.empty())
  {
    units.Bind(*program, "ValueTables", GL_TEXTURE_BUFFER, items.GetValueTables());
  }
  view.SetPixelRays(*program);
  units.Bind(*program, "Filled", GL_TEXTURE_2D, filled.Images[filled.Now].Get());
  program->Set("DepthUnit", static_cast<float>(request.GetDepthUnit()));
  std::vector<vtkPointSplatFramebuffer::Target> targets{ { layers.GetTexelImage(), layer },
    codes };
  if (factors)
  {
    targets.emplace_back(layers.GetFactorImage(), layer);
  }
  if (ids)
  {
    targets.emplace_back(layers.GetIdImage());
  }
  this->Result.Bind(state, targets);
  this->Draw(view.Size, window);
  return true;
}

//------------------------------------------------------------------------------
vtkIdType vtkPointSplatFill::GetMemorySize() const
{
  vtkIdType bytes = 0;
  for (const Level& level : this->Levels)
  {
    bytes += level.Images[0].GetMemorySize() + level.Images[1].GetMemorySize();
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkPointSplatFill::Release()
{
  this->Programs.clear();
  this->Levels.clear();
  this->Framebuffer.Release();
  this->Result.Release();
  this->Screen.Release();
}
