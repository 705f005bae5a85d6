// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatFoldSides
 * @brief   where the splat of a point on an edge is too small for one of the two faces that meet there
 *
 * An internal helper of vtkPointSplatEstimation; see stage 6 there.
 *
 * The splat of a point on an edge, whose normal is an average, goes on behind its line on the other face, by the same radius on
 * both: that of the face with the denser points. A mesh's colour goes over from the edge's to a face's within the face's
 * triangles, which on the other face are wider.
 * 1. Edge points are splats at creases (vtkPointSplatCreases.h) with a fold and no other line.
 * 2. Splats that end at a line without a fold are looked at that are SparserSide times as large as the one of an edge point as
 *    near as they are drawn. They are next to it if it lies on their line and in their plane, within OffSide of their radius, and
 *    is on their face, by one of its two planes.
 * 3. Of those of each of its sides the nearest tells how large a splat on that side alone is, how it bends, and its line.
 *
 * Memory is 48 bytes for each edge point and splat next to it, and a locator's for edge points.
 */
#ifndef vtkPointSplatFoldSides_h
#define vtkPointSplatFoldSides_h

#include "vtkPointSplatCreases.h"

#include <functional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatFoldSides
{
public:
  using Slot = vtkPointSplatNeighbors::Slot;
  using Splat = vtkPointSplatCreases::Splat;

  /// A splat on one side of an edge point's.
  struct Side
  {
    const Splat* Edge;
    const Splat* Next;  // on that side
    const float* Plane; // the edge point's there
    float Clip[3];      // as in the array of clip lines
  };

  /// getRadius: of a slot's splat, in world units.
  vtkPointSplatFoldSides(const vtkPointSplatNeighbors& neighbors, std::function<float(Slot)> getRadius);

  /// Those of the splats at creases, which have to stay where they are, in these' order.
  std::vector<Side> Find(const std::vector<Splat>& splats) const;

private:
  struct Candidate
  {
    Side Of;
    float SquaredWay; // to the edge point
    bool operator<(const Candidate& other) const;
  };
  static bool IsEdge(const Splat& splat);
  void AddSides(const Splat& next, float radius, const Splat& edge, const float way[3], std::vector<Candidate>& found) const;

  const vtkPointSplatNeighbors& Neighbors;
  const std::function<float(Slot)> GetRadius;
};

VTK_ABI_NAMESPACE_END
#endif
