// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Of the frame: from the actors of a pass to their layers.
#include "vtkPointSplatFrame.h"

#include "vtkActor.h"
#include "vtkHardwareSelector.h"
#include "vtkMapper.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkPointSplatStopwatch.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace
{
using Settings = vtkPointSplatSettings;

bool AnyOf(const vtkPointSplatCollection::Entries& entries, bool (*test)(const Settings&))
{
  return std::any_of(entries.begin(), entries.end(),
    [test](const vtkPointSplatEntry& entry) { return test(entry.Settings); });
}

/// Ids that a selection's pass wants, if any.
bool IdsOf(int selectionPass, bool composite, vtkPointSplatCloud::IdKind& kind)
{
  switch (selectionPass)
  {
    case vtkHardwareSelector::POINT_ID_HIGH24:
    case vtkHardwareSelector::POINT_ID_LOW24:
      kind = vtkPointSplatCloud::PointIds;
      return true;
    case vtkHardwareSelector::CELL_ID_HIGH24:
    case vtkHardwareSelector::CELL_ID_LOW24:
      kind = vtkPointSplatCloud::CellIds;
      return true;
    case vtkHardwareSelector::COMPOSITE_INDEX_PASS:
      kind = vtkPointSplatCloud::CompositeIds;
      return composite;
    default:
      return false;
  }
}
}

//------------------------------------------------------------------------------
GLuint vtkPointSplatFrame::CaptureScene(const Pass& pass, bool& failed)
{
  failed = false;
  const std::vector<vtkProp*> props = vtkPointSplatCollection::VisibleProps(this->Renderer);
  if (std::none_of(
        props.begin(), props.end(), [](vtkProp* prop) { return prop->HasOpaqueGeometry() != 0; }))
  {
    return 0;
  }
  if (this->SceneFrame != this->Frame || !(this->SceneParts == pass.Parts))
  {
    // Of all parts at once: later passes have other framebuffers.
    this->SceneGood = this->CaptureParts(pass);
    this->SceneFrame = this->Frame;
    this->SceneParts = pass.Parts;
  }
  failed = !this->SceneGood;
  return this->SceneGood ? this->Scene[pass.Part]->GetTexture() : 0;
}

//------------------------------------------------------------------------------
bool vtkPointSplatFrame::CaptureParts(const Pass& pass)
{
  auto window = static_cast<vtkOpenGLRenderWindow*>(this->Renderer->GetRenderWindow());
  GLint draw = 0;
  GLint read = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw);
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read);
  glm::ivec2 origin = pass.View.Origin - pass.Parts[pass.Part].First;
  if (draw != read)
  {
    // Depth peeling draws to images of the viewport's size; the scene is still where the renderer's
    // viewport has it, unless a pass chain draws to images itself.
    origin = glm::ivec2(0);
    if (read == static_cast<GLint>(window->GetRenderFramebuffer()->GetFBOIndex()))
    {
      int size[2];
      this->Renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin.x, &origin.y);
    }
  }
  this->Scene.resize(pass.Parts.size());
  bool good = true;
  for (size_t i = 0; i < pass.Parts.size(); ++i)
  {
    if (!this->Scene[i])
    {
      this->Scene[i].reset(new vtkPointSplatSceneDepth);
    }
    const vtkPointSplatWindowPart& part = pass.Parts[i];
    good = this->Scene[i]->Capture(window, origin + part.First, part.Size) && good;
  }
  return good;
}

//------------------------------------------------------------------------------
void vtkPointSplatFrame::PrepareEnvironment(const Pass& pass)
{
  const bool wanted = AnyOf(pass.Entries, [](const Settings& s) { return s.Refraction; });
  if (wanted && this->EnvironmentFrame != this->Frame)
  {
    this->EnvironmentGood = this->Environment.Prepare(this->Renderer);
    this->EnvironmentFrame = this->Frame;
  }
  this->HasEnvironment = wanted && this->EnvironmentGood;
}

//------------------------------------------------------------------------------
void vtkPointSplatFrame::Choose(Pass& pass)
{
  const bool selects = pass.SelectionPass >= 0;
  std::vector<vtkActor*> actors;
  for (const vtkPointSplatEntry& entry : pass.Entries)
  {
    actors.push_back(entry.Actor);
  }
  const double seconds =
    selects ? 0.0 : vtkPointSplatStopwatch::AllocatedSeconds(this->Renderer, actors);
  vtkPointSplatFacts facts = vtkPointSplatCollection::Describe(
    pass.Entries, pass.View, pass.Translucent, seconds > 0.0 ? 1.0 : 0.0);
  facts.Compute = vtkPointSplatTiles::IsSupported(pass.View.Size);
  facts.Sortable = pass.Flat;
  facts.Refracts = this->HasEnvironment;
  facts.Selects = selects;
  facts.AsksDeferred = facts.AsksDeferred && !selects; // it knows no ids
  if (facts.AsksDeferred && !facts.Translucent)
  {
    vtkPointSplatCollection::MakeGroups(pass.Entries, pass.View, facts);
  }
  const bool interacts = seconds > 0.0;
  if (this->CanMeasure(pass, facts, interacts))
  {
    vtkPointSplatMeasuredErrors& errors = pass.Surfaces->Errors;
    errors.Look(this->Renderer, pass.Entries, pass.View, facts.TargetError,
      pass.Surfaces->GetGeneration());
    pass.Measures = errors.IsStale();
    facts.EndErrors = errors.GetEnds();
    facts.ApartErrors = errors.GetApart();
    // Not while the user drags: that frame would take as long as one at rest, and longer.
    if (pass.Measures && !interacts)
    {
      facts.Apart = 0.0;
    }
  }
  std::vector<vtkPointSplatChoice> ladder = interacts
    ? vtkPointSplatChoices::Ladder(facts)
    : std::vector<vtkPointSplatChoice>{ vtkPointSplatChoices::Make(facts) };
  if (selects)
  {
    // As at rest, and of no account to a drag.
    pass.Choice = ladder[0];
    pass.Choice.BudgetReason = "selections take as long as they need";
    return;
  }
  pass.Choice = ladder[pass.Surfaces->Budget.Choose(ladder, seconds, this->Frame)];
  pass.Facts = facts;
  // Layers can be measured in passing where a drag's frame has all of them.
  pass.Measures = pass.Measures &&
    (facts.Apart == 0.0 ||
      (pass.Translucent &&
        pass.Choice.LeastContribution <= vtkPointSplatChoices::FullQuality));
  pass.Sorted = pass.Choice.Transparency == Settings::Sorted ? vtkPointSplatFlat::All
    : pass.Choice.Transparency == Settings::NearestExact     ? vtkPointSplatFlat::AllButNearest
                                                             : vtkPointSplatFlat::None;
}

//------------------------------------------------------------------------------
bool vtkPointSplatFrame::CastShadows(Pass& pass)
{
  if (pass.SelectionPass >= 0)
  {
    return true;
  }
  pass.Shadowed = AnyOf(pass.Entries, [](const Settings& s) { return s.Shadows; });
  if (pass.Shadowed && !this->Shadows.Update(this->Renderer, this->Reconstruction))
  {
    this->Error = this->Shadows.GetError();
    return false;
  }
  for (vtkPointSplatEntry& entry : pass.Entries)
  {
    this->Shadows.SetFactors(entry.Item, entry.Settings.Shadows, pass.Choice.Deferred);
  }
  return true;
}

//------------------------------------------------------------------------------
vtkPointSplatRequest vtkPointSplatFrame::MakeRequest(Pass& pass, GLuint sceneDepth)
{
  const vtkPointSplatChoice& choice = pass.Choice;
  vtkPointSplatRequest request;
  request.View = pass.View;
  request.Compute = choice.Compute;
  request.Deferred = choice.Deferred;
  request.FillSteps = choice.FillSteps;
  request.MaximumLayers = choice.MaximumLayers;
  request.LeastContribution = choice.LeastContribution;
  request.SceneDepth = sceneDepth;
  request.SceneFrame = this->Frame;
  request.ShowsEach = pass.Translucent && !pass.Flat;
  request.Outlines = choice.Outlines && pass.SelectionPass < 0 && !this->HasEnvironment;
  bool composite = false;
  bool device = false;
  bool automatic = true;
  for (vtkPointSplatEntry& entry : pass.Entries)
  {
    const Settings& s = entry.Settings;
    vtkPointSplatCollection::MakeItem(
      entry, static_cast<int>(request.Items.size()), pass.View, choice);
    vtkPointSplatCollection::UseLevels(entry, pass.View, choice);
    vtkPointSplatCollection::UseTriangles(entry, pass.View);
    request.Items.push_back(entry.Item);
    request.CloudTimes.push_back(std::max({ entry.Item.Cloud->GetMTime(),
      choice.Deferred ? entry.Item.Cloud->GetGroups().GetMTime() : 0,
      entry.Item.TrianglePixels > 0.0 ? entry.Item.Cloud->GetTriangleTime() : 0 }));
    request.Outlines = request.Outlines && s.AntiAliasing &&
      vtkPointSplatResolve::AreOutlinesSmooth(entry.Actor);
    request.Voronoi = request.Voronoi && s.VoronoiDepth;
    composite = composite || entry.Item.Cloud->IsComposite();
    automatic = automatic && s.TileLists == Settings::AutomaticLists;
    device = device || s.TileLists == Settings::Device;
    if (pass.Translucent)
    {
      request.Gather = request.Gather ||
        (s.GatherRemaining && choice.Transparency == Settings::Peeling);
      request.MaximumMemory = std::max(request.MaximumMemory, s.MaximumImageMemory);
    }
  }
  request.OnDevice = automatic ? !vtkPointSplatContext::IsSoftware() : device;
  request.HasIds = IdsOf(pass.SelectionPass, composite, request.Ids);
  if (request.HasIds || !vtkPointSplatReconstruction::UsesTiles(request))
  {
    for (vtkPointSplatItem& item : request.Items)
    {
      item.Look = vtkPointSplatItemLook();
    }
  }
  // Triangles weigh what splats leave of 1, which is another thing for layers that are gathered; and
  // beside looks they would have to have some.
  if (!vtkPointSplatReconstruction::UsesTiles(request) || request.Gather ||
    request.GetLookTexels() > 0)
  {
    for (vtkPointSplatItem& item : request.Items)
    {
      item.TrianglePixels = 0.0;
    }
  }
  return request;
}

//------------------------------------------------------------------------------
bool vtkPointSplatFrame::Build(Pass& pass)
{
  auto window = static_cast<vtkOpenGLRenderWindow*>(this->Renderer->GetRenderWindow());
  GLuint sceneDepth = 0;
  bool failed = false;
  if (pass.Translucent && pass.SelectionPass < 0)
  {
    sceneDepth = this->CaptureScene(pass, failed);
    // Hooks of one actor's passes alone have a say in each of its layers.
    pass.Flat = pass.Joint && pass.Batched && !failed &&
      !vtkPointSplatCollection::HasOthersBetween(this->Renderer, pass.Entries);
  }
  this->PrepareEnvironment(pass);
  this->Choose(pass);
  for (vtkPointSplatEntry& entry : pass.Entries)
  {
    // Shadows' factors, and what is sorted, are in the order of all splats.
    entry.Item.IsStreamed = entry.Item.Cloud->AreStreamed() && !entry.Settings.Shadows &&
      pass.Sorted == vtkPointSplatFlat::None;
  }
  window->GetShaderCache()->ReleaseCurrentShader();
  if (!this->CastShadows(pass))
  {
    return false;
  }
  if (!pass.Surfaces->Build(this->MakeRequest(pass, sceneDepth), this->Reconstruction))
  {
    this->Error = pass.Surfaces->GetError();
    return false;
  }
  return this->LookUpTextures(pass);
}

//------------------------------------------------------------------------------
bool vtkPointSplatFrame::LookUpTextures(Pass& pass)
{
  vtkPointSplatSurfaces& surfaces = *pass.Surfaces;
  const vtkPointSplatLayers& layers = surfaces.GetLayers();
  if (surfaces.LookGeneration == surfaces.GetGeneration() || layers.GetNumberOfLayers() == 0 ||
    layers.GetLookTexels() == 0)
  {
    return true;
  }
  surfaces.LookGeneration = surfaces.GetGeneration();
  std::vector<vtkPointSplatLooks::Entry> entries;
  for (const vtkPointSplatItem& item : surfaces.GetRequest().Items)
  {
    if (item.Look.Coordinates || item.Look.Tangents)
    {
      entries.push_back({ pass.Entries[static_cast<size_t>(item.Slot)].Actor, item.Slot,
        item.Look.Tangents });
    }
  }
  const bool good = this->Looks.Apply(this->Renderer, pass.View, entries, layers);
  this->Error = good ? this->Error : this->Looks.GetError();
  return good;
}
