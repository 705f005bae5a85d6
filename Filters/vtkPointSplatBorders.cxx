// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatBorders.h"

#include "vtkAlgorithm.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkPointSplatBorderPlane.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
// Those that are fitted by hand are from Testing/Accuracy/fit_constants.py.
/// At a border these reach as far as half of them do elsewhere, past four spacings.
constexpr int NumberOfNeighbors = 32;
/// Of a random sampling: what is no gap of it is seen from farther.
constexpr int NumberAtRandom = 64;
/// Where so many nearest ones lie in a row, four times as many are looked at, which reach the next row
/// of points that are thirty times as dense along rows.
constexpr int NumberInRow = 16;
/// How far, in spacings, points of other sheets say that the surface goes on: less takes creases for
/// borders, more finds none where the other side of a body is near.
constexpr float VoidReach = 2.0f;
/// But those that face away are another sheet's, of a thin shell that ends with this one: around a
/// tube there are others between.
constexpr float AwayCosine = -0.9f;
/// How far into the sector they are (10 degrees).
constexpr double VoidMargin = 0.17;
/// How far, in alphas, a cell reaches that is surely no gap in the sampling, and how many of these a
/// border has at least.
constexpr float SureReach = 2.0f;
constexpr int LeastSure = 8;
/// Which of the spacings around is taken: a point's own one is larger at a border, where there are
/// points to one side alone, and the least of all makes holes of uneven samplings.
constexpr double SpacingQuantile = 0.75;
/// Where cells are long in one place and not in another, alpha in the reaches of the cells around.
constexpr float StretchedReach = 1.9f;
/// How far past the outermost of a random sampling's points its surface ends, in spacings.
constexpr float RandomMargin = 0.3f;
/// Lines of one direction are one (14 degrees).
constexpr float SameCosine = 0.97f;
/// Ends of one border agree on where it goes on by this mean: beside a narrow gap or strip they don't.
constexpr float LeastAgreed = 0.8f;
}

vtkPointSplatBorders::vtkPointSplatBorders(const vtkPointSplatNeighbors& neighbors,
  const float* normals, float usual, const vtkPointSplatDisks& disks)
  : Neighbors(neighbors)
  , Normals(normals)
  , Usual(usual)
  , Disks(disks)
  , Number(disks.Regular ? NumberOfNeighbors : NumberAtRandom)
{
}

bool vtkPointSplatBorders::FindEnd(
  const Neighborhood& around, const vtkPointSplatDisk& disk, End& end) const
{
  int next[2];
  std::vector<float> spacings, openings;
  for (int i = 0; i < around.Count; ++i)
  {
    const float spacing = this->Disks.Spacing[around.Slots[i]];
    if (spacing > 0)
    {
      spacings.push_back(spacing);
    }
    const float opening = this->Disks.Opening[around.Slots[i]];
    if (this->Disks.Stretched && opening > 0)
    {
      openings.push_back(opening);
    }
  }
  if (spacings.empty())
  {
    return false;
  }
  float alpha = this->Disks.HoleLimit * vtkPointSplatDisks::GetQuantile(spacings, SpacingQuantile);
  if (!openings.empty())
  {
    alpha = std::min(
      alpha, StretchedReach * vtkPointSplatDisks::GetQuantile(openings, SpacingQuantile));
  }
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
    const float* other = this->Normals + std::size_t(3) * around.Slots[i];
    const bool away = vtkMath::Dot(other, disk.Normal) < AwayCosine;
    if (!ofSheet[i] && !away && turn > VoidMargin && turn < sector - VoidMargin)
    {
      return false;
    }
  }
  end.At = around.Center;
  end.Gap = disk.Gap;
  // A line as far off as its unit, whose vector is its normal.
  plane.SetLine(from + 0.5 * sector, 1.0f, end.Out);
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

const vtkPointSplatBorders::End* vtkPointSplatBorders::FindAt(
  const std::vector<End>& ends, Slot slot)
{
  const auto at = std::lower_bound(
    ends.begin(), ends.end(), slot, [](const End& end, Slot s) { return end.At < s; });
  return at != ends.end() && at->At == slot ? &*at : nullptr;
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

void vtkPointSplatBorders::Take(vtkSMPThreadLocal<std::vector<End>>& found)
{
  this->Ends.clear();
  for (const std::vector<End>& local : found)
  {
    this->Ends.insert(this->Ends.end(), local.begin(), local.end());
  }
  this->Sort();
}

void vtkPointSplatBorders::Sort()
{
  std::sort(this->Ends.begin(), this->Ends.end(),
    [](const End& a, const End& b) { return a.At < b.At; });
}

bool vtkPointSplatBorders::Find(
  vtkAlgorithm* self, bool elliptical, const std::vector<unsigned char>& candidates)
{
  vtkSMPThreadLocal<std::vector<End>> found;
  auto find = [&](const Neighborhood& around, int round) {
    vtkPointSplatDisk disk;
    disk.Estimate(around, this->Normals, elliptical, this->Usual, this->Disks.HoleLimit);
    End end;
    const bool ends = this->FindEnd(around, disk, end);
    if (ends)
    {
      found.Local().push_back(end);
    }
    return ends || round > 0 || !disk.InRow(NumberInRow);
  };
  const double progress = self->GetProgress();
  if (!this->Neighbors.Visit(self, progress, progress, this->Number, find,
        [&](Slot s) { return candidates[s] != 0; }))
  {
    return false;
  }
  this->Take(found);
  this->Confirm();
  this->Rim = this->Ends;
  return true;
}

bool vtkPointSplatBorders::IsOutside(Slot slot, const float direction[3]) const
{
  const End* end = FindAt(this->Rim, slot);
  if (!end)
  {
    return false;
  }
  const vtkPointSplatBorderPlane plane(this->Normals + std::size_t(3) * slot);
  double x[3], angles[2];
  this->Neighbors.GetPosition(slot, x);
  for (int k = 0; k < 2; ++k)
  {
    double y[3];
    this->Neighbors.GetPosition(end->Next[k], y);
    const float way[3] = { static_cast<float>(y[0] - x[0]), static_cast<float>(y[1] - x[1]),
      static_cast<float>(y[2] - x[2]) };
    angles[k] = plane.GetAngle(way);
  }
  const double sector = vtkPointSplatBorderPlane::Turn(angles[0], angles[1]);
  return vtkPointSplatBorderPlane::Turn(angles[0], plane.GetAngle(direction)) < sector;
}

bool vtkPointSplatBorders::Cut(
  const Neighborhood& around, const vtkPointSplatDisks& disks, End& cut) const
{
  const float reach = KernelReach * disks.Length[around.Center];
  const float* n = this->Normals + std::size_t(3) * around.Center;
  struct Near
  {
    float X[3];
    const End* Of;
  };
  std::vector<Near> ends;
  if (const End* own = this->GetEnd(around.Center))
  {
    ends.push_back({ { 0, 0, 0 }, own });
  }
  const float spacing = this->Disks.Spacing[around.Center];
  const float farthest = 2 * reach + spacing;
  for (int i = 0; i < around.Count && around.SquaredDistance[i] < farthest * farthest; ++i)
  {
    if (const End* end = this->GetEnd(around.Slots[i]))
    {
      ends.push_back({ { around.X[i], around.Y[i], around.Z[i] }, end });
    }
  }
  float out[3] = { 0, 0, 0 };
  for (const Near& end : ends)
  {
    for (int c = 0; c < 3; ++c)
    {
      out[c] += end.Of->Out[c] / static_cast<float>(ends.size());
    }
  }
  if (!(vtkMath::Norm(out) > LeastAgreed))
  {
    return false;
  }
  const float along = vtkMath::Dot(out, n);
  for (int c = 0; c < 3; ++c)
  {
    out[c] -= along * n[c];
  }
  if (!(vtkMath::Normalize(out) > 0))
  {
    return false;
  }
  float side[3];
  vtkMath::Cross(n, out, side);
  float distance = 0;
  for (const Near& end : ends)
  {
    if (std::abs(vtkMath::Dot(end.X, side)) <= reach)
    {
      distance = std::max(distance, vtkMath::Dot(end.X, out));
    }
  }
  distance += RandomMargin * spacing;
  if (!(distance < reach))
  {
    return false;
  }
  cut = End();
  cut.At = around.Center;
  for (int c = 0; c < 3; ++c)
  {
    cut.Clip[c] = out[c] / distance;
  }
  return true;
}

float vtkPointSplatBorders::GetReach(Slot slot) const
{
  return KernelReach * std::max(this->Disks.Length[slot], this->Disks.Gap[slot]);
}

void vtkPointSplatBorders::Lines::Write(float clip[6]) const
{
  std::fill_n(clip, 6, 0.0f);
  for (int c = 0; c < 3 * this->Count; ++c)
  {
    clip[c] = this->Out[c / 3][c % 3] / this->Distance[c / 3];
  }
}

/// Lines are as far from a point as their vectors are short.
bool vtkPointSplatBorders::AddLine(
  const float line[3], const float place[3], const float n[3], Lines& lines)
{
  float out[3];
  const float along = vtkMath::Dot(line, n);
  for (int c = 0; c < 3; ++c)
  {
    out[c] = line[c] - along * n[c];
  }
  const float length = vtkMath::Norm(line);
  if (!(vtkMath::Normalize(out) > 0))
  {
    return false; // there is none
  }
  const float distance = vtkMath::Dot(place, out) + 1 / length;
  const bool same = lines.Count > 0 && vtkMath::Dot(lines.Out[0], out) > SameCosine;
  if (!(distance > 0) || distance >= lines.Reach || same || lines.Count == 2)
  {
    return false;
  }
  std::copy_n(out, 3, lines.Out[lines.Count]);
  lines.Distance[lines.Count++] = distance;
  return true;
}

bool vtkPointSplatBorders::ClipAsNearest(const Neighborhood& around, End& clip) const
{
  const float* n = this->Normals + std::size_t(3) * around.Center;
  Lines lines;
  lines.Reach = this->GetReach(around.Center);
  const End* own = this->GetEnd(around.Center);
  clip = own ? *own : End();
  clip.At = around.Center;
  const float here[3] = { 0, 0, 0 };
  for (int k = 0; own && k < 2; ++k)
  {
    AddLine(own->Clip + 3 * k, here, n, lines);
  }
  bool more = false;
  for (int i = 0;
       i < around.Count && around.SquaredDistance[i] < lines.Reach * lines.Reach && lines.Count < 2;
       ++i)
  {
    const End* end = this->GetEnd(around.Slots[i]);
    const float place[3] = { around.X[i], around.Y[i], around.Z[i] };
    for (int k = 0; end && k < 2; ++k)
    {
      more = AddLine(end->Clip + 3 * k, place, n, lines) || more;
    }
  }
  lines.Write(clip.Clip);
  return more;
}

bool vtkPointSplatBorders::FindNear(
  vtkAlgorithm* self, std::vector<std::atomic<bool>>& near) const
{
  auto mark = [&](const Neighborhood& around, int) {
    near[around.Center].store(true, std::memory_order_relaxed);
    bool farthest = false;
    for (int i = 0; i < around.Count; ++i)
    {
      const Slot s = around.Slots[i];
      const float reach = this->GetReach(s);
      farthest = around.SquaredDistance[i] < reach * reach;
      if (farthest)
      {
        near[s].store(true, std::memory_order_relaxed);
      }
    }
    // Where the farthest reaches the border, more do.
    return !farthest;
  };
  const double progress = self->GetProgress();
  return this->Neighbors.Visit(self, progress, progress, NumberOfNeighbors, mark,
    [this](Slot s) { return this->GetEnd(s) != nullptr; });
}

bool vtkPointSplatBorders::ClipBeside(vtkAlgorithm* self)
{
  std::vector<std::atomic<bool>> near(this->Disks.Length.size());
  vtkSMPThreadLocal<std::vector<End>> found;
  auto clip = [&](const Neighborhood& around, int) {
    End end;
    const bool clips = this->ClipAsNearest(around, end);
    if (clips)
    {
      found.Local().push_back(end);
    }
    return clips || this->GetEnd(around.Center);
  };
  const double progress = self->GetProgress();
  if (!this->FindNear(self, near) ||
    !this->Neighbors.Visit(self, progress, progress, NumberOfNeighbors, clip,
      [&near](Slot s) { return near[s].load(std::memory_order_relaxed); }))
  {
    return false;
  }
  std::vector<End> ends;
  ends.swap(this->Ends);
  this->Take(found);
  const std::vector<End> clipped = this->Ends;
  std::copy_if(ends.begin(), ends.end(), std::back_inserter(this->Ends), [&clipped](const End& end) {
    return !std::binary_search(clipped.begin(), clipped.end(), end,
      [](const End& a, const End& b) { return a.At < b.At; });
  });
  this->Sort();
  return true;
}

bool vtkPointSplatBorders::Straighten(vtkAlgorithm* self, const vtkPointSplatDisks& disks)
{
  std::vector<std::atomic<bool>> near(this->Disks.Spacing.size());
  vtkSMPThreadLocal<std::vector<End>> found;
  auto cut = [&](const Neighborhood& around, int) {
    End end;
    if (!disks.IsAlone(around.Center) && this->Cut(around, disks, end))
    {
      found.Local().push_back(end);
    }
    return true;
  };
  const double progress = self->GetProgress();
  if (!this->FindNear(self, near) ||
    !this->Neighbors.Visit(self, progress, progress, NumberOfNeighbors, cut,
      [&near](Slot s) { return near[s].load(std::memory_order_relaxed); }))
  {
    return false;
  }
  this->Take(found);
  return true;
}

void vtkPointSplatBorders::Reopen(const std::vector<Slot>& slots)
{
  this->Ends.erase(std::remove_if(this->Ends.begin(), this->Ends.end(),
                     [&slots](const End& end) {
                       return std::binary_search(slots.begin(), slots.end(), end.At);
                     }),
    this->Ends.end());
}

bool vtkPointSplatBorders::Finish(vtkAlgorithm* self, vtkPointSplatDisks& disks)
{
  if (this->Ends.empty())
  {
    return true;
  }
  if (!disks.Regular)
  {
    return this->Straighten(self, disks);
  }
  for (const End& end : this->Ends)
  {
    disks.Gap[end.At] = std::max(disks.Gap[end.At], end.Gap);
  }
  return this->ClipBeside(self);
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
