// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatRobustSurface
 * @brief   the robust moving-least-squares surface near one point
 *
 * An internal helper of vtkPointSplatProjection, whose header has the stages and the equations.
 * Lengths inside are in units of the kernel's support h, so that no square overflows.
 */
#ifndef vtkPointSplatRobustSurface_h
#define vtkPointSplatRobustSurface_h

#include "vtkPointSplatNeighbors.h"

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatRobustSurface
{
public:
  /// normalBandwidth: sigma_n; residualBandwidth: sigma_r, in supports.
  vtkPointSplatRobustSurface(float normalBandwidth, float residualBandwidth);

  /**
   * Takes the samples: the centre and its nearest neighbours, with their normals, 3 floats a slot.
   * Chooses the support and the spacing, and begins with the centre's normal.
   */
  void Gather(const vtkPointSplatNeighbors::Neighborhood& around, const float* normals);

  /**
   * Of what was gathered: puts into Normal what the centre's normal is by its neighbours', where it
   * is wrong or an average over a crease.
   */
  void FindNormal();

  ///@{
  /**
   * Takes samples one by one: first the support h and the spacing, world units, and the normal to
   * begin with; then each sample, the centre among them, by its offset from the centre and its
   * normal, until none is left or it is full.
   */
  void Begin(float support, float spacing, const float normal[3]);
  bool Add(const float offset[3], const float normal[3]);
  ///@}

  /**
   * Moves the centre onto the surface. False where the samples do not hold one within reach:
   * then nothing moves, and Normal is the one that the search began with.
   */
  bool Project();

  static constexpr int MaximumNumberOfSamples = 504;

  /// How far the centre moved, world units.
  float Offset[3] = { 0, 0, 0 };
  /// The surface's normal there, unit length.
  float Normal[3] = { 0, 0, 0 };
  /// The deviation of the samples from the surface there, in their mean distance on it.
  float Noise = 0;
  /// The samples' mean distance on the surface, were they even, and the support: world units.
  float Spacing = 0;
  float Support = 0;

private:
  static constexpr int Lanes = 8;
  static constexpr int Capacity = MaximumNumberOfSamples + Lanes;
  struct Sums;
  struct Place;

  void End();
  float GetAgreement(const float normal[3]) const;
  bool IsWithin(const float normal[3]) const;
  float GetFlatness(int sample) const;
  void FindSheet();
  void FindFace();
  void Evaluate(const Place& place, bool robust, Sums& sums) const;

  float NormalScale;   // to the argument of a falloff
  float ResidualScale;
  int Count = 0;     // of samples
  int Padded = 0;    // to whole Lanes, by samples out of reach
  float X[Capacity], Y[Capacity], Z[Capacity];
  float NX[Capacity], NY[Capacity], NZ[Capacity];
  float Weights[Capacity]; // by the kernel, as seen from the centre; of Gather() only
};

VTK_ABI_NAMESPACE_END
#endif
