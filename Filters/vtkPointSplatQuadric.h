// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatQuadric
 * @brief   the normal of a surface of second order through a point's neighbours
 *
 * An internal helper of vtkPointSplatNormals.
 *
 * The plane that fits a point and its neighbours best is not the surface's tangent plane where the surface bends and more
 * of them lie to one side: random samplings of smooth surfaces have normals that are off by degrees. A height field of
 * second order over that plane (Cazals and Pouget 2005, Estimating differential quantities using polynomial fitting of
 * osculating jets, section 2) has the tangent plane itself:
 *
 * 1. Offsets are taken along two axes x, y in the plane and along its normal, z, in units of the farthest neighbour's
 *    distance.
 * 2. z = c0 + c1 x + c2 y + c3 x^2 + c4 x y + c5 y^2 by least squares. Weights fall to almost none at the farthest.
 * 3. Noise has no second order, but a fit follows it. If the terms of second order lessen the squared residual by F times
 *    what they would of noise that is as large as what remains, they are shrunk by 1 - 1 / F, to 0 where F is less than 1
 *    (James and Stein 1961, Estimation with quadratic loss).
 * 4. The normal is (-c1, -c2, 1).
 */
#ifndef vtkPointSplatQuadric_h
#define vtkPointSplatQuadric_h

#include "vtkPointSplatNeighbors.h"

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatQuadric
{
public:
  /// The surface's normal at the centre, of unit length.
  float Normal[3] = { 0, 0, 0 };
  /// By how much the neighbours are off the surface, in their mean distance on it, were they even.
  float Residual = 0;
  /// How far off their centre the point is in the plane, in the distance of the farthest: 0 where they are all around it.
  float Aside = 0;

  /**
   * Fits the surface to a neighbourhood. plane: the unit normal of the plane through it. False if there are too few neighbours
   * or they do not tell: then nothing is set.
   */
  bool Fit(const vtkPointSplatNeighbors::Neighborhood& around, const float plane[3]);
};

VTK_ABI_NAMESPACE_END
#endif
