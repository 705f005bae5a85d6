// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// One item's walk down the tree of its cloud's levels, for one view: vtkPointSplatSelection.h.
#ifndef vtkPointSplatLevelSelection_h
#define vtkPointSplatLevelSelection_h

#include "vtkPointSplatHalfSpaces.h"
#include "vtkPointSplatPatches.h"

#include <memory>

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
  void Visit(const Block& block, vtkPointSplatRuns& chosen);
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
