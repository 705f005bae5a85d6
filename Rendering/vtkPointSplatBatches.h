// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Runs of a cloud's points that are culled together where points are projected as single pixels
// (Schuetz, Kerbl, Wimmer 2021, Rendering Point Clouds with Compute Shaders and Vertex Order
// Optimization, have such batches with bounding boxes).
//
// 1. Once for all frames: each 128 points, in the order of the buffers, make a batch; its
//    bounding box, in the coordinates that the buffers have, is found.
// 2. Each frame: a point is seen where some linear functions of its position are positive: of
//    the near and the far plane, the sides of the window, clipping planes. A batch is
//    left out where one of them is negative in all of its box, by more than single precision
//    may err in the shaders: the picture is the same to the bit.
//
// It saves time where points that follow each other in the input are neighbours in space, as
// scanners and meshes give them; of points in random order no batch is ever left out.
#ifndef vtkPointSplatBatches_h
#define vtkPointSplatBatches_h

#include "vtkType.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

struct vtkPointSplatItem;
struct vtkPointSplatView;

class vtkPointSplatBatches
{
public:
  /// Points of a batch; the last one may have fewer. As in vtkPointSplatPointsCS.glsl.
  static constexpr vtkIdType Size = 128;

  /// Numbers of batches, ascending.
  using List = std::vector<uint32_t>;

  /**
   * Batches of count splats of some words each, taken in an order (empty: as they are).
   */
  void Make(const std::vector<uint32_t>& splats, size_t words, vtkIdType count,
    const std::vector<uint32_t>& order);

  /**
   * The batches that the item may show in this view; null for all of them.
   */
  std::shared_ptr<const List> Select(
    const vtkPointSplatView& view, const vtkPointSplatItem& item) const;

  /// Points of the batches of a list, or all.
  vtkIdType CountPoints(const List* list) const;

private:
  struct Box
  {
    std::array<float, 3> Low;
    std::array<float, 3> High;
  };
  std::vector<Box> Boxes;
  vtkIdType Count = 0; // points
};

#endif
