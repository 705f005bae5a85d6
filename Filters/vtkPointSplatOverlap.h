// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatOverlap
 * @brief   which splats of a cloud overlap: the graph that grouping colours
 *
 * An internal helper of vtkPointSplatGrouping. Splats i and j share an edge where
 * |p_i - p_j| < c (r_i + r_j) (Zhang, Pajarola 2006, section 4.1, equation 5, with the
 * factor c of modification 3), and nothing that they relax says otherwise.
 *
 * 1. Splats are sorted into levels by the binary exponent of their radius, and in each level
 *    into the cells of a grid, c times twice the level's largest radius wide, in Morton order.
 *    So a splat's neighbours of the same or a larger level lie in the 27 cells around it,
 *    whatever other sizes there are: memory and time are linear in splats and edges.
 * 2. Chunks of splats are searched in parallel, each pair found once.
 * 3. Edges are stored twice, in rows (compressed sparse rows); the order within a row depends
 *    on the threads, so nothing that reads it may depend on that order.
 */
#ifndef vtkPointSplatOverlap_h
#define vtkPointSplatOverlap_h

#include "vtkPointSplattingABI.h"
#include "vtkType.h"

#include <cstdint>
#include <functional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatOverlap
{
public:
  using Index = std::uint32_t;

  /**
   * Builds the graph of count splats, positions (3 doubles each) and radii in the same unit.
   * keep(i, j), where given, says of a pair that overlaps whether it makes an edge. False where
   * there would be more than mostEdges edges; the graph is empty then.
   */
  bool Build(const double* positions, const double* radii, Index count, double factor,
    std::size_t mostEdges, const std::function<bool(Index, Index)>& keep = nullptr);

  Index GetNumberOfSplats() const
  {
    return static_cast<Index>(this->Offsets.empty() ? 0 : this->Offsets.size() - 1);
  }
  std::size_t GetNumberOfEdges() const { return this->Neighbors.size() / 2; }
  std::size_t GetDegree(Index i) const { return this->Offsets[i + 1] - this->Offsets[i]; }
  ///@{
  /// The splats that overlap splat i.
  const Index* begin(Index i) const { return this->Neighbors.data() + this->Offsets[i]; }
  const Index* end(Index i) const { return this->Neighbors.data() + this->Offsets[i + 1]; }
  ///@}
  /// Where a splat's row begins, to index what is stored for each of its edges.
  std::size_t GetOffset(Index i) const { return this->Offsets[i]; }

private:
  std::vector<std::size_t> Offsets; // of rows, and the end of the last one
  std::vector<Index> Neighbors;
};

VTK_ABI_NAMESPACE_END
#endif
