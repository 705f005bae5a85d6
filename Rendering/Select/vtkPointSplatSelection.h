// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Which blocks of splats a view shows.
//
// 1. A splat can be seen where some linear functions of its position are positive, or not farther
//    below 0 than its reach makes up for: of the near and the far plane, the sides of the window,
//    clipping planes. A block is left out where one of them is below that in all of its bounding
//    box, by more than single precision may err in the shaders: the picture is the same to the bit.
// 2. More splats than can be drawn at once are drawn in parts of the window: it is halved along its
//    longer side until each part shows few enough, or is a tile's size.
#ifndef vtkPointSplatSelection_h
#define vtkPointSplatSelection_h

#include "vtkPointSplatItem.h"

class vtkPointSplatSelection
{
public:
  /// The blocks that the item may show in its window; null for all of them.
  static std::shared_ptr<const std::vector<uint32_t>> Blocks(
    const vtkPointSplatView& view, const vtkPointSplatItem& item);

  /// The window in parts, each of at most so many splats if that can be; items have their blocks.
  static std::vector<vtkPointSplatPart> Divide(const vtkPointSplatView& view,
    const std::vector<vtkPointSplatItem>& items, const glm::ivec4& window, vtkIdType capacity);
};

#endif
