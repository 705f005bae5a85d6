// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatPieceVotes.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPointSplatPacking.h"
#include "vtkPoints.h"
#include "vtkPointSplatThreads.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace
{
constexpr vtkIdType Voters = 100000; // of all blocks; of each block at least, and at most:
constexpr vtkIdType FewestVoters = 20;
constexpr vtkIdType MostVoters = 1000;
constexpr int NearestPoints = 16;
constexpr size_t FewOwn = 3;
constexpr double LeastShare = 0.15;
// On a sheet with a point: within 45 degrees of its normal, and 17 of its plane.
constexpr double SheetCosine = 0.7;
constexpr double SheetSlope = 0.3;
constexpr double WideGap = 2.44; // radians: 140 degrees

/// What takes part: within the span of the middle nine tenths of all points' coordinates, and as much again on both sides.
void FindRange(const std::vector<vtkPointSet*>& blocks, std::array<double, 3>& low,
  std::array<double, 3>& high)
{
  std::array<std::vector<double>, 3> samples;
  for (vtkPointSet* block : blocks)
  {
    const vtkIdType n = block->GetNumberOfPoints();
    const vtkIdType step = n / MostVoters + 1;
    for (vtkIdType i = 0; i < n; i += step)
    {
      double p[3];
      block->GetPoint(i, p);
      for (size_t k = 0; k < 3; ++k)
      {
        if (std::abs(p[k]) <= vtkPointSplatPacking::LargestLength)
        {
          samples[k].push_back(p[k]);
        }
      }
    }
  }
  double span = 0.0;
  for (size_t k = 0; k < 3; ++k)
  {
    std::sort(samples[k].begin(), samples[k].end());
    const size_t few = samples[k].size() / 20;
    low[k] = samples[k].empty() ? 0.0 : samples[k][few];
    high[k] = samples[k].empty() ? 0.0 : samples[k][samples[k].size() - 1 - few];
    span = std::max(span, high[k] - low[k]);
  }
  for (size_t k = 0; k < 3; ++k)
  {
    low[k] -= span;
    high[k] += span;
  }
}

/// The widest angle without any.
double GapOf(std::vector<double> angles)
{
  if (angles.empty())
  {
    return 2.0 * vtkMath::Pi();
  }
  std::sort(angles.begin(), angles.end());
  double gap = angles.front() - angles.back() + 2.0 * vtkMath::Pi();
  for (size_t i = 1; i < angles.size(); ++i)
  {
    gap = std::max(gap, angles[i] - angles[i - 1]);
  }
  return gap;
}
}

/// Of a block's points that have others' beside them.
struct vtkPointSplatPieceVotes::Votes
{
  int For = 0;
  int Against = 0;
  int Undecided = 0;
  std::vector<size_t> Named; // blocks, by those for

  bool IsPiece() const { return this->For > LeastShare * (this->For + this->Against); }
  bool MayBePiece() const
  {
    return this->IsPiece() || this->Against <= this->For + this->Undecided;
  }
};

//------------------------------------------------------------------------------
vtkPointSplatPieceVotes::vtkPointSplatPieceVotes(const std::vector<vtkPointSet*>& blocks)
{
  std::array<double, 3> low;
  std::array<double, 3> high;
  FindRange(blocks, low, high);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  this->All->SetPoints(points);
  this->Normals->SetNumberOfComponents(3);
  for (vtkPointSet* block : blocks)
  {
    this->Take(block, low, high);
    this->Ends.push_back(points->GetNumberOfPoints());
  }
  if (points->GetNumberOfPoints() > 0)
  {
    this->Locator->SetDataSet(this->All);
    this->Locator->BuildLocator();
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatPieceVotes::Take(
  vtkPointSet* block, const std::array<double, 3>& low, const std::array<double, 3>& high)
{
  vtkDataArray* normals = block->GetPointData()->GetNormals();
  const vtkSmartPointer<vtkUnsignedCharArray> ghosts = vtkPointSplatPacking::GhostsOf(block);
  for (vtkIdType i = 0; i < block->GetNumberOfPoints(); ++i)
  {
    double p[3];
    block->GetPoint(i, p);
    bool good = !ghosts || (ghosts->GetValue(i) & vtkDataSetAttributes::HIDDENPOINT) == 0;
    for (size_t k = 0; k < 3; ++k)
    {
      good = good && p[k] >= low[k] && p[k] <= high[k]; // NaN compares false
    }
    double n[3] = { 0.0, 0.0, 0.0 };
    if (normals && good)
    {
      normals->GetTuple(i, n);
      const double length = vtkMath::Normalize(n);
      good = length > 0.0 && std::isfinite(length);
    }
    if (good)
    {
      this->All->GetPoints()->InsertNextPoint(p);
      if (normals)
      {
        this->Normals->InsertNextTuple(n);
      }
    }
  }
}

//------------------------------------------------------------------------------
std::vector<std::pair<size_t, size_t>> vtkPointSplatPieceVotes::Count() const
{
  const size_t blocks = this->Ends.size();
  std::vector<Votes> votes(blocks);
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(blocks), [&](vtkIdType begin, vtkIdType end) {
    for (size_t b = static_cast<size_t>(begin); b < static_cast<size_t>(end); ++b)
    {
      this->Ask(b, votes[b]);
    }
  });
  std::vector<std::pair<size_t, size_t>> pairs;
  for (size_t b = 0; b < blocks; ++b)
  {
    for (size_t other : votes[b].Named)
    {
      if (votes[b].IsPiece() && votes[other].MayBePiece())
      {
        pairs.emplace_back(b, other);
      }
    }
  }
  return pairs;
}

//------------------------------------------------------------------------------
void vtkPointSplatPieceVotes::Ask(size_t block, Votes& votes) const
{
  const vtkIdType first = block > 0 ? this->Ends[block - 1] : 0;
  const vtkIdType voters =
    std::clamp(Voters / static_cast<vtkIdType>(this->Ends.size()), FewestVoters, MostVoters);
  const vtkIdType step = (this->Ends[block] - first) / voters + 1;
  vtkNew<vtkIdList> nearest;
  for (vtkIdType point = first; point < this->Ends[block]; point += step)
  {
    double p[3];
    this->All->GetPoint(point, p);
    this->Locator->FindClosestNPoints(NearestPoints, p, nearest);
    this->Vote(block, this->Look(point, nearest), votes);
  }
  std::sort(votes.Named.begin(), votes.Named.end());
  votes.Named.erase(std::unique(votes.Named.begin(), votes.Named.end()), votes.Named.end());
}

//------------------------------------------------------------------------------
void vtkPointSplatPieceVotes::Vote(size_t block, const std::vector<View>& around, Votes& votes)
{
  const auto others = std::partition_point(around.begin(), around.end(),
    [block](const View& view) { return view.Block == block; });
  const size_t own = static_cast<size_t>(others - around.begin());
  const size_t foreign = around.size() - own;
  if (foreign == 0)
  {
    return;
  }
  // Where its own block's points are noise, so may others' be.
  const double slope = std::max(SheetSlope, 2.0 * MiddleOf(around, own, &View::Slope));
  const double facing =
    std::min(SheetCosine, MiddleOf(around, own, &View::Facing) - (1.0 - SheetCosine));
  std::vector<double> angles;
  std::vector<double> beside;
  std::transform(around.begin(), others, std::back_inserter(angles),
    [](const View& view) { return view.Angle; });
  for (auto it = others; it != around.end(); ++it)
  {
    if (it->Facing >= facing && it->Slope <= slope)
    {
      beside.push_back(it->Angle);
    }
  }
  std::vector<double> all = angles;
  all.insert(all.end(), beside.begin(), beside.end());
  const bool goesOn = GapOf(angles) > WideGap && GapOf(all) <= WideGap;
  const bool among = own < FewOwn && 4 * beside.size() >= foreign;
  if (among || GapOf(beside) <= WideGap || goesOn)
  {
    ++votes.For;
    std::transform(others, around.end(), std::back_inserter(votes.Named),
      [](const View& view) { return view.Block; });
  }
  else
  {
    ++(2 * beside.size() < foreign ? votes.Against : votes.Undecided);
  }
}

//------------------------------------------------------------------------------
double vtkPointSplatPieceVotes::MiddleOf(const std::vector<View>& around, size_t own, double View::*what)
{
  if (own < FewOwn)
  {
    return what == &View::Facing ? 1.0 : 0.0;
  }
  std::vector<double> all;
  for (size_t i = 0; i < own; ++i)
  {
    all.push_back(around[i].*what);
  }
  std::nth_element(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(own / 2), all.end());
  return all[own / 2];
}

//------------------------------------------------------------------------------
std::vector<vtkPointSplatPieceVotes::View> vtkPointSplatPieceVotes::Look(vtkIdType point, vtkIdList* nearest) const
{
  double n[3];
  this->GetNormal(point, nearest, n);
  double s[3];
  double t[3];
  vtkMath::Perpendiculars(n, s, t, 0.0);
  double p[3];
  this->All->GetPoint(point, p);
  std::vector<View> around;
  for (vtkIdType i = 0; i < nearest->GetNumberOfIds(); ++i)
  {
    const vtkIdType other = nearest->GetId(i);
    double d[3];
    this->All->GetPoint(other, d);
    vtkMath::Subtract(d, p, d);
    const double distance = vtkMath::Norm(d);
    if (other != point)
    {
      around.push_back({ std::atan2(vtkMath::Dot(t, d), vtkMath::Dot(s, d)),
        distance > 0.0 ? std::abs(vtkMath::Dot(n, d)) / distance : 0.0,
        this->GetFacing(n, other), this->BlockOf(other) });
    }
  }
  const size_t block = this->BlockOf(point);
  std::partition(around.begin(), around.end(),
    [block](const View& view) { return view.Block == block; });
  return around;
}

//------------------------------------------------------------------------------
void vtkPointSplatPieceVotes::GetNormal(vtkIdType point, vtkIdList* nearest, double n[3]) const
{
  if (this->Normals->GetNumberOfTuples() > 0)
  {
    this->Normals->GetTuple(point, n);
    return;
  }
  double origin[3];
  vtkNew<vtkPoints> points;
  this->All->GetPoints()->GetPoints(nearest, points);
  vtkPlane::ComputeBestFittingPlane(points, origin, n);
}

//------------------------------------------------------------------------------
double vtkPointSplatPieceVotes::GetFacing(const double n[3], vtkIdType other) const
{
  double m[3] = { n[0], n[1], n[2] };
  if (this->Normals->GetNumberOfTuples() > 0)
  {
    this->Normals->GetTuple(other, m);
  }
  return vtkMath::Dot(n, m);
}

//------------------------------------------------------------------------------
size_t vtkPointSplatPieceVotes::BlockOf(vtkIdType point) const
{
  return static_cast<size_t>(
    std::upper_bound(this->Ends.begin(), this->Ends.end(), point) - this->Ends.begin());
}
