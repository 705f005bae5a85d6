// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatCurvature
 * @brief   how a surface bends at a point, from its neighbours
 *
 * An internal helper of vtkPointSplatEstimation; see the stages there.
 *
 * With tangents a, b and the normal n at a point, to first order the normal of a neighbour at
 * u a + v b + h n is n + (B11 u + B12 v) a + (B12 u + B22 v) b, and to second order h is
 * -(B11 u^2 + 2 B12 u v + B22 v^2) / 2: B is the second fundamental form. So each neighbour,
 * at a distance d, gives three equations, in units of curvature:
 *   (B11 u + B12 v) / d = n_j . a / d,   (B12 u + B22 v) / d = n_j . b / d,
 *   (B11 u^2 + 2 B12 u v + B22 v^2) / d^2 = -2 h / d^2,
 * which B fits by least squares over the neighbours of the point's sheet. The first two hold as
 * well on a circle at any angle up to a right one; the third, which does not, is weighted by the
 * squared cosine between the normals. A neighbour's normal n_j is first turned to the side where n
 * points as it runs along an arc to there: B does not depend on how normals are oriented from point
 * to point, only on the sign of n.
 */
#ifndef vtkPointSplatCurvature_h
#define vtkPointSplatCurvature_h

#include "vtkPointSplatSheet.h"

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatCurvature
{
public:
  /// B as a tensor, XX, YY, ZZ, XY, YZ, XZ, in 1 / world units: B = 1 / R on a sphere of radius
  /// R whose normals point outward. Its null vector is the normal.
  float Tensor[6] = { 0, 0, 0, 0, 0, 0 };
  /// The greater of the principal curvatures' magnitudes, of the fit as it is.
  float Strongest = 0;

  /**
   * Fits the tensor at the neighbourhood's centre, where the normal is n. normals: 3 floats a slot,
   * unit length; radius: of the disk that is to bend, of which the normals of a few points that lie together say little.
   * Where the neighbours do not agree on it (noise, creases, too few of them), it is smaller
   * than the fit, down to 0: there the plane is the better guess.
   */
  void Estimate(const vtkPointSplatNeighbors::Neighborhood& around, const float* normals,
    const float n[3], const vtkPointSplatSheet& sheet, float radius = 0.0f);

  /// How much a surface of that curvature bends: the root of its principal curvatures' sum of squares, 1 / world units.
  static float GetBend(const float tensor[6]);
};

VTK_ABI_NAMESPACE_END
#endif
