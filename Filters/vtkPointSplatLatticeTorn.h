// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatLatticeTorn
 * @brief   the triangles in voxels in which an isosurface was cut off
 *
 * An internal helper of vtkPointSplatLattice. Where a surface was clipped, or lacks points, the sides of a voxel's samples
 * contradict one another, and some of its points lie in its faces or within it, on the cut. What is left of the surface in such
 * a voxel is about flat:
 *
 * 1. Points in one face of the voxel are next to one another if there are two of them, since the surface meets a face in one
 *    line. What is linked so is one sheet; a point within the voxel is of the sheet that is nearest.
 * 2. A sheet's points are ordered around their middle, across the mean of their normals, ...
 * 3. ... and the polygon is divided from the corner from which its diagonals are shortest.
 */
#ifndef vtkPointSplatLatticeTorn_h
#define vtkPointSplatLatticeTorn_h

#include "vtkPointSplatLatticeVoxel.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatLatticeTorn
{
public:
  /// A voxel's point, and the faces of the voxel in which it lies: 1 and 2 across x, 4 and 8 across y, 16 and 32 across z.
  struct Point
  {
    vtkIdType Id;
    unsigned int Faces;
  };

  /// positions: 3 a point; normals: 3 floats a point.
  vtkPointSplatLatticeTorn(const std::vector<double>& positions, const float* normals)
    : Positions(positions)
    , Normals(normals)
  {
  }

  /// Adds the triangles, 3 corners each, in a voxel with these other points.
  void AddTriangles(
    const vtkPointSplatLatticeVoxel& voxel, std::vector<Point> others, std::vector<vtkIdType>& corners) const;

private:
  void AddPolygon(std::vector<vtkIdType>& sheet, std::vector<vtkIdType>& corners) const;

  const std::vector<double>& Positions;
  const float* const Normals;
};

VTK_ABI_NAMESPACE_END
#endif
