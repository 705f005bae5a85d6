// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatEstimates.h"

#include "vtkPointSet.h"
#include "vtkPointSplatCurvature.h"
#include "vtkPointSplatEstimation.h"
#include "vtkPointSplatInput.h"
#include "vtkPointSplatNoise.h"
#include "vtkPointSplatNormalSeams.h"
#include "vtkPointSplatNormals.h"
#include "vtkPointSplatSensors.h"
#include "vtkPointSplatSparsePart.h"
#include "vtkPointSplatThreads.h"
#include "vtkSMPThreadLocal.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
using Slot = vtkPointSplatNeighbors::Slot;

/// Of how many leaves of the search tree, at least, the usual spacing is found.
constexpr Slot UsualLeaves = 512;
}

vtkPointSplatEstimates::vtkPointSplatEstimates(
  vtkPointSplatEstimation* self, vtkPointSet* input)
  : Self(self)
  , Input(input)
  , NumberOfPoints(input->GetNumberOfPoints())
  , Elliptical(self->GetShape() == vtkPointSplatEstimation::Elliptical)
{
}

bool vtkPointSplatEstimates::Run()
{
  vtkDataArray* given = this->MakeArrays();
  if (this->NumberOfPoints == 0)
  {
    return true;
  }
  this->ReadPoints(given);
  this->ReadMesh();
  if (!this->FindNormals() || !this->FindDisks())
  {
    return false;
  }
  Twins twins = this->FindTwins();
  if (!this->FindBorders(twins) || !this->FindCreases(std::move(twins)))
  {
    return false;
  }
  if ((this->Fills() && !this->FindStars()) || !this->Borders->Finish(this->Self, *this->Disks))
  {
    return false;
  }
  this->SetCreases();
  this->BoundMesh();
  if (this->Fills())
  {
    this->FindFill();
  }
  this->Disks->Finish();
  this->Write();
  this->ClipFill();
  if (this->Fills() && this->FillsNoise())
  {
    this->AddFoldSides();
  }
  return true;
}

bool vtkPointSplatEstimates::FindNormals()
{
  const Slot slots = this->Neighbors.GetNumberOfSlots();
  this->SlotNormals = vtkPointSplatLargeArray<float>(std::size_t(3) * slots);
  this->Known.resize(slots);
  std::atomic<Slot> given{ 0 }, missing{ 0 };
  vtkPointSplatThreads::For(0, slots, [&](vtkIdType begin, vtkIdType end) {
    const float none[3] = { 0, 0, 0 };
    Slot known = 0, unknown = 0;
    for (Slot s = static_cast<Slot>(begin); s < static_cast<Slot>(end); ++s)
    {
      const vtkIdType id = this->Neighbors.GetId(s);
      const float* normal = id >= 0 ? this->GetNormal(id) : none;
      std::copy_n(normal, 3, this->SlotNormals.data() + std::size_t(3) * s);
      this->Known[s] = !vtkPointSplatInput::IsZero(normal);
      known += this->Known[s] ? 1 : 0;
      unknown += id >= 0 && !this->Known[s] ? 1 : 0;
    }
    given += known;
    missing += unknown;
  });
  this->Guessed = missing > given;
  this->Trusted = this->Known;
  if (missing > 0)
  {
    vtkPointSplatNormals fitted(this->Neighbors, this->SlotNormals.data(), this->Known);
    const bool consistent =
      this->Self->GetOrientation() == vtkPointSplatEstimation::Consistent;
    std::string error;
    const vtkPointSplatSensors sensors(this->Input, error);
    if (consistent && !error.empty())
    {
      vtkErrorWithObjectMacro(this->Self, << error);
    }
    const int k = this->Self->GetNumberOfNeighbors();
    if (!fitted.Fit(
          this->Self, 0.1, 0.4, { k, k * fitted.GetTimes(this->Self, k), true }, consistent))
    {
      return false;
    }
    fitted.MarkRows(this->Trusted);
    this->OnSurface = fitted.TakeOnSurface();
    if (consistent && !sensors.IsEmpty())
    {
      fitted.OrientToSensors(sensors);
    }
    else if (consistent)
    {
      fitted.OrientConsistently();
    }
    else
    {
      fitted.OrientToViewpoint(this->Self->GetViewpoint());
    }
  }
  // A mesh is one surface, whatever its normals say, but creases of what a noisy volume's is are noise.
  if (this->Fans.IsEmpty() || this->OfLattice)
  {
    const vtkPointSplatNoise::Shares found = vtkPointSplatNoise::Measure(
      this->Self, this->Neighbors, this->SlotNormals.data(), this->Guessed);
    this->Noise = found.Noisy;
    this->Clean = found.Clean;
    this->Contradiction = this->OfLattice ? 0.0 : found.Contradicted;
  }
  return true;
}

/// The spacing of most points: the median of points all over the cloud.
float vtkPointSplatEstimates::GetUsualSpacing() const
{
  vtkSMPThreadLocal<std::vector<float>> found;
  this->Neighbors.Visit(this->Self, 0.05, 0.1, vtkPointSplatSheet::SpacingRank,
    [&](const Neighborhood& around, int) {
      if (around.Count > 0)
      {
        found.Local().push_back(vtkPointSplatSheet::GetBodySpacing(around));
      }
      return true;
    },
    this->Neighbors.WantSome(UsualLeaves));
  std::vector<float> spacings;
  for (const std::vector<float>& local : found)
  {
    std::copy_if(local.begin(), local.end(), std::back_inserter(spacings),
      [](float spacing) { return spacing != 0; });
  }
  return spacings.empty() ? 0.0f : vtkPointSplatVoronoiCells::GetQuantile(spacings, 0.5);
}

/// Whether points of other sheets may hide those of a slot's own: no neighbour counts, or most are of others.
bool vtkPointSplatEstimates::IsHemmed(Slot s) const
{
  return this->Trusted[s] &&
    (this->Disks->IsAlone(s) || (this->Disks->Few[s] && this->Disks->Opening[s] == 0));
}

/// A slot's disk; returns whether its cell is closed, or more neighbours tell nothing new.
bool vtkPointSplatEstimates::Measure(const Neighborhood& around, int round)
{
  const Slot s = around.Center;
  const int count = this->Self->GetNumberOfNeighbors();
  const float* directions = this->Directions;
  vtkPointSplatDisk disk;
  const bool closed = disk.Estimate(
    around, directions, this->Elliptical, this->Disks->GetUsual(s), this->Disks->GetSampling(s).HoleLimit);
  this->Creased[s] = this->Creased[s] ||
    (disk.Sheet.Uneven &&
      vtkPointSplatCrease::IsLikely(
        around, this->SlotNormals.data(), this->GetSlotNormal(s), disk.Sheet.Spacing));
  if (round == 0 && !this->Trusted[s])
  {
    this->Bodies->Look(around, this->SlotNormals.data(), this->OnSurface);
  }
  // In the second look farther neighbours of what is hemmed in are asked for, and nothing about rows.
  const bool again = directions != this->SlotNormals.data();
  const bool hemmed = again && this->IsHemmed(s);
  if (hemmed && round == 1 && !closed)
  {
    return false;
  }
  if (round == 2 && !hemmed)
  {
    this->Bodies->AddRow(around, disk.Sheet, this->Disks->Length[s]);
  }
  if (round > 0 && !closed)
  {
    // What more neighbours do not close is a border: the first round's disk stands.
    if (round == 1)
    {
      const bool inRow = disk.InRow(count);
      if (inRow && this->Trusted[s])
      {
        this->Bodies->LookAtRow(around, count);
      }
      return !inRow;
    }
    return true;
  }
  if (round > 0 && disk.Sheet.IsFewAfar && !this->Trusted[s])
  {
    // Estimated normals of a row agree with the next row's by chance: this may be where the surface goes on, as beside a
    // dense edge, but does not say how far one disk reaches.
    this->FindStar(around, disk);
    return true;
  }
  this->SetDisk(around, disk);
  return closed;
}

/// Takes a disk over, with the surface's curvature.
void vtkPointSplatEstimates::SetDisk(const Neighborhood& around, const vtkPointSplatDisk& disk)
{
  const std::size_t s = around.Center;
  std::copy_n(disk.Normal, 3, this->Disks->Planes.data() + 3 * s);
  const bool fits = std::equal(disk.Normal, disk.Normal + 3, this->Directions + 3 * s);
  for (int i = 0; i < around.Count && !fits; ++i)
  {
    this->Misled[around.Slots[i]].store(true, std::memory_order_relaxed);
  }
  float largest = std::numeric_limits<float>::max();
  if (!this->Elliptical)
  {
    vtkPointSplatCurvature curvature;
    // Normals that are not the surface's say nothing of its curvature.
    if (fits)
    {
      curvature.Estimate(around, this->Directions, disk.Normal, disk.Sheet);
    }
    std::copy_n(curvature.Tensor, 6, this->Disks->Curvatures.data() + 6 * s);
    largest = vtkPointSplatDisks::GetLargest(curvature.Strongest, disk.Length1);
  }
  this->Disks->Set(around, disk, largest);
  this->FindStar(around, disk);
}

void vtkPointSplatEstimates::FindStar(const Neighborhood& around, const vtkPointSplatDisk& disk)
{
  if (this->Self->GetFillGaps() && !this->Elliptical)
  {
    this->Disks->SetStar(around, disk, this->Directions, vtkPointSplatSheet::Grain * this->Median);
  }
}

void vtkPointSplatEstimates::FindSearched()
{
  const std::vector<Slot>& slotOf = this->Neighbors.GetSlots();
  this->Searched = std::vector<std::atomic<bool>>(this->Neighbors.GetNumberOfSlots());
  vtkPointSplatThreads::For(0, this->NumberOfPoints, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType id = begin; id < end; ++id)
    {
      if (slotOf[id] != vtkPointSplatNeighbors::None && !this->Fans.Has(id))
      {
        this->Searched[slotOf[id]].store(true, std::memory_order_relaxed);
      }
    }
  });
}

/// Those of points that dense ones of another part of the surface hem in. taken: of each slot whether it has one.
bool vtkPointSplatEstimates::FindSparseDisks(std::vector<unsigned char>& taken)
{
  vtkPointSplatDisks& disks = *this->Disks;
  std::vector<unsigned char> hemmed(this->Neighbors.GetNumberOfSlots(), 0);
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(hemmed.size()), [&](vtkIdType begin, vtkIdType end) {
    for (Slot s = static_cast<Slot>(begin); s < static_cast<Slot>(end); ++s)
    {
      hemmed[s] = this->Searched[s] && this->IsHemmed(s);
    }
  });
  const vtkPointSplatSparsePart part(this->Neighbors, disks, this->Median, std::move(hemmed));
  auto look = [&](const Neighborhood& around, int round) {
    const std::size_t s = around.Center;
    vtkPointSplatDisk disk;
    const bool closed = disk.Estimate(
      around, this->Directions, this->Elliptical, disks.GetUsualOfPart(s), disks.GetSampling(s).HoleLimit);
    if (!closed && round == 0)
    {
      return false;
    }
    // Where a cell is open, nothing but the dense points tells how far the surface goes on.
    const float most = vtkPointSplatStars::GetRadius(disk.Distance);
    disk.Limit(closed ? most : std::min(most, disks.NearSpacing[s]));
    if (disk.Sheet.Count >= vtkPointSplatSheet::FewMembers && disk.Length1 > disks.Length[s])
    {
      this->SetDisk(around, disk);
      taken[s] = 1;
    }
    return true;
  };
  return part.IsEmpty() ||
    part.Visit(this->Self, this->Input->GetPoints()->GetData(),
      this->Self->GetNumberOfNeighbors(), look);
}

/// Given normals that cancelled where a mesh's triangles are not oriented consistently, of slots and of their points.
bool vtkPointSplatEstimates::MendSeams(vtkPointSplatNormalSeams& seams)
{
  if (!this->Given)
  {
    return true;
  }
  std::vector<unsigned char> given(this->Neighbors.GetNumberOfSlots());
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(given.size()), [&](vtkIdType begin, vtkIdType end) {
    for (Slot s = static_cast<Slot>(begin); s < static_cast<Slot>(end); ++s)
    {
      given[s] = this->Known[s] && this->Searched[s];
    }
  });
  if (!seams.Mend(this->Self, std::move(given), this->Self->GetNumberOfNeighbors()))
  {
    return false;
  }
  const std::vector<Slot>& slotOf = this->Neighbors.GetSlots();
  const vtkIdType last = seams.GetNumberOfMended() > 0 ? this->NumberOfPoints : 0;
  std::atomic<vtkIdType> mended{ 0 };
  vtkPointSplatThreads::For(0, last, [&](vtkIdType begin, vtkIdType end) {
    vtkIdType here = 0;
    for (vtkIdType id = begin; id < end; ++id)
    {
      float* n = this->GetNormal(id);
      if (slotOf[id] != vtkPointSplatNeighbors::None && seams.IsMended(slotOf[id], n))
      {
        std::copy_n(this->GetSlotNormal(slotOf[id]), 3, n);
        ++here;
      }
    }
    mended += here;
  });
  this->NumberOfMendedNormals += mended;
  return true;
}

/// Those of parts, again, whose usual spacing is not the cloud's.
bool vtkPointSplatEstimates::FindOtherDisks()
{
  std::vector<unsigned char> others(this->Neighbors.GetNumberOfSlots(), 0);
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(others.size()), [&](vtkIdType begin, vtkIdType end) {
    for (Slot s = static_cast<Slot>(begin); s < static_cast<Slot>(end); ++s)
    {
      others[s] = this->Searched[s] && this->Disks->GetUsualOfPart(s) != this->Median;
      this->Creased[s] = this->Creased[s] && !others[s];
    }
  });
  this->Bodies->ForgetRows(others);
  return this->Neighbors.Visit(
    this->Self, 0.8, 0.8, this->Self->GetNumberOfNeighbors(),
    [this](const Neighborhood& around, int round) { return this->Measure(around, round); },
    [&others](Slot s) { return others[s] != 0; });
}

/// But for the corners of triangles, whose disks these tell.
bool vtkPointSplatEstimates::FindDisks()
{
  const Slot slots = this->Neighbors.GetNumberOfSlots();
  const std::vector<Slot>& slotOf = this->Neighbors.GetSlots();
  this->FindSearched();
  this->Median = this->GetUsualSpacing();
  this->Disks = std::make_unique<vtkPointSplatDisks>(slots, this->Median, this->Elliptical);
  this->Bodies = std::make_unique<vtkPointSplatBodies>(slots);
  this->Creased.assign(slots, 0);
  this->Misled = std::vector<std::atomic<bool>>(slots);
  this->Directions = this->SlotNormals.data();
  vtkPointSplatDisks& disks = *this->Disks;
  const int count = this->Self->GetNumberOfNeighbors();
  auto measure = [this](const Neighborhood& around, int round) {
    return this->Measure(around, round);
  };
  if (!this->Neighbors.Visit(this->Self, std::max(0.1, this->Self->GetProgress()), 0.8, count, measure,
        [this](Slot s) { return this->Searched[s].load(std::memory_order_relaxed); }))
  {
    return false;
  }
  disks.Samplings.FindParts(disks, disks.BodySpacing);
  if (!disks.Samplings.IsOne() && !this->FindOtherDisks())
  {
    return false;
  }
  // Again where that tells more: neighbours across holes, normals that are not the surface's, and points that are all sparse.
  disks.Samplings.FindLimits(disks);
  disks.FindSparse();
  std::vector<unsigned char> taken(slots, 0); // what has its disk from a sparse part alone is not looked at again
  vtkPointSplatNormalSeams seams(this->Neighbors, this->SlotNormals.data(), disks.Planes.data());
  if (!this->FindSparseDisks(taken) || !this->MendSeams(seams))
  {
    return false;
  }
  this->SheetNormals = vtkPointSplatLargeArray<float>(this->SlotNormals.size());
  std::vector<unsigned char> again(slots, 0);
  vtkPointSplatThreads::For(0, slots, [&](vtkIdType begin, vtkIdType end) {
    for (Slot s = static_cast<Slot>(begin); s < static_cast<Slot>(end); ++s)
    {
      again[s] = this->Searched[s] && !taken[s] &&
        ((this->Misled[s] && !disks.Whole[s]) || seams.IsBeside(s) || this->IsHemmed(s) ||
          disks.MayReachHole(s) || disks.IsSparse(s) ||
          (disks.GetSampling(s).Stretched && disks.Opening[s] == 0));
      const bool planar = this->Searched[s] && !seams.IsMended(s);
      std::copy_n(planar ? disks.Planes.data() + std::size_t(3) * s : this->GetSlotNormal(s), 3,
        this->SheetNormals.data() + std::size_t(3) * s);
    }
  });
  this->Directions = this->SheetNormals.data();
  if (!this->Neighbors.VisitWidely(this->Self, 0.8, 0.83, count, measure,
        [&again](Slot s) { return again[s] != 0; }) ||
    !this->Bodies->Finish(this->Self, 0.83, 0.85, this->Neighbors, count, disks))
  {
    return false;
  }
  for (vtkIdType id = 0; id < static_cast<vtkIdType>(this->Corners.size()); ++id)
  {
    if (slotOf[id] != vtkPointSplatNeighbors::None)
    {
      disks.Set(slotOf[id], this->GetCorner(id));
      this->Creased[slotOf[id]] = this->GetCorner(id).Creased;
    }
  }
  return true;
}

/// Points that share a slot with one whose normal is another.
vtkPointSplatEstimates::Twins vtkPointSplatEstimates::FindTwins() const
{
  if (this->MeshAlone)
  {
    return {}; // triangles tell where faces end
  }
  const std::vector<Slot>& slotOf = this->Neighbors.GetSlots();
  vtkSMPThreadLocal<Twins> found;
  vtkPointSplatThreads::For(0, this->NumberOfPoints, [&](vtkIdType begin, vtkIdType end) {
    Twins& local = found.Local();
    for (vtkIdType id = begin; id < end; ++id)
    {
      const Slot s = slotOf[id];
      const float* n = this->Normals->GetPointer(3 * id);
      if (s != vtkPointSplatNeighbors::None && this->Neighbors.GetId(s) != id && !vtkPointSplatInput::IsZero(n) &&
        vtkPointSplatCrease::Parts(n, this->GetSlotNormal(s)))
      {
        local.push_back({ id, s, { n[0], n[1], n[2] } });
      }
    }
  });
  Twins twins;
  for (const Twins& local : found)
  {
    twins.insert(twins.end(), local.begin(), local.end());
  }
  std::sort(twins.begin(), twins.end(), [](const auto& a, const auto& b) { return a.Id < b.Id; });
  return twins;
}

bool vtkPointSplatEstimates::FindBorders(const Twins& twins)
{
  this->Borders = std::make_unique<vtkPointSplatBorders>(
    this->Neighbors, this->Directions, *this->Disks);
  if (this->IsNoisy())
  {
    return true;
  }
  const Slot slots = this->Neighbors.GetNumberOfSlots();
  std::vector<unsigned char> candidates(slots);
  for (Slot s = 0; s < slots; ++s)
  {
    candidates[s] = this->Searched[s].load(std::memory_order_relaxed);
  }
  for (const vtkPointSplatCreases::Twin& twin : twins)
  {
    candidates[twin.At] = 0;
  }
  return this->Borders->Find(this->Self, this->Elliptical, candidates);
}

bool vtkPointSplatEstimates::FindCreases(Twins twins)
{
  this->Creases = std::make_unique<vtkPointSplatCreases>(this->Neighbors,
    this->SlotNormals.data(), this->Elliptical ? nullptr : this->Disks->Curvatures.data(),
    this->Disks->NearSpacing.data(), this->Elliptical);
  if (!this->Given || !(this->Fans.IsEmpty() || this->MeshAlone) || this->IsRough())
  {
    return true;
  }
  if (!this->Creases->Find(this->Self, 0.85, 0.9, this->Creased, std::move(twins)))
  {
    return false;
  }
  // Beyond a crease neighbours may be far, but triangles tell how far a disk has to reach. Those of a volume's voxels, in which
  // creases are not where the points are, do not.
  for (vtkPointSplatCreases::Splat& splat : this->Creases->Splats)
  {
    const vtkIdType id = splat.Id < 0 ? this->Neighbors.GetId(splat.At) : splat.Id;
    if (this->MeshAlone && !this->OfLattice && id >= 0)
    {
      splat.Length1 = std::min(splat.Length1, this->GetCorner(id).Radius);
      splat.Gap = std::min(splat.Gap, this->GetCorner(id).Radius);
    }
  }
  return true;
}

void vtkPointSplatEstimates::SetCreases()
{
  for (const vtkPointSplatCreases::Splat& splat : this->Creases->Splats)
  {
    if (splat.Id < 0)
    {
      this->Disks->Set(splat);
    }
  }
}

/// Of each slot whether it has a splat that ends at one.
std::vector<unsigned char> vtkPointSplatEstimates::GetSlotsAtCreases() const
{
  std::vector<unsigned char> at(this->Neighbors.GetNumberOfSlots(), 0);
  for (const vtkPointSplatCreases::Splat& splat : this->Creases->Splats)
  {
    at[splat.At] = 1;
  }
  return at;
}

bool vtkPointSplatEstimates::IsDrawn(vtkIdType id) const
{
  return !vtkPointSplatInput::IsDuplicate(this->Ghosts, id);
}

/// Coordinates may be so large that lengths overflow.
float vtkPointSplatEstimates::GetScaled(float length) const
{
  constexpr float largest = std::numeric_limits<float>::max();
  return std::min(
    static_cast<float>(this->Self->GetRadiusScale()) * std::min(length, largest), largest);
}

VTK_ABI_NAMESPACE_END
