// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The automatic choices: how much work a scene needs for a wanted quality, decided in one place
// from facts, without OpenGL and without memory: the same facts make the same choices.
//
// 1. What was asked for by hand is taken, as far as it can be done.
// 2. Of what is left to choose, the fastest setting is taken whose expected error is at most the
//    tolerance. The error is the rms difference of colour, of 1, over the pixels that surfaces
//    cover, from the best picture that the module makes of the scene: two passes, all layers
//    peeled, all shadow samples that were asked for. Each choice is held to the tolerance by itself.
// 3. The tolerance is the target error; while the user drags and frames take longer than they may,
//    vtkPointSplatBudget goes down a ladder of choices for greater tolerances.
//
// Expected errors and the order of times were measured by Testing/Benchmark/splatbench.py --choices
// (VTK 9.1, Mesa's llvmpipe), which lists where a choice is not within 15 % of the fastest setting.
#ifndef vtkPointSplatChoices_h
#define vtkPointSplatChoices_h

#include <string>
#include <vector>

/**
 * All that choices depend on. Names of methods and transparencies are vtkPointSplatMapper's.
 */
struct vtkPointSplatSceneFacts
{
  ///@{ What was asked for, of all mappers of the scene together.
  bool AllAutomatic = true;  // no mapper names a method
  bool AsksDeferred = false; // some mapper does
  bool AsksPoints = false;   // some mapper asks for image space
  bool AsksQuads = false;
  int Transparency = 0; // AUTOMATIC_TRANSPARENCY where no mapper names one
  int MaximumLayers = 32;
  int MaximumFillSteps = 2;
  double TargetError = 1.0 / 256.0;
  ///@}

  ///@{ The scene.
  bool Compute = true;      // compute shaders are there, and images fit their bounds
  bool Translucent = false; // these are the translucent splats
  bool Sortable = true;     // nothing else translucent can lie between the layers
  bool Refracts = false;
  double Splats = 0.0;
  double Pixels = 0.0;        // of the viewport
  double Covered = 0.0;       // of these, what the splats' bounding boxes cover
  double SpacingPixels = 0.0; // of the sparsest points at their nearest; 0: not known
  double Contours = 0.0;      // of a smooth body's image: outline by area, pixels; 0: not known
  double Depth = 0.0;         // surfaces behind one another, a covered pixel; 0: not known
  double Opacity = 1.0;       // the greatest of translucent splats
  double Contrast = 1.0;      // of colours that may mix (vtkPointSplatContrast.h)
  double Crowding = 1.0;      // share of surfaces close to others (vtkPointSplatCrowding.h)
  bool Grouped = false;       // groups for sorting are made
  int Groups = -1;            // for deferred blending; -1: not made yet, 0: cannot be made
  bool GroupsFit = true;      // their images fit the hardware and MaximumImageMemory
  ///@}

  ///@{ While the user drags.
  double Tolerance = 0.0; // errors that time is worth; the greater of this and TargetError counts
  bool HadPoints = false; // the frame before was in image space
  ///@}
};

/**
 * What was chosen, and why.
 */
struct vtkPointSplatChoice
{
  bool Compute = true;
  int Method = 1;       // of mappers that name none: TWO_PASS, DEFERRED or IMAGE_SPACE
  int Transparency = 1; // PEELING, SORTED or NEAREST_EXACT
  int MaximumLayers = 1;
  double LeastContribution = 1.0 / 256.0; // peeling ends where less of the light is left
  int FillSteps = 0;                      // of image space, at most

  ///@{ The automatic least layer distance: of splats in radii; of points in spacings, and in
  /// pixels if that is more.
  // Disks that cover a smooth surface stay much nearer to it than a radius; on rough ones they do
  // not, and a narrower distance leaves neighbours out of the mean.
  double LayerRadii = 1.0;
  double LayerSpacings = 1.0;
  // Within a pixel points of one surface lie up to 1.4 pixels' width apart along the normal, and as
  // much again where the pixel was filled from a neighbour's depth.
  double LayerPixels = 3.0;
  ///@}

  ///@{ Groups for sorted transparency: four, as Zhang and Pajarola 2006 found enough (section 6.2),
  /// whose splats grow by about this much until each group covers the surface, as
  /// vtkPointSplatGrouping's equation 9 finds it on scans and tori (1.9 to 2.2).
  int CoveringGroups = 4;
  double CoveringScale = 2.0;
  ///@}

  double Tolerance = 1.0 / 256.0;
  bool Refused = false; // a method that was asked for cannot be had
  std::string ProjectionReason;
  std::string MethodReason;
  std::string TransparencyReason;
  std::string LayersReason;
  std::string FillReason;
  std::string BudgetReason; // why the tolerance is what it is

  /// Whether both do the same work.
  bool IsLike(const vtkPointSplatChoice& other) const;
};

class vtkPointSplatChoices
{
public:
  /// Errors up to this cannot be seen in pictures of 8 bits: all samples and steps are taken.
  static constexpr double FullQuality = 1.0 / 256.0;

  static vtkPointSplatChoice Make(const vtkPointSplatSceneFacts& facts);

  /**
   * Choices for the target error and for ever greater ones, each with less work than the one
   * before: what a budget of time may be met by.
   */
  static std::vector<vtkPointSplatChoice> Ladder(vtkPointSplatSceneFacts facts);

  /**
   * The error to be expected of image space. At silhouettes points mark all of their pixel, and where
   * they are sparse that of their neighbours; of the covered pixels those are the more the smaller
   * the picture, and the more bodies there are in it; translucent layers that crowd become one.
   */
  static double PointError(const vtkPointSplatSceneFacts& facts);

  /**
   * The error to be expected of deferred blending: where several splats fall in a pixel, groups
   * take but the nearest of each.
   */
  static double DeferredError(const vtkPointSplatSceneFacts& facts);

  /**
   * The error to be expected of sorted layers, all or all but the nearest. Each surface's opacity and
   * shading err a little, and the more where splats are so dense that few pixels tell them apart;
   * surfaces that crowd change places.
   */
  static double SortedError(const vtkPointSplatSceneFacts& facts, bool nearestExact);

  /**
   * The samples of area lights; reason gets why. wanted, interactive: what mappers allow at rest
   * and while the user drags. light: how much brighter the lights make what they fall on
   * (vtkPointSplatContrast::OfLight(), times intensities).
   */
  static int ShadowSamples(int wanted, int interactive, bool interacting, double targetError,
    double light, std::string& reason);

  /// Of an error: 1/64 and the like where that is what it is.
  static std::string Text(double error);
};

#endif
