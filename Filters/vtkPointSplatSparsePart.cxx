// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatSparsePart.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkPointSplatThreads.h"

#include <algorithm>
#include <array>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// Points are dense up to so many times the spacing next to hemmed slots (Testing/Accuracy/fit_constants.py). Were it
/// more, the tree of two parallel sheets that are equally dense would lack some of their points.
constexpr float SparseRatio = 0.8f;
/// So many times as far as what is next to hemmed slots their sheet's sparse points are looked for.
constexpr float SparseReach = 64;
/// Where one of so many slots may be hemmed in, as in a volume full of points, looking for what is near takes longer
/// than a tree of all.
constexpr std::size_t ManyHemmed = 64;
}

vtkPointSplatSparsePart::vtkPointSplatSparsePart(const vtkPointSplatNeighbors& neighbors,
  const vtkPointSplatDisks& disks, float usual, std::vector<unsigned char> hemmed)
  : Neighbors(neighbors)
  , Disks(disks)
  , Usual(usual)
  , Hemmed(std::move(hemmed))
{
  for (std::size_t s = 0; s < this->Hemmed.size(); ++s)
  {
    if (this->Hemmed[s])
    {
      this->Spacings.push_back(this->Disks.NearSpacing[s]);
    }
  }
}

/// Of each point whether it is in the search tree.
std::vector<unsigned char> vtkPointSplatSparsePart::GetUsed() const
{
  std::vector<float> spacings = this->Spacings;
  const float least = SparseRatio * vtkPointSplatVoronoiCells::GetQuantile(spacings, 0.5);
  const std::vector<std::atomic<bool>> near = this->GetNearLeaves();
  std::vector<unsigned char> used(this->Neighbors.GetSlots().size(), 0);
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(this->Hemmed.size()), [&](vtkIdType begin, vtkIdType end) {
    for (Slot s = static_cast<Slot>(begin); s < static_cast<Slot>(end); ++s)
    {
      const vtkIdType id = this->Neighbors.GetId(s);
      if (id >= 0 && near[s / vtkPointSplatNeighbors::LeafSize])
      {
        used[id] = this->Hemmed[s] || this->Disks.Spacing[s] > least;
      }
    }
  });
  return used;
}

/// Of each leaf whether it is within reach of a hemmed slot.
std::vector<std::atomic<bool>> vtkPointSplatSparsePart::GetNearLeaves() const
{
  constexpr Slot leafSize = vtkPointSplatNeighbors::LeafSize;
  std::vector<std::atomic<bool>> near(this->Hemmed.size() / leafSize);
  if (ManyHemmed * this->Spacings.size() > this->Hemmed.size())
  {
    std::fill(near.begin(), near.end(), true);
    return near;
  }
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(near.size()), [&](vtkIdType begin, vtkIdType end) {
    for (Slot leaf = static_cast<Slot>(begin); leaf < static_cast<Slot>(end); ++leaf)
    {
      float spacing = 0;
      for (Slot s = leaf * leafSize; s < (leaf + 1) * leafSize; ++s)
      {
        if (this->Hemmed[s])
        {
          // An outlier's own spacing is the distance to all others: it would reach the whole cloud.
          spacing = std::max(spacing, std::min(this->Disks.NearSpacing[s], this->Usual));
        }
      }
      if (spacing > 0)
      {
        this->Neighbors.VisitLeaves(leaf, SparseReach * spacing, [&near](Slot other) {
          near[other].store(true, std::memory_order_relaxed);
          return true;
        });
      }
    }
  });
  return near;
}

bool vtkPointSplatSparsePart::Visit(
  vtkAlgorithm* self, vtkDataArray* points, int count, const Visitor& visit) const
{
  vtkPointSplatNeighbors sparse;
  sparse.Build(points, this->GetUsed().data());
  const auto getSlot = [&](Slot s) {
    const vtkIdType id = sparse.GetId(s);
    return id >= 0 ? this->Neighbors.GetSlots()[id] : vtkPointSplatNeighbors::None;
  };
  const auto visitTranslated = [&](const Neighborhood& found, int round) {
    std::array<Slot, vtkPointSplatNeighbors::MaximumNumberOfNeighbors> slots;
    std::transform(found.Slots, found.Slots + found.Count, slots.begin(), getSlot);
    Neighborhood around = found;
    around.Center = getSlot(found.Center);
    around.Slots = slots.data();
    return visit(around, round);
  };
  const double progress = self->GetProgress();
  return sparse.Visit(self, progress, progress, count, visitTranslated, [&](Slot s) {
    const Slot slot = getSlot(s);
    return slot != vtkPointSplatNeighbors::None && this->Hemmed[slot] != 0;
  });
}

VTK_ABI_NAMESPACE_END
