// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkParticleSurface.h"

#include "vtkDataSetAttributes.h"
#include "vtkMath.h"
#include "vtkPointSplatBatches.h"
#include "vtkSMPThreadLocal.h"

#include <algorithm>
#include <cmath>
#include <tuple>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// Points this near to one another, in cells, are not told apart by steps in single precision.
constexpr double SettledStep = 1e-4;
constexpr int MostSurfaceSteps = 12;
/// How far one step goes, and how far all of them lead, in cells.
constexpr double LongestStep = 0.5, FarthestWay = 0.95;
/// Without a wish points are 0.4 particle spacings apart.
constexpr double SpacingPerCell = 0.8;
/// Where splats would turn too far, points lie at this part of the spacing.
constexpr double DenserSpacing = 0.5;
/// Coarser spacings would let leaves of one turn see each other's points.
constexpr double CoarsestSpacing = vtkParticleSurfaceTree::CellsPerSide;

/// From its centre to its rim a splat turns by so much (radians) at most, ...
constexpr double LargestSplatTurn = 0.6;
/// ... unless it would be smaller than this part of those on planes.
constexpr double LeastRadius = 0.5;

/// The largest curvature in any direction, of a tensor across the normal.
double GetBend(const double b[6])
{
  // Its eigenvalues are 0 and two with this sum and this sum of squares.
  const double sum = b[0] + b[1] + b[2];
  const double squares = b[0] * b[0] + b[1] * b[1] + b[2] * b[2] +
    2 * (b[3] * b[3] + b[4] * b[4] + b[5] * b[5]);
  return 0.5 * (std::abs(sum) + std::sqrt(std::max(2 * squares - sum * sum, 0.0)));
}

/// The normal, and its derivative, which is that of -gradient / slope: -P H P / slope with
/// P = 1 - n n^T. Leaves the normal as it is, and returns false, where there is no slope.
bool GetCurvature(
  const vtkParticleSurfaceField::Value& value, double normal[3], double curvature[6])
{
  const double slope = vtkMath::Norm(value.Gradient);
  std::fill_n(curvature, 6, 0.0);
  if (!(slope > 0))
  {
    return false;
  }
  for (int c = 0; c < 3; ++c)
  {
    normal[c] = -value.Gradient[c] / slope;
  }
  const double* n = normal;
  const double* h = value.Hessian;
  const double hn[3] = { h[0] * n[0] + h[3] * n[1] + h[5] * n[2],
    h[3] * n[0] + h[1] * n[1] + h[4] * n[2], h[5] * n[0] + h[4] * n[1] + h[2] * n[2] };
  const double nhn = hn[0] * n[0] + hn[1] * n[1] + hn[2] * n[2];
  static const int rows[6] = { 0, 1, 2, 0, 1, 0 };
  static const int columns[6] = { 0, 1, 2, 1, 2, 2 };
  for (int k = 0; k < 6; ++k)
  {
    const int i = rows[k], j = columns[k];
    curvature[k] = -(h[k] - n[i] * hn[j] - hn[i] * n[j] + nhn * n[i] * n[j]) / slope;
  }
  return true;
}
}

bool vtkParticleSurface::Sieve::HasNear(const Sample& sample, double distance) const
{
  for (const auto& [other, thinning] : this->Thinnings)
  {
    if (thinning.HasNear(sample, std::min(distance, other)))
    {
      return true;
    }
  }
  return false;
}

void vtkParticleSurface::Sieve::Add(const Sample& sample, double distance)
{
  this->Thinnings.try_emplace(distance, distance).first->second.Add(sample);
}

vtkParticleSurface::vtkParticleSurface(const std::vector<Kernel>& kernels,
  const vtkParticleSurfaceTree& tree, double spacing, const unsigned char* ghosts)
  : Kernels(kernels)
  , Leaves(tree.GetLeaves())
  , Spacing(spacing)
  , Ghosts(ghosts)
  , Samples(tree.GetLeaves().size())
  , Bent(tree.GetLeaves().size(), 0)
{
}

double vtkParticleSurface::GetSpacing(const Leaf& leaf) const
{
  return this->Spacing > 0
    ? std::clamp(this->Spacing, FinestSpacing * leaf.Cell, CoarsestSpacing * leaf.Cell)
    : SpacingPerCell * leaf.Cell;
}

bool vtkParticleSurface::Find(vtkAlgorithm* self, double from, double to, vtkIdType& count)
{
  vtkSMPThreadLocal<Scratch> scratches;
  count = 0;
  for (std::size_t begin = 0; begin < this->Leaves.size();)
  {
    // Leaves of one turn do not reach each other, and see what turns before have found.
    auto key = [this](std::size_t l) {
      return std::make_tuple(this->Leaves[l].Cell, this->Leaves[l].Turn);
    };
    std::size_t end = begin;
    while (end < this->Leaves.size() && key(end) == key(begin))
    {
      ++end;
    }
    auto fill = [&](vtkIdType first, vtkIdType last) {
      for (vtkIdType l = first; l < last; ++l)
      {
        this->FillLeaf(begin + l, scratches.Local());
      }
    };
    const double step = (to - from) / this->Leaves.size();
    if (!vtkPointSplatBatches::For(self, static_cast<vtkIdType>(end - begin), 1,
          from + step * begin, from + step * end, fill))
    {
      return false;
    }
    for (; begin < end; ++begin)
    {
      const double distance =
        vtkIsosurfaceDivision::DistancePerSpacing * this->GetSpacing(this->Leaves[begin]);
      for (std::size_t i = 0; i < this->Samples[begin].size(); ++i)
      {
        this->Found.Add(
          this->Samples[begin][i], i < this->Bent[begin] ? distance : DenserSpacing * distance);
      }
      count += static_cast<vtkIdType>(this->Samples[begin].size());
    }
  }
  return true;
}

void vtkParticleSurface::FindCandidates(const Leaf& leaf, double spacing, Scratch& scratch) const
{
  constexpr int side = vtkParticleSurfaceTree::CellsPerSide;
  constexpr int row = vtkParticleSurfaceField::NodesPerSide;
  scratch.Candidates.clear();
  const float* nodes = scratch.Field.GetNodes().data();
  const double sides[3] = { leaf.Cell, leaf.Cell, leaf.Cell };
  const vtkIsosurfaceDivision division(sides, spacing);
  const float isovalue = static_cast<float>(vtkParticleSurfaceKernels::Isovalue);
  vtkIsosurfaceDivision::Cell cell;
  for (int k = 0; k < side; ++k)
  {
    for (int j = 0; j < side; ++j)
    {
      for (int i = 0; i < side && scratch.Field.IsNear(j, k); ++i)
      {
        if (!scratch.Wanted[i + side * (j + side * k)])
        {
          continue;
        }
        const float* at = nodes + i + row * (j + row * k);
        const float corners[8] = { at[0], at[1], at[row], at[row + 1], at[row * row],
          at[row * row + 1], at[row * row + row], at[row * row + row + 1] };
        int inside = 0;
        for (const float corner : corners)
        {
          inside += corner >= isovalue;
        }
        if (inside == 0 || inside == 8)
        {
          continue;
        }
        cell.Index[0] = i;
        cell.Index[1] = j;
        cell.Index[2] = k;
        for (int corner = 0; corner < 8; ++corner)
        {
          cell.Corners[corner] = corners[corner] - isovalue;
        }
        division.Divide(cell, scratch.Division, scratch.Candidates);
      }
    }
  }
}

void vtkParticleSurface::FillLeaf(std::size_t l, Scratch& scratch)
{
  const Leaf& leaf = this->Leaves[l];
  auto isDeep = [this](std::uint32_t k) { return this->Kernels[k].Deep; };
  if (std::all_of(leaf.Kernels.begin(), leaf.Kernels.end(), isDeep))
  {
    return;
  }
  scratch.Field.SetLeaf(leaf, this->Kernels);
  scratch.Field.EvaluateNodes();
  scratch.Wanted.fill(true);
  Sieve own;
  const double spacing = this->GetSpacing(leaf);
  this->AddPoints(l, spacing, own, scratch);
  this->Bent[l] = this->Samples[l].size();
  // A spacing that was asked for is kept.
  if (!(this->Spacing > 0) && this->MarkBent(l, scratch))
  {
    this->AddPoints(l, DenserSpacing * spacing, own, scratch);
  }
}

/// Points on the surface in the wanted cells.
void vtkParticleSurface::AddPoints(
  std::size_t l, double spacing, Sieve& own, Scratch& scratch)
{
  const Leaf& leaf = this->Leaves[l];
  const double distance = vtkIsosurfaceDivision::DistancePerSpacing * spacing;
  this->FindCandidates(leaf, spacing, scratch);
  vtkIsosurfaceThinning::Shuffle(scratch.Candidates);
  auto isFree = [&](const Sample& local, Sample& sample) {
    sample = local;
    for (int c = 0; c < 3; ++c)
    {
      sample.Position[c] += leaf.Origin[c];
    }
    return !own.HasNear(sample, distance) && !this->Found.HasNear(sample, distance);
  };
  Sample sample;
  for (Sample& candidate : scratch.Candidates)
  {
    // Most places are taken, which is sooner known than where exactly they are.
    if (!isFree(candidate, sample) || !this->Place(leaf.Cell, scratch.Field, candidate) ||
      !isFree(candidate, sample))
    {
      continue;
    }
    if (this->Ghosts)
    {
      scratch.Field.GetShares(candidate.Position, scratch.Shares);
      if (!this->IsOwn(scratch.Shares))
      {
        continue;
      }
    }
    own.Add(sample, distance);
    this->Samples[l].push_back(sample);
  }
}

/// Makes those cells the wanted ones that are at points where splats would turn too far; false if
/// there are none.
bool vtkParticleSurface::MarkBent(std::size_t l, Scratch& scratch) const
{
  constexpr int side = vtkParticleSurfaceTree::CellsPerSide;
  const Leaf& leaf = this->Leaves[l];
  const double radius = vtkIsosurfaceDivision::DistancePerSpacing * this->GetSpacing(leaf);
  scratch.Wanted.fill(false);
  bool any = false;
  vtkParticleSurfaceField::Value value;
  double normal[3], curvature[6];
  for (const Sample& sample : this->Samples[l])
  {
    double x[3];
    for (int c = 0; c < 3; ++c)
    {
      x[c] = sample.Position[c] - leaf.Origin[c];
    }
    scratch.Field.EvaluateSecond(x, value);
    if (!GetCurvature(value, normal, curvature) || !(radius * GetBend(curvature) > LargestSplatTurn))
    {
      continue;
    }
    any = true;
    int low[3], high[3];
    for (int c = 0; c < 3; ++c)
    {
      low[c] = std::clamp(static_cast<int>((x[c] - radius) / leaf.Cell), 0, side - 1);
      high[c] = std::clamp(static_cast<int>((x[c] + radius) / leaf.Cell), 0, side - 1);
    }
    for (int k = low[2]; k <= high[2]; ++k)
    {
      for (int j = low[1]; j <= high[1]; ++j)
      {
        for (int i = low[0]; i <= high[0]; ++i)
        {
          scratch.Wanted[i + side * (j + side * k)] = true;
        }
      }
    }
  }
  return any;
}

/// Newton steps along the gradient onto the surface; false where they do not settle.
bool vtkParticleSurface::Place(
  double cell, vtkParticleSurfaceField& field, Sample& sample) const
{
  const double start[3] = { sample.Position[0], sample.Position[1], sample.Position[2] };
  vtkParticleSurfaceField::Value value;
  for (int step = 0; step < MostSurfaceSteps; ++step)
  {
    field.Evaluate(sample.Position, value);
    const double slope = vtkMath::Norm(value.Gradient);
    const double difference = value.Sum - vtkParticleSurfaceKernels::Isovalue;
    if (!(slope > 0))
    {
      return false;
    }
    const double move = std::clamp(difference / slope, -LongestStep * cell, LongestStep * cell);
    double moved[3];
    for (int c = 0; c < 3; ++c)
    {
      sample.Position[c] -= move * value.Gradient[c] / slope;
      sample.Side[c] = static_cast<float>(value.Gradient[c] / slope);
      moved[c] = sample.Position[c] - start[c];
    }
    if (!(vtkMath::Norm(moved) <= FarthestWay * cell))
    {
      return false;
    }
    if (std::abs(move) <= SettledStep * cell)
    {
      return true;
    }
  }
  return false;
}

/// Of several processes the one whose particle has the largest share.
bool vtkParticleSurface::IsOwn(const std::vector<Share>& shares) const
{
  auto lesser = [](const Share& a, const Share& b) {
    return a.Weight < b.Weight || (a.Weight == b.Weight && a.Id > b.Id);
  };
  const auto largest = std::max_element(shares.begin(), shares.end(), lesser);
  return largest != shares.end() &&
    !(this->Ghosts[largest->Id] & vtkDataSetAttributes::DUPLICATEPOINT);
}

void vtkParticleSurface::Describe(
  std::size_t l, std::size_t i, Scratch& scratch, Point& point) const
{
  const Leaf& leaf = this->Leaves[l];
  const Sample& sample = this->Samples[l][i];
  double x[3];
  for (int c = 0; c < 3; ++c)
  {
    x[c] = sample.Position[c] - leaf.Origin[c];
    point.Position[c] = sample.Position[c];
    point.Normal[c] = -sample.Side[c];
  }
  vtkParticleSurfaceField::Value value;
  scratch.Field.EvaluateSecond(x, value);
  GetCurvature(value, point.Normal, point.Curvature);
  // No place on the surface is farther from a point than points are from one another at least.
  // Where it bends strongly points lie on all sides, and disks as large would stand out.
  const double full = vtkIsosurfaceDivision::DistancePerSpacing * this->GetSpacing(leaf) *
    (i < this->Bent[l] ? 1.0 : DenserSpacing);
  const double turn = full * GetBend(point.Curvature);
  point.Radius = full * std::clamp(LargestSplatTurn / turn, LeastRadius, 1.0);
  scratch.Field.GetShares(x, scratch.Shares);
  point.Shares = &scratch.Shares;
}

bool vtkParticleSurface::Write(
  vtkAlgorithm* self, double from, double to, const Writer& write) const
{
  std::vector<vtkIdType> first(this->Leaves.size() + 1, 0);
  for (std::size_t l = 0; l < this->Leaves.size(); ++l)
  {
    first[l + 1] = first[l] + static_cast<vtkIdType>(this->Samples[l].size());
  }
  vtkSMPThreadLocal<Scratch> scratches;
  auto describe = [&](vtkIdType begin, vtkIdType end) {
    Scratch& scratch = scratches.Local();
    Point point;
    for (vtkIdType l = begin; l < end; ++l)
    {
      if (this->Samples[l].empty())
      {
        continue;
      }
      scratch.Field.SetLeaf(this->Leaves[l], this->Kernels);
      for (std::size_t i = 0; i < this->Samples[l].size(); ++i)
      {
        this->Describe(l, i, scratch, point);
        write(first[l] + static_cast<vtkIdType>(i), point);
      }
    }
  };
  return vtkPointSplatBatches::For(
    self, static_cast<vtkIdType>(this->Leaves.size()), 1, from, to, describe);
}

VTK_ABI_NAMESPACE_END
