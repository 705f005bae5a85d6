// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatErrors.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkPointSplatSavedState.h"
#include "vtkPointSplatUnits.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr int MostAcross = 128; // pixels of the grid
constexpr int Images = static_cast<int>(vtkPointSplatErrors::Shares) / 4;
}

//------------------------------------------------------------------------------
void vtkPointSplatErrors::TakeBehind(
  GLuint framebuffer, const glm::ivec2& origin, const glm::ivec2& size)
{
  vtkOpenGLState* state = vtkPointSplatContext::Entered().GetWindow()->GetState();
  const vtkPointSplatSavedState saved(state);
  this->Behind.Allocate(size);
  this->Framebuffer.Bind(state, { this->Behind });
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
  saved.SetForImages(size);
  glBlitFramebuffer(origin.x, origin.y, origin.x + size.x, origin.y + size.y, 0, 0, size.x, size.y,
    GL_COLOR_BUFFER_BIT, GL_NEAREST);
  this->HasBehind = true;
}

//------------------------------------------------------------------------------
void vtkPointSplatErrors::ForgetBehind()
{
  this->Behind.Release();
  this->HasBehind = false;
}

//------------------------------------------------------------------------------
bool vtkPointSplatErrors::Draw(const vtkPointSplatShading& shading,
  const vtkPointSplatLayers& layers, const glm::ivec4& window, const std::vector<float>& lights)
{
  const std::string defines = layers.GetDefines() +
    shading.GetDefines(layers.GetGathered() >= 0) + (lights.empty() ? "#define BLEND\n" : "");
  vtkPointSplatProgram& program = this->Programs[defines];
  if (!program.BuildScreen("vtkPointSplatErrorsFS", defines))
  {
    this->Error = program.GetLog();
    return false;
  }
  const glm::ivec2 size = glm::clamp(glm::ivec2(window.z - window.x + 1, window.w - window.y + 1),
    glm::ivec2(1), glm::ivec2(MostAcross));
  this->Pixels.Allocate(size, Images);
  std::vector<vtkPointSplatFramebuffer::Target> targets;
  for (int image = 0; image < (lights.empty() ? 1 : Images); ++image)
  {
    targets.emplace_back(this->Pixels, image);
  }
  vtkOpenGLRenderWindow* window3D = vtkPointSplatContext::Entered().GetWindow();
  const vtkPointSplatSavedState saved(window3D->GetState());
  this->Framebuffer.Bind(window3D->GetState(), targets);
  saved.SetForImages(size);
  program.Use();
  vtkPointSplatUnits units(window3D);
  layers.Bind(units, program);
  shading.Bind(units, program, layers.GetFactorCount());
  units.Bind(program, "Behind", GL_TEXTURE_2D, this->HasBehind ? this->Behind.Get() : 0);
  program.Set("HasBehind", this->HasBehind);
  program.Set("GridSize", size);
  program.Set("GridWindow", window);
  if (!lights.empty())
  {
    program.Set("EndLights", lights);
  }
  this->Screen.Draw();
  shading.Unbind();
  return true;
}

//------------------------------------------------------------------------------
std::vector<float> vtkPointSplatErrors::Download(int image) const
{
  const glm::ivec2 size = this->Pixels.GetSize();
  std::vector<float> texels(4 * static_cast<size_t>(size.x) * static_cast<size_t>(size.y));
  vtkOpenGLState* state = vtkPointSplatContext::Entered().GetWindow()->GetState();
  const vtkPointSplatSavedState saved(state);
  vtkPointSplatFramebuffer framebuffer;
  framebuffer.Bind(state, { { this->Pixels, image } });
  glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_FLOAT, texels.data());
  return texels;
}

//------------------------------------------------------------------------------
std::vector<double> vtkPointSplatErrors::MeasureEnds(const vtkPointSplatShading& shading,
  const vtkPointSplatLayers& layers, const glm::ivec4& window, const std::vector<float>& lights)
{
  std::vector<double> sums;
  size_t covered = 0;
  for (int image = 0; image < Images; ++image)
  {
    if (image == 0 && !this->Draw(shading, layers, window, lights))
    {
      return {};
    }
    const std::vector<float> squares = this->Download(image);
    sums.resize(sums.size() + 4, 0.0);
    covered = 0;
    for (size_t i = 0; i < squares.size(); ++i)
    {
      const bool counts = squares[i] >= 0.0f;
      sums[sums.size() - 4 + i % 4] += counts ? squares[i] : 0.0;
      covered += counts && i % 4 == 0;
    }
  }
  for (double& sum : sums)
  {
    sum = std::sqrt(sum / static_cast<double>(std::max<size_t>(covered, 1)));
  }
  return covered > 0 ? sums : std::vector<double>();
}

//------------------------------------------------------------------------------
std::vector<float> vtkPointSplatErrors::Blend(const vtkPointSplatShading& shading,
  const vtkPointSplatLayers& layers, const glm::ivec4& window)
{
  return this->Draw(shading, layers, window, {}) ? this->Download(0) : std::vector<float>();
}

//------------------------------------------------------------------------------
double vtkPointSplatErrors::Difference(const std::vector<float>& a, const std::vector<float>& b)
{
  double sum = 0.0;
  size_t covered = 0;
  for (size_t i = 0; i + 3 < std::min(a.size(), b.size()); i += 4)
  {
    if (a[i + 3] > 0.0f || b[i + 3] > 0.0f)
    {
      ++covered;
      for (size_t k = 0; k < 3; ++k)
      {
        // Pictures end at white.
        sum += std::pow(std::min(a[i + k], 1.0f) - std::min(b[i + k], 1.0f), 2.0) / 3.0;
      }
    }
  }
  return covered > 0 ? std::sqrt(sum / static_cast<double>(covered)) : 0.0;
}

//------------------------------------------------------------------------------
void vtkPointSplatErrors::Release()
{
  this->Programs.clear();
  this->Pixels.Release();
  this->ForgetBehind();
  this->Framebuffer.Release();
  this->Screen.Release();
}
