// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Of the compositor: which actors make layers, and what is asked of the stages.
#include "vtkPointSplatCompositor.h"

#include "vtkActor.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointSplatMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>

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
  if (computed &&
    !this->Shadows.Update(renderer, vtkPointSplatCompositor::IsInteracting(renderer)))
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
  bool voronoi = true;
  double layer = 0.0;
  int slot = 0;
  if (translucent)
  {
    bool failed = false;
    request.SceneDepth = this->CaptureScene(renderer, view, failed);
    request.Frame = this->Frame;
    request.LeastOpacity = 1.0;
    flat = flat && !failed;
  }
  this->Choose(renderer, view, entries, translucent, flat, layers);
  const vtkPointSplatChoice& choice = this->Choice;
  sorted = !translucent || choice.Transparency == vtkPointSplatMapper::PEELING
    ? vtkPointSplatFlat::None
    : choice.Transparency == vtkPointSplatMapper::SORTED ? vtkPointSplatFlat::All
                                                         : vtkPointSplatFlat::AllButNearest;
  const bool deferred = choice.Method == vtkPointSplatMapper::DEFERRED;
  request.Compute = choice.Compute;
  request.MaximumLayers = choice.MaximumLayers;
  request.LeastContribution = choice.LeastContribution;
  request.FillSteps = choice.FillSteps;
  for (Entry& entry : entries)
  {
    vtkPointSplatMapper* mapper = entry.Mapper;
    entry.Item.Slot = slot++;
    entry.Item.CoveringScale =
      sorted != vtkPointSplatFlat::None ? mapper->MakeCoveringGroups(choice) : 1.0;
    mapper->FillItem(entry.Actor, view, choice, entry.Item);
    entry.Item.Refracts = mapper->GetRefraction() && this->Resolve.GetEnvironment();
    layer = std::max(layer, entry.Item.LargestLayer);
    voronoi = voronoi && mapper->GetVoronoiDepth();
    if (translucent)
    {
      request.Gather =
        request.Gather || (sorted == vtkPointSplatFlat::None && mapper->GetGatherRemaining());
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
  this->Last = &layers;
  if (!layers.Build(window, std::move(request), this->Stages))
  {
    this->Error = layers.GetError();
    return false;
  }
  return true;
}
