// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Where parts of a cloud, the blocks of its input, meet, in its levels (vtkPointSplatHierarchy.h), and
// how much they differ there.
//
// No splat of a level stands for points of two parts, so that nothing within a level's block tells
// that another colour begins beside it. Large splats would blur that border, and reach over it.
// 1. Each of the levels' blocks of points is searched in the tree of all blocks for those of other
//    parts that touch it: boxes about the centres, widened by the largest radius, which at each level
//    hold all disks below. What holds points of the own part alone is left out at once. Once a cloud.
// 2. Of data, a word a splat, means over the splats of both are compared; a block has the largest
//    difference below it. Once for each change of the data.
//
// Parts that are mixed everywhere, such as scans of one place, touch many others: of those, the
// first few tell enough.
#ifndef vtkPointSplatSeams_h
#define vtkPointSplatSeams_h

#include "vtkPointSplatHierarchy.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

class vtkPointSplatSeams
{
public:
  using Block = vtkPointSplatHierarchy::Block;

  /// Finds what touches. ends: behind each part's last point, in ascending order.
  void Make(
    const std::vector<Block>& blocks, size_t roots, const std::vector<uint32_t>& ends);

  /// Raises, of each block, a deviation to the largest difference; of four bytes a word, from 0 to 1,
  /// or of values (vtkPointSplatCloud.h).
  void Raise(const std::vector<Block>& blocks, const std::vector<uint32_t>& data, bool values,
    std::vector<float>& deviations) const;

private:
  /// The points of one part in a block of points.
  struct Run
  {
    uint32_t Block;
    uint32_t First;
    uint32_t Count;
    uint32_t Part;
  };
  class Search;

  std::vector<Run> Runs;
  std::vector<std::pair<uint32_t, uint32_t>> Touching; // runs; the first ones in ascending order
};

#endif
