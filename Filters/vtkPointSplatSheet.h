// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatSheet
 * @brief   which of a point's neighbours lie on its own sheet of the surface
 *
 * An internal helper of vtkPointSplatEstimation; see the stages there.
 *
 * Between two points of a sheet, d apart, the surface runs about as a circle's arc. Then their
 * normals n and m are mirror images in the plane half way between the points, and n . d = -m . d.
 * So with m turned to where n's mirror image points, half of |(n + m) . d| is the distance at which
 * the surface through one point passes the other: 0 on an arc, the distance of parallel sheets, the
 * diameter from one side of a tube to the other, and the noise of noisy scans. And n . d / |d| is the
 * sine of half the angle by which the arc turns. At an edge whose normal is an average of its faces', at a
 * rim and at a tip the surface between two points is flat instead: one lies in the other's tangent plane.
 */
#ifndef vtkPointSplatSheet_h
#define vtkPointSplatSheet_h

#include "vtkPointSplatNeighbors.h"

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatSheet
{
public:
  /// The neighbour whose distance tells the spacing: past what lies together by chance, or around a
  /// grid's vertex where an isosurface passes it.
  static constexpr int SpacingRank = 6;
  /// So many neighbours are not of the sheet by chance.
  static constexpr int FewMembers = 3;
  static float GetSpacing(const vtkPointSplatNeighbors::Neighborhood& around);
  /// The same on bodies of few points, too, where the neighbour of that rank is another body's.
  static float GetBodySpacing(const vtkPointSplatNeighbors::Neighborhood& around);

  /// By how much the surface turns from a point with the normal n to one that lies there, over their distance: twice
  /// the sine of the angle at which it leaves the tangent plane; squared. Nearer than grain counts as so far.
  static float GetSquaredTurn(const float n[3], const float place[3], float grain);
  /// The same, by the normal of that neighbour.
  static float GetSquaredTurn(
    const float n[3], const float m[3], const float place[3], float grain);
  /// Of the distance that most points are apart: nearer ones, as those of a pole, are as good as one.
  static constexpr float Grain = 1.0f / 256;

  /// How many of the neighbours lie as near as neighbours do where points have that spacing.
  static int CountNear(const vtkPointSplatNeighbors::Neighborhood& around, float spacing);

  /// How a neighbour lies to the centre, whose normal is n.
  struct Arc
  {
    float Height, OtherHeight; // n . d and m . d
    float Cosine;              // n . m
    float Offset;              // the distance at which the surfaces through both pass each other
  };

  /**
   * Finds how all neighbours lie to the centre if n is its normal. normals: 3 floats a slot, unit
   * length.
   */
  void Compare(const vtkPointSplatNeighbors::Neighborhood& around, const float* normals,
    const float n[3]);

  /// How far surfaces through the centre and through its neighbours, the nearest count of them, pass
  /// each other by the last comparison: squared, as a part of their squared distances.
  float GetResidual(const vtkPointSplatNeighbors::Neighborhood& around, int count) const;

  /// Whether a neighbour is of the sheet by the last comparison, as one across a gap is.
  bool IsAcross(const vtkPointSplatNeighbors::Neighborhood& around, int i) const;

  /**
   * Selects of the neighbourhood, of which so many are near, by the last comparison. spacing: of the
   * points here.
   */
  void Select(
    const vtkPointSplatNeighbors::Neighborhood& around, int countNear, float spacing);

  /// The neighbours of the sheet, nearest first: their places in the neighbourhood.
  int Members[vtkPointSplatNeighbors::MaximumNumberOfNeighbors];
  int Count = 0;
  /// How many of these, the first ones, are near. What is farther is a neighbour only across a gap.
  int Near = 0;
  /// Whether those that are not near have the centre's normal, all of them: the sheet is a plane there.
  bool IsFlatAfar = false;
  /// Whether these are few of those that are far, but too much alike to be there by chance: the others are of other sheets.
  bool IsFewAfar = false;
  /// Whether all neighbours are of the sheet.
  bool Whole = false;
  float Spacing = 0; // as given
  /// Whether a near neighbour's normal has turned more than an arc between the two explains: the
  /// one thing that all creases have, and hardly any surface that is smooth.
  bool Uneven = false;

private:
  static bool MeetsEdge(const Arc& arc, float squared);
  static bool IsEdge(const Arc& arc, float turn, float squared);
  void KeepAlike(const vtkPointSplatNeighbors::Neighborhood& around, int countFar);

  Arc Arcs[vtkPointSplatNeighbors::MaximumNumberOfNeighbors];
};

VTK_ABI_NAMESPACE_END
#endif
