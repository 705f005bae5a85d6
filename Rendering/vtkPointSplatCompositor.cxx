// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatCompositor.h"

#include "vtkActor.h"
#include "vtkCommand.h"
#include "vtkHardwareSelector.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointSplatMapper.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTimerLog.h"
#include "vtkVolume.h"

#include <algorithm>

//------------------------------------------------------------------------------
std::vector<vtkProp*> vtkPointSplatCompositor::VisibleProps(vtkRenderer* renderer)
{
  std::vector<vtkProp*> props;
  vtkCollectionSimpleIterator it;
  renderer->GetViewProps()->InitTraversal(it);
  while (vtkProp* prop = renderer->GetViewProps()->GetNextProp(it))
  {
    if (prop->GetVisibility())
    {
      props.push_back(prop);
    }
  }
  return props;
}

//------------------------------------------------------------------------------
bool vtkPointSplatCompositor::IsWithoutSplats(vtkProp* prop)
{
  vtkActor* actor = vtkActor::SafeDownCast(prop);
  auto* mapper = actor ? vtkPointSplatMapper::SafeDownCast(actor->GetMapper()) : nullptr;
  return mapper && !mapper->UpdateCloud();
}

class vtkPointSplatCompositor::FrameObserver : public vtkCommand
{
public:
  static FrameObserver* New() { return new FrameObserver; }
  void Execute(vtkObject*, unsigned long, void*) override { ++*this->Frame; }
  unsigned long* Frame = nullptr;
};

//------------------------------------------------------------------------------
vtkPointSplatCompositor::vtkPointSplatCompositor(vtkRenderer* renderer)
  : Renderer(renderer)
{
  vtkNew<FrameObserver> observer;
  observer->Frame = &this->Frame;
  this->ObserverTag = renderer->AddObserver(vtkCommand::StartEvent, observer);
}

//------------------------------------------------------------------------------
vtkPointSplatCompositor::~vtkPointSplatCompositor()
{
  if (this->Renderer)
  {
    this->Renderer->RemoveObserver(this->ObserverTag);
  }
  this->Context.Use([this] { this->ReleaseAll(); });
}

//------------------------------------------------------------------------------
std::shared_ptr<vtkPointSplatCompositor> vtkPointSplatCompositor::Of(vtkRenderer* renderer)
{
  static std::map<vtkRenderer*, std::weak_ptr<vtkPointSplatCompositor>> all;
  std::shared_ptr<vtkPointSplatCompositor> compositor = all[renderer].lock();
  if (compositor && compositor->Renderer != renderer)
  {
    compositor.reset(); // of a renderer that has gone, at the same address
  }
  if (!compositor)
  {
    // The moment to forget those whose renderers are gone.
    for (auto it = all.begin(); it != all.end();)
    {
      it = it->second.expired() ? all.erase(it) : std::next(it);
    }
    compositor = std::make_shared<vtkPointSplatCompositor>(renderer);
    all[renderer] = compositor;
  }
  return compositor;
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
  if (!this->Context.IsOf(window))
  {
    // Whatever is left belongs to another context, or to one that has gone.
    this->Context.Use([this] { this->ReleaseAll(); });
    this->Opaque.Invalidate();
    this->Translucent.Invalidate();
    this->Alone.clear();
    this->Shadows.Forget();
    this->SceneFrame = this->FlatFrame = this->EnvironmentFrame = 0;
    this->Window = window;
    this->Context.Set(window);
  }
  this->Users.insert(mapper);
  this->TransparencyUsed = "none";

  const vtkPointSplatView view = vtkPointSplatView::Current(renderer);
  if (view.Size.x <= 0 || view.Size.y <= 0)
  {
    return true;
  }
  const bool translucent = actor->IsRenderingTranslucentPolygonalGeometry();
  const glm::dmat4 matrix = vtkPointSplatView::Matrix(actor->GetMatrix());
  std::vector<Entry> entries = vtkPointSplatCompositor::Collect(renderer, translucent);
  auto found = std::find_if(entries.begin(), entries.end(),
    [&](const Entry& entry) { return entry.Actor == actor && entry.Item.MCWC == matrix; });
  size_t own = static_cast<size_t>(found - entries.begin());
  const bool joint = own < entries.size();
  bool flat = joint;
  if (joint && entries.size() > static_cast<size_t>(vtkPointSplatStages::MaximumSlots))
  {
    // More actors than tags can tell apart are drawn in batches, between which
    // the framebuffer's depth test, or the translucent pass, decides.
    const size_t slots = vtkPointSplatStages::MaximumSlots;
    const size_t first = own / slots * slots;
    const size_t last = std::min(entries.size(), first + slots);
    entries = std::vector<Entry>(
      entries.begin() + static_cast<long>(first), entries.begin() + static_cast<long>(last));
    own -= first;
    flat = false;
  }
  std::unique_ptr<vtkPointSplatLayers>* alone = nullptr;
  if (!joint)
  {
    if (renderer->GetSelector() &&
      actor->GetProperty()->GetOpacity() < mapper->GetPickOpacityThreshold())
    {
      return true;
    }
    entries.assign(1, Entry{ actor, mapper, {} });
    entries[0].Item.MCWC = matrix;
    own = 0;
    alone = &this->Alone[mapper];
    if (!*alone)
    {
      alone->reset(new vtkPointSplatLayers);
    }
  }
  if (flat && translucent)
  {
    for (vtkProp* prop : vtkPointSplatCompositor::VisibleProps(renderer))
    {
      const bool splats = std::any_of(
        entries.begin(), entries.end(), [prop](const Entry& e) { return e.Actor == prop; });
      flat = flat &&
        (splats || !prop->HasTranslucentPolygonalGeometry() || IsWithoutSplats(prop)) &&
        !(vtkVolume::SafeDownCast(prop) && renderer->GetUseDepthPeelingForVolumes());
    }
  }

  vtkPointSplatLayers& layers = alone ? **alone : translucent ? this->Translucent : this->Opaque;
  // Who comes first in a frame makes the layers, and meets all that they cost.
  const bool first = layers.GetBudget().IsNew(this->Frame) && !renderer->GetSelector();
  const bool timed = first && vtkPointSplatCompositor::IsInteracting(renderer);
  const unsigned long generation = layers.GetGeneration();
  double start = 0.0;
  if (timed)
  {
    glFinish();
    start = vtkTimerLog::GetUniversalTime();
  }
  bool sorted = false;
  const bool good = this->BuildAndPresent(
    renderer, actor, mapper, view, entries, own, joint, flat, sorted, layers);
  if (first)
  {
    double seconds = 0.0;
    if (timed && (sorted || layers.GetGeneration() != generation))
    {
      glFinish();
      seconds = vtkTimerLog::GetUniversalTime() - start;
    }
    layers.GetBudget().Measured(seconds, this->Frame);
  }
  return good;
}

//------------------------------------------------------------------------------
bool vtkPointSplatCompositor::BuildAndPresent(vtkRenderer* renderer, vtkActor* actor,
  vtkPointSplatMapper* mapper, const vtkPointSplatView& view, std::vector<Entry>& entries,
  size_t own, bool joint, bool flat, bool& isSorted, vtkPointSplatLayers& layers)
{
  const bool translucent = actor->IsRenderingTranslucentPolygonalGeometry();
  vtkPointSplatFlat::SortedLayers sorted = vtkPointSplatFlat::None;
  this->PrepareEnvironment(renderer, entries);
  if (!this->Build(renderer, view, entries, translucent, layers, flat, sorted))
  {
    return false;
  }
  isSorted = sorted != vtkPointSplatFlat::None;
  if (layers.GetNumberOfLayers() == 0 && sorted != vtkPointSplatFlat::All)
  {
    return true;
  }
  if (renderer->GetSelector())
  {
    vtkHardwareSelector* selector = renderer->GetSelector();
    selector->BeginRenderProp(); // sets the prop's colour
    const bool good =
      this->PresentSelection(renderer, actor, mapper, view, entries[own].Item, layers);
    selector->EndRenderProp();
    return good;
  }
  if (translucent)
  {
    return this->PresentTranslucent(
      renderer, actor, mapper, view, entries, joint, flat, sorted, layers);
  }
  return this->Resolve.Present(renderer, actor, mapper, view, entries[own].Item,
    layers.GetImages(0), layers.GetDepthUnit(), vtkPointSplatResolve::Shaded, 0);
}

//------------------------------------------------------------------------------
bool vtkPointSplatCompositor::PresentTranslucent(vtkRenderer* renderer, vtkActor* actor,
  vtkPointSplatMapper* mapper, const vtkPointSplatView& view, const std::vector<Entry>& entries,
  bool joint, bool flat, vtkPointSplatFlat::SortedLayers sorted, vtkPointSplatLayers& layers)
{
  this->TransparencyUsed = sorted == vtkPointSplatFlat::All ? "sorted"
    : sorted == vtkPointSplatFlat::AllButNearest            ? "nearest-exact"
                                                            : "peeling";
  const bool batched = joint && entries.front().Item.Slot == 0 && !flat &&
    entries.size() == static_cast<size_t>(vtkPointSplatStages::MaximumSlots);
  if (joint && !batched)
  {
    // Who comes first in a frame presents for all, in each pass of that frame; others may have
    // been culled, this one was not.
    if (this->PresenterFrame != this->Frame)
    {
      this->PresenterFrame = this->Frame;
      this->Presenter = actor;
    }
    if (this->Presenter != actor)
    {
      return true;
    }
  }
  if (flat)
  {
    if (this->FlatFrame != this->Frame || this->FlatGeneration != layers.GetGeneration())
    {
      std::vector<vtkPointSplatFlat::Part> parts;
      for (const Entry& entry : entries)
      {
        parts.push_back({ entry.Actor, entry.Mapper });
      }
      if (!this->Flat.Blend(renderer, parts, layers, this->Resolve, sorted, this->Refraction,
            this->Resolve.GetEnvironment()))
      {
        this->Error = this->Refraction.GetError();
        return false;
      }
      this->FlatFrame = this->Frame;
      this->FlatGeneration = layers.GetGeneration();
    }
    return this->Flat.Present(renderer, actor, mapper, view, this->Resolve);
  }
  return this->PresentLayers(renderer, actor, mapper, view, entries, batched, layers);
}

//------------------------------------------------------------------------------
bool vtkPointSplatCompositor::PresentLayers(vtkRenderer* renderer, vtkActor* actor,
  vtkPointSplatMapper* mapper, const vtkPointSplatView& view, const std::vector<Entry>& entries,
  bool batched, vtkPointSplatLayers& layers)
{
  bool good = true;
  if (this->Resolve.GetEnvironment() && vtkPointSplatRefraction::IsNeeded(layers) &&
    (!batched || entries.front().Actor == actor))
  {
    std::vector<vtkPointSplatMapper*> mappers;
    for (const Entry& entry : entries)
    {
      mappers.push_back(entry.Mapper);
    }
    good =
      this->Refraction.DrawImages(renderer, mappers, layers, *this->Resolve.GetEnvironment()) &&
      this->Resolve.PresentFlat(renderer, actor, mapper, view, this->Refraction.GetColour(),
        this->Refraction.GetDepth());
    this->Error = this->Refraction.GetError();
  }
  for (int layer = layers.GetNumberOfLayers() - 1; layer >= 0; --layer)
  {
    for (const Entry& entry : entries)
    {
      if (!batched || entry.Actor == actor)
      {
        good = this->Resolve.Present(renderer, entry.Actor, entry.Mapper, view, entry.Item,
                 layers.GetImages(layer), layers.GetDepthUnit(), vtkPointSplatResolve::Shaded, 0,
                 layers.IsGathered(layer)) &&
          good;
      }
    }
  }
  return good;
}

//------------------------------------------------------------------------------
bool vtkPointSplatCompositor::PresentSelection(vtkRenderer* renderer, vtkActor* actor,
  vtkPointSplatMapper* mapper, const vtkPointSplatView& view, const vtkPointSplatItem& item,
  vtkPointSplatLayers& layers)
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
  if (output == vtkPointSplatResolve::SelectionIds)
  {
    auto window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
    if (!layers.Identify(window, this->Stages, kind))
    {
      this->Error = layers.GetError();
      return false;
    }
  }
  return this->Resolve.Present(renderer, actor, mapper, view, item, layers.GetImages(0),
    layers.GetDepthUnit(), output, shift);
}

//------------------------------------------------------------------------------
vtkIdType vtkPointSplatCompositor::GetMemorySize() const
{
  vtkIdType bytes = this->Opaque.GetMemorySize() + this->Translucent.GetMemorySize() +
    this->Refraction.GetMemorySize();
  for (const auto& alone : this->Alone)
  {
    bytes += alone.second ? alone.second->GetMemorySize() : 0;
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkPointSplatCompositor::Leave(vtkPointSplatMapper* mapper, vtkWindow* window)
{
  this->Users.erase(mapper);
  auto alone = this->Alone.find(mapper);
  if (alone != this->Alone.end())
  {
    if (alone->second)
    {
      this->Context.Use([&alone] { alone->second->Release(); });
    }
    this->Last = this->Last == alone->second.get() ? nullptr : this->Last;
    this->Alone.erase(alone);
  }
  if (this->Users.empty() && window && this->Window == window)
  {
    this->ReleaseAll();
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatCompositor::ReleaseAll()
{
  for (auto& alone : this->Alone)
  {
    alone.second->Release();
  }
  this->Alone.clear();
  this->Opaque.Release();
  this->Translucent.Release();
  this->Scene.Release();
  this->Flat.Release();
  this->Refraction.Release();
  this->Environment.Release();
  this->Shadows.Release();
  this->Stages.Release();
  this->Resolve.Release();
  this->Last = nullptr;
  this->SceneFrame = this->FlatFrame = this->EnvironmentFrame = 0;
}
