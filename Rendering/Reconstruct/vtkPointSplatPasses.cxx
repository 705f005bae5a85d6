// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatPasses.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkPointSplatSavedState.h"
#include "vtkPointSplatUnits.h"

#include <algorithm>

namespace
{
// Room for layers before it is known how many there are.
constexpr int FirstPassLayers = 4;
}

//------------------------------------------------------------------------------
bool vtkPointSplatPasses::Reconstruct(
  const vtkPointSplatRequest& given, vtkPointSplatLayers& layers)
{
  vtkPointSplatRequest request = given;
  GLint room = 0;
  glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &room);
  request.MaximumLayers = request.GetMostLayers(room);
  const glm::ivec2& size = request.View.Size;
  const auto isPoints = [](const vtkPointSplatItem& item) { return item.IsPoints; };
  this->Fills = std::any_of(request.Items.begin(), request.Items.end(), isPoints);
  this->ByCompute = request.Compute && vtkPointSplatPointSums::Fits(size) &&
    std::all_of(request.Items.begin(), request.Items.end(), isPoints);
  const vtkPointSplatSums::Content content{ size, request.HasColours() || request.Gather,
    request.GetFactorCount(), request.HasIds || request.ShowsGreatest() };
  this->ByCompute ? this->Sums.AllocateBuffers(content) : this->Sums.AllocateImages(content);
  this->Items.Upload(request.Items, request.View);
  for (vtkPointSplatImage& image : this->Codes)
  {
    image.Allocate(size);
  }

  const int bound = request.GetLayersThatCount();
  int capacity = std::min(bound, std::max(FirstPassLayers, layers.GetCapacity()));
  int count = 0;
  for (bool fits = false; !fits;)
  {
    layers.AllocateImages(size, capacity, content.Factors, request.HasIds);
    bool empty = false;
    for (count = 0; count < capacity && !empty; ++count)
    {
      if (!this->MakeLayer(request, count, layers, empty))
      {
        return false;
      }
    }
    count -= empty ? 1 : 0;
    fits = empty || capacity == bound;
    capacity = std::min(bound, 2 * capacity);
  }
  layers.SetNumberOfLayers(count);
  layers.SetGathered(request.Gather ? request.MaximumLayers - 1 : -1);
  this->FillSteps = this->Fills ? this->Fill.GetNumberOfSteps() : 0;
  return true;
}

//------------------------------------------------------------------------------
bool vtkPointSplatPasses::MakeLayer(
  const vtkPointSplatRequest& request, int layer, vtkPointSplatLayers& layers, bool& empty)
{
  vtkPointSplatPeel peel;
  peel.Peels = request.IsPeeled();
  peel.Layer = layer;
  peel.Gather = request.Gather && layer == request.MaximumLayers - 1;
  peel.SceneDepth = request.SceneDepth;
  for (int k = 1; k <= std::min(layer, 3); ++k)
  {
    peel.Previous.push_back(this->Codes[static_cast<size_t>(layer - k) % 4].Get());
  }
  const vtkPointSplatImage& codes = this->Codes[static_cast<size_t>(layer) % 4];
  bool good = false;
  if (this->ByCompute)
  {
    const glm::ivec4 window = request.GetWindow();
    this->Sums.ClearRows(window.y, window.w);
    good = this->PointSums.Project(request, peel, this->Sums, empty);
  }
  else
  {
    good = this->Raster.Project(
      request, peel, this->Sums, this->Fills ? this->Sums.Depths : codes, empty);
  }
  this->Error = good ? "" : this->PointSums.GetError() + this->Raster.GetError();
  if (good && !empty && this->Fills)
  {
    good = this->Fill.Reconstruct(request, this->Items, this->Sums, layers, layer, codes);
    this->Error = this->Fill.GetError();
  }
  else if (good && !empty)
  {
    good = this->Normalise(request, layer, layers);
  }
  return good;
}

//------------------------------------------------------------------------------
bool vtkPointSplatPasses::Normalise(
  const vtkPointSplatRequest& request, int layer, vtkPointSplatLayers& layers)
{
  const bool factors = layers.GetFactorCount() > 0;
  const bool ids = request.HasIds && layer == 0;
  const std::string colours =
    request.GetAppearanceDefines(request.Gather && layer == request.MaximumLayers - 1);
  const std::string defines =
    (factors ? "#define FACTORS\n" : "") + colours + (ids ? "#define IDS\n" : "");
  vtkPointSplatProgram& program = this->Normalising[defines];
  if (!program.BuildScreen("vtkPointSplatNormaliseFS", defines))
  {
    this->Error = program.GetLog();
    return false;
  }
  vtkOpenGLRenderWindow* window = vtkPointSplatContext::Entered().GetWindow();
  const vtkPointSplatSavedState saved(window->GetState());
  saved.SetForImages(request.View.Size);
  std::vector<vtkPointSplatFramebuffer::Target> targets{ { layers.GetTexelImage(), layer } };
  if (factors)
  {
    targets.emplace_back(layers.GetFactorImage(), layer);
  }
  if (ids)
  {
    targets.emplace_back(layers.GetIdImage());
  }
  this->Framebuffer.Bind(window->GetState(), targets);
  program.Use();
  vtkPointSplatUnits units(window);
  this->Sums.Bind(units, program);
  units.Bind(program, "Depths", GL_TEXTURE_2D, this->Codes[static_cast<size_t>(layer) % 4].Get());
  if (!colours.empty())
  {
    units.Bind(program, "ItemTable", GL_TEXTURE_BUFFER, this->Items.GetTexture());
    units.Bind(program, "ValueTables", GL_TEXTURE_BUFFER, this->Items.GetValueTables());
  }
  program.Set("TagMask", request.GetTagMask());
  program.Set("DepthUnit", static_cast<float>(request.GetDepthUnit()));
  program.Set("PixelSize", request.View.GetPixelSize());
  this->Screen.Draw();
  return true;
}

//------------------------------------------------------------------------------
vtkIdType vtkPointSplatPasses::GetMemorySize() const
{
  vtkIdType bytes =
    this->Sums.GetMemorySize() + this->PointSums.GetMemorySize() + this->Fill.GetMemorySize();
  for (const vtkPointSplatImage& image : this->Codes)
  {
    bytes += image.GetMemorySize();
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkPointSplatPasses::Release()
{
  this->Items.Release();
  this->Sums.Release();
  for (vtkPointSplatImage& image : this->Codes)
  {
    image.Release();
  }
  this->Raster.Release();
  this->PointSums.Release();
  this->Fill.Release();
  this->Normalising.clear();
  this->Framebuffer.Release();
  this->Screen.Release();
}
