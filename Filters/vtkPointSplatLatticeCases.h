// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatLatticeCases
 * @brief   where an isosurface's vertices lie in a volume's lattice, and marching cubes' triangles between them
 *
 * An internal helper of vtkPointSplatLattice. A voxel's corners are numbered by bits: 1 further along x, 2 along y, 4 along z;
 * its edges as vtkMarchingCubesTriangleCases has them.
 */
#ifndef vtkPointSplatLatticeCases_h
#define vtkPointSplatLatticeCases_h

#include "vtkMarchingCubesTriangleCases.h"
#include "vtkPointSplattingABI.h"
#include "vtkType.h"

#include <cstdint>

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatLatticeCases
{
public:
  static constexpr int AtSample = 3; // in place of an edge's axis

  /// A point's place in the lattice, in the order of Key, row by row: 4 times the sample at the lower end of its edge, and the
  /// edge's axis, or AtSample.
  struct Crossing
  {
    std::int64_t Key;
    vtkIdType Id;
  };

  /// The lower ends of a voxel's edges, and their axes.
  static constexpr int EdgeEnds[12] = { 0, 1, 2, 0, 4, 5, 6, 4, 0, 1, 2, 3 };
  static constexpr int EdgeAxes[12] = { 0, 1, 0, 1, 0, 1, 0, 1, 2, 2, 2, 2 };
  /// The edge from a corner along each axis, to the one or the other side.
  static constexpr int EdgesOf[8][3] = { { 0, 3, 8 }, { 0, 1, 9 }, { 2, 3, 10 }, { 2, 1, 11 }, { 4, 7, 8 }, { 4, 5, 9 },
    { 6, 7, 10 }, { 6, 5, 11 } };

  /// Calls visit(edges), of which there are three, for each triangle around the corners that are inside, a bit for each.
  template <typename Visitor>
  static void VisitTriangles(int inside, const Visitor& visit)
  {
    constexpr int corners[8] = { 0, 1, 3, 2, 4, 5, 7, 6 }; // in the order of marching cubes
    int index = 0;
    for (int corner = 0; corner < 8; ++corner)
    {
      index |= inside & (1 << corners[corner]) ? 1 << corner : 0;
    }
    for (const int* edges = vtkMarchingCubesTriangleCases::GetCases()[index].edges; *edges >= 0; edges += 3)
    {
      visit(edges);
    }
  }
};

VTK_ABI_NAMESPACE_END
#endif
