// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatDisjointSets
 * @brief   which of so many things are connected: disjoint sets
 *
 * An internal helper of vtkPointSplatEstimation. Each thing is of one group; at first each is one of its own. Memory is 4 bytes a
 * thing.
 */
#ifndef vtkPointSplatDisjointSets_h
#define vtkPointSplatDisjointSets_h

#include "vtkPointSplatNeighbors.h"

#include <algorithm>
#include <numeric>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatDisjointSets
{
public:
  using Index = vtkPointSplatNeighbors::Slot;

  explicit vtkPointSplatDisjointSets(std::size_t count)
    : First(count)
  {
    std::iota(this->First.begin(), this->First.end(), Index(0));
  }

  /// The first of a thing's group, which stands for all of it.
  Index Find(Index i)
  {
    while (this->First[i] != i)
    {
      // The way is half as long next time.
      i = this->First[i] = this->First[this->First[i]];
    }
    return i;
  }

  /// Makes one group of those that two things stand for.
  void Join(Index a, Index b) { this->First[std::max(a, b)] = std::min(a, b); }

  /// Whether two are known to be of one group, without looking far.
  bool AreNear(Index a, Index b) const { return this->First[a] == this->First[b]; }

private:
  std::vector<Index> First; // an earlier thing of the group, or the thing itself
};

VTK_ABI_NAMESPACE_END
#endif
