// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatBorders.h"

#include "vtkAlgorithm.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkPointSplatBorderPlane.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
// Those that are fitted by hand are from Testing/Accuracy/fit_constants.py.
/// At a border these reach as far as half of them do elsewhere: past five spacings, and to the next
/// row of points that are twenty times as dense along rows.
constexpr int NumberOfNeighbors = 64;
/// How far, in spacings, points of other sheets say that the surface goes on: less takes creases for
/// borders, more finds none where the other side of a body is near.
constexpr float VoidReach = 2.0f;
/// How far into the sector they are (10 degrees).
constexpr double VoidMargin = 0.17;
/// How far, in alphas, a cell reaches that is surely no gap in the sampling, and how many of these a
/// border has at least.
constexpr float SureReach = 2.0f;
constexpr int LeastSure = 8;
/// Which of the spacings around is taken: a point's own one is larger at a border, where there are
/// points to one side alone, and the least of all makes holes of uneven samplings.
constexpr double SpacingQuantile = 0.75;
}

vtkPointSplatBorders::vtkPointSplatBorders(const vtkPointSplatNeighbors& neighbors,
  const float* normals, float usual, const vtkPointSplatDisks& disks)
  : Neighbors(neighbors)
  , Normals(normals)
  , Usual(usual)
  , HoleLimit(disks.HoleLimit)
  , Spacings(disks.Spacing)
{
}

bool vtkPointSplatBorders::FindEnd(
  const Neighborhood& around, bool elliptical, End& end) const
{
  vtkPointSplatDisk disk;
  disk.Estimate(around, this->Normals, elliptical, this->Usual, this->HoleLimit);
  int next[2];
  std::vector<float> spacings;
  for (int i = 0; i < around.Count; ++i)
  {
    const float spacing = this->Spacings[around.Slots[i]];
    if (spacing > 0)
    {
      spacings.push_back(spacing);
    }
  }
  if (spacings.empty())
  {
    return false;
  }
  const float alpha = this->HoleLimit * vtkPointSplatDisks::GetQuantile(spacings, SpacingQuantile);
  const float reach = disk.FindBorder(alpha, next);
  if (!(reach > 0))
  {
    return false;
  }
  const vtkPointSplatBorderPlane plane(disk.Normal);
  const auto getAngle = [&](int i) {
    const float x[3] = { around.X[i], around.Y[i], around.Z[i] };
    return plane.GetAngle(x);
  };
  const double from = getAngle(next[0]);
  const double sector = vtkPointSplatBorderPlane::Turn(from, getAngle(next[1]));
  std::vector<unsigned char> ofSheet(around.Count, 0);
  for (int k = 0; k < disk.Sheet.Count; ++k)
  {
    ofSheet[disk.Sheet.Members[k]] = 1;
  }
  const float spacing = disk.Sheet.Spacing;
  for (int i = 0; i < around.Count &&
       around.SquaredDistance[i] <= VoidReach * VoidReach * spacing * spacing;
       ++i)
  {
    const double turn = vtkPointSplatBorderPlane::Turn(from, getAngle(i));
    if (!ofSheet[i] && turn > VoidMargin && turn < sector - VoidMargin)
    {
      return false;
    }
  }
  end.At = around.Center;
  end.Gap = disk.Gap;
  end.Sure = reach > SureReach * alpha;
  for (int k = 0; k < 2; ++k)
  {
    end.Next[k] = around.Slots[next[k]];
  }
  const float nearest =
    std::min(around.SquaredDistance[next[0]], around.SquaredDistance[next[1]]);
  plane.SetLines(from, sector, spacing, std::sqrt(nearest), end.Clip);
  return true;
}

const vtkPointSplatBorders::End* vtkPointSplatBorders::GetEnd(Slot slot) const
{
  const auto at = std::lower_bound(this->Ends.begin(), this->Ends.end(), slot,
    [](const End& end, Slot s) { return end.At < s; });
  return at != this->Ends.end() && at->At == slot ? &*at : nullptr;
}

/// Leaves the chains that are borders.
void vtkPointSplatBorders::Confirm()
{
  // Of each, the first of its chain as far as it is known; that one counts those that are sure.
  std::vector<std::size_t> first(this->Ends.size());
  std::vector<int> sure(this->Ends.size());
  std::iota(first.begin(), first.end(), std::size_t(0));
  std::transform(this->Ends.begin(), this->Ends.end(), sure.begin(),
    [](const End& end) { return end.Sure ? 1 : 0; });
  const auto find = [&first](std::size_t i) {
    while (first[i] != i)
    {
      i = first[i] = first[first[i]];
    }
    return i;
  };
  // Of each slot the ends that have to do with it.
  std::vector<std::pair<Slot, std::size_t>> links;
  for (std::size_t i = 0; i < this->Ends.size(); ++i)
  {
    const End& end = this->Ends[i];
    for (const Slot slot : { end.At, end.Next[0], end.Next[1] })
    {
      links.emplace_back(slot, i);
    }
  }
  std::sort(links.begin(), links.end());
  for (std::size_t k = 1; k < links.size(); ++k)
  {
    const std::size_t a = find(links[k - 1].second), b = find(links[k].second);
    if (links[k - 1].first == links[k].first && a != b)
    {
      first[b] = a;
      sure[a] += sure[b];
    }
  }
  std::vector<End> confirmed;
  for (std::size_t i = 0; i < this->Ends.size(); ++i)
  {
    if (sure[find(i)] >= LeastSure)
    {
      confirmed.push_back(this->Ends[i]);
    }
  }
  this->Ends.swap(confirmed);
}

bool vtkPointSplatBorders::Find(
  vtkAlgorithm* self, bool elliptical, const std::vector<unsigned char>& candidates)
{
  vtkSMPThreadLocal<std::vector<End>> found;
  auto find = [&](const Neighborhood& around, int) {
    End end;
    if (this->FindEnd(around, elliptical, end))
    {
      found.Local().push_back(end);
    }
    return true;
  };
  const double progress = self->GetProgress();
  if (!this->Neighbors.Visit(self, progress, progress, NumberOfNeighbors, find,
        [&](Slot s) { return candidates[s] != 0; }))
  {
    return false;
  }
  this->Ends.clear();
  for (const std::vector<End>& local : found)
  {
    this->Ends.insert(this->Ends.end(), local.begin(), local.end());
  }
  std::sort(this->Ends.begin(), this->Ends.end(),
    [](const End& a, const End& b) { return a.At < b.At; });
  this->Confirm();
  return true;
}

void vtkPointSplatBorders::Widen(vtkPointSplatDisks& disks) const
{
  for (const End& end : this->Ends)
  {
    disks.Gap[end.At] = std::max(disks.Gap[end.At], end.Gap);
  }
}

void vtkPointSplatBorders::MakeLines(vtkFloatArray* clips, vtkIdType count)
{
  if (clips->GetNumberOfTuples() == 0)
  {
    clips->SetNumberOfComponents(6);
    clips->SetNumberOfTuples(count);
    clips->FillValue(0);
  }
}

void vtkPointSplatBorders::Write(
  const std::vector<Slot>& slotOf, vtkFloatArray* clips) const
{
  const vtkIdType count = static_cast<vtkIdType>(slotOf.size());
  if (this->Ends.empty())
  {
    return;
  }
  vtkPointSplatBorders::MakeLines(clips, count);
  float* values = clips->GetPointer(0);
  vtkSMPTools::For(0, count, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType id = begin; id < end; ++id)
    {
      const Slot s = slotOf[id];
      const End* at = s == vtkPointSplatNeighbors::None ? nullptr : this->GetEnd(s);
      const bool free = std::all_of(
        values + 6 * id, values + 6 * id + 6, [](float v) { return v == 0; });
      if (at && free)
      {
        std::copy_n(at->Clip, 6, values + 6 * id);
      }
    }
  });
}

VTK_ABI_NAMESPACE_END
