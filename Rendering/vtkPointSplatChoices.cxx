// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatChoices.h"

#include "vtkPointSplatMapper.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{
// Image space against two passes (PointError()). Opaque, on tori and spheres 0.7 to 5.4 pixels apart:
// squared errors over the spacing in pixels and the outlines' share of the covered pixels, and the
// part of that where one step fills the holes. Translucent, on tori and orbitals 0.5 to 8 pixels apart:
// squared errors of silhouettes, times the side in pixels of the square that is covered, and of
// shading, over the square of the spacing in pixels. All are the upper ends of what was seen.
constexpr double ContourError = 0.036;
constexpr double OneStepPart = 0.35;
constexpr double TranslucentSilhouetteError = 0.2;
constexpr double ShadingError = 6e-5;
// All were seen at this contrast; scenes of more have more. Layers that crowd merge: of
// shells, times contrast and the share that is crowded.
constexpr double PointContrast = 0.6;
constexpr double CrowdedPointError = 0.13;
// Points farther apart than this, in pixels, leave holes in image space.
constexpr double MostSpacing = 8.0;
// While the user drags, a method once taken stays for spacings and errors that are by so much worse.
constexpr double Hysteresis = 1.25;

// Points at most this far apart, in pixels, leave holes of single pixels only, be they spread at
// random. A second step would widen silhouettes; from 1.3 pixels on it is needed.
constexpr double OneStepPixels = 1.0;

// One pass over groups by quads beats two of them, by up to a fifth, where there are this many
// splats a pixel of the viewport; compute shaders beat both (Testing/Benchmark/deferred_benchmark.py).
constexpr double LeastSplatsPerPixel = 0.5;
// Deferred blending against two passes, where splats are this many pixels apart, or more: 0.003 on
// grids, this on points at random. Denser, the error grows with the power of the density.
constexpr double DeferredErrorAtMost = 0.008;
constexpr double DeferredSpacing = 1.2;
constexpr double DeferredPower = 2.5;

// Sorted transparency against peeling, of all layers and of all but the nearest (SortedError()): what
// it has at no contrast and what contrast adds, on spheres, shells, tori and orbitals, on grids and at
// random, opacities from 0.03 to 0.9, close-ups among them. All are upper ends of what was seen.
constexpr double SortedErrors[2] = { 0.013, 0.018 };
constexpr double NearestExactErrors[2] = { 0.0087, 0.011 };
// Below this opacity the error of sorting all falls with the root, down to a share; below so many
// pixels between splats errors grow.
constexpr double FullOpacity = 0.15;
constexpr double LeastOpacityShare = 0.55;
constexpr double SortedSpacing = 3.0;
// Of shells 0.2 to 2 spacings apart and of neghip's isosurfaces, times contrast and a power of the
// share that is crowded.
constexpr double CrowdedError = 0.22;
constexpr double CrowdingPower = 2.0 / 3.0;
// Sorting takes less time than peeling from so many surfaces behind one another on, ...
constexpr double LeastDepthToSort = 1.5;
constexpr double LeastDepthForNearestExact = 3.0;
// ... and less than peeling in image space from so many on, where a splat costs less than so many
// pixels of a layer.
constexpr double LeastDepthToSortRather = 4.0;
constexpr double PixelsPerSortedSplat = 16.0;
// Peeling draws more than this even where time is short.
constexpr double MostContribution = 1.0 / 8.0;

// Of one jittered sample of an area light that shines on white, against many; n samples have it over
// the root of n. A ball over a torus has 0.02 to 0.055, by lamps of a tenth to eight tenths of the
// torus' radius.
constexpr double ShadowSampleError = 0.06;

std::string Number(double value)
{
  std::ostringstream text;
  text.precision(2);
  text << value;
  return text.str();
}
}

//------------------------------------------------------------------------------
bool vtkPointSplatChoice::IsLike(const vtkPointSplatChoice& other) const
{
  return this->Compute == other.Compute && this->Method == other.Method &&
    this->Transparency == other.Transparency && this->MaximumLayers == other.MaximumLayers &&
    this->LeastContribution == other.LeastContribution && this->FillSteps == other.FillSteps;
}

//------------------------------------------------------------------------------
std::string vtkPointSplatChoices::Text(double error)
{
  const double inverse = std::round(1.0 / error);
  return error < 1.0 && std::abs(inverse * error - 1.0) < 1e-6
    ? "1/" + std::to_string(static_cast<long>(inverse))
    : Number(error);
}

//------------------------------------------------------------------------------
double vtkPointSplatChoices::PointError(const vtkPointSplatSceneFacts& facts)
{
  const double contrast = std::max(1.0, facts.Contrast / PointContrast);
  const double side = std::sqrt(std::max(facts.Covered, 1.0));
  const double spacing = facts.SpacingPixels;
  if (facts.Translucent)
  {
    return std::hypot(
      contrast * std::sqrt(TranslucentSilhouetteError / side + ShadingError * spacing * spacing),
      CrowdedPointError * facts.Contrast * facts.Crowding);
  }
  // What is flat has its border for an outline.
  const double contours = std::max(facts.Contours, 4.0 / side);
  return contrast *
    std::sqrt(ContourError * contours * (spacing > OneStepPixels ? spacing : OneStepPart));
}

//------------------------------------------------------------------------------
double vtkPointSplatChoices::DeferredError(const vtkPointSplatSceneFacts& facts)
{
  const double density =
    facts.SpacingPixels > 0.0 ? std::max(1.0, DeferredSpacing / facts.SpacingPixels) : 1.0;
  return DeferredErrorAtMost * std::pow(density, DeferredPower);
}

//------------------------------------------------------------------------------
double vtkPointSplatChoices::SortedError(const vtkPointSplatSceneFacts& facts, bool nearestExact)
{
  const double* errors = nearestExact ? NearestExactErrors : SortedErrors;
  const double density =
    facts.SpacingPixels > 0.0 ? std::max(1.0, SortedSpacing / facts.SpacingPixels) : 1.0;
  const double opacity = nearestExact
    ? 1.0
    : std::clamp(std::sqrt(facts.Opacity / FullOpacity), LeastOpacityShare, 1.0);
  return opacity *
    std::hypot(density * (errors[0] + errors[1] * facts.Contrast),
      CrowdedError * facts.Contrast * std::pow(facts.Crowding, CrowdingPower));
}

namespace
{
//------------------------------------------------------------------------------
void ChooseProjection(const vtkPointSplatSceneFacts& facts, vtkPointSplatChoice& choice)
{
  choice.Compute = facts.Compute && !facts.AsksQuads;
  choice.ProjectionReason = choice.Compute ? "a splat takes less time than by quads"
    : facts.AsksQuads                      ? "quads were asked for"
                                           : "compute shaders need OpenGL 4.3 and images that fit";
}

//------------------------------------------------------------------------------
/// Whether deferred blending can be had; else why not.
bool CanDefer(const vtkPointSplatSceneFacts& facts, std::string& why)
{
  if (facts.AsksPoints)
  {
    why = "points in image space share the layer";
  }
  else if (facts.Translucent)
  {
    why = "deferred blending makes opaque layers only";
  }
  else if (facts.Groups == 0)
  {
    why = "the splats cannot be grouped";
  }
  else if (!facts.GroupsFit)
  {
    why = "images for " + std::to_string(facts.Groups) + " groups of " +
      std::to_string(static_cast<long>(facts.Pixels)) +
      " pixels are more than MaximumImageMemory or the hardware allows; lower OverlapFactor";
  }
  else
  {
    return true;
  }
  return false;
}

//------------------------------------------------------------------------------
/// Whether sorting splats is allowed and takes less time than peeling points in image space, whose
/// silhouettes make some four layers more.
bool PrefersSorting(const vtkPointSplatSceneFacts& facts, double tolerance)
{
  // Grouping takes about as long as ten frames.
  const bool affordable = facts.Grouped || facts.Tolerance == 0.0;
  return facts.Translucent && facts.Sortable && !facts.Refracts && affordable &&
    tolerance >= vtkPointSplatChoices::SortedError(facts, false) &&
    facts.Transparency == vtkPointSplatMapper::AUTOMATIC_TRANSPARENCY &&
    facts.Depth >= LeastDepthToSortRather &&
    PixelsPerSortedSplat * facts.Splats < facts.Pixels * (2.0 * facts.Depth + 4.0);
}

//------------------------------------------------------------------------------
void ChooseMethod(
  const vtkPointSplatSceneFacts& facts, double tolerance, vtkPointSplatChoice& choice)
{
  choice.Method = vtkPointSplatMapper::TWO_PASS;
  std::string& why = choice.MethodReason;
  if (!facts.AllAutomatic)
  {
    const bool defers = facts.AsksDeferred && CanDefer(facts, why);
    choice.Refused = facts.AsksDeferred && !defers && !facts.AsksPoints && !facts.Translucent;
    if (defers)
    {
      choice.Method = vtkPointSplatMapper::DEFERRED;
      choice.Compute = false;
      choice.ProjectionReason = "deferred blending needs quads";
    }
    why = why.empty() ? "it was asked for" : why;
    return;
  }
  if (PrefersSorting(facts, tolerance))
  {
    why = "splats can be sorted";
    return;
  }
  const double slack = facts.HadPoints ? Hysteresis : 1.0;
  const double error = vtkPointSplatChoices::PointError(facts);
  const bool known = facts.SpacingPixels > 0.0 && !facts.Refracts;
  if (known && error <= slack * tolerance && facts.SpacingPixels <= slack * MostSpacing)
  {
    choice.Method = vtkPointSplatMapper::IMAGE_SPACE;
    why = "points " + Number(facts.SpacingPixels) + " pixels apart have an error of " +
      Number(error) + " in image space, within " + vtkPointSplatChoices::Text(tolerance);
    return;
  }
  if (!choice.Compute && facts.Splats > LeastSplatsPerPixel * facts.Pixels &&
    vtkPointSplatChoices::DeferredError(facts) <= tolerance && CanDefer(facts, why))
  {
    choice.Method = vtkPointSplatMapper::DEFERRED;
    why = "by quads one pass over groups takes less time than two, from a splat to two pixels "
          "on";
    return;
  }
  why += why.empty() ? "" : "; ";
  why += known && tolerance > vtkPointSplatChoices::FullQuality
    ? "in image space points " + Number(facts.SpacingPixels) +
      " pixels apart would have an error of " + Number(error) + ", and the target is " +
      vtkPointSplatChoices::Text(tolerance)
    : "no faster one has an error within " + vtkPointSplatChoices::Text(tolerance);
}

//------------------------------------------------------------------------------
void ChooseLayers(const vtkPointSplatSceneFacts& facts, double tolerance,
  vtkPointSplatChoice& choice)
{
  const bool points =
    facts.AsksPoints || choice.Method == vtkPointSplatMapper::IMAGE_SPACE;
  choice.Transparency = vtkPointSplatMapper::PEELING;
  if (!facts.Translucent)
  {
    choice.MaximumLayers = 1;
    choice.TransparencyReason = "nothing is translucent";
    choice.LayersReason = "only the nearest layer is seen";
    return;
  }
  const double sortedError = vtkPointSplatChoices::SortedError(facts, false);
  const double nearestExactError = vtkPointSplatChoices::SortedError(facts, true);
  choice.MaximumLayers = facts.MaximumLayers;
  choice.LeastContribution = std::min(tolerance, std::max(facts.TargetError, MostContribution));
  choice.LayersReason = "until nothing is left, or less than " +
    vtkPointSplatChoices::Text(choice.LeastContribution) + " of the light behind";
  if (facts.Transparency == vtkPointSplatMapper::PEELING)
  {
    choice.TransparencyReason = "peeling was asked for";
    return;
  }
  if (!facts.Sortable)
  {
    choice.TransparencyReason = "other translucent props may lie between the layers";
    return;
  }
  if (points)
  {
    choice.TransparencyReason = "points without a size cannot be sorted";
    return;
  }
  if (facts.Transparency != vtkPointSplatMapper::AUTOMATIC_TRANSPARENCY)
  {
    choice.Transparency = facts.Transparency;
    choice.TransparencyReason = "it was asked for";
  }
  else if (facts.Refracts)
  {
    choice.TransparencyReason = "refraction magnifies errors of layers";
  }
  else if (tolerance >= sortedError && facts.Depth >= LeastDepthToSort)
  {
    choice.Transparency = vtkPointSplatMapper::SORTED;
    choice.TransparencyReason = "about " + Number(facts.Depth) +
      " surfaces lie behind one another; sorted they have an error of " + Number(sortedError);
  }
  else if (tolerance >= nearestExactError && facts.Depth >= LeastDepthForNearestExact)
  {
    choice.Transparency = vtkPointSplatMapper::NEAREST_EXACT;
    choice.TransparencyReason = "about " + Number(facts.Depth) +
      " surfaces lie behind one another; with the nearest exact and the others sorted they have an "
      "error of " + Number(nearestExactError);
  }
  else
  {
    choice.TransparencyReason = tolerance <= vtkPointSplatChoices::FullQuality
      ? "sorted layers have greater errors than " + vtkPointSplatChoices::Text(tolerance)
      : tolerance < nearestExactError
      ? "sorted layers have an error of " + Number(sortedError) +
        ", those behind an exact nearest one of " + Number(nearestExactError)
      : "too few surfaces lie behind one another to be worth sorting";
  }
  if (choice.Transparency != vtkPointSplatMapper::PEELING)
  {
    // What the nearest layer reflects and refracts needs it, sorted or not.
    choice.MaximumLayers =
      choice.Transparency == vtkPointSplatMapper::SORTED && !facts.Refracts ? 0 : 1;
    choice.LayersReason = "the others are sorted";
  }
}

//------------------------------------------------------------------------------
void ChooseFill(const vtkPointSplatSceneFacts& facts, vtkPointSplatChoice& choice)
{
  if (!facts.AsksPoints && choice.Method != vtkPointSplatMapper::IMAGE_SPACE)
  {
    choice.FillSteps = 0;
    choice.FillReason = "splats leave no holes";
    return;
  }
  const bool one = facts.SpacingPixels > 0.0 && facts.SpacingPixels <= OneStepPixels;
  choice.FillSteps = one ? 1 : facts.MaximumFillSteps;
  choice.FillReason = "points are " + Number(facts.SpacingPixels) + " pixels apart; up to " +
    Number(OneStepPixels) + " one step does";
}
}

//------------------------------------------------------------------------------
vtkPointSplatChoice vtkPointSplatChoices::Make(const vtkPointSplatSceneFacts& facts)
{
  const double tolerance = std::max(facts.TargetError, facts.Tolerance);
  vtkPointSplatChoice choice;
  choice.Tolerance = tolerance;
  ChooseProjection(facts, choice);
  ChooseMethod(facts, tolerance, choice);
  ChooseLayers(facts, tolerance, choice);
  ChooseFill(facts, choice);
  return choice;
}

//------------------------------------------------------------------------------
std::vector<vtkPointSplatChoice> vtkPointSplatChoices::Ladder(vtkPointSplatSceneFacts facts)
{
  facts.Tolerance = 0.0;
  std::vector<vtkPointSplatChoice> ladder{ vtkPointSplatChoices::Make(facts) };
  for (const double error : { 1.0 / 64.0, 1.0 / 32.0, 1.0 / 16.0, 1.0 })
  {
    facts.Tolerance = error;
    vtkPointSplatChoice looser = vtkPointSplatChoices::Make(facts);
    // Where peeling ends alone saves little: that is left to the last rung.
    vtkPointSplatChoice compared = looser;
    if (error < 1.0)
    {
      compared.LeastContribution = ladder.back().LeastContribution;
    }
    if (error > facts.TargetError && !compared.IsLike(ladder.back()))
    {
      ladder.push_back(std::move(looser));
    }
  }
  return ladder;
}

//------------------------------------------------------------------------------
int vtkPointSplatChoices::ShadowSamples(int wanted, int interactive, bool interacting,
  double targetError, double light, std::string& reason)
{
  const int all = interacting ? std::min(wanted, interactive) : wanted;
  if (targetError <= FullQuality)
  {
    reason = interacting ? "while dragging" : "as many as were asked for";
    return all;
  }
  const double error = ShadowSampleError * light;
  const double needed = std::ceil(std::pow(error / targetError, 2.0));
  const int samples = needed < all ? std::max(1, static_cast<int>(needed)) : all;
  reason = samples < all ? "they have an error of " +
      Number(error / std::sqrt(static_cast<double>(samples)))
    : interacting ? "while dragging"
                  : "as many as were asked for";
  return samples;
}
