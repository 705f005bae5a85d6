// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatSamplings.h"

#include "vtkPointSplatDisjointSets.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
using Slot = vtkPointSplatNeighbors::Slot;
using Sampling = vtkPointSplatSamplings::Sampling;

// Those that are fitted by hand are from Testing/Accuracy/fit_constants.py.
/// Where samplings are as regular as meshes' (the 95th percentile of the disks' sizes, in
/// spacings, is below RegularSpread medians), a disk of more than HoleFactor such percentiles
/// reaches over a hole; where they are random (IrregularSpread medians), over a gap to be closed. Where splats are to end, that
/// percentile of sizes over those next to them counts if it is less: it is 1.5 and more of random samplings alone.
/// A mesh whose cells are long in one place and square in another is regular too: sizes next to one
/// another have next to no spread (StretchedSpread).
constexpr float RegularSpread = 1.25f;
constexpr float IrregularSpread = 1.45f;
constexpr float StretchedSpread = 1.15f;
constexpr float HoleFactor = 1.3f;
constexpr float GapFactor = 3.0f;
/// Where sizes are as even as that, what disks leave uncovered that are made smaller since the surface bends
/// is no noise.
constexpr float EvenSpread = 1.05f;
/// Points that lie together in places, as the vertices of tetrahedra's isosurfaces do, have cells of up to a hundred of their own
/// spacings, which say nothing of gaps. In the largest spacings around that percentile is a third for them, and for points at
/// random less by this.
constexpr float AroundShare = 1.17f; // Testing/Cxx/TestSplatBorders.cxx
/// From how many times the cloud's usual spacing on, or its part, a part's own one counts.
constexpr float OtherSpacing = 1.5f;
/// Fewer slots than that are no part of their own.
constexpr Slot LeastOfPart = 1000;
/// Neighbours are of one part if neither is so many times as dense.
constexpr float AsDense = 2.0f;
/// Of fewer cells nothing is told.
constexpr std::size_t LeastKnown = 100;

/// The cells of a part.
struct Part
{
  const vtkPointSplatVoronoiCells& Cells;
  const std::vector<Slot>& Slots; // none of the whole cloud: it has all

  /// What get(slot) knows, which is more than 0.
  template <typename Getter>
  std::vector<float> GetKnown(const Getter& get) const
  {
    return this->Slots.empty()
      ? vtkPointSplatVoronoiCells::GetSamples(
          this->Cells.Opening.size(), [&](std::size_t s) { return get(static_cast<Slot>(s)); })
      : vtkPointSplatVoronoiCells::GetSamples(
          this->Slots.size(), [&](std::size_t i) { return get(this->Slots[i]); });
  }

  /// The 95th percentile, in medians, of the disks' sizes over those of their witnesses.
  float GetLocalSpread() const
  {
    std::vector<float> ratios = this->GetKnown([this](Slot s) {
      float sum = 0;
      int count = 0;
      this->Cells.VisitWitnesses(s, [&](Slot witness) {
        sum += this->Cells.Opening[witness];
        count += this->Cells.Opening[witness] > 0 ? 1 : 0;
      });
      return count > 0 ? count * this->Cells.Opening[s] / sum : 0.0f;
    });
    if (ratios.empty())
    {
      return std::numeric_limits<float>::max();
    }
    const float usual = vtkPointSplatVoronoiCells::GetQuantile(ratios, 0.5);
    return vtkPointSplatVoronoiCells::GetQuantile(ratios, 0.95) / usual;
  }

  /// otherwise: what it is like where that is not known.
  Sampling Measure(const Sampling& otherwise) const
  {
    std::vector<float> sizes = this->GetKnown([this](Slot s) {
      return this->Cells.Opening[s] > 0 ? this->Cells.Opening[s] / this->Cells.Spacing[s] : 0.0f;
    });
    if (sizes.size() < LeastKnown)
    {
      return otherwise;
    }
    const float usual = vtkPointSplatVoronoiCells::GetQuantile(sizes, 0.5);
    const float large = vtkPointSplatVoronoiCells::GetQuantile(sizes, 0.95);
    const auto factor = [](float spread) {
      const float t = (spread - RegularSpread) / (IrregularSpread - RegularSpread);
      return HoleFactor + std::clamp(t, 0.0f, 1.0f) * (GapFactor - HoleFactor);
    };
    Sampling found;
    const float spread = large / usual, local = this->GetLocalSpread();
    found.HoleLimit = large * factor(spread);
    found.Even = local < EvenSpread;
    found.Stretched = spread > RegularSpread && local < StretchedSpread;
    // Of meshes whose sizes differ from place to place points next to one another are as regular as of others.
    const float beside = found.Stretched ? spread : std::min(spread, local);
    found.BorderLimit = large * factor(beside);
    found.Regular = beside < IrregularSpread || found.Stretched;
    if (!found.Regular)
    {
      std::vector<float> around = this->GetKnown([this](Slot s) {
        return this->Cells.Opening[s] > 0 ? this->Cells.Opening[s] / this->Cells.GetSpacingAround(s) : 0.0f;
      });
      found.BorderLimit =
        std::min(found.BorderLimit, AroundShare * vtkPointSplatVoronoiCells::GetQuantile(around, 0.95) * factor(beside));
    }
    return found;
  }
};
}

void vtkPointSplatSamplings::Connect(
  const vtkPointSplatVoronoiCells& cells, const vtkPointSplatLargeArray<float>& spacings)
{
  const Slot slots = static_cast<Slot>(cells.Opening.size());
  vtkPointSplatDisjointSets groups(slots);
  std::vector<Slot> sizes(slots, 1); // of the groups, of what stands for them
  const auto join = [&](Slot a, Slot b) {
    if (a != b)
    {
      groups.Join(a, b);
      sizes[std::min(a, b)] += sizes[std::max(a, b)];
    }
  };
  for (Slot s = 0; s < slots; ++s)
  {
    cells.VisitWitnesses(s, [&](Slot witness) {
      const auto [least, most] = std::minmax(spacings[s], spacings[witness]);
      if (!groups.AreNear(s, witness) && most < AsDense * least)
      {
        join(groups.Find(s), groups.Find(witness));
      }
    });
  }
  // A few points that are denser than those beside them are no part.
  for (Slot s = 0; s < slots; ++s)
  {
    if (sizes[groups.Find(s)] < LeastOfPart)
    {
      cells.VisitWitnesses(s, [&](Slot witness) {
        const Slot a = groups.Find(s), b = groups.Find(witness);
        if (std::min(sizes[a], sizes[b]) < LeastOfPart)
        {
          join(a, b);
        }
      });
    }
  }
  const auto isConnected = [&](Slot s) { return sizes[groups.Find(s)] > 1; };
  Slot connected = 0, largest = 0;
  for (Slot s = 0; s < slots; ++s)
  {
    connected += isConnected(s) ? 1 : 0;
    largest = std::max(largest, sizes[groups.Find(s)]);
  }
  if (connected == largest || largest < LeastOfPart)
  {
    return; // it is one part alone
  }
  this->PartOf.assign(slots, 0);
  for (Slot s = 0; s < slots; ++s)
  {
    const Slot first = groups.Find(s);
    if (first == s && sizes[s] >= LeastOfPart)
    {
      this->PartOf[s] = static_cast<Slot>(this->Parts.size());
      this->Parts.emplace_back();
    }
    this->PartOf[s] = this->PartOf[first];
    if (isConnected(s))
    {
      this->Parts[this->PartOf[s]].push_back(s);
    }
  }
}

void vtkPointSplatSamplings::FindParts(
  const vtkPointSplatVoronoiCells& cells, const vtkPointSplatLargeArray<float>& spacings)
{
  this->Connect(cells, spacings);
  if (this->IsOne())
  {
    return;
  }
  const auto areAlike = [](float a, float b) { return std::max(a, b) < OtherSpacing * std::min(a, b); };
  const Sampling all = this->Found[0];
  this->Found.assign(this->Parts.size(), all);
  std::vector<float> usual(this->Parts.size(), all.Usual);
  const std::size_t first = this->Parts[0].empty() ? 1 : 0; // where there are no small ones
  for (std::size_t k = first; k < this->Parts.size(); ++k)
  {
    std::vector<float> known;
    for (const Slot s : this->Parts[k])
    {
      known.push_back(spacings[s]);
    }
    usual[k] = vtkPointSplatVoronoiCells::GetQuantile(known, 0.5);
    this->Found[k].Usual = areAlike(usual[k], all.Usual) ? all.Usual : usual[k];
    if (first == 0 && k > 0 && areAlike(usual[k], usual[0]))
    {
      this->Parts[0].insert(this->Parts[0].end(), this->Parts[k].begin(), this->Parts[k].end());
    }
  }
}

void vtkPointSplatSamplings::FindLimits(const vtkPointSplatVoronoiCells& cells)
{
  const std::vector<Slot> every;
  const Sampling all = Part{ cells, every }.Measure(Sampling());
  for (std::size_t k = 0; k < this->Parts.size(); ++k)
  {
    const float usual = this->Found[k].Usual;
    this->Found[k] = this->Parts[k].empty() ? all : Part{ cells, this->Parts[k] }.Measure(all);
    // Where cells are long in one place and not in another, that points are sparse is known no less than that they are dense.
    this->Found[k].Usual = this->Found[k].Stretched ? std::numeric_limits<float>::max() : usual;
  }
  this->Parts.clear();
}

VTK_ABI_NAMESPACE_END
