// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkIsosurfaceFill
 * @brief   how a splat in the middle of an outline lies, and bends
 *
 * Internal to vtkIsosurfaceEdges. Where the isosurface bends by much within a voxel, the disks of the
 * points on its edges, whose normals differ, stand out over one another. A fill point at the
 * outline's centroid lets them be smaller. Its normal n is the mean of the points' normals n_i; and
 * the form B by which normals change around it (vtkIsosurfaceSplat.h) is the one that fits them
 * best by least squares, P n_i = B P d_i, with the points' offsets d_i from the centroid and
 * P = I - n n^T: so it is shaded as triangles of these points are.
 */
#ifndef vtkIsosurfaceFill_h
#define vtkIsosurfaceFill_h

#include "vtkPointSplattingABI.h"

VTK_ABI_NAMESPACE_BEGIN

class vtkIsosurfaceSplat;

class vtkIsosurfaceFill
{
public:
  /// Whether two of the normals of an outline's points turn by so much that a fill point is wanted.
  static bool IsBent(int count, const double (*normals)[3]);

  /**
   * By an outline's points: offsets from its centroid, world units, and normals of unit length. False:
   * the normals have no mean.
   */
  bool Fit(int count, const double (*offsets)[3], const double (*normals)[3]);

  /// Gives a splat, whose radius is set, the normal and the bend.
  void Apply(vtkIsosurfaceSplat& splat) const;

private:
  float Normal[3];
  float Form[6]; // XX, YY, ZZ, XY, YZ, XZ, 1 / world units
};

VTK_ABI_NAMESPACE_END
#endif
