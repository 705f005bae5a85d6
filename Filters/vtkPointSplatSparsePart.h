// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatSparsePart
 * @brief   the neighbours that dense points of another part of the surface hide
 *
 * An internal helper of vtkPointSplatEstimation; see stage 4 there. Where dense points lie close to a sparse part of
 * the surface, as those of a belt on a body or of a button on a coat, all of the nearest neighbours of a sparse point
 * may be dense ones of another sheet: the point is hemmed in. However many neighbours are looked at, its own sheet's
 * are few among them, or none.
 *
 * 1. Which slots may be hemmed in is given.
 * 2. A search tree is made of these and of all slots but the dense ones: those whose disks' neighbours are less than
 *    SparseRatio times as far apart as what the former have next to them, at the median. Where all points are about as
 *    dense, all are in it. What is farther from the former than Reach times that spacing is not, to save time.
 * 3. Each of the former is visited with its neighbours in that tree.
 */
#ifndef vtkPointSplatSparsePart_h
#define vtkPointSplatSparsePart_h

#include "vtkPointSplatDisks.h"

#include <atomic>
#include <functional>
#include <vector>

class vtkAlgorithm;
class vtkDataArray;

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatSparsePart
{
public:
  using Slot = vtkPointSplatNeighbors::Slot;
  using Neighborhood = vtkPointSplatNeighbors::Neighborhood;
  /// As vtkPointSplatNeighbors::Visit() has it.
  using Visitor = std::function<bool(const Neighborhood& around, int round)>;

  /// usual: the spacing of most points; hemmed: of each slot whether it may be hemmed in.
  vtkPointSplatSparsePart(const vtkPointSplatNeighbors& neighbors, const vtkPointSplatDisks& disks,
    float usual, std::vector<unsigned char> hemmed);

  /// Whether no slot may be hemmed in.
  bool IsEmpty() const { return this->Spacings.empty(); }

  /**
   * Visits all that may be hemmed in with their neighbours, of which the first round has so many, by the numbers that
   * slots have in the whole cloud. points: as that was built from. Returns false if self was aborted.
   */
  bool Visit(vtkAlgorithm* self, vtkDataArray* points, int count, const Visitor& visit) const;

private:
  std::vector<unsigned char> GetUsed() const;
  std::vector<std::atomic<bool>> GetNearLeaves() const;

  const vtkPointSplatNeighbors& Neighbors;
  const vtkPointSplatDisks& Disks;
  const float Usual;
  const std::vector<unsigned char> Hemmed;
  std::vector<float> Spacings; // next to those
};

VTK_ABI_NAMESPACE_END
#endif
