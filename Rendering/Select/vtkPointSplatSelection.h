// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Which splats a view shows: stage 1 of the frame.
//
// 1. A splat can be seen where some linear functions of its position are positive, or not farther
//    below 0 than its reach makes up for: of the near and the far plane, the sides of the window,
//    clipping planes. A block is left out where one of them is below that in all of its bounding
//    box, by more than single precision may err in the shaders: the picture is the same to the bit.
// 2. Where a cloud has levels (vtkPointSplatLevels.h), blocks are taken from the tree of these
//    (Pajarola, Sainz, Guidotti 2004, section 6.2): one that is out of view, or of which only sides
//    that are not drawn are seen by its cone of normals, is left out with all that is below it. Of
//    the others it is drawn itself, instead of those below, if its splats' radii are within the
//    item's bounds where it is nearest to the eye: Pixels wherever it is, SmoothPixels where its
//    normals deviate little from their linear change, and its colours and shadows from their means,
//    so that larger splats show the same; half of that where both sides are seen, along outlines.
// 3. Where a mesh's triangles are to be drawn, blocks of points of which these are magnified are left
//    to them (vtkPointSplatPatches.h); of levels none is drawn that stands for such ones. Boxes are those
//    of all their triangles then.
// 4. More splats and triangles than can be drawn at once are drawn in parts of the window: it is
//    halved along its longer side until each part shows few enough, or is a tile's size.
#ifndef vtkPointSplatSelection_h
#define vtkPointSplatSelection_h

#include "vtkPointSplatItem.h"

class vtkPointSplatSelection
{
public:
  /// The splats that the item may show in its window; null for those of all points.
  static std::shared_ptr<const vtkPointSplatRuns> Runs(
    const vtkPointSplatView& view, const vtkPointSplatItem& item);

  /// The window in parts, each of at most so many splats if that can be; items have their runs.
  static std::vector<vtkPointSplatPart> Divide(const vtkPointSplatView& view,
    const std::vector<vtkPointSplatItem>& items, const glm::ivec4& window, vtkIdType capacity);
};

#endif
