// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The automatic choices: how much work a scene needs for a wanted quality, decided in one place
// from facts, without OpenGL and without memory: the same facts make the same choices.
//
// 1. What was asked for by hand is taken, as far as it can be done.
// 2. The tolerance is the target error; while the user drags and frames take longer than they may,
//    vtkPointSplatBudget goes down a ladder of choices for greater tolerances, up to 1/32.
// 3. Errors are rms differences of colour, of 1, over the pixels that surfaces cover, from the best
//    picture that the module makes of the scene. What fewer splats and layers would lose is known from
//    frames that were drawn and measured (vtkPointSplatFrameMeasures.cxx); before any was, fitted constants
//    tell the most that it might be. Measured errors may have four ninths of the squared tolerance; the rest is
//    left to outlines and to views that were not measured.
// 4. Of splats that are denser than pixels only every second, fourth, ... is drawn, larger by as much
//    as it takes to cover the surface. Outlines are not smoothed where the tolerance is greater than what
//    that, and splats that are larger, change there.
// 5. Where clouds have levels, splats may stand for others as long as a pixel's own filter averages
//    as much, or surfaces are so smooth that larger ones show the same: then none are left out. In
//    image space pixels are the filter, and points stand for others until there are some two of them in
//    each, or one where it is smooth.
// 6. Peeling ends where so little light is left that what is behind differs by the tolerance: it cannot
//    by more than that light.
#ifndef vtkPointSplatChoices_h
#define vtkPointSplatChoices_h

#include "vtkPointSplatSettings.h"

#include <optional>
#include <string>
#include <vector>

/**
 * All that choices depend on.
 */
struct vtkPointSplatFacts
{
  ///@{ What was asked for, of all mappers of the scene together.
  bool AsksDeferred = false; // some mapper does
  bool AsksPoints = false;   // some mapper asks for image space
  bool AsksQuads = false;
  int Transparency = vtkPointSplatSettings::AutomaticTransparency;
  int MaximumLayers = 32;
  int MaximumFillSteps = 2;
  double TargetError = 1.0 / 256.0;
  ///@}

  ///@{ The scene.
  struct Cloud
  {
    double Splats;
    // Of the sparsest points, 0 where not known: of image space at their nearest, else in the mean.
    double SpacingPixels;
    double PerPixel = 0.0; // splats, of the part of the window that they may cover
    bool Painted = false; // points have colours or shadows of their own, which fewer would blur
  };
  std::vector<Cloud> Clouds;
  bool Compute = true;      // compute shaders are there, and images fit their bounds
  bool Translucent = false; // these are the translucent splats
  bool Sortable = true;     // nothing else translucent can lie between the layers
  bool Refracts = false;
  bool Levels = false;      // some cloud has levels
  bool LevelsUnderWay = false; // those of some cloud are being made
  bool Selects = false;     // ids of points are wanted
  ///@{ Errors that frames were measured to have, if that is known: of peeling that ends at each of
  /// EndLights(), and of splats that are as far apart as each of ApartPixels().
  std::vector<double> EndErrors;
  std::vector<double> ApartErrors;
  ///@}
  /// How many pixels splats may be apart in a frame that is measured, with all layers: 0 in the best
  /// one, more in those that are held against it. Of other frames it is chosen.
  std::optional<double> Apart;
  int Groups = -1;          // for deferred blending; -1: not made yet, 0: cannot be made
  bool GroupsFit = true;    // their images fit the hardware and MaximumImageMemory
  ///@}

  /// While the user drags, errors that time is worth; the greater of this and TargetError counts.
  double Tolerance = 0.0;
};

/**
 * What was chosen, and why.
 */
struct vtkPointSplatChoice
{
  bool Compute = true;
  bool Deferred = false; // of splats: deferred blending
  int Transparency = vtkPointSplatSettings::Peeling;
  int MaximumLayers = 1;
  double LeastContribution = 1.0 / 256.0; // peeling ends where less of the light is left
  int FillSteps = 0;                      // of image space, at most
  bool Outlines = true;                   // are smoothed, where mappers want it
  std::vector<int> StrideShifts;          // of each cloud: every 2^n-th splat is drawn

  ///@{ Splats may stand for others whose radii, in pixels, are within the first; where normals
  /// deviate from their linear change by no more than LevelDeviation, within the second. 0: none.
  double LevelPixels = 0.0;
  double SmoothLevelPixels = 0.0;
  double PointLevelPixels = 0.0; // of points that are projected as single pixels
  double LevelDeviation = 0.0;
  double ShownLevelPixels = 0.0; // where points are selected: what frames may show of radii
  bool HasLevels = false; // some cloud has some
  ///@}

  ///@{ The automatic least layer distance: of splats in radii; of points their spacing, or so many
  /// pixels if that is more. Testing/Stability/stability.py sweeps what they must bear.
  // Disks that cover a smooth surface stay much nearer to it than a radius; on rough ones they do
  // not, and a narrower distance leaves neighbours out of the mean.
  double LayerRadii = 1.0;
  // Within a pixel points of one surface lie up to 1.4 pixels' width apart along the normal, and as
  // much again where the pixel was filled from a neighbour's depth.
  double LayerPixels = 3.0;
  ///@}

  /// Groups for sorted transparency, as many as Zhang and Pajarola 2006 found enough (section 6.2).
  int CoveringGroups = 4;

  double Tolerance = 1.0 / 256.0;
  bool Refused = false; // a method that was asked for cannot be had
  std::string ProjectionReason;
  std::string MethodReason;
  std::string TransparencyReason;
  std::string LayersReason;
  std::string OutlinesReason;
  std::string FillReason;
  std::string SplatsReason;
  std::string LevelsReason;
  std::string BudgetReason; // why the tolerance is what it is

  /// Whether both do the same work.
  bool IsLike(const vtkPointSplatChoice& other) const;
};

class vtkPointSplatChoices
{
public:
  /// Errors up to this cannot be seen in pictures of 8 bits: all samples and splats are taken.
  static constexpr double FullQuality = 1.0 / 256.0;

  static vtkPointSplatChoice Make(const vtkPointSplatFacts& facts);

  /**
   * Choices for the target error and for ever greater ones, each with less work than the one
   * before: what a budget of time may be met by.
   */
  static std::vector<vtkPointSplatChoice> Ladder(vtkPointSplatFacts facts);

  /// Shares of the light behind of which frames tell what peeling that ends there would lose.
  static std::vector<double> EndLights();

  /// Pixels between splats, for which frames tell what fewer splats would lose, as far as a target error may go.
  static std::vector<double> ApartPixels(double targetError);
  /// The error that fewer splats may have, where it was measured.
  static double MostApartError(const vtkPointSplatFacts& facts, double tolerance);

  /// Of splats that are so many pixels apart every 2^n-th is no farther from the next than allowed.
  static int StrideShift(double spacingPixels, double allowed);

  /// The rms error of colour, of 1, of one sample of a light of intensity 1 that shines on white. tangent: of the
  /// angle at which the light's radius is seen.
  static double OneSampleError(double tangent);

  /**
   * The samples of area lights; reason gets why. error: that of one sample of each light, together, on what they
   * fall on.
   */
  static int ShadowSamples(const vtkPointSplatSettings& settings, bool interacting, double error,
    std::string& reason);

  /// Of an error: 1/64 and the like where that is what it is.
  static std::string Text(double error);
};

#endif
