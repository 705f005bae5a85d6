// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatPrincipal
 * @brief   the principal axes of a point and its neighbours
 *
 * An internal helper of vtkPointSplatEstimation: the covariance's eigenvalues are variances, and the axis of the least is the
 * normal of the plane that fits the points best (Hoppe et al. 1992, Surface Reconstruction from Unorganized Points,
 * section 3.2).
 */
#ifndef vtkPointSplatPrincipal_h
#define vtkPointSplatPrincipal_h

#include "vtkPointSplatNeighbors.h"

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatPrincipal
{
public:
  using Neighborhood = vtkPointSplatNeighbors::Neighborhood;

  /// Of the centre, if it is to count, and so many of its neighbours, the nearest.
  vtkPointSplatPrincipal(const Neighborhood& around, int count, bool withCentre = true);
  explicit vtkPointSplatPrincipal(const Neighborhood& around)
    : vtkPointSplatPrincipal(around, around.Count)
  {
  }

  /// The variances along the axes, the greatest first, in squared world units.
  float Variances[3] = { 0, 0, 0 };

  /// The axis of the least variance, of unit length: of points in a row any across it, of a ball's any.
  void GetNormal(float normal[3]) const;

private:
  double Matrix[6] = { 0, 0, 0, 0, 0, 0 }; // XX, XY, XZ, YY, YZ, ZZ, the greatest of magnitude 1
  double Least = 0;                        // of its eigenvalues
  double Spread = 0;                       // of these: 0 of a ball's
};

VTK_ABI_NAMESPACE_END
#endif
