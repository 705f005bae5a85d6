// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The automatic choices: how much work a scene needs for a wanted quality, decided in one place
// from facts, without OpenGL and without memory: the same facts make the same choices.
//
// 1. What was asked for by hand is taken, as far as it can be done.
// 2. The tolerance is the target error; while the user drags and frames take longer than they may,
//    vtkPointSplatBudget goes down a ladder of choices for greater tolerances, up to 1/32.
// 3. Of splats that are much denser than pixels only every second, fourth, ... is drawn, larger by
//    as much as it takes to cover the surface, as long as the expected error is within the
//    tolerance. Errors are rms differences of colour, of 1, over the pixels that surfaces cover,
//    from the best picture that the module makes of the scene.
// 4. Where clouds have levels, splats may stand for others as long as a pixel's own filter averages
//    as much, or surfaces are so smooth that larger ones show the same: then none are left out. In
//    image space pixels are the filter, and points stand for others until there are some two of them in
//    each, or one where it is smooth.
// 5. Peeling ends where so little light is left that what is behind differs by the tolerance.
#ifndef vtkPointSplatChoices_h
#define vtkPointSplatChoices_h

#include "vtkPointSplatSettings.h"

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
    double SpacingPixels; // of the sparsest points at their nearest; 0: not known
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

  /// Every 2^n-th splat does for the tolerance, where splats are so many pixels apart.
  static int StrideShift(double spacingPixels, double tolerance);

  /**
   * The samples of area lights; reason gets why. wanted, interactive: what mappers allow at rest
   * and while the user drags. light: how much brighter the lights make what they fall on.
   */
  static int ShadowSamples(const vtkPointSplatSettings& settings, bool interacting, double light,
    std::string& reason);

  /// Of an error: 1/64 and the like where that is what it is.
  static std::string Text(double error);
};

#endif
