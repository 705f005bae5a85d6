// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatLatticeRegions
 * @brief   the samples of a volume next to its surfaces' vertices, joined where no vertex lies between them
 *
 * An internal helper of vtkPointSplatLatticeLabels and vtkPointSplatLatticeLevels, where several surfaces cross an edge. A
 * sample that a vertex lies at is a region of its own.
 */
#ifndef vtkPointSplatLatticeRegions_h
#define vtkPointSplatLatticeRegions_h

#include "vtkPointSplatLatticeCases.h"
#include "vtkPointSplatThreads.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatLatticeRegions
{
public:
  using Crossing = vtkPointSplatLatticeCases::Crossing;

  /// crossings: in order; size: of the lattice in samples, one more on each side than voxels have.
  vtkPointSplatLatticeRegions(const std::vector<Crossing>& crossings, const std::int64_t size[3]);

  /// Returns false where there are too many samples.
  bool Find();

  /// Points on an edge, or at a sample.
  struct Range
  {
    const Crossing* First;
    const Crossing* Last;
    std::size_t GetCount() const { return static_cast<std::size_t>(this->Last - this->First); }
  };

  /// Points between a sample and the next one along an axis, or AtSample.
  Range Get(std::int64_t sample, int axis) const;
  std::int64_t GetCorner(std::int64_t voxel, int corner) const;
  /// From a sample to the next along each axis.
  const std::int64_t* GetStrides() const { return this->Strides; }
  /// How many regions, at most, there are.
  std::size_t GetCount() const { return this->Samples.size(); }
  /// A sample's region, or GetCount() if it is not next to a point.
  std::size_t GetRegion(std::int64_t sample) const;

  /// Whether a region is one sample that a point lies at.
  bool IsAtSample(std::size_t region) const { return this->AtSample[region] != 0; }

  /// Visits the edges of voxels that have points, and the regions of their ends, until visit(on, axis, a, b) returns false, as
  /// is returned.
  template <typename Visitor>
  bool VisitEdges(const Visitor& visit) const
  {
    for (std::size_t i = 0; i < this->Crossings.size();)
    {
      const std::int64_t sample = this->Crossings[i].Key / 4;
      const int axis = static_cast<int>(this->Crossings[i].Key % 4);
      const Range on = this->Get(sample, axis);
      i += on.GetCount();
      if (axis != vtkPointSplatLatticeCases::AtSample)
      {
        const std::size_t a = this->GetRegion(sample), b = this->GetRegion(sample + this->Strides[axis]);
        const bool within = a != this->GetCount() && b != this->GetCount();
        if (within && !visit(on, axis, a, b))
        {
          return false;
        }
      }
    }
    return true;
  }

  /// What add(voxel, corners) adds of each voxel next to points: 3 corners a triangle.
  template <typename Adder>
  std::vector<vtkIdType> GetTriangles(const Adder& add) const
  {
    constexpr std::size_t atOnce = 1024;
    std::vector<std::vector<vtkIdType>> found((this->Voxels.size() + atOnce - 1) / atOnce);
    vtkPointSplatThreads::For(0, static_cast<vtkIdType>(found.size()), [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType block = begin; block < end; ++block)
      {
        const std::size_t last = std::min<std::size_t>(this->Voxels.size(), (block + 1) * atOnce);
        for (std::size_t i = block * atOnce; i < last; ++i)
        {
          add(this->Voxels[i], found[block]);
        }
      }
    });
    std::vector<vtkIdType> corners;
    for (const std::vector<vtkIdType>& ofBlock : found)
    {
      corners.insert(corners.end(), ofBlock.begin(), ofBlock.end());
    }
    return corners;
  }

private:
  std::size_t GetNumber(std::int64_t sample) const;
  void AddVoxels(const Crossing& crossing);

  const std::vector<Crossing>& Crossings;
  const std::int64_t Size[3];
  const std::int64_t Strides[3];
  std::vector<std::int64_t> Voxels;  // next to points, by their lowest samples, in order
  std::vector<std::int64_t> Samples; // of these, in order
  std::vector<unsigned char> AtSample; // whether a point lies at each
  std::vector<std::uint32_t> Regions; // of each
};

VTK_ABI_NAMESPACE_END
#endif
