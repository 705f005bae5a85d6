// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatDisks.h"

#include "vtkMath.h"
#include "vtkPointSplatCurvature.h"
#include "vtkPointSplatThreads.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN

// Those that are fitted by hand are from Testing/Accuracy/fit_constants.py.
namespace
{
/// The radius of a point that has no neighbour to compare with.
constexpr float LoneRadius = 0.1f;
/// How much larger than its neighbours' disks one may be.
constexpr float LargestRatio = 2.5f;
/// By how much the normal of a tube turns at least on the way to the cell's farthest vertex: less is closed anyway.
constexpr float TubeBend = 0.7f;
/// How far beside the axis of a tube disks reach at least, of the distance to what is nearest.
constexpr float NearestShare = 0.6f;
/// How many times as steeply as normals positions may turn. Where half of the points exceed it these are off the surface:
/// it is 1 to 1.6 of scans and isosurfaces, 7 to 18 where points are off it by a thirtieth of their distance, as TestSplatFill's.
constexpr float MostSteepness = 4;
/// Of HoleLimit counts HoleShare at a border, and this with the least spacing around, which is that farther inside: where
/// cells are even none reaches so far.
constexpr float InsideShare = 0.9f;
/// Where cells are long in one place and not in another: by how much one is longer than others around that may reach
/// into a hole.
constexpr float LeastStretch = 1.5f; // Testing/Cxx/TestSplatBorders.cxx
/// How far the normal may turn from the centre to the rim of a disk: the kernel's rim, a half
/// farther out, then stays within a tube's silhouette.
constexpr float LargestBend = 0.6f;
/// What is left of a disk at least, however much the surface bends: noise may look like it.
constexpr float LeastShare = 0.75f;
/// From how many times the usual spacing on that does not tell which neighbours are near, ...
constexpr float SparserThanUsual = 2.0f;
/// ... if none is so many times as dense, and of these and the point no more are alone: nearly all are in spray, some at edges.
constexpr float AsSparse = 2.0f;
constexpr int MostAlone = 2;
/// The cosine (45 degrees) between planes from which on a neighbour is beyond a crease, ...
constexpr float OwnFace = 0.7f;
/// ... and how many times denser it must be there not to bound a disk: of even samplings none is.
constexpr float Denser = 3.0f;
/// The radius of a body alone, of the distance to what is nearest.
constexpr float BodyRadius = 0.5f;
}

vtkPointSplatDisks::vtkPointSplatDisks(Slot slots, float usual, bool elliptical)
  : vtkPointSplatVoronoiCells(slots)
  , Distance(slots, 0.0f)
  , Turn(slots, 0.0f)
  , Facing(slots, 0.0f)
  , Farthest(slots, 0.0f)
  , Length(slots, 0.0f)
  , Gap(slots, 0.0f)
  , Whole(slots, 0)
  , Few(slots, 0)
  , NearSpacing(slots, std::numeric_limits<float>::max())
  , BodySpacing(slots, std::numeric_limits<float>::max())
  , Axes(elliptical ? std::size_t(6) * slots : 0, 0.0f)
  , Planes(std::size_t(3) * slots, 0.0f)
  , Curvatures(elliptical ? 0 : std::size_t(6) * slots, 0.0f)
  , Samplings(usual)
  , Sparse(slots, 0)
  , Cut(slots, 0)
  , Graded(slots, 0)
  , Nearest(slots, 0.0f)
{
}

void vtkPointSplatDisks::Set(const vtkPointSplatNeighbors::Neighborhood& around,
  const vtkPointSplatDisk& disk, float largest)
{
  const Slot s = around.Center;
  if (!this->Axes.empty())
  {
    const float ratio = disk.Length1 > 0 ? disk.Length2 / disk.Length1 : 1.0f;
    for (int c = 0; c < 3; ++c)
    {
      this->Axes[std::size_t(6) * s + c] = disk.Axis1[c];
      this->Axes[std::size_t(6) * s + 3 + c] = ratio * disk.Axis2[c];
    }
  }
  this->Length[s] = std::min(disk.Length1, largest);
  this->Gap[s] = std::min(disk.Gap, largest);
  this->Cut[s] = disk.Length1 > largest;
  this->Opening[s] = disk.Opening;
  this->Whole[s] = disk.Sheet.Whole;
  this->Few[s] = 2 * disk.Sheet.Count < around.Count;
  this->Spacing[s] = disk.Spacing;
  this->NearSpacing[s] = std::min(this->NearSpacing[s], vtkPointSplatSheet::GetSpacing(around));
  this->BodySpacing[s] = std::min(this->BodySpacing[s], vtkPointSplatSheet::GetBodySpacing(around));
  this->Distance[s] = disk.Distance;
  this->Nearest[s] = around.Count > 0 ? std::sqrt(around.SquaredDistance[0]) : 0.0f;
  for (int w = 0; w < NumberOfWitnesses && around.Count >= NumberOfWitnesses; ++w)
  {
    this->Witnesses[std::size_t(NumberOfWitnesses) * s + w] =
      around.Slots[(w + 1) * around.Count / NumberOfWitnesses - 1];
  }
}

void vtkPointSplatDisks::SetStar(
  const vtkPointSplatNeighbors::Neighborhood& around, const vtkPointSplatDisk& disk,
  const float* normals, float grain)
{
  float turn2 = 0, facing2 = 0, squared = 0;
  const float most = this->GetSampling(around.Center).HoleLimit * disk.Spacing;
  disk.VisitTriangles([&](int a, int b, float reach) {
    for (const int i : { a, b })
    {
      if (reach > most)
      {
        continue;
      }
      const float place[3] = { around.X[i], around.Y[i], around.Z[i] };
      squared = std::max(squared, around.SquaredDistance[i]);
      turn2 = std::max(turn2, vtkPointSplatSheet::GetSquaredTurn(disk.Normal, place, grain));
      facing2 = std::max(facing2,
        vtkPointSplatSheet::GetSquaredTurn(
          disk.Normal, normals + std::size_t(3) * around.Slots[i], place, grain));
    }
  });
  this->Turn[around.Center] = std::sqrt(turn2);
  this->Facing[around.Center] = std::sqrt(facing2);
  this->Farthest[around.Center] = std::sqrt(squared);
}

void vtkPointSplatDisks::Set(Slot slot, const vtkPointSplatFans::Disk& disk)
{
  this->Length[slot] = this->Spacing[slot] = disk.Radius;
  std::copy_n(disk.Plane, 3, this->Planes.data() + std::size_t(3) * slot);
  std::copy_n(disk.Curvature, 6, this->Curvatures.data() + std::size_t(6) * slot);
}

void vtkPointSplatDisks::Set(const vtkPointSplatCreases::Splat& splat)
{
  const std::size_t s = splat.At;
  float largest = std::numeric_limits<float>::max();
  if (this->Axes.empty())
  {
    largest = GetLargest(splat.Strongest, splat.Length1);
    std::copy_n(splat.Normal, 3, this->Planes.data() + 3 * s);
    std::copy_n(splat.Tensor, 6, this->Curvatures.data() + 6 * s);
  }
  else
  {
    const float ratio = splat.Length1 > 0 ? splat.Length2 / splat.Length1 : 1.0f;
    for (int c = 0; c < 3; ++c)
    {
      this->Axes[6 * s + c] = splat.Axis1[c];
      this->Axes[6 * s + 3 + c] = ratio * splat.Axis2[c];
    }
  }
  for (int w = 0; w < NumberOfWitnesses && this->Axes.empty(); ++w)
  {
    Slot& witness = this->Witnesses[NumberOfWitnesses * s + w];
    if (witness != vtkPointSplatNeighbors::None && splat.Spacing > Denser * this->NearSpacing[witness] &&
      std::abs(vtkMath::Dot(splat.Normal, this->Planes.data() + std::size_t(3) * witness)) < OwnFace)
    {
      witness = vtkPointSplatNeighbors::None;
    }
  }
  this->Length[s] = std::min(splat.Length1, largest);
  this->Gap[s] = std::min(splat.Gap, largest);
  this->Spacing[s] = splat.Spacing;
}

float vtkPointSplatDisks::GetLargest(float curvature, float radius)
{
  return curvature > 0 ? std::max(LargestBend / curvature, LeastShare * radius)
                       : std::numeric_limits<float>::max();
}

void vtkPointSplatDisks::TrustNormals()
{
  std::vector<float> ratios = GetSamples(this->Turn.size(), [this](std::size_t s) {
    return this->Facing[s] > 0 ? this->Turn[s] / this->Facing[s] : 0.0f;
  });
  if (ratios.size() < 100 || GetQuantile(ratios, 0.5) <= MostSteepness)
  {
    return;
  }
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(this->Turn.size()), [this](vtkIdType begin, vtkIdType end) {
    for (std::size_t s = static_cast<std::size_t>(begin); s < static_cast<std::size_t>(end); ++s)
    {
      this->Turn[s] = std::min(this->Turn[s], MostSteepness * this->Facing[s]);
    }
  });
}

bool vtkPointSplatDisks::GetTubeLines(Slot slot, float clip[6]) const
{
  const float opening = this->Opening[slot];
  if (!this->GetSampling(slot).Even || !this->Cut[slot] || opening == 0 || this->MayReachHole(slot))
  {
    return false;
  }
  const float* t = this->Curvatures.data() + std::size_t(6) * slot;
  double rows[3][3] = { { t[0], t[3], t[5] }, { t[3], t[1], t[4] }, { t[5], t[4], t[2] } };
  double values[3], vectors[3][3];
  double* matrix[3] = { rows[0], rows[1], rows[2] };
  double* columns[3] = { vectors[0], vectors[1], vectors[2] };
  vtkMath::Jacobi(matrix, values, columns);
  int strongest = 0;
  for (int k = 1; k < 3; ++k)
  {
    strongest = std::abs(values[k]) > std::abs(values[strongest]) ? k : strongest;
  }
  for (int k = 0; k < 3; ++k)
  {
    const double bend = std::abs(values[k]) * opening;
    if (k == strongest ? bend < TubeBend : bend > LargestBend)
    {
      return false; // it bends both ways, or little
    }
  }
  const double distance =
    std::max<double>(0.5 * LargestBend / std::abs(values[strongest]), NearestShare * this->Nearest[slot]);
  for (int c = 0; c < 3; ++c)
  {
    clip[c] = static_cast<float>(vectors[c][strongest] / distance);
    clip[3 + c] = -clip[c];
  }
  return true;
}

void vtkPointSplatDisks::Lengthen(Slot slot, float length)
{
  const float bend = this->Curvatures.empty()
    ? 0.0f
    : vtkPointSplatCurvature::GetBend(this->Curvatures.data() + std::size_t(6) * slot);
  const float most = bend > 0 ? std::min(length, LargestBend / bend) : length;
  this->Length[slot] = std::max(this->Length[slot], most);
}

void vtkPointSplatDisks::Close(Slot slot)
{
  float lines[6];
  const float gap = this->GetTubeLines(slot, lines) ? this->Opening[slot] : this->Gap[slot];
  if (gap <= this->GetSampling(slot).HoleLimit * this->Spacing[slot])
  {
    this->Length[slot] = std::max(this->Length[slot], gap);
  }
}

void vtkPointSplatDisks::Finish()
{
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(this->Length.size()), [this](vtkIdType begin, vtkIdType end) {
    for (vtkIdType s = begin; s < end; ++s)
    {
      this->Close(static_cast<Slot>(s));
    }
  });
  std::vector<float> lengths =
    GetSamples(this->Length.size(), [this](std::size_t s) { return this->Length[s]; });
  this->Body = lengths.empty() ? std::numeric_limits<float>::max() : GetQuantile(lengths, 0.5);
}

float vtkPointSplatDisks::GetBounded(Slot slot) const
{
  if (this->IsAlone(slot))
  {
    return this->Nearest[slot] > 0 ? std::min(BodyRadius * this->Nearest[slot], this->Body)
                                   : LoneRadius;
  }
  return this->Graded[slot] ? this->Length[slot]
                            : std::min(this->Length[slot], this->GetBound(slot));
}

/// LargestRatio times the second smallest of some neighbours' reaches.
float vtkPointSplatDisks::GetBound(Slot slot) const
{
  float smallest = std::numeric_limits<float>::max(), second = smallest;
  this->VisitWitnesses(slot, [&](Slot witness) {
    if (!this->IsAlone(witness))
    {
      const float length = this->GetReach(witness);
      second = std::min(second, std::max(smallest, length));
      smallest = std::min(smallest, length);
    }
  });
  return LargestRatio * second;
}

void vtkPointSplatDisks::FindSparse()
{
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(this->Sparse.size()), [&](vtkIdType begin, vtkIdType end) {
    for (Slot s = static_cast<Slot>(begin); s < static_cast<Slot>(end); ++s)
    {
      const float spacing = this->BodySpacing[s];
      bool sparse = spacing / SparserThanUsual > this->GetUsualOfPart(s);
      int alone = this->IsAlone(s) ? 1 : 0;
      this->VisitWitnesses(s, [&](Slot witness) {
        sparse = sparse && AsSparse * this->BodySpacing[witness] > spacing;
        alone += this->IsAlone(witness) ? 1 : 0;
      });
      this->Sparse[s] = sparse && alone <= MostAlone;
    }
  });
}

bool vtkPointSplatDisks::IsOutlier(Slot slot, float times) const
{
  float largest = 0;
  this->VisitWitnesses(
    slot, [&](Slot witness) { largest = std::max(largest, this->Spacing[witness]); });
  return largest > 0 && this->Nearest[slot] > times * largest;
}

bool vtkPointSplatDisks::HasSmallWitness(
  Slot slot, const vtkPointSplatLargeArray<float>& sizes) const
{
  bool any = false;
  this->VisitWitnesses(
    slot, [&](Slot witness) { any = any || 2 * sizes[witness] < sizes[slot]; });
  return any;
}

bool vtkPointSplatDisks::HasClosedWitness(Slot slot) const
{
  bool any = false;
  this->VisitWitnesses(slot, [&](Slot witness) { any = any || this->Opening[witness] > 0; });
  return any;
}

bool vtkPointSplatDisks::MayEnd(Slot slot) const
{
  const float opening = this->Opening[slot];
  const vtkPointSplatSamplings::Sampling& sampling = this->GetSampling(slot);
  if (this->IsAlone(slot))
  {
    return false;
  }
  if (sampling.Stretched)
  {
    float least = std::numeric_limits<float>::max();
    this->VisitWitnesses(slot, [&](Slot witness) {
      least = this->Opening[witness] > 0 ? std::min(least, this->Opening[witness]) : least;
    });
    return opening == 0 || opening > LeastStretch * least;
  }
  if (sampling.Regular)
  {
    float inside = this->Spacing[slot];
    this->VisitWitnesses(slot, [&](Slot witness) {
      const float spacing = this->Spacing[witness];
      inside = spacing > 0 ? std::min(inside, spacing) : inside;
    });
    return opening == 0 ||
      opening > sampling.BorderLimit * std::max(this->GetSpacingInside(slot), InsideShare * inside);
  }
  return opening == 0 && this->HasClosedWitness(slot);
}

bool vtkPointSplatDisks::MayBeBay(Slot slot) const
{
  return !this->GetSampling(slot).Regular && this->Opening[slot] > BayLimit * this->GetSpacingAround(slot);
}

void vtkPointSplatDisks::Shrink(Slot slot, float length)
{
  this->Length[slot] = length;
  this->Gap[slot] = 0;
  this->Cut[slot] = 0;
  this->Graded[slot] = 1;
}

void vtkPointSplatDisks::Open(Slot slot, float length)
{
  this->Length[slot] = length;
  this->Gap[slot] = this->Opening[slot] = 0;
}

bool vtkPointSplatDisks::AgreeWitnesses(
  Slot slot, const std::vector<unsigned char>& marks) const
{
  int unmarked = 0;
  this->VisitWitnesses(slot, [&](Slot witness) { unmarked += marks[witness] ? 0 : 1; });
  return 2 * (NumberOfWitnesses - unmarked) >= NumberOfWitnesses;
}

void vtkPointSplatDisks::GetBall(Slot slot, float tensor[6]) const
{
  const float curvature = LargestBend / this->GetBounded(slot);
  for (int k = 0; k < 6; ++k)
  {
    tensor[k] = k < 3 ? curvature : 0.0f;
  }
}

VTK_ABI_NAMESPACE_END
