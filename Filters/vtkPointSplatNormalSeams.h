// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatNormalSeams
 * @brief   normals that cancelled where triangles of opposite windings meet
 *
 * An internal helper of vtkPointSplatEstimation, stage 4 there. A vertex' normal is a mean of its triangles'. On a seam of a
 * mesh, where a part of these is wound the other way, it is what is left of normals of both signs and points anywhere. The
 * neighbours tell better what was meant:
 * 1. A normal that leans over by more than 45 degrees from its disk's plane is looked at, and so are those of the neighbours
 *    of what is mended.
 * 2. Of the eight nearest neighbours five or more have normals across the plane, of either sign, to 37 degrees. The plane is the
 *    disk's if the normal leans over from that, else the one through the eight.
 * 3. They lie all around: a vertex on a face's rim, whose normal leans over to another face with few vertices, has them on one
 *    side. No angle between two of them next to one another is more than 126 degrees.
 * 4. A normal that leans over is like those of no more than two of them, to 25 degrees: what a seam leaves is alike along it,
 *    and what is alike all around is steep.
 * 5. Then a surface of second order through the neighbours tells the normal (vtkPointSplatQuadric.h), on the side of the nearest
 *    normal across the plane, if it is another by more than 10 degrees and the neighbours are off the surface by less than a
 *    tenth of their distance: those on both walls of a rib, whose normals are of either sign, are not.
 * 6. Seams are long: all this is done again as long as there are more, up to eight times.
 */
#ifndef vtkPointSplatNormalSeams_h
#define vtkPointSplatNormalSeams_h

#include "vtkPointSplatNeighbors.h"

#include <array>
#include <map>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatNormalSeams
{
public:
  using Slot = vtkPointSplatNeighbors::Slot;

  /// normals: 3 floats a slot, read and written. planes: those of the disks, likewise.
  vtkPointSplatNormalSeams(const vtkPointSplatNeighbors& neighbors, float* normals, const float* planes);

  /// Mends normals of the slots that are marked, with so many neighbours each. Returns false if aborted.
  bool Mend(vtkAlgorithm* self, std::vector<unsigned char> slots, int count);

  vtkIdType GetNumberOfMended() const { return static_cast<vtkIdType>(this->Given.size()); }
  bool IsMended(Slot slot) const { return this->Given.count(slot) > 0; }
  /// Whether a slot's normal was this one before.
  bool IsMended(Slot slot, const float normal[3]) const;
  /// Whether a slot is, or has it as neighbour, what was mended.
  bool IsBeside(Slot slot) const { return this->Beside[slot] != 0; }

private:
  bool LeansOver(Slot slot) const;
  bool Find(const vtkPointSplatNeighbors::Neighborhood& around, float mended[3]) const;

  const vtkPointSplatNeighbors& Neighbors;
  float* Normals;
  const float* Planes;
  std::map<Slot, std::array<float, 3>> Given; // the normals of those that were mended, before
  std::vector<unsigned char> Beside;
};

VTK_ABI_NAMESPACE_END
#endif
