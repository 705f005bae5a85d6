// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatLayers.h"

#include "vtkOpenGLRenderWindow.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
bool vtkPointSplatLayersRequest::operator==(const vtkPointSplatLayersRequest& other) const
{
  return this->View == other.View && this->Items == other.Items &&
    this->CloudTimes == other.CloudTimes && this->Compute == other.Compute &&
    this->VoronoiScale == other.VoronoiScale && this->FillSteps == other.FillSteps &&
    this->MaximumLayers == other.MaximumLayers &&
    this->LeastContribution == other.LeastContribution && this->Gather == other.Gather && this->LeastOpacity == other.LeastOpacity &&
    this->MaximumMemory == other.MaximumMemory && this->SceneDepth == other.SceneDepth &&
    (this->SceneDepth == 0 || this->Frame == other.Frame);
}

//------------------------------------------------------------------------------
bool vtkPointSplatLayers::Build(vtkOpenGLRenderWindow* window,
  vtkPointSplatLayersRequest request, vtkPointSplatStages& stages)
{
  if (this->Built && this->Request == request)
  {
    this->Request.View.Origin = request.View.Origin;
    return true;
  }
  this->Built = false;
  this->IdentifiedKind = -1;
  this->Request = std::move(request);
  this->Count = 0;
  ++this->Generation;

  double layer = 0.0;
  for (const vtkPointSplatItem& item : this->Request.Items)
  {
    layer = std::max(layer, item.LargestLayer);
  }
  // Splats seen edge-on may lie 5 layer distances off along the ray; see
  // sameLayer() in vtkPointSplatProjection.glsl. Nothing lies farther off than the clipping planes:
  // one actor of huge splats must not coarsen the unit of all without bound.
  const double range = this->Request.View.Far - this->Request.View.Near;
  this->DepthUnit =
    static_cast<float>(layer > 0.0 && 5.0 * layer < range ? 5.0 * layer : range);

  double remaining = 1.0; // of the light behind the layers so far, at most
  bool empty = false;
  while (this->Count < this->Request.MaximumLayers && remaining >= this->Request.LeastContribution)
  {
    if (this->Count > 0 && this->Request.MaximumMemory > 0 &&
      this->GetMemorySize() / this->Count * (this->Count + 1) > this->Request.MaximumMemory)
    {
      break;
    }
    if (!this->BuildLayer(window, stages, empty))
    {
      return false;
    }
    if (empty)
    {
      break;
    }
    ++this->Count;
    remaining *= 1.0 - this->Request.LeastOpacity;
  }
  // Images of frames that needed more layers go, but for the one that was tried last.
  const size_t used = static_cast<size_t>(this->Count) + 1;
  while (this->Layers.size() > used)
  {
    this->Layers.back()->Release();
    this->Layers.pop_back();
  }
  this->Built = true;
  return true;
}

//------------------------------------------------------------------------------
bool vtkPointSplatLayers::BuildLayer(
  vtkOpenGLRenderWindow* window, vtkPointSplatStages& stages, bool& empty)
{
  const vtkPointSplatLayersRequest& r = this->Request;
  const size_t index = static_cast<size_t>(this->Count);
  if (index == this->Layers.size())
  {
    this->Layers.emplace_back(new vtkPointSplatImages);
  }
  vtkPointSplatImages& images = *this->Layers[index];
  bool colours = false;
  int factors = 0;
  // Only the rectangle that something can cover is filled, and only its rows are emptied.
  glm::ivec4 covered(r.View.Size.x, r.View.Size.y, -1, -1);
  for (const vtkPointSplatItem& item : r.Items)
  {
    colours = colours || item.Cloud->HasColours();
    factors = std::max(factors, item.FactorCount);
    if (item.Window.x <= item.Window.z)
    {
      // And one row more: in multisampled framebuffers Mesa lets samples of the next one through.
      covered = glm::ivec4(std::min(covered.x, item.Window.x),
        std::min(covered.y, std::max(item.Window.y - 1, 0)), std::max(covered.z, item.Window.z),
        std::max(covered.w, std::min(item.Window.w + 1, r.View.Size.y - 1)));
    }
  }
  vtkPointSplatPeel peel;
  peel.Gather = this->IsGathered(this->Count);
  peel.SceneDepth = r.SceneDepth;
  peel.Layer = this->Count;
  for (size_t k = index; k > 0 && peel.Previous.size() < 3; --k)
  {
    peel.Previous.push_back(this->Layers[k - 1].get());
  }
  const bool filled = r.FillSteps > 0;
  vtkPointSplatImages& projected = filled ? this->Projected : images;
  projected.Allocate(r.Compute, r.View.Size, colours || peel.Gather, factors);
  if (r.Compute)
  {
    projected.ClearBuffers(covered);
  }
  empty = false;
  const bool peeling = r.MaximumLayers > 1 || r.SceneDepth;
  if (r.VoronoiScale >= 0.0f)
  {
    if (!this->Deferred.Reconstruct(
          window, r.View, r.Items, images, this->DepthUnit, r.VoronoiScale))
    {
      this->Error = this->Deferred.GetError();
      return false;
    }
    return true;
  }
  if (!stages.Reconstruct(window, r.View, r.Items, projected, this->DepthUnit,
        peeling ? &peel : nullptr, peeling ? &empty : nullptr))
  {
    this->Error = stages.GetError();
    return false;
  }
  if (filled && !empty)
  {
    images.AllocateFilled(r.Compute, r.View.Size, factors);
    if (!this->Fill.Reconstruct(window, r.View, r.Items, projected, covered, r.FillSteps,
          this->DepthUnit, images))
    {
      this->Error = this->Fill.GetError();
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkPointSplatLayers::Identify(
  vtkOpenGLRenderWindow* window, vtkPointSplatStages& stages, vtkPointSplatCloud::IdKind kind)
{
  if (this->IdentifiedKind == kind || this->Count == 0)
  {
    return true;
  }
  vtkPointSplatImages& images =
    this->Request.FillSteps > 0 ? this->Projected : *this->Layers[0];
  if (!stages.Identify(window, this->Request.View, this->Request.Items, images, kind))
  {
    this->Error = stages.GetError();
    return false;
  }
  this->IdentifiedKind = kind;
  return true;
}

//------------------------------------------------------------------------------
vtkIdType vtkPointSplatLayers::GetMemorySize() const
{
  vtkIdType bytes = this->Deferred.GetMemorySize() + this->Projected.GetMemorySize() +
    this->Fill.GetMemorySize();
  for (const auto& layer : this->Layers)
  {
    bytes += layer->GetMemorySize();
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkPointSplatLayers::Release()
{
  for (auto& layer : this->Layers)
  {
    layer->Release();
  }
  this->Layers.clear();
  this->Deferred.Release();
  this->Projected.Release();
  this->Fill.Release();
  this->Count = 0;
  this->Built = false;
}
