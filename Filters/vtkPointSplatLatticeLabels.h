// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatLatticeLabels
 * @brief   the triangles of many labels' surfaces, told by where their vertices lie
 *
 * An internal helper of vtkPointSplatLattice, for what vtkDiscreteFlyingEdges3D and its like extract of a volume of labels:
 * each label has a surface of its own, and where two labels touch there are two points in the middle of an edge, with normals to
 * both sides.
 *
 * 1. *Regions.* Samples between which no point lies have one label (vtkPointSplatLatticeRegions.h).
 * 2. *Background.* A region has a surface of its own if its points' normals point out of it. Normals of the points of which
 *    an edge has but one say on which side the background is, and all around a region vote. A region
 *    that shares edges of two points is a label's.
 * 3. *Triangles* are those of marching cubes for each label's region alone; of the two points of an edge each has the one whose
 *    normal points out of it.
 *
 * Nothing is found where a point lies between two samples of one region, more than two lie on an edge, or many edges do not
 * have as many as the votes say.
 */
#ifndef vtkPointSplatLatticeLabels_h
#define vtkPointSplatLatticeLabels_h

#include "vtkPointSplatLatticeRegions.h"

#include <cstddef>
#include <cstdint>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatLatticeLabels
{
public:
  using Crossing = vtkPointSplatLatticeCases::Crossing;

  /// crossings: in order, none at a sample; size: of the lattice in samples, one more on each side than voxels have; normals: 3
  /// floats a point.
  vtkPointSplatLatticeLabels(
    const std::vector<Crossing>& crossings, const std::int64_t size[3], const float* normals);

  bool Find();

  std::vector<vtkIdType> Corners; // 3 a triangle

private:
  using Range = vtkPointSplatLatticeRegions::Range;

  bool Vote();
  void AddTriangles(std::int64_t voxel, std::vector<vtkIdType>& corners) const;
  vtkIdType GetPoint(std::int64_t voxel, int edge, int inside) const;

  vtkPointSplatLatticeRegions Regions;
  const float* Normals;
  std::vector<float> Votes; // of each region: more than 0 for a label's
};

VTK_ABI_NAMESPACE_END
#endif
