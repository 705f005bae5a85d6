// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatCreases.h"

#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkPointSplatMirrored.h"
#include "vtkPointSplatThreads.h"
#include "vtkSMPThreadLocal.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <tuple>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
using Slot = vtkPointSplatNeighbors::Slot;
using Neighborhood = vtkPointSplatNeighbors::Neighborhood;

/// How far, in neighbourhoods, a crease goes on from where it is sure (Testing/Accuracy/fit_constants.py).
constexpr int MostSpread = 8;
/// How many points with lines a point with lines must be among these neighbours of, or have among
/// its own: of the dozen or more of them that a strip along a crease has ...
constexpr int LeastCompany = 10;
/// ... and how many it must have, or one from which the crease goes on to it. A fold of a scan that is sharp
/// over a few points has at most 15: too short to gain from, where each line makes all frames
/// dearer. Both are from Testing/Accuracy/fit_constants.py.
constexpr int LeastSureCompany = 16;
/// Of points of two faces at one position, as where somebody cut a mesh at its edges, so many; and so many neighbours are
/// such, too, the next ones along that edge.
constexpr int LeastSplitCompany = 4;
constexpr int NextAlongSplit = 2;
/// How far splats reach, of their disks' radius: the kernels' rim, and what joins a layer
/// (vtkPointSplatMapper.h: SplatClip).
constexpr float SplatReach = 2.5f;
/// The cosine (20 degrees) between a line and the direction of the face behind it.
constexpr float AcrossCosine = 0.94f;
/// The next row's points are off the plane by no more than this part of their distance, ...
constexpr float NextRowSlope = 0.17f;
/// ... and their directions' cosine to the row is no more than this (45 degrees).
constexpr float AlongRow = 0.7f;
/// How far neighbours must reach, of that row's distance, to have enough of it.
constexpr float NextRowReach = 1.4f;

/// Whether a splat ends at two lines, one on either side of it.
bool IsStrip(const vtkPointSplatCreases::Splat& splat)
{
  return vtkMath::Dot(splat.Clip, splat.Clip + 3) < 0;
}

/// The distance of the nearest neighbour on the face with the normal n that is not along a row (0: wherever it is);
/// 0 if there is none.
float GetNextRow(
  const Neighborhood& around, const float* normals, const float n[3], const float along[3])
{
  for (int i = 0; i < around.Count; ++i)
  {
    const float x[3] = { around.X[i], around.Y[i], around.Z[i] };
    const float* m = normals + std::size_t(3) * around.Slots[i];
    const float height = vtkMath::Dot(n, x), part = vtkMath::Dot(along, x);
    const float squared = around.SquaredDistance[i];
    if (std::abs(vtkMath::Dot(n, m)) > vtkPointSplatCreases::OwnCosine &&
      height * height < NextRowSlope * NextRowSlope * squared && part * part < AlongRow * AlongRow * squared)
    {
      return std::sqrt(squared);
    }
  }
  return 0;
}
}

vtkPointSplatCreases::vtkPointSplatCreases(const vtkPointSplatNeighbors& neighbors, const float* normals,
  const float* tensors, const float* spacings, bool elliptical)
  : Neighbors(neighbors)
  , Elliptical(elliptical)
{
  this->Faces.Normals = normals;
  this->Faces.Tensors = tensors;
  this->Faces.Spacings = spacings;
}

bool vtkPointSplatCreases::HasFold(const Splat& splat)
{
  return std::any_of(splat.Fold, splat.Fold + 6, [](float v) { return v != 0; });
}

bool vtkPointSplatCreases::HasLine(const Splat& splat)
{
  return std::any_of(splat.Clip, splat.Clip + 6, [](float v) { return v != 0; });
}

/// Fits the nearest of the faces whose average a row's normal is, or the next one where that has no points of its own.
bool vtkPointSplatCreases::FitMeeting(const Neighborhood& around, const Row& row,
  const vtkPointSplatCrease& crease, vtkPointSplatFace& face, float plane[3]) const
{
  const float* n = row.Normal;
  const float spacing = face.Members.Spacing;
  const float(*normals)[3] = crease.Meeting;
  int order[vtkPointSplatCrease::MaximumNumberOfMeeting];
  std::iota(order, order + crease.NumberOfMeeting, 0);
  std::stable_sort(order, order + crease.NumberOfMeeting, [normals, n](int a, int b) {
    return vtkMath::Dot(normals[a], n) > vtkMath::Dot(normals[b], n);
  });
  for (int k = 0; k < crease.NumberOfMeeting; ++k)
  {
    std::copy_n(normals[order[k]], 3, plane);
    face.Fit(around, this->Faces.Normals, plane, spacing);
    // The other faces may be denser.
    const float next = face.Sound ? 0 : GetNextRow(around, this->Faces.Normals, plane, row.Along);
    if (next > spacing)
    {
      face.Fit(around, this->Faces.Normals, plane, next);
    }
    // A face's own normal is no average.
    if (face.Sound || vtkMath::Dot(plane, n) > OwnCosine)
    {
      break;
    }
  }
  return face.Sound;
}

/// row is open where the face with its normal is a row, or has no points here; what it ends at may be hidden where
/// neighbours are of one face and of edges alone. spacing: of the points that are to be looked at.
bool vtkPointSplatCreases::FindSplat(
  const Neighborhood& around, float spacing, Row& row, Splat& splat) const
{
  vtkPointSplatFace face;
  vtkPointSplatCrease crease;
  const float* n = row.Normal;
  face.Fit(around, this->Faces.Normals, n, spacing);
  float plane[3] = { n[0], n[1], n[2] };
  const bool twin = row.Id >= 0;
  const bool strip = face.Row && !twin && this->Faces.IsSound(around.Center);
  row.Open = strip || (twin && (face.Row || face.Members.Count == 0));
  std::fill_n(row.Along, 3, 0.0f);
  if (face.Row)
  {
    const int last = face.Members.Members[face.Members.Count - 1];
    const float along[3] = { around.X[last], around.Y[last], around.Z[last] };
    std::copy_n(along, 3, row.Along);
    vtkMath::Normalize(row.Along);
  }
  // Where a mesh was split normals are no averages, and say where the face ends.
  const bool split = face.Members.Count > 0 && this->IsSplit(around);
  if (!face.Sound && !strip && !split)
  {
    if (!crease.FindMeeting(around, n, spacing, this->Faces))
    {
      row.Hidden = !twin && crease.HidesFace();
      return false;
    }
    if (!this->FitMeeting(around, row, crease, face, plane))
    {
      return false;
    }
  }
  const bool ends = this->DescribeSplat(around, plane, face, crease, splat);
  row.Hidden = !ends && !row.Open && crease.HidesFace();
  return ends;
}

bool vtkPointSplatCreases::FindWider(const Neighborhood& around, bool last, Found& found) const
{
  bool left = false;
  for (std::size_t r = found.Rows.size();
       r > 0 && found.Rows[r - 1].At / vtkPointSplatNeighbors::LeafSize ==
         around.Center / vtkPointSplatNeighbors::LeafSize;
       --r)
  {
    Row& row = found.Rows[r - 1];
    Splat splat;
    splat.At = row.At;
    splat.Id = row.Id;
    if (row.At == around.Center && row.Hidden)
    {
      if (this->FindSplat(around, GetSpacing(around, 1), row, splat))
      {
        found.Splats.push_back(splat);
      }
      row.Open = row.Hidden = false;
    }
    if (row.At != around.Center || !row.Open)
    {
      continue;
    }
    const float next = GetNextRow(around, this->Faces.Normals, row.Normal, row.Along);
    const float reach = NextRowReach * next;
    const bool enough = last || around.SquaredDistance[around.Count - 1] >= reach * reach;
    vtkPointSplatFace face;
    if (next > 0 && enough)
    {
      face.Fit(around, this->Faces.Normals, row.Normal, next);
    }
    vtkPointSplatCrease crease;
    if (!face.Sound || !this->DescribeSplat(around, row.Normal, face, crease, splat))
    {
      left = true;
      continue;
    }
    if (row.HasSplat)
    {
      found.Splats[row.Splat] = splat;
    }
    else
    {
      found.Splats.push_back(splat);
    }
    row.Open = false;
  }
  return !left;
}

bool vtkPointSplatCreases::DescribeSplat(const Neighborhood& around, const float plane[3],
  const vtkPointSplatFace& face, vtkPointSplatCrease& crease, Splat& splat) const
{
  crease.Find(around, face, plane, this->Faces);
  if (this->IsSplit(around))
  {
    crease.AddSplit(around, plane, this->Faces.Normals + std::size_t(3) * around.Center);
    for (auto twin = this->FindTwin(around.Center);
         twin != this->Twins.end() && twin->At == around.Center; ++twin)
    {
      crease.AddSplit(around, plane, twin->Normal);
    }
  }
  if (crease.Count == 0)
  {
    return false;
  }
  vtkPointSplatMirrored mirrored;
  mirrored.AddMeeting(around, this->Faces, plane, crease, face.Members.Spacing);
  mirrored.AddFace(around, this->Faces.Normals, plane, face, crease);
  const auto estimate = [&](vtkPointSplatDisk& disk) {
    disk.Estimate(mirrored.Get(plane), mirrored.Normals, this->Elliptical, std::numeric_limits<float>::max(),
      std::numeric_limits<float>::max());
    return std::max(disk.Length1, disk.Gap);
  };
  vtkPointSplatDisk whole, bounded;
  const float reach = estimate(whole);
  const bool bounds = mirrored.AddNext(around, this->Faces, plane, face, crease) && estimate(bounded) < reach;
  const vtkPointSplatDisk& disk = bounds ? bounded : whole;
  std::copy_n(disk.Axis1, 3, splat.Axis1);
  std::copy_n(disk.Axis2, 3, splat.Axis2);
  std::copy_n(disk.Normal, 3, splat.Normal);
  splat.Length1 = disk.Length1;
  splat.Length2 = disk.Length2;
  splat.Gap = disk.Gap;
  splat.Spacing = disk.Spacing;
  splat.Strongest = face.Strongest;
  std::copy_n(face.Tensor, 6, splat.Tensor);
  std::fill_n(splat.Clip, 6, 0.0f);
  std::fill_n(splat.Fold, 6, 0.0f);
  int lines = 0;
  for (int l = 0; l < crease.Count; ++l)
  {
    const vtkPointSplatCrease::Line& line = crease.Lines[l];
    if (line.Distance <= SplatReach * reach)
    {
      for (int c = 0; c < 3; ++c)
      {
        splat.Clip[3 * lines + c] = line.Direction[c] / line.Distance;
      }
      for (int f = 0; f < crease.NumberOfMeeting; ++f)
      {
        // The face behind a line is the one whose normal is across it.
        const float part = vtkMath::Dot(crease.Meeting[f], plane);
        const float across = vtkMath::Dot(crease.Meeting[f], line.Direction);
        // Of the disk's own face there is nothing across.
        if (part < OwnCosine && across * across > AcrossCosine * AcrossCosine * (1 - part * part) &&
          crease.GoesOn(f, plane, line.Direction))
        {
          std::copy_n(crease.Meeting[f], 3, splat.Fold + 3 * lines);
        }
      }
      ++lines;
    }
  }
  // Where no line is in reach of this disk, one may be of the disk that ends where its face does.
  return lines != 1 || !this->ReachesOver(around, plane, crease.Lines[0], disk.Length1);
}

/// Whether a disk that ends at one line alone has points in it that are on its plane but of no face, as on another edge:
/// then it should end there, too.
bool vtkPointSplatCreases::ReachesOver(const Neighborhood& around, const float plane[3],
  const vtkPointSplatCrease::Line& line, float radius) const
{
  const float spacing = vtkPointSplatSheet::GetSpacing(around);
  for (int i = 0; i < around.Count && around.SquaredDistance[i] < radius * radius; ++i)
  {
    const float x[3] = { around.X[i], around.Y[i], around.Z[i] };
    const float inside = line.Distance - vtkMath::Dot(line.Direction, x);
    const float height = vtkMath::Dot(plane, x);
    if (!this->Faces.IsSound(around.Slots[i]) && inside > 0 &&
      std::abs(height) < NextRowSlope * inside &&
      !vtkPointSplatCrease::IsOn(line, x, spacing))
    {
      return true;
    }
  }
  return false;
}

std::vector<vtkPointSplatCreases::Twin>::const_iterator vtkPointSplatCreases::FindTwin(
  Slot s) const
{
  return std::lower_bound(this->Twins.begin(), this->Twins.end(), s,
    [](const Twin& a, Slot b) { return a.At < b; });
}

bool vtkPointSplatCreases::HasTwins(Slot s) const
{
  const auto twin = this->FindTwin(s);
  return twin != this->Twins.end() && twin->At == s;
}

bool vtkPointSplatCreases::IsSplit(const Neighborhood& around) const
{
  return this->HasTwins(around.Center) &&
    std::count_if(around.Slots, around.Slots + around.Count, [this](Slot s) { return this->HasTwins(s); }) >=
    NextAlongSplit;
}

/// Appends those of a slot and of its twins.
void vtkPointSplatCreases::FindSplats(const Neighborhood& around, Found& found) const
{
  auto find = [&](vtkIdType id, const float* n) {
    Splat splat;
    splat.At = around.Center;
    splat.Id = id;
    Row row;
    row.At = around.Center;
    row.Id = id;
    std::copy_n(n, 3, row.Normal);
    row.HasSplat = this->FindSplat(around, GetSpacing(around, 0), row, splat);
    if (row.HasSplat)
    {
      row.Splat = found.Splats.size();
      found.Splats.push_back(splat);
    }
    // A strip ends on both sides.
    if (row.Hidden || (row.Open && !(row.HasSplat && IsStrip(splat))))
    {
      found.Rows.push_back(row);
    }
  };
  find(-1, this->Faces.Normals + std::size_t(3) * around.Center);
  for (auto twin = this->FindTwin(around.Center);
       twin != this->Twins.end() && twin->At == around.Center; ++twin)
  {
    find(twin->Id, twin->Normal);
  }
}

bool vtkPointSplatCreases::Find(vtkAlgorithm* self, double from, double to,
  const std::vector<unsigned char>& candidates, std::vector<Twin> twins)
{
  const Slot slots = this->Neighbors.GetNumberOfSlots();
  this->Splats.clear();
  this->Twins = std::move(twins);
  std::sort(this->Twins.begin(), this->Twins.end(),
    [](const Twin& a, const Twin& b) { return std::tie(a.At, a.Id) < std::tie(b.At, b.Id); });

  // Of each slot: whether it is looked at now, and next to how many that have lines.
  std::vector<unsigned char> wanted(candidates);
  std::vector<std::atomic<std::uint16_t>> beside(slots);
  for (const Twin& twin : this->Twins)
  {
    wanted[twin.At] = 1;
  }
  if (std::find(wanted.begin(), wanted.end(), 1) == wanted.end())
  {
    return true;
  }
  this->Faces.Numbers.assign(slots, vtkPointSplatNeighbors::None);
  this->Faces.Fitted.clear();
  this->Faces.Sound.clear();
  this->Faces.Strips.clear();

  vtkSMPThreadLocal<Found> found;
  bool looksWider = false;
  auto find = [&](const Neighborhood& around, int round) {
    Found& local = found.Local();
    const std::size_t before = local.Splats.size(), rows = local.Rows.size();
    bool done = true;
    if (round > 0)
    {
      done = this->FindWider(around, round > 1, local);
    }
    else
    {
      this->FindSplats(around, local);
      done = !looksWider || local.Rows.size() == rows;
    }
    const bool ends = std::any_of(local.Splats.begin() + before, local.Splats.end(), HasLine);
    for (int i = 0; i < std::min(around.Count, NumberOfNeighbors) && ends; ++i)
    {
      beside[around.Slots[i]].fetch_add(1, std::memory_order_relaxed);
    }
    return done;
  };
  auto isWanted = [&](Slot s) { return wanted[s] != 0; };
  // 1. A first look, of which nothing is kept but where it found lines.
  const double step = (to - from) / 6;
  if (!this->Neighbors.Visit(self, from, from + step, NumberOfNeighbors, find, isWanted))
  {
    return false;
  }
  for (Slot s = 0; s < slots; ++s)
  {
    wanted[s] = beside[s].exchange(0, std::memory_order_relaxed) > 0;
  }
  for (Found& local : found)
  {
    for (const Splat& splat : local.Splats)
    {
      wanted[splat.At] = 1;
    }
    local.Splats.clear();
    local.Rows.clear();
  }
  looksWider = true;
  for (const double start : { from + step, from + 3 * step })
  {
    // 2. Faces; 3. and 4. lines, and disks
    std::vector<unsigned char> faces;
    if (!this->AddOthers(self, start, wanted, faces) ||
      !this->FitFaces(self, start, start + step, faces))
    {
      return false;
    }
    for (Slot s = 0; s < slots; ++s)
    {
      wanted[s] &= faces[s];
    }
    if (!this->Neighbors.VisitWidely(
        self, start + step, start + 2 * step, NumberOfNeighbors, find, isWanted))
    {
      return false;
    }
    // What is near to those with lines, and has none.
    for (Slot s = 0; s < slots; ++s)
    {
      wanted[s] = beside[s].load(std::memory_order_relaxed) > 0;
    }
    for (const Found& local : found)
    {
      for (const Splat& splat : local.Splats)
      {
        wanted[splat.At] = 0;
      }
    }
  }
  for (const Found& local : found)
  {
    this->Splats.insert(this->Splats.end(), local.Splats.begin(), local.Splats.end());
  }
  // 5. A crease is a line of points: what has hardly any beside it, or only such, is noise.
  // A point that stands alone is a neighbour of few, but has as many itself.
  std::vector<unsigned char> looked(slots, 0), lined(slots, 0), sure(slots, 0), kept(slots, 0);
  for (const Splat& splat : this->Splats)
  {
    looked[splat.At] = 1;
    lined[splat.At] |= HasLine(splat);
    sure[splat.At] = kept[splat.At] =
      beside[splat.At] >= (this->HasTwins(splat.At) ? LeastSplitCompany : LeastSureCompany);
  }
  auto confirm = [&](const Neighborhood& around, int) {
    const Slot* end = around.Slots + around.Count;
    const auto own = std::count_if(around.Slots, end, [&lined](Slot s) { return lined[s] != 0; });
    kept[around.Center] =
      std::max<std::ptrdiff_t>(own, beside[around.Center]) >= LeastCompany &&
      std::any_of(around.Slots, end, [&sure](Slot s) { return sure[s] != 0; });
    return true;
  };
  bool grows = true;
  for (int round = 0; grows && round < MostSpread; ++round)
  {
    if (!this->Neighbors.Visit(self, round == 0 ? from + 5 * step : to, to, NumberOfNeighbors, confirm,
          [&](Slot s) { return looked[s] && !sure[s]; }))
    {
      return false;
    }
    grows = sure != kept;
    sure = kept;
  }
  this->Splats.erase(std::remove_if(this->Splats.begin(), this->Splats.end(),
                       [&kept](const Splat& splat) { return !kept[splat.At]; }),
    this->Splats.end());
  std::sort(this->Splats.begin(), this->Splats.end(),
    [](const Splat& a, const Splat& b) { return std::tie(a.At, a.Id) < std::tie(b.At, b.Id); });
  return true;
}

void vtkPointSplatCreases::Write(
  const std::vector<Slot>& slotOf, vtkFloatArray* clips, vtkFloatArray* folds) const
{
  const vtkIdType count = static_cast<vtkIdType>(slotOf.size());
  const bool folded = std::any_of(this->Splats.begin(), this->Splats.end(), &HasFold);
  std::vector<const Splat*> splatOf(this->Neighbors.GetNumberOfSlots(), nullptr);
  for (const Splat& splat : this->Splats)
  {
    if (splat.Id < 0)
    {
      splatOf[splat.At] = &splat;
    }
  }
  for (vtkFloatArray* array : { clips, folds })
  {
    if (array == folds && !folded)
    {
      continue;
    }
    array->SetNumberOfComponents(6);
    array->SetNumberOfTuples(count);
    float* values = array->GetPointer(0);
    std::fill_n(values, 6 * count, 0.0f);
    auto write = [&](const Splat& splat, vtkIdType id) {
      std::copy_n(array == clips ? splat.Clip : splat.Fold, 6, values + 6 * id);
    };
    vtkPointSplatThreads::For(0, count, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType id = begin; id < end; ++id)
      {
        const Slot s = slotOf[id];
        if (s != vtkPointSplatNeighbors::None && splatOf[s])
        {
          write(*splatOf[s], id);
        }
      }
    });
    for (const Splat& splat : this->Splats)
    {
      if (splat.Id >= 0)
      {
        write(splat, splat.Id);
      }
    }
  }
}

VTK_ABI_NAMESPACE_END
