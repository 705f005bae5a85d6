// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkPointSplatMoments.h
 * @brief sums over points, from which the splat that stands for them follows
 *
 * The generic homogeneous covariance (Pajarola, Sainz, Guidotti 2004, section 4.2, equation 2) is
 * the sum of p p^T over the points, p with a fourth coordinate of 1: the area, the sum of
 * positions, and that of their products. It does not depend on a centre, so that those of two sets
 * are added (equation 4). Sums of normals and of products of normals and positions go the same way.
 */
#ifndef vtkPointSplatMoments_h
#define vtkPointSplatMoments_h

#include "vtkPointSplatHierarchy.h"

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatMoments
{
public:
  void Add(const vtkPointSplatHierarchy::Point& point);
  void Add(const vtkPointSplatMoments& other);

  /**
   * Sets all of a splat but what it covers: position, normal, curvature, variance; and the axes in
   * the tangent plane by the covariance, the shorter one of the circle if that is wanted. fallback:
   * the normal where the sum of all is none.
   */
  void Describe(vtkPointSplatHierarchy::Splat& splat, bool ellipse, const float fallback[3]) const;

private:
  double Count = 0.0;
  double Area = 0.0;
  double Position[3] = { 0.0, 0.0, 0.0 };
  double Products[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 }; // XX, YY, ZZ, XY, YZ, XZ
  double Normal[3] = { 0.0, 0.0, 0.0 };
  double Mixed[3][3] = { { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 } }; // normal, position
  // What the points' own disks add, which are known to bend: of their variance, and times curvature.
  double Spread = 0.0;
  double Bend[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
};

VTK_ABI_NAMESPACE_END
#endif
