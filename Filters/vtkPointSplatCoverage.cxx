// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatCoverage.h"

#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPointSplatThreads.h"
#include "vtkPolyData.h"
#include "vtkSMPThreadLocalObject.h"
#include "vtkSMPThreadLocal.h"
#include "vtkStaticPointLocator.h"

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

constexpr std::size_t ManySplats = 2000;
constexpr int ManySamples = 256;
constexpr int FewSamples = 64;
// The cosine of the angle between normals past which disks are of different sheets.
constexpr double SameSheet = 0.3;
// The share of the surface's area that a group whose radii are enlarged may leave bare: with three times
// that, gaps show as spots in the shadows of TestSplatsShadows.
constexpr double AreaTolerance = 0.0025;
constexpr Index MostMeasured = 4096;
// Of a group's splats the nearest this many are looked at to tell which of them covers a point first;
// those that overlap the point's disk are looked at besides, since they may be large.
constexpr int Nearest = 16;

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
vtkPointSplatCoverage::vtkPointSplatCoverage(const double* positions, const double* normals,
  const double* radii, const vtkPointSplatOverlap& graph)
  : Positions(positions)
  , Normals(normals)
  , Radii(radii)
  , Graph(graph)
  , Count(graph.GetNumberOfSplats())
{
  // A sunflower: the k-th point at a radius that gives each the same area.
  const std::size_t samples = this->Count > ManySplats ? FewSamples : ManySamples;
  const double golden = vtkMath::Pi() * (3 - std::sqrt(5.0));
  for (std::size_t k = 0; k < samples; ++k)
  {
    const double r = std::sqrt((k + 0.5) / samples);
    this->Samples.push_back(r * std::cos(k * golden));
    this->Samples.push_back(r * std::sin(k * golden));
  }
  this->Measured.resize(std::min(this->Count, MostMeasured));
  std::iota(this->Measured.begin(), this->Measured.end(), 0);
  for (Index m = 0; this->Count > MostMeasured && m < MostMeasured; ++m)
  {
    // By the golden section, so that no row of a regular sampling is met again and again.
    const double part = std::fmod(0.6180339887498949 * (m + 1.0), 1.0);
    this->Measured[m] = std::min(static_cast<Index>(part * this->Count), this->Count - 1);
  }
  this->Weights.resize(this->Measured.size() * samples);
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(this->Measured.size()),
    [this, samples](vtkIdType begin, vtkIdType end) {
      std::array<int, ManySamples> covers;
      for (vtkIdType m = begin; m < end; ++m)
      {
        const Index i = this->Measured[static_cast<std::size_t>(m)];
        double axes[2][3];
        this->Axes(i, axes);
        covers.fill(1);
        for (const Index* j = this->Graph.begin(i); j != this->Graph.end(i); ++j)
        {
          this->EachDistance(i, *j, axes,
            [&covers](std::size_t k, double squared) { covers[k] += squared < 1.0 ? 1 : 0; });
        }
        for (std::size_t k = 0; k < samples; ++k)
        {
          this->Weights[static_cast<std::size_t>(m) * samples + k] =
            this->Radii[i] * this->Radii[i] / covers[k];
        }
      }
    });
  this->Area = std::accumulate(this->Weights.begin(), this->Weights.end(), 0.0);
}

//------------------------------------------------------------------------------
void vtkPointSplatCoverage::Axes(Index i, double axes[2][3]) const
{
  vtkMath::Perpendiculars(this->Normals + 3 * std::size_t(i), axes[0], axes[1], 0.0);
}

//------------------------------------------------------------------------------
template <typename Visit>
void vtkPointSplatCoverage::EachDistance(
  Index i, Index j, const double axes[2][3], const Visit& visit) const
{
  const double* n = this->Normals + 3 * std::size_t(i);
  const double* m = this->Normals + 3 * std::size_t(j);
  const double* p = this->Positions + 3 * std::size_t(i);
  const double* q = this->Positions + 3 * std::size_t(j);
  const double r = this->Radii[i];
  const double R = this->Radii[j];
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
  // |base + u along0 + v along1|^2 / R^2 as a polynomial in u and v.
  const double unit = 1 / (R * R);
  const double c = unit * vtkMath::Dot(base, base);
  const double cu = 2 * unit * vtkMath::Dot(base, along[0]);
  const double cv = 2 * unit * vtkMath::Dot(base, along[1]);
  const double cuu = unit * vtkMath::Dot(along[0], along[0]);
  const double cvv = unit * vtkMath::Dot(along[1], along[1]);
  const double cuv = 2 * unit * vtkMath::Dot(along[0], along[1]);
  const std::size_t samples = this->Samples.size() / 2;
  for (std::size_t k = 0; k < samples; ++k)
  {
    const double u = this->Samples[2 * k];
    const double v = this->Samples[2 * k + 1];
    visit(k, c + u * (cu + cuu * u + cuv * v) + v * (cv + cvv * v));
  }
}

//------------------------------------------------------------------------------
vtkPointSplatCoverage::Cover vtkPointSplatCoverage::Measure(const std::vector<Index>& group) const
{
  Cover cover;
  std::vector<unsigned char> inside(this->Count, 0);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Index i : group)
  {
    inside[i] = 1;
    points->InsertNextPoint(this->Positions + 3 * std::size_t(i));
  }
  if (group.empty())
  {
    return cover;
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(data);
  locator->BuildLocator();

  // By how much the group's disks must grow, squared.
  const std::size_t samples = this->Samples.size() / 2;
  std::vector<double> needed(this->Weights.size(), std::numeric_limits<double>::infinity());
  vtkSMPThreadLocalObject<vtkIdList> lists;
  vtkPointSplatThreads::For(
    0, static_cast<vtkIdType>(this->Measured.size()), [&](vtkIdType begin, vtkIdType end) {
      vtkIdList* nearest = lists.Local();
      for (vtkIdType m = begin; m < end; ++m)
      {
        const Index i = this->Measured[static_cast<std::size_t>(m)];
        double* least = &needed[static_cast<std::size_t>(m) * samples];
        double axes[2][3];
        this->Axes(i, axes);
        const auto look = [&](Index j) {
          this->EachDistance(i, j, axes, [least](std::size_t k, double squared) {
            least[k] = std::min(least[k], squared);
          });
        };
        if (inside[i])
        {
          look(i);
        }
        for (const Index* j = this->Graph.begin(i); j != this->Graph.end(i); ++j)
        {
          if (inside[*j])
          {
            look(*j);
          }
        }
        locator->FindClosestNPoints(Nearest, this->Positions + 3 * std::size_t(i), nearest);
        for (vtkIdType n = 0; n < nearest->GetNumberOfIds(); ++n)
        {
          look(group[static_cast<std::size_t>(nearest->GetId(n))]);
        }
      }
    });
  std::vector<std::size_t> order(needed.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&needed](std::size_t a, std::size_t b) {
    return needed[a] != needed[b] ? needed[a] < needed[b] : a < b;
  });
  cover.Shares.reserve(order.size());
  double sum = 0;
  for (const std::size_t k : order)
  {
    sum += this->Weights[k] / this->Area;
    cover.Shares.emplace_back(std::sqrt(needed[k]), sum);
  }
  return cover;
}

//------------------------------------------------------------------------------
double vtkPointSplatCoverage::Cover::GetShare(double scale) const
{
  const auto behind = std::upper_bound(this->Shares.begin(), this->Shares.end(), scale,
    [](double value, const std::pair<double, double>& entry) { return value < entry.first; });
  return behind == this->Shares.begin() ? 0.0 : (behind - 1)->second;
}

//------------------------------------------------------------------------------
double vtkPointSplatCoverage::Cover::GetFullScale(double mostScale) const
{
  for (const auto& entry : this->Shares)
  {
    if (entry.second >= 1.0 - AreaTolerance)
    {
      return std::clamp(entry.first, 1.0, mostScale);
    }
  }
  return 1.0; // nothing is there to cover
}

//------------------------------------------------------------------------------
std::vector<Index> vtkPointSplatCoverage::Fill(
  const std::vector<Index>& group, double mostClipped) const
{
  const vtkPointSplatOverlap& graph = this->Graph;
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
    this->EachDistance(i, j, axes, [&mask](std::size_t k, double squared) {
      mask[k / 64] |= static_cast<std::uint64_t>(squared < 1.0 ? 1 : 0) << (k % 64);
    });
  };
  vtkPointSplatThreads::For(0, this->Count, [&](vtkIdType begin, vtkIdType end) {
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
