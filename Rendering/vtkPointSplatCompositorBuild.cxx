// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Of the compositor: which actors make layers, by what method, and what is asked of the stages.
#include "vtkPointSplatCompositor.h"

#include "vtkActor.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointSplatMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace
{
// One pass by quads beats two of them where there are this many splats a pixel of the
// viewport; compute shaders beat both (Testing/Benchmark/deferred_benchmark.py).
constexpr double LeastSplatsPerPixel = 0.75;

// Points at most this far apart, in pixels, leave holes of single pixels only.
constexpr double OneStepPixels = 0.5;
}

//------------------------------------------------------------------------------
std::vector<vtkPointSplatCompositor::Entry> vtkPointSplatCompositor::Collect(
  vtkRenderer* renderer, bool translucent)
{
  std::vector<Entry> entries;
  for (vtkProp* prop : vtkPointSplatCompositor::VisibleProps(renderer))
  {
    vtkActor* actor = vtkActor::SafeDownCast(prop);
    vtkPointSplatMapper* mapper =
      actor ? vtkPointSplatMapper::SafeDownCast(actor->GetMapper()) : nullptr;
    if (!mapper || !mapper->UpdateCloud() ||
      !(renderer->GetSelector() || // which draws all as if they were opaque
        (translucent ? actor->HasTranslucentPolygonalGeometry() : actor->HasOpaqueGeometry())))
    {
      continue;
    }
    // What cannot be picked does not hide what can.
    if (renderer->GetSelector() &&
      (!prop->GetPickable() ||
        actor->GetProperty()->GetOpacity() < mapper->GetPickOpacityThreshold()))
    {
      continue;
    }
    Entry entry{ actor, mapper, {} };
    entry.Item.MCWC = vtkPointSplatView::Matrix(actor->GetMatrix());
    entries.push_back(entry);
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
void vtkPointSplatCompositor::PrepareEnvironment(
  vtkRenderer* renderer, const std::vector<Entry>& entries)
{
  const bool wanted = !renderer->GetSelector() &&
    std::any_of(entries.begin(), entries.end(),
      [](const Entry& entry) { return entry.Mapper->GetRefraction(); });
  if (wanted && this->EnvironmentFrame != this->Frame)
  {
    this->HasPreparedEnvironment = this->Environment.Prepare(renderer);
    this->EnvironmentFrame = this->Frame;
  }
  this->Resolve.SetEnvironment(
    wanted && this->HasPreparedEnvironment ? &this->Environment : nullptr);
}

//------------------------------------------------------------------------------
GLuint vtkPointSplatCompositor::CaptureScene(
  vtkRenderer* renderer, const vtkPointSplatView& view, bool& failed)
{
  failed = false;
  bool opaque = false;
  for (vtkProp* prop : vtkPointSplatCompositor::VisibleProps(renderer))
  {
    opaque = opaque || prop->HasOpaqueGeometry();
  }
  if (!opaque || renderer->GetSelector())
  {
    return 0;
  }
  if (this->SceneFrame != this->Frame)
  {
    auto window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
    GLint draw = 0;
    GLint read = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw);
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read);
    glm::ivec2 origin = view.Origin;
    if (draw != read)
    {
      // Depth peeling draws to images of the viewport's size; the scene is still where the renderer's
      // viewport has it, unless a pass chain draws to images itself.
      origin = glm::ivec2(0);
      if (read == static_cast<GLint>(window->GetRenderFramebuffer()->GetFBOIndex()))
      {
        int size[2];
        renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin.x, &origin.y);
      }
    }
    this->SceneGood = this->Scene.Capture(window, origin, view.Size);
    this->SceneFrame = this->Frame;
  }
  failed = !this->SceneGood;
  return this->SceneGood ? this->Scene.GetTexture() : 0;
}

//------------------------------------------------------------------------------
bool vtkPointSplatCompositor::MakeFactors(vtkRenderer* renderer, std::vector<Entry>& entries)
{
  auto window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  if (renderer->GetSelector())
  {
    return true;
  }
  bool computed = false;
  for (const Entry& entry : entries)
  {
    computed = computed || entry.Mapper->GetShadows();
  }
  if (computed && !this->Shadows.Update(renderer))
  {
    this->Error = this->Shadows.GetError();
    return false;
  }
  for (Entry& entry : entries)
  {
    vtkPointSplatItem& item = entry.Item;
    item.Factors = 0;
    item.FactorCount = 0;
    item.FactorVersion = 0;
    if (entry.Mapper->GetShadows())
    {
      item.Factors = this->Shadows.GetFactors(item.Cloud, item.MCWC);
      item.FactorCount = item.Factors ? this->Shadows.GetNumberOfLights() : 0;
      item.FactorVersion = this->Shadows.GetNumberOfUpdates();
    }
    else if (item.Cloud->GetFactorCount() > 0)
    {
      item.Factors = item.Cloud->Upload(window).Factors;
      item.FactorCount = item.Cloud->GetFactorCount();
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkPointSplatCompositor::Build(vtkRenderer* renderer, const vtkPointSplatView& view,
  std::vector<Entry>& entries, bool translucent, vtkPointSplatLayers& layers, bool& flat,
  vtkPointSplatFlat::SortedLayers& sorted)
{
  auto window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkPointSplatLayersRequest request;
  request.View = view;
  request.Compute = this->WantsCompute(window, entries, view.Size);
  bool voronoi = true;
  bool refracts = false;
  double layer = 0.0;
  int slot = 0;
  if (translucent)
  {
    request.MaximumLayers = 1;
    request.LeastOpacity = 1.0;
  }
  sorted = vtkPointSplatFlat::None;
  bool points = false;
  for (const Entry& entry : entries)
  {
    points = points || entry.Mapper->GetMethod() == vtkPointSplatMapper::IMAGE_SPACE;
  }
  for (const Entry& entry : entries)
  {
    const int wanted = entry.Mapper->GetTransparency();
    if (translucent && flat && sorted == vtkPointSplatFlat::None)
    {
      sorted = wanted == vtkPointSplatMapper::SORTED ? vtkPointSplatFlat::All
        : wanted == vtkPointSplatMapper::NEAREST_EXACT ? vtkPointSplatFlat::AllButNearest
                                                       : vtkPointSplatFlat::None;
    }
  }
  bool failed = false;
  if (translucent)
  {
    request.SceneDepth = this->CaptureScene(renderer, view, failed);
    request.Frame = this->Frame;
    flat = flat && !failed;
    // Points that are projected as single pixels have no extent to be sorted with.
    sorted = flat && !points ? sorted : vtkPointSplatFlat::None;
  }
  const bool deferred =
    !translucent && !points && this->WantsDeferred(entries, view.Size, request.Compute);
  request.Compute = request.Compute && !deferred;
  for (Entry& entry : entries)
  {
    vtkPointSplatMapper* mapper = entry.Mapper;
    entry.Item.Slot = slot++;
    const double scale =
      sorted != vtkPointSplatFlat::None ? mapper->MakeCoveringGroups() : 1.0;
    mapper->FillItem(entry.Actor, view, entry.Item);
    entry.Item.Refracts = mapper->GetRefraction() && this->Resolve.GetEnvironment();
    refracts = refracts || entry.Item.Refracts;
    entry.Item.CoveringScale = scale;
    layer = std::max(layer, entry.Item.LargestLayer);
    voronoi = voronoi && mapper->GetVoronoiDepth();
    if (entry.Item.Points)
    {
      request.FillSteps = std::max(request.FillSteps,
        entry.Item.SpacingPixels > OneStepPixels ? mapper->GetMaximumNumberOfFillSteps() : 1);
    }
    if (translucent)
    {
      request.MaximumLayers = std::max(request.MaximumLayers, mapper->GetMaximumNumberOfLayers());
      request.Gather = request.Gather || mapper->GetGatherRemaining();
      request.MaximumMemory = std::max(request.MaximumMemory, mapper->GetMaximumImageMemory());
      // Points with opacities of their own may let all light through.
      request.LeastOpacity = std::min(request.LeastOpacity,
        mapper->HasTranslucentPolygonalGeometry() ? 0.0
                                                  : entry.Actor->GetProperty()->GetOpacity());
    }
  }
  if (!this->MakeFactors(renderer, entries))
  {
    return false;
  }
  for (const Entry& entry : entries)
  {
    request.Items.push_back(entry.Item);
    request.CloudTimes.push_back(entry.Item.Cloud->GetMTime());
  }
  layer = std::min(layer, view.Far - view.Near);
  request.VoronoiScale = !deferred ? -1.0f : voronoi ? static_cast<float>(layer) : 0.0f;
  if (sorted != vtkPointSplatFlat::None)
  {
    // What the nearest layer reflects and refracts needs it, sorted or not.
    request.MaximumLayers = sorted == vtkPointSplatFlat::All && !refracts ? 0 : 1;
    request.Gather = false;
  }
  this->Last = &layers;
  if (!layers.Build(window, std::move(request), this->Stages))
  {
    this->Error = layers.GetError();
    return false;
  }
  return true;
}
