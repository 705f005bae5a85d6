// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatCoverage.h"

#include "vtkMath.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>
#include <tuple>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
using Index = vtkPointSplatOverlap::Index;

constexpr std::size_t ManySplats = 50000;
constexpr int ManySamples = 256;
constexpr int FewSamples = 64;
// The cosine of the angle between normals past which disks are of different sheets.
constexpr double SameSheet = 0.3;
// How near the covered area must come to the surface's, as a share of it, and in how many steps.
constexpr double AreaTolerance = 0.0025;
constexpr int MostSteps = 40;

using Mask = std::array<std::uint64_t, ManySamples / 64>;

int CountBits(const Mask& mask)
{
  int count = 0;
  for (std::uint64_t word : mask)
  {
    for (; word; word &= word - 1)
    {
      ++count;
    }
  }
  return count;
}
}

//------------------------------------------------------------------------------
vtkPointSplatCoverage::vtkPointSplatCoverage(
  const double* positions, const double* normals, const double* radii, Index count)
  : Positions(positions)
  , Normals(normals)
  , Radii(radii)
  , Count(count)
{
  // A sunflower: the k-th point at a radius that gives each the same area.
  const int samples = count > ManySplats ? FewSamples : ManySamples;
  const double golden = vtkMath::Pi() * (3 - std::sqrt(5.0));
  for (int k = 0; k < samples; ++k)
  {
    const double r = std::sqrt((k + 0.5) / samples);
    this->Samples.push_back(r * std::cos(k * golden));
    this->Samples.push_back(r * std::sin(k * golden));
  }
  std::vector<Index> all(count);
  std::iota(all.begin(), all.end(), 0);
  this->SurfaceArea = this->CoveredArea(all, 1.0);
}

//------------------------------------------------------------------------------
void vtkPointSplatCoverage::Axes(Index i, double axes[2][3]) const
{
  vtkMath::Perpendiculars(this->Normals + 3 * std::size_t(i), axes[0], axes[1], 0.0);
}

//------------------------------------------------------------------------------
template <typename Visit>
void vtkPointSplatCoverage::EachCovered(
  Index i, Index j, double scale, const double axes[2][3], const Visit& visit) const
{
  const double* n = this->Normals + 3 * std::size_t(i);
  const double* m = this->Normals + 3 * std::size_t(j);
  const double* p = this->Positions + 3 * std::size_t(i);
  const double* q = this->Positions + 3 * std::size_t(j);
  const double r = scale * this->Radii[i];
  const double R = scale * this->Radii[j];
  const double facing = vtkMath::Dot(n, m);
  const double d[3] = { p[0] - q[0], p[1] - q[1], p[2] - q[2] };
  if (std::abs(facing) < SameSheet || std::abs(vtkMath::Dot(d, n)) > r + R)
  {
    return;
  }
  // From a point d + x of disk i, t n leads to the plane of disk j, where t is linear in x.
  const double s = 1 / facing;
  const double t0 = -vtkMath::Dot(d, m) * s;
  const double ta = -r * vtkMath::Dot(axes[0], m) * s;
  const double tb = -r * vtkMath::Dot(axes[1], m) * s;
  double base[3];
  double along[2][3];
  for (int k = 0; k < 3; ++k)
  {
    base[k] = d[k] + t0 * n[k];
    along[0][k] = r * axes[0][k] + ta * n[k];
    along[1][k] = r * axes[1][k] + tb * n[k];
  }
  // |base + u along0 + v along1|^2 as a polynomial in u and v.
  const double c = vtkMath::Dot(base, base) - R * R;
  const double cu = 2 * vtkMath::Dot(base, along[0]);
  const double cv = 2 * vtkMath::Dot(base, along[1]);
  const double cuu = vtkMath::Dot(along[0], along[0]);
  const double cvv = vtkMath::Dot(along[1], along[1]);
  const double cuv = 2 * vtkMath::Dot(along[0], along[1]);
  const std::size_t samples = this->Samples.size() / 2;
  for (std::size_t k = 0; k < samples; ++k)
  {
    const double u = this->Samples[2 * k];
    const double v = this->Samples[2 * k + 1];
    visit(k, c + u * (cu + cuu * u + cuv * v) + v * (cv + cvv * v) < 0 ? 1 : 0);
  }
}

//------------------------------------------------------------------------------
double vtkPointSplatCoverage::CoveredArea(const std::vector<Index>& group, double scale) const
{
  const Index count = static_cast<Index>(group.size());
  std::vector<double> positions(3 * group.size());
  std::vector<double> radii(group.size());
  for (Index g = 0; g < count; ++g)
  {
    std::copy_n(this->Positions + 3 * std::size_t(group[g]), 3, &positions[3 * std::size_t(g)]);
    radii[g] = scale * this->Radii[group[g]];
  }
  vtkPointSplatOverlap graph;
  if (!graph.Build(positions.data(), radii.data(), count, 1.0,
        std::numeric_limits<std::size_t>::max()))
  {
    return 0;
  }
  std::vector<double> shares(group.size());
  vtkSMPTools::For(0, count, [&](vtkIdType begin, vtkIdType end) {
    std::array<int, ManySamples> covers;
    for (vtkIdType g = begin; g < end; ++g)
    {
      const Index i = group[g];
      double axes[2][3];
      this->Axes(i, axes);
      covers.fill(1);
      for (const Index* j = graph.begin(static_cast<Index>(g));
           j != graph.end(static_cast<Index>(g)); ++j)
      {
        this->EachCovered(
          i, group[*j], scale, axes, [&covers](std::size_t k, int covered) { covers[k] += covered; });
      }
      double sum = 0;
      const std::size_t samples = this->Samples.size() / 2;
      for (std::size_t k = 0; k < samples; ++k)
      {
        sum += 1.0 / covers[k];
      }
      shares[g] = vtkMath::Pi() * radii[g] * radii[g] * sum / samples;
    }
  });
  return std::accumulate(shares.begin(), shares.end(), 0.0);
}

//------------------------------------------------------------------------------
double vtkPointSplatCoverage::Enlarge(const std::vector<Index>& group, double mostScale) const
{
  // Equation 9, with the clipped area as the difference between the disks' own area n pi r^2 and
  // what they cover: n pi r'^2 = A + n pi r^2 - Covered(r). Its steps become short long before
  // the end, so two of them are extended to where the line through them has no difference left.
  double own = 0;
  for (const Index i : group)
  {
    own += vtkMath::Pi() * this->Radii[i] * this->Radii[i];
  }
  const double most = mostScale * mostScale;
  double square = 1; // of the scale
  double before = 0;
  double missingBefore = 0;
  for (int step = 0; step < MostSteps && !group.empty(); ++step)
  {
    const double missing =
      this->SurfaceArea - this->CoveredArea(group, std::sqrt(square));
    if (std::abs(missing) <= AreaTolerance * this->SurfaceArea || (missing < 0 && square <= 1) ||
      (missing > 0 && square >= most))
    {
      break;
    }
    double next = square + missing / own;
    if (step > 0 && missingBefore != missing)
    {
      const double secant = square + missing * (square - before) / (missingBefore - missing);
      // Not past twice the plain step's reach many times over: near full cover the line is flat.
      next = (secant > square) == (missing > 0) ? std::min(secant, square + 8 * missing / own) : next;
    }
    before = square;
    missingBefore = missing;
    square = std::clamp(next, 1.0, most);
  }
  return std::sqrt(square);
}

//------------------------------------------------------------------------------
std::vector<Index> vtkPointSplatCoverage::Fill(
  const std::vector<Index>& group, const vtkPointSplatOverlap& graph, double mostClipped) const
{
  std::vector<unsigned char> inside(this->Count, 0);
  for (const Index i : group)
  {
    inside[i] = 1;
  }
  std::vector<Mask> clipped(this->Count);
  auto clip = [&](Index i, Index j) {
    double axes[2][3];
    this->Axes(i, axes);
    Mask& mask = clipped[i];
    this->EachCovered(i, j, 1.0, axes, [&mask](std::size_t k, int covered) {
      mask[k / 64] |= static_cast<std::uint64_t>(covered) << (k % 64);
    });
  };
  vtkSMPTools::For(0, this->Count, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType v = begin; v < end; ++v)
    {
      const Index i = static_cast<Index>(v);
      clipped[i].fill(0);
      for (const Index* j = graph.begin(i); !inside[i] && j != graph.end(i); ++j)
      {
        if (inside[*j])
        {
          clip(i, *j);
        }
      }
    }
  });

  // Most clipped first, of equals the one with the least index.
  using Entry = std::tuple<int, Index>;
  auto later = [](const Entry& a, const Entry& b) {
    return std::get<0>(a) != std::get<0>(b) ? std::get<0>(a) < std::get<0>(b)
                                            : std::get<1>(a) > std::get<1>(b);
  };
  std::vector<Entry> start;
  for (Index i = 0; i < this->Count; ++i)
  {
    if (!inside[i])
    {
      start.emplace_back(CountBits(clipped[i]), i);
    }
  }
  std::priority_queue<Entry, std::vector<Entry>, decltype(later)> queue(later, std::move(start));
  const int most = static_cast<int>(mostClipped * (this->Samples.size() / 2));
  std::vector<Index> added;
  while (!queue.empty())
  {
    const int old = std::get<0>(queue.top());
    const Index i = std::get<1>(queue.top());
    queue.pop();
    const int now = CountBits(clipped[i]);
    if (now > most)
    {
      continue;
    }
    if (now != old)
    {
      queue.emplace(now, i);
      continue;
    }
    added.push_back(i);
    inside[i] = 1;
    for (const Index* j = graph.begin(i); j != graph.end(i); ++j)
    {
      if (!inside[*j])
      {
        clip(*j, i);
      }
    }
  }
  return added;
}

VTK_ABI_NAMESPACE_END
