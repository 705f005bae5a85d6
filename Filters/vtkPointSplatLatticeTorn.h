// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatLatticeTorn
 * @brief   the triangles in voxels in which an isosurface was cut off
 *
 * An internal helper of vtkPointSplatLattice. Where a surface was clipped or cropped, or lacks points, the sides of a voxel's
 * samples contradict one another. If it was clipped some of the voxel's points lie on no edge, but in its faces or within it,
 * on the cut. What is left of the surface in such a voxel is about flat:
 *
 * 1. Points in one face of the voxel are next to one another if there are two of them, since the surface meets a face in one
 *    line. What is linked so is one sheet; a point within the voxel is of the sheet whose points are nearest.
 * 2. A sheet's points are ordered around their middle, across the mean of their normals, ...
 * 3. ... and the polygon is divided from the corner from which its diagonals are shortest.
 *
 * Sheets of one or two points have no triangle, nor have those whose normals cancel one another.
 */
#ifndef vtkPointSplatLatticeTorn_h
#define vtkPointSplatLatticeTorn_h

#include "vtkPointSplatLatticeVoxel.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatLatticeTorn
{
public:
  /// A point, and by bits the faces of a voxel that it lies in.
  struct Point
  {
    vtkIdType Id;
    unsigned int Faces;
  };

  /// A bit for the face across an axis at a voxel's lower end (0), or at its upper one (1).
  static constexpr unsigned int GetFace(int axis, int end) { return 1u << (2 * axis + end); }

  /// positions: 3 a point; normals: 3 floats a point.
  vtkPointSplatLatticeTorn(const std::vector<double>& positions, const float* normals)
    : Positions(positions)
    , Normals(normals)
  {
  }

  /// Adds a point on no edge to a voxel that it lies in or borders.
  void Add(std::int64_t voxel, const Point& point) { this->Loose.push_back({ voxel, point }); }
  /// After all were added, and before anything else is asked.
  void Sort();

  bool IsEmpty() const { return this->Loose.empty(); }
  bool Has(std::int64_t voxel) const;

  /// A voxel's points on edges, at samples and on none.
  std::vector<Point> GetPoints(const vtkPointSplatLatticeVoxel& voxel) const;
  /// Adds the triangles, 3 corners each, of a voxel's points.
  void AddTriangles(const vtkPointSplatLatticeVoxel& voxel, std::vector<vtkIdType>& corners) const;

private:
  struct LoosePoint
  {
    std::int64_t Voxel;
    Point At;
  };

  std::vector<LoosePoint>::const_iterator FindFirst(std::int64_t voxel) const;
  std::size_t FindNearest(const std::vector<Point>& points, std::size_t of) const;
  void AddPolygon(std::vector<vtkIdType>& sheet, std::vector<vtkIdType>& corners) const;

  const std::vector<double>& Positions;
  const float* const Normals;
  std::vector<LoosePoint> Loose; // voxel by voxel
};

VTK_ABI_NAMESPACE_END
#endif
