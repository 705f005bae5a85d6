// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatFrame.h"

#include "vtkActor.h"
#include "vtkCommand.h"
#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkMapper.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkPointSplatStopwatch.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace
{
/// Of the images of a layer, a pixel of the window, at most.
constexpr vtkIdType BytesByTiles = 28;
constexpr vtkIdType BytesALookTexel = 16;
constexpr vtkIdType BytesByQuads = 76;

GLint BoundFramebuffer()
{
  GLint framebuffer = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
  return framebuffer;
}

/// Windows that borrow another's context, as ParaView 6 has them, were not there when it was made.
bool HasContext(vtkOpenGLRenderWindow* window)
{
  return window->GetContextCreationTime() != 0 || window->IsCurrent();
}

int SelectionPassOf(vtkRenderer* renderer)
{
  return renderer->GetSelector() ? renderer->GetSelector()->GetCurrentPass() : -1;
}

/// Whether render passes that ask for keys take both actors or none.
bool HaveSameKeys(vtkActor* a, vtkActor* b)
{
  // What cullers leave out, since it is out of view, gets no keys: there is nothing of it to see.
  if (a->GetRenderTimeMultiplier() == 0.0 || b->GetRenderTimeMultiplier() == 0.0)
  {
    return true;
  }
  vtkInformation* first = a->GetPropertyKeys();
  vtkInformation* second = b->GetPropertyKeys();
  return first == second || ((!first || b->HasKeys(first)) && (!second || a->HasKeys(second)));
}
}

class vtkPointSplatFrame::Observer : public vtkCommand
{
public:
  static Observer* New() { return new Observer; }
  void Execute(vtkObject*, unsigned long, void*) override
  {
    ++this->Self->Frame;
    this->Self->Next.Begin(this->Self->Renderer);
  }
  vtkPointSplatFrame* Self = nullptr;
};

//------------------------------------------------------------------------------
vtkPointSplatFrame::vtkPointSplatFrame(vtkRenderer* renderer)
  : Renderer(renderer)
  , Next(this->Users)
{
  vtkNew<Observer> observer;
  observer->Self = this;
  this->ObserverTag = renderer->AddObserver(vtkCommand::StartEvent, observer);
}

//------------------------------------------------------------------------------
vtkPointSplatFrame::~vtkPointSplatFrame()
{
  if (this->Renderer)
  {
    this->Renderer->RemoveObserver(this->ObserverTag);
  }
}

//------------------------------------------------------------------------------
std::shared_ptr<vtkPointSplatFrame> vtkPointSplatFrame::Of(vtkRenderer* renderer)
{
  static std::map<vtkRenderer*, std::weak_ptr<vtkPointSplatFrame>> all;
  std::shared_ptr<vtkPointSplatFrame> frame = all[renderer].lock();
  if (frame && frame->Renderer != renderer)
  {
    frame.reset(); // of a renderer that has gone, at the same address
  }
  if (!frame)
  {
    // The moment to forget those whose renderers are gone.
    for (auto it = all.begin(); it != all.end();)
    {
      it = it->second.expired() ? all.erase(it) : std::next(it);
    }
    frame = std::make_shared<vtkPointSplatFrame>(renderer);
    all[renderer] = frame;
  }
  return frame;
}

//------------------------------------------------------------------------------
void vtkPointSplatFrame::SetWishes(const vtkPointSplatWishes* wishes)
{
  this->Wishes = wishes;
  this->Current = Pass();
}

//------------------------------------------------------------------------------
bool vtkPointSplatFrame::IsUnderWay(vtkActor* actor, bool translucent) const
{
  const Pass& pass = this->Current;
  return pass.Frame == this->Frame && pass.Translucent == translucent &&
    pass.Called.count(actor) == 0 && pass.SelectionPass == SelectionPassOf(this->Renderer) &&
    pass.Framebuffer == BoundFramebuffer() &&
    pass.View == vtkPointSplatView::Current(this->Renderer);
}

//------------------------------------------------------------------------------
void vtkPointSplatFrame::Begin(vtkActor* actor, bool translucent)
{
  this->Current = Pass();
  Pass& pass = this->Current;
  pass.Translucent = translucent;
  pass.Frame = this->Frame;
  pass.View = vtkPointSplatView::Current(this->Renderer);
  pass.Framebuffer = BoundFramebuffer();
  pass.SelectionPass = SelectionPassOf(this->Renderer);
  pass.Entries = vtkPointSplatCollection::Collect(this->Renderer, translucent, this->Wishes);
  // More actors than tags can tell apart are drawn each for itself.
  pass.Entries.resize(std::min(pass.Entries.size(), this->MostEntries(pass)));
  pass.Batched = pass.SelectionPass < 0 && vtkPointSplatResolve::AreHooksShared(actor);
  for (size_t i = 0; i < pass.Entries.size(); ++i)
  {
    vtkActor* other = pass.Entries[i].Actor;
    pass.Own[other] = i;
    pass.Batched = pass.Batched && HaveSameKeys(actor, other);
  }
  pass.Surfaces = translucent ? &this->Translucent : &this->Opaque;
}

//------------------------------------------------------------------------------
bool vtkPointSplatFrame::MayUseTiles(const Pass& pass)
{
  return vtkPointSplatTiles::IsSupported(pass.View.Size) &&
    std::none_of(
      pass.Entries.begin(), pass.Entries.end(), [](const vtkPointSplatEntry& entry) {
        return entry.Settings.Projection == vtkPointSplatSettings::Quads ||
          entry.Settings.Method == vtkPointSplatSettings::Deferred ||
          entry.Settings.Method == vtkPointSplatSettings::ImageSpace;
      });
}

//------------------------------------------------------------------------------
size_t vtkPointSplatFrame::MostEntries(const Pass& pass) const
{
  return vtkPointSplatFrame::MayUseTiles(pass) ? vtkPointSplatItemTable::MostSlots : vtkPointSplatPasses::MostItems;
}

//------------------------------------------------------------------------------
bool vtkPointSplatFrame::Present(
  vtkActor* actor, vtkPointSplatSource& source, vtkPointSplatReport& report)
{
  auto window = vtkOpenGLRenderWindow::SafeDownCast(this->Renderer->GetRenderWindow());
  if (!window)
  {
    this->Error = "The renderer has no OpenGL window.";
    return false;
  }
  if (!HasContext(window))
  {
    this->Error = "The window has no OpenGL context.";
    return false;
  }
  const vtkPointSplatContextScope scope(window);
  this->Users.insert(&source);
  const bool translucent = actor->IsRenderingTranslucentPolygonalGeometry() != 0;
  if (!this->IsUnderWay(actor, translucent))
  {
    this->Begin(actor, translucent);
  }
  Pass& pass = this->Current;
  if (pass.View.Size.x <= 0 || pass.View.Size.y <= 0)
  {
    return true;
  }
  pass.Called.insert(actor);
  const std::optional<size_t> own = OwnOf(pass, actor, source);
  if (!own)
  {
    return this->PresentAlone(actor, source, report);
  }
  if (!pass.Batched || !pass.Presented)
  {
    pass.Good = this->Draw(pass, actor, *own);
    pass.Presented = true;
  }
  this->Report(pass, *own, report);
  return pass.Good;
}

//------------------------------------------------------------------------------
std::optional<size_t> vtkPointSplatFrame::OwnOf(
  const Pass& pass, vtkActor* actor, const vtkPointSplatSource& source)
{
  const glm::dmat4 place = vtkPointSplatView::Matrix(actor->GetMatrix());
  auto own = pass.Own.find(actor);
  if (own == pass.Own.end())
  {
    // Props with several levels of detail draw by an actor that the renderer does not know.
    own = std::find_if(pass.Own.begin(), pass.Own.end(), [&](const auto& other) {
      const vtkPointSplatEntry& entry = pass.Entries[other.second];
      return entry.Source == &source && entry.Item.MCWC == place;
    });
  }
  if (own == pass.Own.end() || pass.Entries[own->second].Item.MCWC != place)
  {
    return {};
  }
  return own->second;
}

//------------------------------------------------------------------------------
bool vtkPointSplatFrame::PresentAlone(
  vtkActor* actor, vtkPointSplatSource& source, vtkPointSplatReport& report)
{
  Pass pass;
  pass.Translucent = this->Current.Translucent;
  pass.Frame = this->Frame;
  pass.View = this->Current.View;
  pass.SelectionPass = this->Current.SelectionPass;
  pass.Joint = false;
  pass.Batched = pass.SelectionPass < 0;
  pass.Entries.push_back(
    vtkPointSplatCollection::MakeEntry(this->Renderer, actor, &source, this->Wishes));
  if (pass.SelectionPass >= 0 &&
    actor->GetProperty()->GetOpacity() < pass.Entries[0].Settings.PickOpacityThreshold)
  {
    return true;
  }
  std::unique_ptr<vtkPointSplatSurfaces>& surfaces = this->Alone[&source];
  if (!surfaces)
  {
    surfaces.reset(new vtkPointSplatSurfaces);
  }
  pass.Surfaces = surfaces.get();
  const bool good = this->Draw(pass, actor, 0);
  this->Report(pass, 0, report);
  return good;
}

//------------------------------------------------------------------------------
bool vtkPointSplatFrame::Draw(Pass& pass, vtkActor* actor, size_t own)
{
  // Who comes first in a frame makes the layers, and meets all that they cost.
  vtkPointSplatBudget& budget = pass.Surfaces->Budget;
  const bool first = budget.IsNew(this->Frame) && pass.SelectionPass < 0;
  vtkPointSplatStopwatch watch(first && vtkPointSplatStopwatch::IsInteracting(this->Renderer));
  const unsigned long generation = pass.Surfaces->GetGeneration();
  const vtkPointSplatView whole = pass.View;
  pass.Parts = vtkPointSplatFrame::PartsOf(pass, actor);
  pass.Layers = 0;
  pass.Projected.assign(pass.Entries.size(), {});
  bool good = true;
  for (pass.Part = 0; pass.Part < pass.Parts.size(); ++pass.Part)
  {
    const vtkPointSplatWindowPart& part = pass.Parts[pass.Part];
    pass.View = pass.Parts.size() > 1 ? whole.Part(part.First, part.Size) : whole;
    // What was made for the actor before is of the last part.
    const bool built = pass.Presented && pass.Parts.size() == 1 ? pass.Good : this->Build(pass);
    good = built && this->DrawPart(pass, actor, own) && good;
  }
  pass.View = whole;
  if (first)
  {
    const bool made =
      pass.Surfaces->GetGeneration() != generation || pass.Sorted != vtkPointSplatFlat::None;
    budget.Measured(made ? watch.GetSeconds() : 0.0, this->Frame);
  }
  return good;
}

//------------------------------------------------------------------------------
std::vector<vtkPointSplatWindowPart> vtkPointSplatFrame::PartsOf(const Pass& pass, vtkActor* actor)
{
  vtkInformation* keys = actor->GetPropertyKeys();
  if (pass.Translucent && keys && keys->Has(vtkOpenGLRenderPass::RenderPasses()))
  {
    // Depth peeling draws to images of its own, between which layers must be kept.
    return vtkPointSplatWindowParts::Divide(pass.View.Size, BytesByTiles, 0);
  }
  vtkIdType most = 0;
  int texels = 0;
  for (const vtkPointSplatEntry& entry : pass.Entries)
  {
    texels = std::max(texels, entry.Item.Look.GetTexels());
    const vtkIdType bytes = entry.Settings.MaximumWindowMemory;
    most = bytes > 0 && (most == 0 || bytes < most) ? bytes : most;
  }
  return vtkPointSplatWindowParts::Divide(pass.View.Size,
    vtkPointSplatFrame::MayUseTiles(pass) ? BytesByTiles + BytesALookTexel * texels
                                          : BytesByQuads,
    most);
}

//------------------------------------------------------------------------------
glm::ivec4 vtkPointSplatFrame::ShownWindow(const Pass& pass)
{
  const glm::ivec4 window = pass.Surfaces->GetRequest().GetWindow();
  const glm::ivec4& shown = pass.Parts[pass.Part].Shown;
  return { std::max(window.x, shown.x), std::max(window.y, shown.y), std::min(window.z, shown.z),
    std::min(window.w, shown.w) };
}

//------------------------------------------------------------------------------
bool vtkPointSplatFrame::DrawPart(Pass& pass, vtkActor* actor, size_t own)
{
  pass.Layers = std::max(pass.Layers, pass.Surfaces->GetLayers().GetNumberOfLayers());
  for (size_t slot = 0; slot < pass.Entries.size(); ++slot)
  {
    const vtkPointSplatProjected projected = pass.Surfaces->GetProjected(slot);
    pass.Projected[slot].Splats += projected.Splats;
    pass.Projected[slot].Triangles += projected.Triangles;
  }
  return pass.SelectionPass >= 0 ? this->PresentSelection(pass, actor, own)
                                 : this->PresentLayers(pass, actor, own);
}

//------------------------------------------------------------------------------
bool vtkPointSplatFrame::PresentLayers(Pass& pass, vtkActor* actor, size_t own)
{
  const vtkPointSplatLayers& layers = pass.Surfaces->GetLayers();
  const glm::ivec4 window = vtkPointSplatFrame::ShownWindow(pass);
  if ((layers.GetNumberOfLayers() == 0 && pass.Sorted == vtkPointSplatFlat::None) ||
    window.x > window.z || window.y > window.w)
  {
    return true;
  }
  std::vector<vtkPointSplatMaterials::Entry> materials;
  for (const vtkPointSplatEntry& entry : pass.Entries)
  {
    materials.push_back(vtkPointSplatCollection::MakeMaterial(entry));
  }
  this->Materials.Upload(materials);
  const vtkPointSplatLights lights(this->Renderer, pass.View);
  const vtkPointSplatShading shading{ pass.View, &lights, &this->Materials,
    this->HasEnvironment ? &this->Environment : nullptr,
    this->Materials.ArePhysical() && this->Radiance.Prepare(this->Renderer) ? &this->Radiance
                                                                            : nullptr,
    pass.Shadowed ? this->Shadows.GetMaps() : nullptr };
  const vtkPointSplatResolve::Target target{ this->Renderer, actor,
    pass.Entries[own].Source->GetMapper(), window,
    pass.Translucent || pass.Surfaces->GetOutlines().GetCount() == 0 ||
      !vtkPointSplatCollection::HasOpaqueAfter(this->Renderer, pass.Entries[own].Actor),
    !pass.Translucent };
  const int slot = pass.Batched ? -1 : static_cast<int>(own);
  if (pass.Translucent && !this->Flatten(pass, shading))
  {
    this->Error = this->Flat.GetError();
    return false;
  }
  if (pass.Measures && !this->MeasureErrors(pass, shading))
  {
    this->Error = this->Errors.GetError();
    return false;
  }
  const bool good = pass.Translucent
    ? this->PresentTranslucent(pass, shading, target, slot)
    : this->Resolve.Present(
        target, shading, { layers, pass.Surfaces->GetOutlines() }, 0, slot);
  this->Error = good ? this->Error : this->Resolve.GetError();
  return good;
}

//------------------------------------------------------------------------------
bool vtkPointSplatFrame::Flatten(Pass& pass, const vtkPointSplatShading& shading)
{
  vtkPointSplatSurfaces& surfaces = *pass.Surfaces;
  if ((!pass.Flat && !shading.Reflects()) ||
    (surfaces.FlatFrame == this->Frame && surfaces.FlatGeneration == surfaces.GetGeneration()))
  {
    return true;
  }
  surfaces.FlatFrame = this->Frame;
  surfaces.FlatGeneration = surfaces.GetGeneration();
  const vtkPointSplatRequest& request = surfaces.GetRequest();
  const vtkPointSplatLayers& layers = surfaces.GetLayers();
  return pass.Flat ? this->Flat.Blend(shading, request, layers, pass.Sorted, surfaces.Flat)
                   : this->Flat.Refract(shading, request, layers, surfaces.Flat);
}

//------------------------------------------------------------------------------
bool vtkPointSplatFrame::PresentTranslucent(Pass& pass, const vtkPointSplatShading& shading,
  const vtkPointSplatResolve::Target& target, int slot)
{
  vtkPointSplatSurfaces& surfaces = *pass.Surfaces;
  const vtkPointSplatLayers& layers = surfaces.GetLayers();
  const vtkPointSplatResolve::Source source{ layers, surfaces.GetOutlines() };
  bool good = true;
  if (pass.Flat || (shading.Reflects() && !pass.Presented))
  {
    good = this->Resolve.PresentFlat(target, pass.View, surfaces.Flat, surfaces.GetOutlines());
  }
  for (int layer = layers.GetNumberOfLayers() - 1; layer >= 0 && !pass.Flat; --layer)
  {
    good = this->Resolve.Present(target, shading, source, layer, slot) && good;
  }
  return good;
}

//------------------------------------------------------------------------------
bool vtkPointSplatFrame::PresentSelection(Pass& pass, vtkActor* actor, size_t own)
{
  const vtkPointSplatRequest& request = pass.Surfaces->GetRequest();
  if (pass.Surfaces->GetLayers().GetNumberOfLayers() == 0)
  {
    return true;
  }
  const vtkPointSplatEntry& entry = pass.Entries[own];
  const bool showsLevels = entry.Settings.LevelOfDetail && entry.Item.Cloud->GetLevels().AreMade();
  const vtkPointSplatResolve::Selection selection{ request.HasIds,
    pass.SelectionPass == vtkHardwareSelector::POINT_ID_HIGH24 ||
        pass.SelectionPass == vtkHardwareSelector::CELL_ID_HIGH24
      ? 24
      : 0,
    showsLevels && this->Renderer->GetPreserveDepthBuffer() ? pass.Choice.ShownLevelPixels : 0.0 };
  const vtkPointSplatResolve::Target target{ this->Renderer, actor,
    entry.Source->GetMapper(), vtkPointSplatFrame::ShownWindow(pass), false, false };
  vtkHardwareSelector* selector = this->Renderer->GetSelector();
  selector->BeginRenderProp(); // sets the prop's colour
  if (pass.SelectionPass == vtkHardwareSelector::COMPOSITE_INDEX_PASS && !request.HasIds)
  {
    selector->RenderCompositeIndex(1);
  }
  const bool good = this->Resolve.PresentSelection(
    target, pass.View, pass.Surfaces->GetLayers(), static_cast<int>(own), selection);
  selector->EndRenderProp();
  this->Error = good ? this->Error : this->Resolve.GetError();
  return good;
}

//------------------------------------------------------------------------------
void vtkPointSplatFrame::Report(
  const Pass& pass, size_t own, vtkPointSplatReport& report) const
{
  const vtkPointSplatItem& item = pass.Entries[own].Item;
  const vtkPointSplatRequest& request = pass.Surfaces->GetRequest();
  report.Settings = pass.Entries[own].Settings;
  report.Choice = pass.Choice;
  report.Projection = request.Compute ? "compute" : "quads";
  report.Method = item.IsPoints ? "image-space" : request.Deferred ? "deferred" : "two-pass";
  report.Transparency = !pass.Translucent || pass.SelectionPass >= 0 ? "none"
    : pass.Sorted == vtkPointSplatFlat::All           ? "sorted"
    : pass.Sorted == vtkPointSplatFlat::AllButNearest ? "nearest-exact"
                                                      : "peeling";
  report.Layers = pass.Layers;
  report.FillSteps = pass.Surfaces->GetNumberOfFillSteps();
  report.ProjectedSpacing = item.Points.SpacingPixels;
  report.ImageMemory = this->GetMemorySize();
  report.Projected = own < pass.Projected.size() ? pass.Projected[own] : vtkPointSplatProjected();
  report.StrideShift = item.StrideShift;
  report.ShadowSamples = this->Shadows.GetSamplesUsed();
  report.ShadowReason = this->Shadows.GetSamplesReason();
  report.ShadowUpdates = this->Shadows.GetNumberOfUpdates();
  report.HasEnvironment = this->HasEnvironment;
}

//------------------------------------------------------------------------------
void vtkPointSplatFrame::AskForNext()
{
  this->Next.Ask(this->Renderer);
}

//------------------------------------------------------------------------------
vtkPointSplatLightMaps* vtkPointSplatFrame::PrepareLightMaps()
{
  auto window = vtkOpenGLRenderWindow::SafeDownCast(this->Renderer->GetRenderWindow());
  if (!window || !HasContext(window))
  {
    return nullptr;
  }
  const vtkPointSplatContextScope scope(window);
  window->GetShaderCache()->ReleaseCurrentShader();
  if (!this->Shadows.UpdateMaps(this->Renderer, this->Reconstruction, true))
  {
    this->Error = this->Shadows.GetError();
    return nullptr;
  }
  return this->Shadows.GetMaps();
}

//------------------------------------------------------------------------------
vtkIdType vtkPointSplatFrame::GetMemorySize() const
{
  vtkIdType bytes = this->Reconstruction.GetMemorySize() + this->Opaque.GetMemorySize() +
    this->Translucent.GetMemorySize();
  for (const auto& alone : this->Alone)
  {
    bytes += alone.second->GetMemorySize();
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkPointSplatFrame::Leave(vtkPointSplatSource& source, vtkWindow* window)
{
  auto own = vtkOpenGLRenderWindow::SafeDownCast(window);
  this->Users.erase(&source);
  this->Current = Pass();
  if (own)
  {
    const vtkPointSplatContextScope scope(own);
    this->Alone.erase(&source);
  }
  else
  {
    this->Alone.erase(&source);
  }
  if (this->Users.empty() && own && this->Renderer && this->Renderer->GetRenderWindow() == own)
  {
    const vtkPointSplatContextScope scope(own);
    this->ReleaseAll();
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatFrame::ReleaseAll()
{
  this->Alone.clear();
  this->Opaque.Release();
  this->Translucent.Release();
  this->Trial.Release();
  this->Flat.Release();
  this->Errors.Release();
  this->Reconstruction.Release();
  this->Resolve.Release();
  this->Materials.Release();
  this->Looks.Release();
  this->Shadows.Release();
  this->Scene.clear();
  this->Environment.Release();
  this->SceneFrame = this->EnvironmentFrame = 0;
}
