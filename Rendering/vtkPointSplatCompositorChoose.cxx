// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Of the compositor: the facts from which vtkPointSplatChoices chooses.
#include "vtkPointSplatCompositor.h"

#include "vtkActor.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointSplatContrast.h"
#include "vtkPointSplatCrowding.h"
#include "vtkPointSplatMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

namespace
{
// What vtkRenderWindow wants of frames at rest, where there is no interactor to ask.
constexpr double StillUpdateRate = 0.0001;
}

//------------------------------------------------------------------------------
bool vtkPointSplatCompositor::IsInteracting(vtkRenderer* renderer)
{
  vtkRenderWindow* window = renderer->GetRenderWindow();
  vtkRenderWindowInteractor* interactor = window->GetInteractor();
  const double still =
    std::max(interactor ? interactor->GetStillUpdateRate() : 0.0, StillUpdateRate);
  return window->GetDesiredUpdateRate() > still;
}

//------------------------------------------------------------------------------
double vtkPointSplatCompositor::AllocatedSeconds(
  vtkRenderer* renderer, const std::vector<Entry>& entries)
{
  if (renderer->GetSelector() || !vtkPointSplatCompositor::IsInteracting(renderer))
  {
    return 0.0;
  }
  // VTK shares the time that a frame may take out among the props; layers are made for all of
  // these together.
  double seconds = 0.0;
  for (const Entry& entry : entries)
  {
    seconds += std::max(entry.Actor->GetAllocatedRenderTime(), 0.0);
  }
  return seconds > 0.0 ? seconds : 1.0 / renderer->GetRenderWindow()->GetDesiredUpdateRate();
}

//------------------------------------------------------------------------------
vtkPointSplatSceneFacts vtkPointSplatCompositor::Describe(vtkRenderer* renderer,
  const vtkPointSplatView& view, const std::vector<Entry>& entries, bool translucent, bool flat,
  bool hurried)
{
  auto window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkPointSplatSceneFacts facts;
  // All items share the images, so that one mapper's wish for quads decides.
  facts.Compute =
    vtkPointSplatStages::ComputeSupported(window) && vtkPointSplatImages::FitCompute(view.Size);
  facts.Translucent = translucent;
  facts.Sortable = flat;
  facts.Pixels = view.Size.x * static_cast<double>(view.Size.y);
  facts.MaximumLayers = 1;
  facts.MaximumFillSteps = 1;
  facts.TargetError = 1.0;
  facts.Opacity = 0.0;
  glm::ivec4 covered(view.Size.x, view.Size.y, -1, -1);
  for (const Entry& entry : entries)
  {
    vtkPointSplatMapper* mapper = entry.Mapper;
    const int method = mapper->GetMethod();
    facts.AllAutomatic =
      facts.AllAutomatic && method == vtkPointSplatMapper::AUTOMATIC_METHOD;
    facts.AsksDeferred = facts.AsksDeferred || method == vtkPointSplatMapper::DEFERRED;
    facts.AsksPoints = facts.AsksPoints || method == vtkPointSplatMapper::IMAGE_SPACE;
    facts.AsksQuads =
      facts.AsksQuads || mapper->GetProjection() == vtkPointSplatMapper::QUADS;
    // Sorting by hand counts for more than peeling by hand, and the first of its kind decides.
    const int transparency = mapper->GetTransparency();
    if (facts.Transparency <= vtkPointSplatMapper::PEELING &&
      transparency != vtkPointSplatMapper::AUTOMATIC_TRANSPARENCY)
    {
      facts.Transparency = transparency;
    }
    facts.MaximumLayers = std::max(facts.MaximumLayers, mapper->GetMaximumNumberOfLayers());
    facts.MaximumFillSteps =
      std::max(facts.MaximumFillSteps, mapper->GetMaximumNumberOfFillSteps());
    const double error = mapper->GetTargetError();
    facts.TargetError = std::min(
      facts.TargetError, error >= 0.0 ? error : vtkPointSplatChoices::FullQuality); // of NaN
    facts.Refracts =
      facts.Refracts || (mapper->GetRefraction() && this->Resolve.GetEnvironment());
    facts.Grouped = (&entry == &entries.front() || facts.Grouped) &&
      mapper->GetNumberOfGroups() > 0;
    facts.Opacity = std::max(facts.Opacity,
      mapper->GetCloud()->HasColours() || entry.Actor->GetBackfaceProperty()
        ? 1.0
        : entry.Actor->GetProperty()->GetOpacity());
    facts.Splats += static_cast<double>(mapper->GetNumberOfSplats());
    const glm::ivec4 own =
      view.Cover(entry.Item.MCWC, mapper->GetCloud()->GetBounds().data(), 0.0);
    if (own.x <= own.z && own.y <= own.w)
    {
      covered = glm::ivec4(std::min(covered.x, own.x), std::min(covered.y, own.y),
        std::max(covered.z, own.z), std::max(covered.w, own.w));
    }
  }
  facts.Covered = std::max(covered.z - covered.x + 1, 0) *
    static_cast<double>(std::max(covered.w - covered.y + 1, 0));
  const bool rough = hurried || facts.TargetError > vtkPointSplatChoices::FullQuality;
  double spacing = 0.0; // world units
  for (const Entry& entry : entries)
  {
    // To find it takes a pass over the points, once: only where it can matter.
    if (entry.Mapper->GetMethod() == vtkPointSplatMapper::IMAGE_SPACE ||
      ((facts.AllAutomatic || translucent) && rough))
    {
      const vtkPointSplatSpacing found = entry.Mapper->FindSpacing(view, entry.Item);
      const double pixels = found.Pixels;
      spacing = std::max(spacing, found.World);
      facts.SpacingPixels = std::max(facts.SpacingPixels, pixels);
      // Half the surface times the curvature, over a quarter of the surface, which is the image.
      facts.Contours = std::max(facts.Contours, 2.0 * found.Curvature * found.LargestPixel);
      // On average a surface is seen at half its area.
      facts.Depth += 0.5 * static_cast<double>(entry.Mapper->GetNumberOfSplats()) * pixels *
        pixels / std::max(facts.Covered, 1.0);
    }
  }
  facts.Contrast = rough ? vtkPointSplatContrast::Of(renderer) : 1.0;
  if (translucent && rough)
  {
    facts.Crowding = this->FindCrowding(entries, spacing);
  }
  return facts;
}

//------------------------------------------------------------------------------
double vtkPointSplatCompositor::FindCrowding(const std::vector<Entry>& entries, double spacing)
{
  std::vector<vtkPointSplatCrowding::Cloud> clouds;
  std::vector<CrowdingKey> keys;
  for (const Entry& entry : entries)
  {
    vtkPointSplatCloud* cloud = entry.Mapper->GetCloud();
    const std::array<double, 3>& o = cloud->GetOrigin();
    keys.emplace_back(cloud, cloud->GetGeometryMTime(), entry.Item.MCWC);
    clouds.push_back({ &cloud->GetSplats(), cloud->GetWordsPerSplat(),
      glm::translate(entry.Item.MCWC, glm::dvec3(o[0], o[1], o[2])) });
  }
  if (keys != this->CrowdingKeys)
  {
    this->Crowding = vtkPointSplatCrowding::Share(clouds, spacing);
    this->CrowdingKeys = std::move(keys);
  }
  return this->Crowding;
}

//------------------------------------------------------------------------------
void vtkPointSplatCompositor::Choose(vtkRenderer* renderer, const vtkPointSplatView& view,
  const std::vector<Entry>& entries, bool translucent, bool flat, vtkPointSplatLayers& layers)
{
  const double seconds = vtkPointSplatCompositor::AllocatedSeconds(renderer, entries);
  vtkPointSplatSceneFacts facts =
    this->Describe(renderer, view, entries, translucent, flat, seconds > 0.0);
  facts.HadPoints = seconds > 0.0 && layers.GetRequest().FillSteps > 0;
  if (vtkPointSplatChoices::Make(facts).Method == vtkPointSplatMapper::DEFERRED)
  {
    // Groups are made at need, and only then it is known what they take.
    vtkIdType bytes = 0;
    facts.Groups = 0;
    bool made = true;
    for (const Entry& entry : entries)
    {
      made = made && entry.Mapper->MakeGroups();
      facts.Groups = std::max(facts.Groups, entry.Mapper->GetNumberOfGroups());
      bytes = std::max(bytes, entry.Mapper->GetMaximumImageMemory());
    }
    facts.Groups = made ? facts.Groups : 0;
    facts.GroupsFit = vtkPointSplatDeferred::Fits(view.Size, facts.Groups, bytes);
  }
  if (renderer->GetSelector())
  {
    // As at rest, and of no account to a drag.
    this->Choice = vtkPointSplatChoices::Make(facts);
    this->Choice.BudgetReason = "selections take as long as they need";
    return;
  }
  std::vector<vtkPointSplatChoice> ladder = seconds > 0.0
    ? vtkPointSplatChoices::Ladder(facts)
    : std::vector<vtkPointSplatChoice>{ vtkPointSplatChoices::Make(facts) };
  this->Choice = ladder[layers.GetBudget().Choose(ladder, seconds, this->Frame)];
}
