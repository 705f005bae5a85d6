// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatSamplings
 * @brief   how regular the samplings of a cloud's parts are, and how wide their gaps
 *
 * An internal helper of vtkPointSplatEstimation. What a gap of the sampling is, and what a hole of the surface, most cells
 * tell, but not those of another body beside it, which may be sampled in another way.
 *
 * 1. Points are of one part if witnesses connect them (vtkPointSplatVoronoiCells.h) that are about as dense. Parts of fewer
 *    than a thousand points that touch a larger one are of it; the others, as droplets and specks, are one together.
 * 2. The usual spacing is that of most points of the part, if it is not about the cloud's, which disks were looked at with
 *    before parts are known.
 * 3. Of each part the distance of the cells' farthest vertices, in spacings, is looked at, all over the part and over that of
 *    the cells around: how much both spread tells whether it is regular, and their 95th percentile the limits. Small bodies
 *    have those of all parts whose points are about as dense.
 *
 * Memory is 8 bytes a slot while parts are looked for, and 8 to 12 more where there are several, of which 4 stay.
 */
#ifndef vtkPointSplatSamplings_h
#define vtkPointSplatSamplings_h

#include "vtkPointSplatVoronoiCells.h"

#include <limits>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatSamplings
{
public:
  using Slot = vtkPointSplatNeighbors::Slot;

  struct Sampling
  {
    float Usual = std::numeric_limits<float>::max(); // the spacing of most points
    /// The distance of a cell's vertex, in spacings, past which it lies in a hole of the surface.
    float HoleLimit = std::numeric_limits<float>::max();
    float BorderLimit = std::numeric_limits<float>::max(); // the same for it to be one that splats end at
    /**
     * Whether it is as regular as a mesh's vertices are: all over, or from one point to the next, as where a mesh is coarser
     * in one place than in another. Random samplings differ as much there as all over.
     */
    bool Regular = false;
    bool Even = false;      // sizes next to one another are the same
    bool Stretched = false; // regular, with cells that are long in one place and not in another
  };

  /// usual: the spacing of most points of the cloud. It is one part, without limits.
  explicit vtkPointSplatSamplings(float usual) { this->Found[0].Usual = usual; }

  /// Finds the parts, and where most points of one are much nearer to one another than those of the cloud, or farther from, the
  /// spacing of those. spacings: of each slot.
  void FindParts(const vtkPointSplatVoronoiCells& cells, const vtkPointSplatLargeArray<float>& spacings);
  /// Finds all else of the parts.
  void FindLimits(const vtkPointSplatVoronoiCells& cells);

  /// Whether there is one part alone.
  bool IsOne() const { return this->PartOf.empty(); }
  /// That of the part that a slot is of.
  const Sampling& Get(Slot slot) const { return this->Found[this->PartOf.empty() ? 0 : this->PartOf[slot]]; }

private:
  void Connect(const vtkPointSplatVoronoiCells& cells, const vtkPointSplatLargeArray<float>& spacings);

  std::vector<Sampling> Found{ 1 };
  std::vector<std::vector<Slot>> Parts{ 1 }; // the slots of each, those of the small ones first; none if there is one alone
  std::vector<Slot> PartOf; // of each slot; empty where there is one part alone
};

VTK_ABI_NAMESPACE_END
#endif
