// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatBorders.h"

#include "vtkAlgorithm.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkPointSplatBorderPlane.h"
#include "vtkPointSplatDisjointSets.h"
#include "vtkPointSplatThreads.h"
#include "vtkSMPThreadLocal.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
// Those that are fitted by hand are from Testing/Accuracy/fit_constants.py.
/// Of a random sampling, or where gaps are as wide: what is no gap is seen from farther.
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
/// But where cells are long in one place and not in another alpha is no more than this, in spacings: NumberAtRandom
/// neighbours are not farther off.
constexpr float LargestAlpha = 5.0f;
/// How far, in alphas, a cell reaches that is surely no gap in the sampling, of a random and of a regular one,
/// and how many of these a border has at least.
constexpr float SureReach = 2.0f;
constexpr float RegularReach = 1.5f;
constexpr int LeastSure = 8;
/// What is as far as the farthest vertex, but for rounding.
constexpr float FarthestShare = 0.999f;
/// Which of the spacings around is taken: a point's own one is larger at a border, where there are
/// points to one side alone, and the least of all makes holes of uneven samplings.
constexpr double SpacingQuantile = 0.75;
/// Where cells are long in one place and not in another, alpha in the reaches of the cells around: of the median, since
/// a third of these cells may be beside the same hole.
constexpr float StretchedReach = 1.9f; // Testing/Cxx/TestSplatBorders.cxx
constexpr double ReachQuantile = 0.5;
/// Lines of one direction are one (14 degrees).
constexpr float SameCosine = 0.97f;
}

vtkPointSplatBorders::vtkPointSplatBorders(const vtkPointSplatNeighbors& neighbors,
  const float* normals, const vtkPointSplatDisks& disks)
  : Neighbors(neighbors)
  , Normals(normals)
  , Disks(disks)
{
}

vtkPointSplatBorders::Gaps::Gaps(const vtkPointSplatSamplings::Sampling& sampling)
  : Alpha(sampling.Stretched ? sampling.BorderLimit : std::min(sampling.BorderLimit, LargestAlpha))
  // What is no wider than gaps that are closed is one of these.
  , LeastReach(sampling.Regular
        ? std::max(RegularReach, std::min(sampling.HoleLimit, LargestAlpha) / this->Alpha)
        : SureReach)
  , Wide(!sampling.Regular || (!sampling.Stretched && this->LeastReach * this->Alpha > LargestAlpha))
{
}

float vtkPointSplatBorders::GetWidestGap(Slot slot) const
{
  const Gaps gaps = this->GetGaps(slot);
  return this->Disks.GetSampling(slot).Regular ? gaps.LeastReach * gaps.Alpha : 0.0f;
}

float vtkPointSplatBorders::GetAlpha(const Neighborhood& around, float limit) const
{
  const bool stretched = this->Disks.GetSampling(around.Center).Stretched;
  std::vector<float> spacings, openings;
  for (int i = 0; i < around.Count; ++i)
  {
    const float spacing = this->Disks.Spacing[around.Slots[i]];
    if (spacing > 0)
    {
      spacings.push_back(spacing);
    }
    const float opening = this->Disks.Opening[around.Slots[i]];
    if (stretched && opening > 0)
    {
      openings.push_back(opening);
    }
  }
  if (spacings.empty())
  {
    return 0;
  }
  const float alpha = limit * vtkPointSplatVoronoiCells::GetQuantile(spacings, SpacingQuantile);
  return openings.empty()
    ? alpha
    : std::min(
        alpha, StretchedReach * vtkPointSplatVoronoiCells::GetQuantile(openings, ReachQuantile));
}

bool vtkPointSplatBorders::FindEnd(
  const Neighborhood& around, const vtkPointSplatDisk& disk, End& end) const
{
  int next[2];
  const vtkPointSplatSamplings::Sampling& sampling = this->Disks.GetSampling(around.Center);
  const Gaps gaps(sampling);
  const float alpha = this->GetAlpha(around, gaps.Alpha);
  if (!(alpha > 0))
  {
    return false;
  }
  float reach = disk.FindBorder(alpha, next);
  const bool bay = !(reach > 0) && !sampling.Regular;
  if (bay)
  {
    reach = disk.FindBorder(this->GetAlpha(around, vtkPointSplatDisks::BayLimit), next);
  }
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
    const float x[3] = { around.X[i], around.Y[i], around.Z[i] };
    const float* other = this->Normals + std::size_t(3) * around.Slots[i];
    const bool away = vtkMath::Dot(other, disk.Normal) < AwayCosine;
    if (!ofSheet[i] && !away && plane.IsInSector(x, from, sector, VoidMargin))
    {
      return false;
    }
  }
  end.At = around.Center;
  end.Gap = disk.Gap;
  // A line as far off as its unit, whose vector is its normal.
  plane.SetLine(from + 0.5 * sector, 1.0f, end.Out);
  float least = alpha;
  disk.VisitTriangles([&](int a, int b, float circumscribed) {
    // Where cells are long in one place and not in another a spacing does not tell how far they reach.
    if (circumscribed >= FarthestShare * reach && !sampling.Stretched)
    {
      const float inside = std::max(this->Disks.GetSpacingInside(around.Slots[a]),
        this->Disks.GetSpacingInside(around.Slots[b]));
      least = std::max(least, gaps.Alpha * inside);
    }
  });
  // Where points are at random, how far an open cell reaches is not known of so few neighbours.
  const bool open = !sampling.Regular && disk.Opening == 0;
  end.Sure = !bay && !open && reach > gaps.LeastReach * least;
  end.Bay = bay;
  for (int k = 0; k < 2; ++k)
  {
    end.Next[k] = around.Slots[next[k]];
  }
  const float nearest =
    std::min(around.SquaredDistance[next[0]], around.SquaredDistance[next[1]]);
  plane.SetLines(from, sector, vtkPointSplatBorderPlane::LeastDistance * spacing, std::sqrt(nearest), end.Clip);
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
  vtkPointSplatDisjointSets chains(this->Ends.size());
  // Of each slot the ends that have to do with it.
  std::vector<std::pair<Slot, Slot>> links;
  for (Slot i = 0; i < this->Ends.size(); ++i)
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
    if (links[k - 1].first == links[k].first)
    {
      chains.Join(chains.Find(links[k - 1].second), chains.Find(links[k].second));
    }
  }
  std::vector<int> sure(this->Ends.size(), 0); // of the chains, of what stands for them
  for (Slot i = 0; i < this->Ends.size(); ++i)
  {
    sure[chains.Find(i)] += this->Ends[i].Sure ? 1 : 0;
  }
  std::vector<End> confirmed;
  for (Slot i = 0; i < this->Ends.size(); ++i)
  {
    if (sure[chains.Find(i)] >= LeastSure)
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
    std::vector<End>& ends = found.Local();
    // Of those of a leaf, whose rounds follow one another.
    const auto last = ends.rbegin() + std::min<std::ptrdiff_t>(ends.size(), vtkPointSplatNeighbors::LeafSize);
    const auto unsure = std::find_if(
      ends.rbegin(), last, [&around](const End& end) { return end.At == around.Center; });
    if (round > 0 && unsure != last)
    {
      unsure->Sure = round > 1 && this->IsVoid(around, *unsure);
      return round > 1;
    }
    vtkPointSplatDisk disk;
    const bool closed = disk.Estimate(around, this->Normals, elliptical, this->Disks.GetUsualOfPart(around.Center),
      this->Disks.GetSampling(around.Center).BorderLimit);
    // A cell that more neighbours closed: these are denser, and to one side.
    if (round == 0 && !closed && this->Disks.Opening[around.Center] > 0)
    {
      return false;
    }
    End end;
    if (this->FindEnd(around, disk, end))
    {
      ends.push_back(end);
      // What is a gap may be wider than these neighbours are far.
      return end.Sure || end.Bay || !this->GetGaps(around.Center).Wide;
    }
    return round > 0 || !disk.InRow(NumberInRow);
  };
  const double progress = self->GetProgress();
  for (const bool bays : { false, true })
  {
    for (const bool wide : { false, true })
    {
      const auto isWanted = [&](Slot s) {
        return candidates[s] && this->GetGaps(s).Wide == wide &&
          (bays ? this->Disks.MayBeBay(s) : this->Disks.MayEnd(s));
      };
      if (!this->Neighbors.Visit(
            self, progress, progress, wide ? NumberAtRandom : NumberOfNeighbors, find, isWanted))
      {
        return false;
      }
    }
    this->Take(found);
    this->Confirm();
    if (this->Ends.empty())
    {
      break;
    }
  }
  this->Rim = this->Ends;
  return true;
}

double vtkPointSplatBorders::GetSector(
  const vtkPointSplatBorderPlane& plane, const End& end, double& from) const
{
  double x[3], angles[2];
  this->Neighbors.GetPosition(end.At, x);
  for (int k = 0; k < 2; ++k)
  {
    double y[3];
    this->Neighbors.GetPosition(end.Next[k], y);
    const float way[3] = { static_cast<float>(y[0] - x[0]), static_cast<float>(y[1] - x[1]),
      static_cast<float>(y[2] - x[2]) };
    angles[k] = plane.GetAngle(way);
  }
  from = angles[0];
  return vtkPointSplatBorderPlane::Turn(angles[0], angles[1]);
}

bool vtkPointSplatBorders::IsOutside(Slot slot, const float direction[3]) const
{
  const End* end = FindAt(this->Rim, slot);
  if (!end)
  {
    return false;
  }
  const vtkPointSplatBorderPlane plane(this->Normals + std::size_t(3) * slot);
  double from;
  const double sector = this->GetSector(plane, *end, from);
  return plane.IsInSector(direction, from, sector, 0.0);
}

bool vtkPointSplatBorders::IsVoid(const Neighborhood& around, const End& end) const
{
  const Gaps gaps = this->GetGaps(around.Center);
  const float far = gaps.LeastReach * this->GetAlpha(around, gaps.Alpha);
  if (around.Count == 0 || !(around.SquaredDistance[around.Count - 1] >= far * far))
  {
    return false;
  }
  const float* n = this->Normals + std::size_t(3) * end.At;
  vtkPointSplatSheet sheet;
  sheet.Compare(around, this->Normals, n);
  const vtkPointSplatBorderPlane plane(n);
  double from;
  const double sector = this->GetSector(plane, end, from);
  for (int i = 0; i < around.Count; ++i)
  {
    const float x[3] = { around.X[i], around.Y[i], around.Z[i] };
    if (sheet.IsAcross(around, i) && plane.IsInSector(x, from, sector, VoidMargin))
    {
      return false;
    }
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
  const auto random = std::stable_partition(this->Ends.begin(), this->Ends.end(),
    [this](const End& end) { return this->Disks.GetSampling(end.At).Regular; });
  std::vector<End> others(random, this->Ends.end());
  this->Ends.erase(random, this->Ends.end());
  for (const End& end : this->Ends)
  {
    disks.Gap[end.At] = std::max(disks.Gap[end.At], end.Gap);
  }
  if (!this->Ends.empty() && !this->ClipBeside(self))
  {
    return false;
  }
  this->Ends.swap(others);
  if (!this->Ends.empty() && !this->Straighten(self))
  {
    return false;
  }
  this->Ends.insert(this->Ends.end(), others.begin(), others.end());
  this->Sort();
  return true;
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
  vtkPointSplatThreads::For(0, count, [&](vtkIdType begin, vtkIdType end) {
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
