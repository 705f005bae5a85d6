// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatChoices.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{
// Testing/Benchmark/fit_choices.py fits the constants of errors, and OneStepPixels, and prints residuals.

// Fewer splats against all of them, of smooth clouds, where that was not measured: of splats that are
// then this many pixels apart the error is at most this much for each, outlines without smoothing included.
constexpr double StrideErrorPerPixel = 0.0125;
// Fewer splats move outlines here and there, however dense they are, and without smoothing they have
// steps: of bodies of 200 pixels that is an error of 0.016, of smaller ones more. And noise of normals, of
// which fewer splats average less, has 0.03 and more for each pixel, which strides at smaller targets that
// were not measured would miss far more often.
constexpr double OutlineError = 1.0 / 32.0;
// So many splats in each pixel show what any number more of them does, to 49 dB. All of them may be too many: software
// drivers end loops after 65,535 rounds, so that tiles with a thousand in each pixel had wrong pixels.
constexpr double MostPerPixel = 128.0;
// OpenGL promises strides of 2048 bytes; a splat takes 64.
constexpr int MostStrideShift = 5;

// Testing/Benchmark/levels.py measures what the next four cost.
// Pixels, of the radii of splats that stand for others, at full quality: wherever they are, as much
// as the prefilter averages; and of smooth surfaces.
constexpr double FilterPixels = 0.6;
constexpr double SmoothPixels = 2.5;
// What normals of smooth surfaces may deviate from their linear change over a splat, and colours from
// their mean.
constexpr double SmoothDeviation = 0.02;
// In image space, where a pixel averages all points that fall into it, the radii of those that stand
// for others, which are one and a half times their distance, where it is smooth: some one a pixel.
// Elsewhere half of it.
constexpr double PointPixels = 1.8;

// Of the squared tolerance, what measured errors may have together. The rest is for outlines, and for views that
// the camera turns to before errors are measured again: with half of it one of a body with thin legs had 1.03 of the
// tolerance. With this share those of Testing/Benchmark/splatbench.py --choices have 0.57 at most, and nine meshes had 0.74.
constexpr double MeasuredShare = 4.0 / 9.0;
// However small the error, splats are no more than so many times as far apart as where it was not measured:
// what is wrong between them is little, but large enough to be seen.
constexpr double MostFarther = 2.0;
// Lights for which errors are measured, each less than the one before by a factor: the last do for 1/64.
constexpr size_t Ends = 16;
constexpr double EndFactor = 0.8;
// Pixels between splats for which they are, each a stride more than the one before; those for 1/64, 1/32 and 1/16
// are among them.
constexpr double LeastApart = 0.625;

// Points at most this far apart, in pixels, leave holes of single pixels only, be they spread at
// random. A second step would widen silhouettes.
constexpr double OneStepPixels = 1.0;

// Of one jittered sample of an area light that shines on white, against many: this times that power of the
// tangent at which the lamp is seen, since wider ones have wider penumbras. n samples have it over the root of n.
// Low lamps have most.
constexpr double ShadowSampleError = 0.32;
constexpr double ShadowWidthPower = 0.7;

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
  return this->Compute == other.Compute && this->Deferred == other.Deferred &&
    this->Transparency == other.Transparency && this->MaximumLayers == other.MaximumLayers &&
    this->LeastContribution == other.LeastContribution && this->FillSteps == other.FillSteps &&
    this->StrideShifts == other.StrideShifts && this->Outlines == other.Outlines &&
    (this->LevelPixels == other.LevelPixels || !this->HasLevels);
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
std::vector<double> vtkPointSplatChoices::EndLights()
{
  std::vector<double> lights;
  for (double light = EndFactor; lights.size() < Ends; light *= EndFactor)
  {
    lights.push_back(light);
  }
  return lights;
}

//------------------------------------------------------------------------------
std::vector<double> vtkPointSplatChoices::ApartPixels(double targetError)
{
  // Splats are farther apart than the image is wide long before an error of 1.
  const double farthest = (1.0 + 1e-6) * MostFarther * std::min(targetError, 1.0) / StrideErrorPerPixel;
  std::vector<double> pixels;
  for (double apart = LeastApart; apart <= farthest;
       apart = LeastApart * std::exp2(0.5 * static_cast<double>(pixels.size())))
  {
    pixels.push_back(apart);
  }
  return pixels;
}

//------------------------------------------------------------------------------
double vtkPointSplatChoices::MostApartError(const vtkPointSplatFacts& facts, double tolerance)
{
  // Where there are layers to leave out, these may have as much.
  return tolerance * std::sqrt(MeasuredShare / (facts.Translucent ? 2.0 : 1.0));
}

//------------------------------------------------------------------------------
int vtkPointSplatChoices::StrideShift(double spacingPixels, double allowed)
{
  int shift = 0;
  while (spacingPixels > 0.0 && shift < MostStrideShift &&
    spacingPixels * std::exp2(0.5 * (shift + 1)) <= allowed)
  {
    ++shift;
  }
  return shift;
}

namespace
{
//------------------------------------------------------------------------------
void ChooseProjection(const vtkPointSplatFacts& facts, vtkPointSplatChoice& choice)
{
  choice.Compute = facts.Compute && !facts.AsksQuads;
  choice.ProjectionReason = choice.Compute ? "by tiles of the image"
    : facts.AsksQuads                      ? "quads were asked for"
                                           : "compute shaders need OpenGL 4.3 and images that fit";
}

//------------------------------------------------------------------------------
/// Whether deferred blending can be had; else why not.
bool CanDefer(const vtkPointSplatFacts& facts, std::string& why)
{
  if (facts.Translucent)
  {
    why = "deferred blending makes opaque layers only";
  }
  else if (facts.Groups == 0)
  {
    why = "the splats cannot be grouped";
  }
  else if (!facts.GroupsFit)
  {
    why = "images for " + std::to_string(facts.Groups) +
      " groups are more than MaximumImageMemory or the hardware allows; lower OverlapFactor";
  }
  else
  {
    return true;
  }
  return false;
}

//------------------------------------------------------------------------------
void ChooseMethod(const vtkPointSplatFacts& facts, vtkPointSplatChoice& choice)
{
  choice.Deferred = facts.AsksDeferred && CanDefer(facts, choice.MethodReason);
  choice.Refused = facts.AsksDeferred && !choice.Deferred;
  if (choice.MethodReason.empty())
  {
    choice.MethodReason = facts.AsksDeferred || facts.AsksPoints
      ? "it was asked for"
      : "no other takes less time for the same picture";
  }
}

//------------------------------------------------------------------------------
bool IsMeasured(const vtkPointSplatFacts& facts)
{
  return facts.Apart || !facts.ApartErrors.empty();
}

//------------------------------------------------------------------------------
/// How many of ApartPixels() may be taken.
size_t CountOfFitting(const vtkPointSplatFacts& facts, double tolerance)
{
  const double most = vtkPointSplatChoices::MostApartError(facts, tolerance);
  const size_t known =
    std::min(facts.ApartErrors.size(), vtkPointSplatChoices::ApartPixels(tolerance).size());
  size_t count = 0;
  while (count < known && facts.ApartErrors[count] <= most)
  {
    ++count;
  }
  return count;
}

//------------------------------------------------------------------------------
/// How many pixels splats may be apart: as was measured, or for lack of that as was fitted.
double Apart(const vtkPointSplatFacts& facts, double tolerance)
{
  if (facts.Apart)
  {
    return *facts.Apart;
  }
  if (!IsMeasured(facts))
  {
    return tolerance / StrideErrorPerPixel;
  }
  const size_t count = CountOfFitting(facts, tolerance);
  return count > 0 ? vtkPointSplatChoices::ApartPixels(tolerance)[count - 1] : 0.0;
}

//------------------------------------------------------------------------------
/// The least light behind that counts: colours cannot differ by more, and were measured to differ by less.
double LeastContribution(const vtkPointSplatFacts& facts, double tolerance)
{
  double least = tolerance;
  const size_t count = CountOfFitting(facts, tolerance);
  const double fewer = count > 0 ? facts.ApartErrors[count - 1] : 0.0;
  const double most = MeasuredShare * tolerance * tolerance - fewer * fewer;
  const std::vector<double> lights = vtkPointSplatChoices::EndLights();
  const std::vector<double>& errors = facts.EndErrors;
  const auto fits = std::find_if(
    errors.begin(), errors.end(), [most](double error) { return error * error <= most; });
  return fits == errors.end() ? least : std::max(least, lights[fits - errors.begin()]);
}

//------------------------------------------------------------------------------
void ChooseLayers(const vtkPointSplatFacts& facts, double tolerance, vtkPointSplatChoice& choice)
{
  if (!facts.Translucent)
  {
    choice.LayersReason = "opaque surfaces have one";
    choice.TransparencyReason = "all is opaque";
    return;
  }
  choice.MaximumLayers = facts.MaximumLayers;
  choice.LeastContribution = facts.Apart ? vtkPointSplatChoices::FullQuality
    : tolerance > vtkPointSplatChoices::FullQuality ? LeastContribution(facts, tolerance)
                                                    : tolerance;
  choice.LayersReason = "until nothing is left, or less than " +
    vtkPointSplatChoices::Text(choice.LeastContribution) + " of the light behind" +
    (facts.Apart                        ? ", to measure what they count for"
        : choice.LeastContribution > tolerance ? ", which was measured to count for less than " +
          vtkPointSplatChoices::Text(tolerance)
                                               : "");
  if (facts.Transparency <= vtkPointSplatSettings::Peeling)
  {
    choice.TransparencyReason = facts.Transparency == vtkPointSplatSettings::Peeling
      ? "peeling was asked for"
      : "no other takes less time for the same picture";
  }
  else if (!facts.Sortable)
  {
    choice.TransparencyReason = "other translucent props may lie between the layers";
  }
  else if (facts.AsksPoints)
  {
    choice.TransparencyReason = "points without a size cannot be sorted";
  }
  else
  {
    choice.Transparency = facts.Transparency;
    choice.TransparencyReason = "it was asked for";
    // What the nearest layer reflects and refracts needs it, sorted or not.
    choice.MaximumLayers =
      choice.Transparency == vtkPointSplatSettings::Sorted && !facts.Refracts ? 0 : 1;
    choice.LayersReason = "the others are sorted";
  }
}

//------------------------------------------------------------------------------
void ChooseFill(const vtkPointSplatFacts& facts, vtkPointSplatChoice& choice)
{
  if (!facts.AsksPoints)
  {
    choice.FillReason = "splats leave no holes";
    return;
  }
  double spacing = 0.0;
  for (const vtkPointSplatFacts::Cloud& cloud : facts.Clouds)
  {
    spacing = std::max(spacing, cloud.SpacingPixels);
  }
  const bool one = spacing > 0.0 && spacing <= OneStepPixels;
  choice.FillSteps = one ? 1 : facts.MaximumFillSteps;
  choice.FillReason = "points are " + Number(spacing) + " pixels apart; up to " +
    Number(OneStepPixels) + " one step does";
}

//------------------------------------------------------------------------------
void ChooseOutlines(double tolerance, vtkPointSplatChoice& choice)
{
  choice.Outlines = tolerance < OutlineError;
  choice.OutlinesReason = choice.Outlines
    ? "steps might have a greater error than " + vtkPointSplatChoices::Text(tolerance)
    : "steps have an error of at most " + vtkPointSplatChoices::Text(tolerance);
}

//------------------------------------------------------------------------------
void ChooseSplats(const vtkPointSplatFacts& facts, double tolerance, vtkPointSplatChoice& choice)
{
  double all = 0.0;
  double drawn = 0.0;
  const bool whole = choice.Deferred || facts.Selects ||
    choice.Transparency != vtkPointSplatSettings::Peeling || facts.AsksPoints;
  const bool measured = IsMeasured(facts);
  const double allowed = measured || tolerance >= OutlineError ? Apart(facts, tolerance) : 0.0;
  for (const vtkPointSplatFacts::Cloud& cloud : facts.Clouds)
  {
    int shift = whole || (cloud.Painted && !measured)
      ? 0
      : vtkPointSplatChoices::StrideShift(cloud.SpacingPixels, allowed);
    while (!whole && tolerance > 0.0 && shift < MostStrideShift &&
      std::ldexp(cloud.PerPixel, -shift) > MostPerPixel)
    {
      ++shift;
    }
    choice.StrideShifts.push_back(shift);
    all += cloud.Splats;
    drawn += std::ldexp(cloud.Splats, -shift);
  }
  choice.SplatsReason = drawn < all
    ? "fewer, larger ones have an error of at most " + vtkPointSplatChoices::Text(tolerance)
    : facts.Apart
    ? "to measure what fewer would lose"
    : "fewer ones might have a greater error than " + vtkPointSplatChoices::Text(tolerance);
}

//------------------------------------------------------------------------------
void ChooseLevels(const vtkPointSplatFacts& facts, double tolerance, vtkPointSplatChoice& choice)
{
  const bool able = choice.Compute && !choice.Deferred &&
    choice.Transparency == vtkPointSplatSettings::Peeling;
  choice.HasLevels = facts.Levels;
  choice.LevelsReason = !able ? "the method takes all points"
    : tolerance <= 0.0        ? "no error is allowed"
                              : "";
  if (!choice.LevelsReason.empty())
  {
    return;
  }
  // The least of what strides of the same error have for spacing.
  const double looser = tolerance / vtkPointSplatChoices::FullQuality;
  const double scale = std::min(looser, 1.0);
  choice.LevelPixels = std::max(scale * FilterPixels, Apart(facts, tolerance));
  choice.SmoothLevelPixels = std::max(scale * SmoothPixels, choice.LevelPixels);
  choice.LevelDeviation = looser * SmoothDeviation;
  choice.PointLevelPixels = scale * PointPixels;
  if (facts.Selects)
  {
    choice.ShownLevelPixels = choice.SmoothLevelPixels;
    choice.LevelPixels = choice.SmoothLevelPixels = choice.PointLevelPixels = 0.0;
    choice.LevelsReason = "points are selected";
    return;
  }
  choice.LevelsReason = facts.Levels
    ? "splats stand for others up to a radius of " + Number(choice.LevelPixels) +
      " pixels, of " + Number(choice.SmoothLevelPixels) + " where it is smooth"
    : facts.LevelsUnderWay ? "they are being made; until then all points are drawn"
                           : "no cloud has levels";
}
}

//------------------------------------------------------------------------------
vtkPointSplatChoice vtkPointSplatChoices::Make(const vtkPointSplatFacts& facts)
{
  const double tolerance = std::max(facts.TargetError, facts.Tolerance);
  vtkPointSplatChoice choice;
  choice.Tolerance = tolerance;
  ChooseProjection(facts, choice);
  ChooseMethod(facts, choice);
  ChooseLayers(facts, tolerance, choice);
  ChooseFill(facts, choice);
  ChooseOutlines(tolerance, choice);
  ChooseSplats(facts, tolerance, choice);
  ChooseLevels(facts, tolerance, choice);
  return choice;
}

//------------------------------------------------------------------------------
std::vector<vtkPointSplatChoice> vtkPointSplatChoices::Ladder(vtkPointSplatFacts facts)
{
  facts.Tolerance = 0.0;
  std::vector<vtkPointSplatChoice> ladder{ vtkPointSplatChoices::Make(facts) };
  for (const double error : { 1.0 / 64.0, 1.0 / 32.0 })
  {
    facts.Tolerance = error;
    vtkPointSplatChoice looser = vtkPointSplatChoices::Make(facts);
    if (error > facts.TargetError && !looser.IsLike(ladder.back()))
    {
      ladder.push_back(std::move(looser));
    }
  }
  return ladder;
}

//------------------------------------------------------------------------------
double vtkPointSplatChoices::OneSampleError(double tangent)
{
  return ShadowSampleError * std::pow(tangent, ShadowWidthPower);
}

//------------------------------------------------------------------------------
int vtkPointSplatChoices::ShadowSamples(const vtkPointSplatSettings& settings, bool interacting,
  double error, std::string& reason)
{
  const int wanted = settings.NumberOfShadowSamples;
  const int all =
    interacting ? std::min(wanted, settings.NumberOfInteractiveShadowSamples) : wanted;
  const double needed = std::ceil(std::pow(error / settings.TargetError, 2.0));
  // With a target of 0 that is no number, or more than any.
  const int samples = needed < all ? std::max(1, static_cast<int>(needed)) : all;
  reason = samples < all ? "they have an error of " +
      Number(error / std::sqrt(static_cast<double>(samples)))
    : interacting ? "while dragging"
                  : "as many as were asked for";
  return samples;
}
