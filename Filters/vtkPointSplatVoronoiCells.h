// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatVoronoiCells
 * @brief   how far all slots' Voronoi cells reach, and which neighbours tell whether that is usual
 *
 * An internal helper of vtkPointSplatEstimation.
 */
#ifndef vtkPointSplatVoronoiCells_h
#define vtkPointSplatVoronoiCells_h

#include "vtkPointSplatLargeArray.h"
#include "vtkPointSplatNeighbors.h"

#include <algorithm>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatVoronoiCells
{
public:
  using Slot = vtkPointSplatNeighbors::Slot;

  explicit vtkPointSplatVoronoiCells(Slot slots)
    : Opening(slots, 0.0f)
    , Spacing(slots, 0.0f)
    , Witnesses(std::size_t(NumberOfWitnesses) * slots, vtkPointSplatNeighbors::None)
  {
  }

  /// So many neighbours, near ones and far ones, tell whether a cell, and its disk, is as large as those around.
  static constexpr int NumberOfWitnesses = 4;

  /// Calls visit(witness) for each that a slot has.
  template <typename Visitor>
  void VisitWitnesses(Slot slot, const Visitor& visit) const
  {
    const Slot* first = this->Witnesses.data() + std::size_t(NumberOfWitnesses) * slot;
    for (const Slot* witness = first; witness != first + NumberOfWitnesses; ++witness)
    {
      if (*witness != vtkPointSplatNeighbors::None)
      {
        visit(*witness);
      }
    }
  }

  /// The largest spacing of a slot and its witnesses: of a few points that lie together it is that of those around.
  float GetSpacingAround(Slot slot) const
  {
    float spacing = this->Spacing[slot];
    this->VisitWitnesses(
      slot, [&](Slot witness) { spacing = std::max(spacing, this->Spacing[witness]); });
    return spacing;
  }

  /// An element of some order; values are shuffled.
  static float GetQuantile(std::vector<float>& values, double q)
  {
    auto at = values.begin() + static_cast<std::ptrdiff_t>(q * (values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
  }

  /// What is known, which is more than 0, of so many slots: of MostSamples of them at most, all over the cloud.
  template <typename Getter>
  static std::vector<float> GetSamples(std::size_t slots, const Getter& get)
  {
    // An odd stride: all lanes of leaves are among them.
    const std::size_t stride = std::max<std::size_t>(1, slots / MostSamples) | 1;
    std::vector<float> samples;
    for (std::size_t s = 0; s < slots; s += stride)
    {
      const float value = get(s);
      if (value > 0)
      {
        samples.push_back(value);
      }
    }
    return samples;
  }

  vtkPointSplatLargeArray<float> Opening; // the distance of a cell's farthest vertex, 0 for an open cell
  vtkPointSplatLargeArray<float> Spacing; // of the neighbours that the disk is made of

protected:
  vtkPointSplatLargeArray<Slot> Witnesses;

private:
  static constexpr std::size_t MostSamples = std::size_t(1) << 20;
};

VTK_ABI_NAMESPACE_END
#endif
