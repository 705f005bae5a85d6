// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Of the frame: how much less work would lose. A frame that is drawn with all splats and layers is
// blended with fewer of its layers, and layers are made of fewer and fewer splats, until they differ
// by more than the target error.
#include "vtkPointSplatFrame.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>

//------------------------------------------------------------------------------
bool vtkPointSplatFrame::CanMeasure(
  const Pass& pass, const vtkPointSplatFacts& facts, bool interacts)
{
  // Where something lies between layers, or the window is drawn part by part, they are not at hand together.
  const bool together = (pass.Flat || !pass.Translucent) && pass.Parts.size() == 1;
  const bool matters = facts.TargetError > vtkPointSplatChoices::FullQuality ||
    (interacts && pass.Translucent);
  // By image space all points are taken.
  const bool less = pass.Translucent || !facts.AsksPoints;
  return together && matters && less && pass.SelectionPass < 0 && !this->HasEnvironment &&
    facts.Transparency <= vtkPointSplatSettings::Peeling && !facts.AsksDeferred &&
    std::none_of(pass.Entries.begin(), pass.Entries.end(),
      [](const vtkPointSplatEntry& entry) { return entry.Settings.GatherRemaining; });
}

//------------------------------------------------------------------------------
bool vtkPointSplatFrame::MeasureErrors(Pass& pass, const vtkPointSplatShading& shading)
{
  pass.Measures = false;
  if (!this->Renderer->GetPass())
  {
    // Translucent passes draw to images of their own; the scene is still where the renderer has it. Pass
    // chains may have it elsewhere.
    auto window = static_cast<vtkOpenGLRenderWindow*>(this->Renderer->GetRenderWindow());
    glm::ivec2 size;
    glm::ivec2 origin;
    this->Renderer->GetTiledSizeAndOrigin(&size.x, &size.y, &origin.x, &origin.y);
    this->Errors.TakeBehind(
      window->GetRenderFramebuffer()->GetFBOIndex(), origin, pass.View.Size);
  }
  vtkPointSplatSurfaces& surfaces = *pass.Surfaces;
  std::vector<double> ends;
  if (pass.Translucent)
  {
    const std::vector<double> lights = vtkPointSplatChoices::EndLights();
    ends = this->Errors.MeasureEnds(shading, surfaces.GetLayers(),
      surfaces.GetRequest().GetWindow(), std::vector<float>(lights.begin(), lights.end()));
  }
  surfaces.Errors.Set(ends, pass.Facts.Apart == 0.0 ? this->TryFewer(pass, shading)
                                                    : std::vector<double>());
  this->Errors.ForgetBehind();
  return this->Errors.GetError().empty();
}

//------------------------------------------------------------------------------
std::vector<double> vtkPointSplatFrame::TryFewer(Pass& pass, const vtkPointSplatShading& shading)
{
  const vtkPointSplatRequest& best = pass.Surfaces->GetRequest();
  if (pass.Facts.AsksPoints || best.GetLookTexels() > 0)
  {
    return {}; // all points are taken; textures are not looked up here
  }
  const glm::ivec4 window = best.GetWindow();
  const std::vector<float> all = this->Errors.Blend(shading, pass.Surfaces->GetLayers(), window);
  const vtkPointSplatCollection::Entries entries = pass.Entries;
  const vtkPointSplatChoice chosen = pass.Choice;
  const double target = pass.Facts.TargetError;
  const std::vector<double> pixels = vtkPointSplatChoices::ApartPixels(target);
  const double most = vtkPointSplatChoices::MostApartError(pass.Facts, target);
  // The fewest come first, since they take the least time: those that fit end the search, as no finer
  // ones have a greater error.
  std::vector<double> errors(pixels.size(), 0.0);
  vtkPointSplatChoice last = chosen;
  double error = 2.0 * target;
  for (size_t i = pixels.size(); i > 0 && error > most; --i)
  {
    vtkPointSplatFacts facts = pass.Facts;
    facts.Apart = pixels[i - 1];
    pass.Choice = vtkPointSplatChoices::Make(facts);
    if (pass.Choice.IsLike(chosen))
    {
      std::fill_n(errors.begin(), i, 0.0); // nor do those that are finer leave any out
      break;
    }
    if (!pass.Choice.IsLike(last))
    {
      vtkPointSplatRequest request = this->MakeRequest(pass, best.SceneDepth);
      request.Outlines = false;
      error = this->Trial.Build(std::move(request), this->Reconstruction)
        ? vtkPointSplatErrors::Difference(
            all, this->Errors.Blend(shading, this->Trial.GetLayers(), window))
        : 1.0;
    }
    last = pass.Choice;
    std::fill_n(errors.begin(), i, error);
  }
  this->Trial.Release();
  pass.Entries = entries;
  pass.Choice = chosen;
  return errors;
}
