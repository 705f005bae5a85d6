// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Runs of a cloud's splats that are selected together (Schuetz, Kerbl, Wimmer 2021, Rendering Point
// Clouds with Compute Shaders and Vertex Order Optimization, have such batches with bounding
// boxes). Each 128 splats, in the order of the buffers, make a block.
#ifndef vtkPointSplatBlocks_h
#define vtkPointSplatBlocks_h

#include "vtkType.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/**
 * Splats that are drawn: runs of them, none longer than a block.
 */
struct vtkPointSplatRuns
{
  struct Run
  {
    uint32_t First;
    uint32_t Count;
  };
  std::vector<Run> Runs;
  double LargestRadius = 0.0;
  /// Triangles that are drawn in the place of splats (vtkPointSplatTriangles.h); bit 31 is set for
  /// those that splats may lie beside.
  std::vector<uint32_t> Triangles;

  vtkIdType GetNumberOfSplats() const
  {
    vtkIdType count = 0;
    for (const Run& run : this->Runs)
    {
      count += run.Count;
    }
    return count;
  }
};

class vtkPointSplatBlocks
{
public:
  /// Splats of a block; the last one may have fewer.
  static constexpr int Shift = 7;
  static constexpr vtkIdType Size = vtkIdType(1) << Shift;
  /// Those of levels are drawn in pieces, since they have any number.
  static constexpr int PieceShift = 5;

  /// The centres' bounding box, in the buffers' coordinates, and the largest radius.
  struct Box
  {
    std::array<float, 3> Low;
    std::array<float, 3> High;
    float Radius;
  };

  /// Of count splats of some words each.
  void Make(const std::vector<uint32_t>& splats, size_t words, vtkIdType count);

  const std::vector<Box>& GetBoxes() const { return this->Boxes; }
  /// Splats of a block.
  vtkIdType GetCount(size_t block) const
  {
    const vtkIdType first = static_cast<vtkIdType>(block) * Size;
    return first + Size < this->Count ? Size : this->Count - first;
  }

private:
  std::vector<Box> Boxes;
  vtkIdType Count = 0;
};

#endif
