// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatLatticeSides
 * @brief   which samples of a volume are inside of an isosurface, by what its vertices tell in each voxel
 *
 * An internal helper of vtkPointSplatLattice. The vertices on a voxel's edges tell which of its samples are on the same side,
 * and normals at these vertices which side that is. But the gradients of a volume, which are differences over two voxels, point
 * anywhere where the surface bends within one. So normals vote:
 *
 * 1. A part of a voxel is on the side that its own normals tell.
 * 2. If there are parts of neighbouring voxels that contradict one another at a sample that they share, all that are
 *    linked by shared samples are turned to agree, and all of their normals together tell the side.
 */
#ifndef vtkPointSplatLatticeSides_h
#define vtkPointSplatLatticeSides_h

#include "vtkPointSplattingABI.h"

#include <cstddef>
#include <cstdint>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatLatticeSides
{
public:
  /// Corners of a voxel, by bits (1 further along x, 2 along y, 4 along z), that tell one another's sides.
  struct Part
  {
    std::int64_t Voxel;    // its place in the lattice, row by row
    unsigned char Corners; // a bit for each
    unsigned char Inside;  // of these
    float Agreement;       // how much normals agree with that; less than 0 if they contradict it

    /// What stands for a voxel whose corners contradict one another.
    static Part MakeTorn(std::int64_t voxel) { return { voxel, 0, 0, 0 }; }
    bool IsTorn() const { return this->Corners == 0; }

    void Turn()
    {
      this->Inside ^= this->Corners;
      this->Agreement = -this->Agreement;
    }
    bool operator<(const Part& other) const
    {
      return this->Voxel != other.Voxel ? this->Voxel < other.Voxel : this->Corners < other.Corners;
    }
  };

  /// Turns parts until they agree. strides: from a voxel to the next along each axis.
  static void Settle(std::vector<Part>& parts, const std::int64_t strides[3]);

  /// The parts of a voxel, of those that were settled.
  struct Range
  {
    const Part* First;
    const Part* Last;
    const Part* begin() const { return this->First; }
    const Part* end() const { return this->Last; }
  };
  static Range Find(const std::vector<Part>& parts, std::int64_t voxel);

private:
  template <typename Visitor>
  static void VisitShared(
    const std::vector<Part>& parts, const std::int64_t strides[3], std::size_t begin, std::size_t end, const Visitor& visit);
};

VTK_ABI_NAMESPACE_END
#endif
