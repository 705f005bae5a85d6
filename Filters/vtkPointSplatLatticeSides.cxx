// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatLatticeSides.h"

#include "vtkPointSplatThreads.h"
#include "vtkSMPTools.h"
#include "vtkType.h"

#include <algorithm>
#include <atomic>
#include <numeric>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// Parts that are linked, and whether they have to be turned to agree.
class Links
{
public:
  explicit Links(std::size_t count)
    : First(count)
    , Against(count, 0)
  {
    std::iota(this->First.begin(), this->First.end(), std::size_t(0));
  }

  /// The part that stands for all that are linked to one; against: whether the two contradict one another.
  std::size_t Find(std::size_t part, bool& against)
  {
    against = false;
    std::size_t first = part;
    for (; this->First[first] != first; first = this->First[first])
    {
      against = against != (this->Against[first] != 0);
    }
    // All on the way are linked to it, so that the next way is short.
    for (bool left = against; this->First[part] != first && part != first;)
    {
      const std::size_t next = this->First[part];
      const bool own = this->Against[part] != 0;
      this->First[part] = first;
      this->Against[part] = left;
      left = left != own;
      part = next;
    }
    return first;
  }

  void Add(std::size_t a, std::size_t b, bool contradict)
  {
    bool againstA, againstB;
    const std::size_t firstA = this->Find(a, againstA), firstB = this->Find(b, againstB);
    if (firstA != firstB)
    {
      const auto [first, second] = std::minmax(firstA, firstB);
      this->First[second] = first;
      this->Against[second] = contradict != (againstA != againstB);
    }
  }

private:
  std::vector<std::size_t> First;
  std::vector<unsigned char> Against;
};
}

/// Calls visit(a, b, contradict) for parts from begin to end and those of the next voxels that they share samples with.
template <typename Visitor>
void vtkPointSplatLatticeSides::VisitShared(
  const std::vector<Part>& parts, const std::int64_t strides[3], std::size_t begin, std::size_t end, const Visitor& visit)
{
  constexpr unsigned int beyond[3] = { 0xaa, 0xcc, 0xf0 }; // corners that are further along each axis
  for (int axis = 0; axis < 3; ++axis)
  {
    const int bit = 1 << axis;
    std::size_t next = begin;
    for (std::size_t i = begin; i < end; ++i)
    {
      const std::int64_t voxel = parts[i].Voxel + strides[axis];
      next = i == begin ? Find(parts, voxel).First - parts.data() : next;
      while (next < parts.size() && parts[next].Voxel < voxel)
      {
        ++next;
      }
      for (std::size_t j = next; j < parts.size() && parts[j].Voxel == voxel; ++j)
      {
        const unsigned int shared = ((parts[i].Corners & beyond[axis]) >> bit) & parts[j].Corners;
        if (shared != 0)
        {
          visit(i, j, ((((parts[i].Inside & beyond[axis]) >> bit) ^ parts[j].Inside) & shared) != 0);
        }
      }
    }
  }
}

void vtkPointSplatLatticeSides::Settle(std::vector<Part>& parts, const std::int64_t strides[3])
{
  vtkSMPTools::Sort(parts.begin(), parts.end());
  std::atomic<bool> agree{ true };
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(parts.size()), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      if (parts[i].Agreement < 0)
      {
        parts[i].Turn();
      }
    }
  });
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(parts.size()), [&](vtkIdType begin, vtkIdType end) {
    bool here = true;
    VisitShared(parts, strides, begin, end, [&](std::size_t, std::size_t, bool contradict) { here = here && !contradict; });
    if (!here)
    {
      agree = false;
    }
  });
  if (agree)
  {
    return;
  }
  Links links(parts.size());
  // Where the surface was cut off sides may be those of what is not there: such links contradict what others agree on.
  std::vector<std::pair<std::size_t, std::size_t>> contradicting;
  VisitShared(parts, strides, 0, parts.size(), [&](std::size_t a, std::size_t b, bool contradict) {
    if (contradict)
    {
      contradicting.emplace_back(a, b);
    }
    else
    {
      links.Add(a, b, false);
    }
  });
  for (const auto& [a, b] : contradicting)
  {
    links.Add(a, b, true);
  }
  std::vector<double> votes(parts.size(), 0.0); // of those that stand for others
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    bool against;
    const std::size_t first = links.Find(i, against);
    votes[first] += against ? -parts[i].Agreement : parts[i].Agreement;
  }
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    bool against;
    const std::size_t first = links.Find(i, against);
    if (against != (votes[first] < 0))
    {
      parts[i].Turn();
    }
  }
}

vtkPointSplatLatticeSides::Range vtkPointSplatLatticeSides::Find(const std::vector<Part>& parts, std::int64_t voxel)
{
  const Part* last = parts.data() + parts.size();
  const Part* first = std::lower_bound(
    parts.data(), last, voxel, [](const Part& part, std::int64_t at) { return part.Voxel < at; });
  return { first, std::find_if(first, last, [voxel](const Part& part) { return part.Voxel != voxel; }) };
}

VTK_ABI_NAMESPACE_END
