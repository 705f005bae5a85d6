// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Where the surface of a cloud ends, in its levels (vtkPointSplatHierarchy.h).
//
// Splats that stand for others reach farther over the surface's end than these, which on smooth
// surfaces, where they are some pixels large, shows as teeth. So blocks at the end are to be known.
// 1. Of a block of points, the last ones in eight directions across the axis of its normals.
// 2. From such a point on, the surface goes on if there is another one within five radii, more than
//    half of that ahead. It is searched in the tree of all blocks: boxes about the centres, widened
//    by the largest radius, which at each level hold all disks below. Points spread at random, a
//    radius apart, have fifteen there.
// 3. Blocks have a rim if one of their points' blocks has.
//
// Bodies of some ten radii have one everywhere, as have creases: there splats must not be large either.
#ifndef vtkPointSplatRims_h
#define vtkPointSplatRims_h

#include "vtkPointSplatHierarchy.h"

#include <cstddef>
#include <cstdint>
#include <vector>

class vtkPointSplatRims
{
public:
  using Block = vtkPointSplatHierarchy::Block;

  /// Splats as they are packed, of some words each, in another order than the blocks'.
  struct Points
  {
    const uint32_t* Splats;
    size_t Words;
    const std::vector<uint32_t>& Order;
  };

  /// Of each block whether the surface ends there. The first ones of all are the roots.
  static std::vector<bool> Find(
    const Points& points, const std::vector<Block>& blocks, size_t roots);
};

#endif
