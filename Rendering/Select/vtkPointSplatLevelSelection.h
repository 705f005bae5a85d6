// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// One item's walk down the tree of its cloud's levels, for one view: vtkPointSplatSelection.h. Threads
// visit branches of the tree, and what they choose is put together in the tree's order.
#ifndef vtkPointSplatLevelSelection_h
#define vtkPointSplatLevelSelection_h

#include "vtkPointSplatHalfSpaces.h"
#include "vtkPointSplatPatches.h"

#include <memory>
#include <vector>

class vtkPointSplatLevelSelection
{
public:
  vtkPointSplatLevelSelection(const vtkPointSplatView& view, const vtkPointSplatItem& item);

  std::shared_ptr<const vtkPointSplatRuns> Choose();

private:
  using Block = vtkPointSplatLevels::Block;
  enum class Decision
  {
    LeaveOut,
    Divide,
    TakeTriangles,
    TakeSplats
  };
  Decision Decide(const Block& block) const;
  /// What is chosen of a branch.
  struct Chosen
  {
    std::vector<vtkPointSplatRuns::Run> Runs;
    std::vector<uint32_t> Patches; // whose triangles are drawn
    double LargestRadius = 0.0;
  };
  void Visit(const Block& block, Chosen& chosen) const;
  /// Blocks of which no two are in one branch, and which are all that is to be visited.
  std::vector<uint32_t> FindBranches() const;
  /// Where points move, brings the blocks that Visit() will come to to where they are now, and no others.
  void MoveVisited();
  bool IsOutside(const Block& block) const;
  /// Of all triangles of the points that a block stands for.
  const vtkPointSplatTriangles::Extent& ExtentOf(const Block& block) const;
  /// Which sides of a block's splats may be seen.
  struct Sides
  {
    bool Front;
    bool Back;
  };
  Sides SidesOf(const Block& block) const;
  bool IsFine(const Block& block, const Sides& sides) const;

  const vtkPointSplatItem& Item;
  vtkPointSplatHalfSpaces Halves;
  // In the coordinates of the cloud's buffers.
  glm::dvec4 Eye;     // or the direction to it, whose w is 0
  vtkPointSplatPixelSize PixelSize;
  vtkPointSplatPatches Patches;
};

#endif
