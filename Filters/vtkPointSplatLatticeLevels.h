// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatLatticeLevels
 * @brief   the triangles of several isosurfaces of one volume, told by where their vertices lie
 *
 * An internal helper of vtkPointSplatLattice, for what contour filters extract of one volume at several values. Each value has
 * a surface of its own, and an edge of the lattice as many vertices as there are values between those of its ends.
 *
 * 1. *Regions.* Samples between which no vertex lies are between the same two values (vtkPointSplatLatticeRegions.h). A sample
 *    that a vertex lies at has just a value.
 * 2. *Depths.* A region's depth is twice the number of surfaces that it is inside of, and one more at a value. That of two
 *    regions differs by two for each vertex between them, and by one where these lie at a sample. From the
 *    largest region on, each has the depth that most edges to known ones say; where two depths are as many edges', normals of the
 *    vertices together say which of the regions is deeper, and the clearest one is the next.
 * 3. *Triangles* are those of marching cubes for each surface alone; along an edge the vertices are in the order of depth.
 *
 * Nothing is found if an edge contradicts these depths.
 */
#ifndef vtkPointSplatLatticeLevels_h
#define vtkPointSplatLatticeLevels_h

#include "vtkPointSplatLatticeRegions.h"

#include <cstddef>
#include <cstdint>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatLatticeLevels
{
public:
  using Crossing = vtkPointSplatLatticeCases::Crossing;

  /// crossings: in order, those of an edge along it; size: of the lattice in samples, one more on each side than voxels have;
  /// normals: 3 floats a point.
  vtkPointSplatLatticeLevels(
    const std::vector<Crossing>& crossings, const std::int64_t size[3], const float* normals);

  bool Find();

  std::vector<vtkIdType> Corners; // 3 a triangle

private:
  using Range = vtkPointSplatLatticeRegions::Range;

  /// Two regions whose depths differ by a step.
  struct Link
  {
    std::size_t A, B;
    int Step;
    float Vote;  // more than 0 if A is deeper
    int Edges;   // so many say it
  };

  void AddLink(std::size_t a, std::size_t b, int step, float vote);
  void FindLinks();
  void JoinLinks();
  bool FindDepths();
  vtkIdType GetPoint(std::int64_t voxel, int edge, const int depths[8], int surface) const;
  void AddTriangles(std::int64_t voxel, std::vector<vtkIdType>& corners) const;

  const std::vector<Crossing>& Crossings;
  vtkPointSplatLatticeRegions Regions;
  const float* Normals;
  std::vector<Link> Links;
  std::vector<int> Depths; // of each region
};

VTK_ABI_NAMESPACE_END
#endif
