// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatCompositor.h"

#include "vtkActor.h"
#include "vtkHardwareSelector.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointSplatMapper.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <map>

namespace
{
// One pass by quads beats two of them where there are this many splats a pixel of the
// viewport; compute shaders beat both (Testing/Benchmark/deferred_benchmark.py).
constexpr double LeastSplatsPerPixel = 0.75;
}

//------------------------------------------------------------------------------
std::shared_ptr<vtkPointSplatCompositor> vtkPointSplatCompositor::Of(vtkRenderer* renderer)
{
  static std::map<vtkRenderer*, std::weak_ptr<vtkPointSplatCompositor>> all;
  std::shared_ptr<vtkPointSplatCompositor> compositor = all[renderer].lock();
  if (!compositor)
  {
    // The moment to forget those whose renderers are gone.
    for (auto it = all.begin(); it != all.end();)
    {
      it = it->second.expired() ? all.erase(it) : std::next(it);
    }
    compositor = std::make_shared<vtkPointSplatCompositor>();
    all[renderer] = compositor;
  }
  return compositor;
}

//------------------------------------------------------------------------------
std::vector<vtkPointSplatCompositor::Entry> vtkPointSplatCompositor::CollectOpaque(
  vtkRenderer* renderer)
{
  std::vector<Entry> entries;
  vtkCollectionSimpleIterator it;
  renderer->GetViewProps()->InitTraversal(it);
  while (vtkProp* prop = renderer->GetViewProps()->GetNextProp(it))
  {
    // What cannot be picked does not hide what can.
    if (!prop->GetVisibility() || (renderer->GetSelector() && !prop->GetPickable()))
    {
      continue;
    }
    vtkActor* actor = vtkActor::SafeDownCast(prop);
    vtkPointSplatMapper* mapper =
      actor ? vtkPointSplatMapper::SafeDownCast(actor->GetMapper()) : nullptr;
    if (mapper && mapper->UpdateCloud() && actor->HasOpaqueGeometry())
    {
      Entry entry{ actor, mapper, {} };
      entry.Item.MCWC = vtkPointSplatView::Matrix(actor->GetMatrix());
      entries.push_back(entry);
    }
  }
  return entries;
}

//------------------------------------------------------------------------------
bool vtkPointSplatCompositor::WantsCompute(vtkOpenGLRenderWindow* window,
  const std::vector<Entry>& entries, const glm::ivec2& size) const
{
  // All items share the images, so that one mapper's wish for quads decides.
  for (const Entry& entry : entries)
  {
    if (entry.Mapper->GetProjection() == vtkPointSplatMapper::QUADS)
    {
      return false;
    }
  }
  return vtkPointSplatStages::ComputeSupported(window) && vtkPointSplatImages::FitCompute(size);
}

//------------------------------------------------------------------------------
bool vtkPointSplatCompositor::WantsDeferred(
  const std::vector<Entry>& entries, const glm::ivec2& size, bool compute)
{
  this->MethodReason.clear();
  bool wanted = false;
  bool automatic = true;
  vtkIdType bytes = 0;
  vtkIdType splats = 0;
  for (const Entry& entry : entries)
  {
    wanted = wanted || entry.Mapper->GetMethod() == vtkPointSplatMapper::DEFERRED;
    automatic = automatic && entry.Mapper->GetMethod() == vtkPointSplatMapper::AUTOMATIC_METHOD;
    bytes = std::max(bytes, entry.Mapper->GetMaximumImageMemory());
    splats += entry.Mapper->GetNumberOfSplats();
  }
  wanted = wanted ||
    (automatic && !compute &&
      splats > LeastSplatsPerPixel * size.x * static_cast<double>(size.y));
  int groups = 0;
  for (const Entry& entry : entries)
  {
    if (wanted && !entry.Mapper->MakeGroups())
    {
      this->MethodReason = "the splats cannot be grouped.";
      return false;
    }
    groups = std::max(groups, entry.Mapper->GetNumberOfGroups());
  }
  if (wanted && !vtkPointSplatDeferred::Fits(size, groups, bytes))
  {
    this->MethodReason = "images for " + std::to_string(groups) + " groups of " +
      std::to_string(size.x) + " x " + std::to_string(size.y) +
      " pixels are more than MaximumImageMemory or the hardware allows; lower OverlapFactor.";
    return false;
  }
  return wanted;
}

//------------------------------------------------------------------------------
bool vtkPointSplatCompositor::Build(
  vtkRenderer* renderer, const vtkPointSplatView& view, std::vector<Entry>& entries)
{
  auto window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  bool compute = this->WantsCompute(window, entries, view.Size);
  const bool deferred = this->WantsDeferred(entries, view.Size, compute);
  compute = compute && !deferred;
  bool voronoi = true;
  std::vector<vtkPointSplatItem> items;
  std::vector<vtkMTimeType> times;
  int slot = 0;
  double layer = 0.0;
  bool colours = false;
  for (Entry& entry : entries)
  {
    entry.Item.Slot = slot++;
    entry.Mapper->FillItem(entry.Actor, view, entry.Item);
    layer = std::max(layer, entry.Item.LargestLayer);
    colours = colours || entry.Item.Cloud->HasColours();
    voronoi = voronoi && entry.Mapper->GetVoronoiDepth();
    items.push_back(entry.Item);
    times.push_back(entry.Item.Cloud->GetMTime());
  }
  const float voronoiScale = !deferred ? -1.0f : voronoi ? static_cast<float>(layer) : 0.0f;
  if (this->Built && this->View == view && this->Items == items && this->CloudTimes == times &&
    this->Images.IsCompute() == compute && this->VoronoiScale == voronoiScale)
  {
    this->View.Origin = view.Origin;
    return true;
  }

  this->Built = false;
  this->IdentifiedKind = -1;
  this->VoronoiScale = voronoiScale;
  this->Images.Allocate(compute, view.Size, colours);
  if (compute)
  {
    // Only the rows that something can cover are emptied, and read.
    glm::ivec4 rows(0, view.Size.y, view.Size.x - 1, -1);
    for (const vtkPointSplatItem& item : items)
    {
      if (item.Window.x <= item.Window.z)
      {
        rows.y = std::min(rows.y, item.Window.y);
        rows.w = std::max(rows.w, item.Window.w);
      }
    }
    this->Images.ClearBuffers(rows);
  }
  // Splats seen edge-on may lie 5 layer distances off along the ray; see
  // sameLayer() in vtkPointSplatProjection.glsl.
  this->DepthUnit = static_cast<float>(5.0 * layer);
  const bool good = deferred
    ? this->Deferred.Reconstruct(window, view, items, this->Images, this->DepthUnit, voronoiScale)
    : this->Stages.Reconstruct(window, view, items, this->Images, this->DepthUnit);
  if (!good)
  {
    this->Error = deferred ? this->Deferred.GetError() : this->Stages.GetError();
    return false;
  }
  this->Built = true;
  this->View = view;
  this->Items = std::move(items);
  this->CloudTimes = std::move(times);
  return true;
}

//------------------------------------------------------------------------------
bool vtkPointSplatCompositor::Present(
  vtkRenderer* renderer, vtkActor* actor, vtkPointSplatMapper* mapper)
{
  auto window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window)
  {
    this->Error = "The renderer has no OpenGL window.";
    return false;
  }
  if (this->Window != window)
  {
    // Whatever is left belongs to a context that has gone.
    this->Built = false;
    this->Window = window;
  }
  this->Users.insert(mapper);

  const vtkPointSplatView view = vtkPointSplatView::Current(renderer);
  if (view.Size.x <= 0 || view.Size.y <= 0)
  {
    return true;
  }
  std::vector<Entry> entries;
  size_t own = 0;
  const glm::dmat4 matrix = vtkPointSplatView::Matrix(actor->GetMatrix());
  if (!actor->IsRenderingTranslucentPolygonalGeometry())
  {
    entries = vtkPointSplatCompositor::CollectOpaque(renderer);
    auto found = std::find_if(entries.begin(), entries.end(),
      [&](const Entry& entry) { return entry.Actor == actor && entry.Item.MCWC == matrix; });
    own = static_cast<size_t>(found - entries.begin());
    if (own < entries.size())
    {
      // More actors than tags can tell apart are drawn in batches, between which
      // the framebuffer's depth test decides.
      const size_t first = own / vtkPointSplatStages::MaximumSlots * vtkPointSplatStages::MaximumSlots;
      const size_t last =
        std::min<size_t>(entries.size(), first + vtkPointSplatStages::MaximumSlots);
      entries = std::vector<Entry>(
        entries.begin() + static_cast<long>(first), entries.begin() + static_cast<long>(last));
      own -= first;
    }
  }
  if (entries.empty() || own >= entries.size())
  {
    entries.assign(1, Entry{ actor, mapper, {} });
    entries[0].Item.MCWC = matrix;
    own = 0;
  }

  if (!this->Build(renderer, view, entries))
  {
    return false;
  }
  if (renderer->GetSelector())
  {
    vtkHardwareSelector* selector = renderer->GetSelector();
    selector->BeginRenderProp(); // sets the prop's colour
    const bool good = this->PresentSelection(renderer, actor, mapper, view, entries[own].Item);
    selector->EndRenderProp();
    return good;
  }
  return this->Resolve.Present(renderer, actor, mapper, view, entries[own].Item, this->Images,
    this->DepthUnit, vtkPointSplatResolve::Shaded, 0);
}

//------------------------------------------------------------------------------
bool vtkPointSplatCompositor::PresentSelection(vtkRenderer* renderer, vtkActor* actor,
  vtkPointSplatMapper* mapper, const vtkPointSplatView& view, const vtkPointSplatItem& item)
{
  vtkHardwareSelector* selector = renderer->GetSelector();
  vtkPointSplatResolve::Output output = vtkPointSplatResolve::SelectionIds;
  vtkPointSplatCloud::IdKind kind = vtkPointSplatCloud::PointIds;
  int shift = 0;
  switch (selector->GetCurrentPass())
  {
    case vtkHardwareSelector::POINT_ID_HIGH24:
      shift = 24;
      break;
    case vtkHardwareSelector::POINT_ID_LOW24:
      break;
    case vtkHardwareSelector::CELL_ID_HIGH24:
      shift = 24;
      kind = vtkPointSplatCloud::CellIds;
      break;
    case vtkHardwareSelector::CELL_ID_LOW24:
      kind = vtkPointSplatCloud::CellIds;
      break;
    case vtkHardwareSelector::COMPOSITE_INDEX_PASS:
      kind = vtkPointSplatCloud::CompositeIds;
      if (!mapper->HasCompositeInput())
      {
        selector->RenderCompositeIndex(1);
        output = vtkPointSplatResolve::SelectionColour;
      }
      break;
    default:
      output = vtkPointSplatResolve::SelectionColour;
      break;
  }
  if (output == vtkPointSplatResolve::SelectionIds && this->IdentifiedKind != kind)
  {
    auto window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
    if (!this->Stages.Identify(window, view, this->Items, this->Images, kind))
    {
      this->Error = this->Stages.GetError();
      return false;
    }
    this->IdentifiedKind = kind;
  }
  return this->Resolve.Present(
    renderer, actor, mapper, view, item, this->Images, this->DepthUnit, output, shift);
}

//------------------------------------------------------------------------------
void vtkPointSplatCompositor::Leave(vtkPointSplatMapper* mapper, vtkWindow* window)
{
  this->Users.erase(mapper);
  if (this->Users.empty() && window && this->Window == window)
  {
    this->Images.Release();
    this->Stages.Release();
    this->Deferred.Release();
    this->Resolve.Release();
    this->Built = false;
  }
}
