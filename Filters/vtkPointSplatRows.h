// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkPointSplatRows.h
 * @brief points that lie in rows: along curves, or of a surface that is sampled so
 *
 * An internal helper of vtkPointSplatNormals and vtkPointSplatBodies. Scan lines, sections and the lines of a solver's grid
 * are many times as dense along them as from one to the next: all of a point's nearest neighbours are of its own row, and
 * say nothing of the surface's normal. Farther ones do, if what lies beside the row is a surface:
 *
 * 1. The nearest neighbours tell the row's direction.
 * 2. The nearest one that is not along it tells how far rows are apart.
 * 3. A plane fits all that is within PlaneReach such distances, and what is off it must be little beside how far the rows
 *    lie apart: curves in a volume, and coils as wide as their turns are apart, have no such plane.
 * 4. There must be rows enough, three on one side or two on both: two or three wires side by side are no surface.
 * 5. Of the points beside the row some must have about the same plane, which those of curves that pass by have not, and of
 *    those farther beside that lie in rows at least half a plane: two curves that pass by one another do lie in one. And
 *    half of those nearest must lie in a row themselves, since of points at random some do by chance.
 */
#ifndef vtkPointSplatRows_h
#define vtkPointSplatRows_h

#include "vtkPointSplatNeighbors.h"
#include "vtkPointSplatPrincipal.h"

#include <cstddef>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

namespace vtkPointSplatRows
{
using Neighborhood = vtkPointSplatNeighbors::Neighborhood;

/// Whether so many nearest neighbours, which have these variances, lie on a curve.
bool IsCurve(const Neighborhood& around, int count, const float variances[3]);
/// Whether they may lie on a curve, and noise hides it: more of them will tell.
bool IsLong(const float variances[3]);
/// Whether the nearest few alone lie in a row.
bool IsRow(const Neighborhood& around);

/**
 * Takes the plane of more neighbours for the normal that the nearest ones gave, if these lie in the plane of a row and the
 * noise of its points, and more, which are of the rows beside, too, in the surface's. principal: the axes of all. Returns whether it does.
 */
bool FitThick(const vtkPointSplatPrincipal& principal, float normal[3]);

/// How many points, the nearest, tell whether it is a row, ...
constexpr std::size_t NumberOfAlong = 4;
/// ... how many beside it have a say, the nearest ...
constexpr std::size_t NumberOfBeside = 5;
/// ... and all that are within RowsReach.
constexpr std::size_t NumberOfWitnesses = 8;

/// What may be the plane of a surface at a point in a row.
struct Plane
{
  vtkPointSplatNeighbors::Slot At;
  vtkPointSplatNeighbors::Slot Along[NumberOfAlong]; // the nearest
  vtkPointSplatNeighbors::Slot Beside[NumberOfBeside]; // the nearest that are not along the row, then None
  vtkPointSplatNeighbors::Slot Witnesses[NumberOfWitnesses]; // as many, near and far
  float Normal[3]; // of unit length
};

/**
 * Finds such a plane (stages 1 to 4) in a neighbourhood that reaches past its row, as the last round's of
 * vtkPointSplatNeighbors::VisitWidely() does. Returns false if there is none.
 */
bool Fit(const Neighborhood& around, Plane& plane);

/**
 * Leaves of the planes those that points beside agree with (stage 5), and sets their normals. normals: 3 floats a slot;
 * inRow: of each slot whether its neighbours lie in a row.
 */
void KeepSurfaces(
  std::vector<Plane>& planes, const std::vector<unsigned char>& inRow, float* normals);
}

VTK_ABI_NAMESPACE_END
#endif
