// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkIsosurfaceSplat
 * @brief   a point on an isosurface with the size and the bend of its disk
 *
 * Internal to vtkIsosurfacePoints.
 *
 * The normal is n = s g / |g| with the field's gradient g and a sign s, -1 where it points to
 * lesser values. A step d across n changes it, to first order, by B d with
 *   B = s P H P / |g|,   P = I - n n^T,
 * H being the Hessian (Goldman 2005, Curvature formulas for implicit curves and surfaces, has
 * the invariants of this matrix). B is the second fundamental form: 1 / R on a
 * sphere of radius R whose normals point outward.
 *
 * A disk's radius is at most that within which the normal turns by 0.6 where B is strongest, but at least 0.75 of what it
 * was: a larger one would stand out over the outline of a tube. B's eigenvalues are held within 1 / radius, where the disk's rim has turned by 45 degrees: so a
 * splat does not leave a tube that is thinner than it, and a gradient that all but vanishes gives
 * no spikes.
 */
#ifndef vtkIsosurfaceSplat_h
#define vtkIsosurfaceSplat_h

#include "vtkPointSplattingABI.h"

VTK_ABI_NAMESPACE_BEGIN

class vtkIsosurfaceSplat
{
public:
  double Position[3]; // world units
  double Normal[3];   // unit length
  double Radius;      // world units
  double Curvature[6] = { 0, 0, 0, 0, 0, 0 }; // XX, YY, ZZ, XY, YZ, XZ

  /**
   * Bends the disk, and makes it smaller where it bends by much, by derivatives of the field in world units: the length of its gradient, and its
   * Hessian (XX, YY, ZZ, XY, YZ, XZ) with the normal's sign s. Normal and Radius are set. Flat
   * where the derivatives are not finite or the gradient is zero.
   */
  void Bend(const double hessian[6], double slope);

  /// A form's tensor (XX, YY, ZZ, XY, YZ, XZ) from its elements 11, 22, 12 by two orthogonal directions.
  static void ToTensor(
    const double form[3], const double a[3], const double b[3], double tensor[6]);
};

VTK_ABI_NAMESPACE_END
#endif
