// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatLatticeFrame.h"

#include "vtkMath.h"
#include "vtkPointSplatLatticePlanes.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// A window has so many points, and so many times three of them are taken.
constexpr std::size_t PointsOfWindow = 64;
constexpr int TimesThree = 1024;
/// So many windows, at most, are looked at: some lie on a flat face, which tells no more than its own plane, ...
constexpr std::size_t MostWindows = 16;
/// ... and so many suffice that have others.
constexpr int EnoughWindows = 4;
/// The part of a window's points, at least, that are on parallel planes with others, and of all points: of flat bodies few lie on
/// planes along these; and how many planes.
constexpr double LeastShared = 0.25;
constexpr double LeastOfAll = 0.05;
constexpr std::size_t LeastPlanes = 3;
/// Directions that are kept, and frames that are tried.
constexpr std::size_t MostDirections = 8;
constexpr int MostFrames = 8;
/// So many times as many points may share planes by chance as of points that are anywhere.
constexpr double ByChance = 4;
/// Three points tell their plane if the sine of the angle at one is at least this.
constexpr double LeastSine = 0.3;
/// Sines of directions that are the same, and cosines of those that are perpendicular, are less.
constexpr double Same = 1e-3;
/// Planes are fitted to so many points first, and then to four times as many, and so on, up to about so many.
constexpr std::size_t FirstFitted = 256;
constexpr std::size_t MostFitted = 4096; // this and the others: Testing/Cxx/TestSplatLattice.cxx

template <typename Directions>
void KeepBest(Directions& all)
{
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.Score > b.Score; });
  all.erase(all.begin() + std::min(all.size(), MostDirections), all.end());
}

/// Adds products of offsets of points from their middle.
template <typename Iterator>
void AddProducts(Iterator first, Iterator last, double sum[3][3])
{
  double mean[3] = { 0, 0, 0 };
  for (auto at = first; at != last; ++at)
  {
    vtkMath::Add(mean, at->second->X, mean);
  }
  vtkMath::MultiplyScalar(mean, 1.0 / static_cast<double>(last - first));
  for (auto at = first; at != last; ++at)
  {
    double offset[3];
    vtkMath::Subtract(at->second->X, mean, offset);
    for (int k = 0; k < 9; ++k)
    {
      sum[k / 3][k % 3] += offset[k / 3] * offset[k % 3];
    }
  }
}
}

//------------------------------------------------------------------------------
double vtkPointSplatLatticeFrame::Vector::Dot(const Vector& other) const
{
  return vtkMath::Dot(this->X, other.X);
}

vtkPointSplatLatticeFrame::Vector vtkPointSplatLatticeFrame::Vector::Cross(const Vector& other) const
{
  Vector product;
  vtkMath::Cross(this->X, other.X, product.X);
  return product;
}

//------------------------------------------------------------------------------
bool vtkPointSplatLatticeFrame::Direction::IsLike(const Vector& other) const
{
  const double cosine = this->Across.Dot(other);
  return 1 - cosine * cosine < Same * Same;
}

bool vtkPointSplatLatticeFrame::Direction::HasPlanes(double least) const
{
  return static_cast<double>(this->Shared) >= least && this->Planes >= LeastPlanes;
}

void vtkPointSplatLatticeFrame::Direction::Count(const std::vector<Vector>& points, double tolerance)
{
  std::vector<std::pair<double, const Vector*>> along;
  along.reserve(points.size());
  for (const Vector& point : points)
  {
    along.push_back({ this->Across.Dot(point), &point });
  }
  std::sort(along.begin(), along.end());
  this->Shared = this->Planes = this->Largest = 0;
  std::fill_n(this->Products[0], 9, 0.0);
  const auto getCoordinate = [](const auto& point) { return point.first; };
  vtkPointSplatLatticePlanes::Visit(along, tolerance, getCoordinate, [this](auto first, auto last) {
    const std::size_t count = last - first;
    if (count > 1)
    {
      this->Shared += count;
      this->Largest = std::max(this->Largest, count);
      ++this->Planes;
      AddProducts(first, last, this->Products);
    }
  });
  const double all = static_cast<double>(points.size());
  const double extent = std::max(along.back().first - along.front().first, tolerance);
  const double byChance = ByChance * all * all * 2 * tolerance / extent;
  this->Shared -= static_cast<std::size_t>(std::min<double>(byChance, this->Shared));
}

void vtkPointSplatLatticeFrame::Direction::Fit()
{
  double variances[3], axes[3][3];
  vtkMath::Diagonalize3x3(this->Products, variances, axes);
  const int least = static_cast<int>(std::min_element(variances, variances + 3) - variances);
  for (int c = 0; c < 3; ++c)
  {
    this->Across.X[c] = axes[c][least];
  }
}

//------------------------------------------------------------------------------
/// The points nearest to one.
std::vector<vtkPointSplatLatticeFrame::Vector> vtkPointSplatLatticeFrame::GetWindow(
  const std::vector<double>& positions, const std::vector<unsigned char>& used, const Vector& center)
{
  std::vector<std::pair<double, std::size_t>> nearest; // a heap
  for (std::size_t id = 0; id < used.size(); ++id)
  {
    const double distance = vtkMath::Distance2BetweenPoints(positions.data() + 3 * id, center.X);
    if (!used[id] || (nearest.size() == PointsOfWindow && distance >= nearest.front().first))
    {
      continue;
    }
    if (nearest.size() == PointsOfWindow)
    {
      std::pop_heap(nearest.begin(), nearest.end());
      nearest.pop_back();
    }
    nearest.push_back({ distance, id });
    std::push_heap(nearest.begin(), nearest.end());
  }
  std::vector<Vector> window(nearest.size());
  for (std::size_t i = 0; i < nearest.size(); ++i)
  {
    std::copy_n(positions.data() + 3 * nearest[i].second, 3, window[i].X);
  }
  return window;
}

/// Adds directions across planes that a window's points lie on; returns whether there are any, if only that of a flat face.
bool vtkPointSplatLatticeFrame::LookAt(const Vector& center, const std::vector<Vector>& window)
{
  const double least = LeastShared * static_cast<double>(window.size());
  std::vector<Direction> found;
  bool any = false;
  std::minstd_rand random; // the same each time
  for (int k = 0; k < TimesThree; ++k)
  {
    const Vector &a = window[random() % window.size()], &b = window[random() % window.size()],
                 &c = window[random() % window.size()];
    Vector u, v;
    vtkMath::Subtract(b.X, a.X, u.X);
    vtkMath::Subtract(c.X, a.X, v.X);
    Direction direction(u.Cross(v), center);
    const double length = vtkMath::Normalize(direction.Across.X);
    const auto isLike = [&](const Direction& other) { return other.IsLike(direction.Across); };
    if (!(length > LeastSine * std::sqrt(u.Dot(u) * v.Dot(v))) || std::any_of(found.begin(), found.end(), isLike))
    {
      continue;
    }
    direction.Count(window, this->Tolerance);
    any = any || std::max(direction.Shared, direction.Largest) >= least;
    if (direction.HasPlanes(least))
    {
      direction.Fit();
      direction.Count(window, this->Tolerance);
      if (direction.HasPlanes(least))
      {
        direction.Score = static_cast<double>(direction.Shared) - static_cast<double>(direction.Planes);
        found.push_back(direction);
      }
    }
  }
  this->Windows += found.empty() ? 0 : 1;
  KeepBest(found);
  for (const Direction& direction : found)
  {
    const auto known = std::find_if(this->Directions.begin(), this->Directions.end(),
      [&](const Direction& other) { return other.IsLike(direction.Across); });
    if (known == this->Directions.end())
    {
      this->Directions.push_back(direction);
    }
    else
    {
      known->Score += direction.Score;
    }
  }
  return any;
}

/// Fits a direction to the sample, from near to far; returns false where it is one of some places only, or becomes a known one.
bool vtkPointSplatLatticeFrame::FitToAll(Direction& direction, const std::vector<Direction>& known) const
{
  std::vector<std::pair<double, const Vector*>> order;
  const std::size_t stride = 1 + this->Sample.size() / MostFitted;
  for (std::size_t i = 0; i < this->Sample.size(); i += stride)
  {
    const Vector& point = this->Sample[i];
    order.push_back({ vtkMath::Distance2BetweenPoints(point.X, direction.Near.X), &point });
  }
  std::vector<Vector> fitted;
  for (std::size_t count = FirstFitted; fitted.size() < order.size(); count *= 4)
  {
    const auto first = order.begin() + fitted.size(), last = order.begin() + std::min(count, order.size());
    std::nth_element(first, last, order.end());
    std::transform(first, last, std::back_inserter(fitted), [](const auto& point) { return *point.second; });
    direction.Count(fitted, this->Tolerance);
    direction.Fit();
    const auto isLike = [&](const Direction& other) { return other.IsLike(direction.Across); };
    if (!direction.HasPlanes(LeastOfAll * static_cast<double>(fitted.size())) ||
      std::any_of(known.begin(), known.end(), isLike))
    {
      return false;
    }
  }
  return true;
}

/// The volume of a voxel of the lattice along axes, or 0 where there is none.
double vtkPointSplatLatticeFrame::GetVoxel(const Vector axes[3]) const
{
  std::vector<double> along[3];
  for (int c = 0; c < 3; ++c)
  {
    along[c].reserve(this->Sample.size());
    for (const Vector& point : this->Sample)
    {
      along[c].push_back(axes[c].Dot(point));
    }
  }
  vtkPointSplatLatticePlanes planes[3];
  return vtkPointSplatLatticePlanes::Choose(along, planes);
}

/// Of perpendicular pairs of directions the one whose voxels are the largest, and larger than those along the coordinates' axes.
bool vtkPointSplatLatticeFrame::Choose()
{
  KeepBest(this->Directions);
  std::vector<Direction> fitted;
  for (Direction& direction : this->Directions)
  {
    if (this->FitToAll(direction, fitted))
    {
      fitted.push_back(direction);
    }
  }
  const Vector along[3] = { { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } };
  const double least = fitted.size() > 1 ? this->GetVoxel(along) : 0.0;
  double largest = least;
  int tried = 0;
  for (std::size_t i = 0; i < fitted.size(); ++i)
  {
    for (std::size_t j = 0; j < i && tried < MostFrames; ++j)
    {
      const Vector &first = fitted[j].Across, &second = fitted[i].Across;
      if (std::abs(first.Dot(second)) > Same)
      {
        continue;
      }
      Vector third = first.Cross(second);
      vtkMath::Normalize(third.X);
      const Vector axes[3] = { first, third.Cross(first), third };
      ++tried;
      const double voxel = this->GetVoxel(axes);
      if (voxel > largest * (1 + Same))
      {
        largest = voxel;
        std::copy_n(axes, 3, this->Axes);
      }
    }
  }
  return largest > least;
}

/// Puts the axes in the order of the coordinates that they are along, right-handed.
void vtkPointSplatLatticeFrame::Order()
{
  for (int c = 0; c < 2; ++c)
  {
    std::swap(this->Axes[c], *std::max_element(this->Axes + c, this->Axes + 3, [c](const Vector& a, const Vector& b) {
      return std::abs(a.X[c]) < std::abs(b.X[c]);
    }));
    vtkMath::MultiplyScalar(this->Axes[c].X, this->Axes[c].X[c] < 0 ? -1.0 : 1.0);
  }
  this->Axes[2] = this->Axes[0].Cross(this->Axes[1]);
}

bool vtkPointSplatLatticeFrame::Find(const std::vector<double>& positions, const std::vector<unsigned char>& used)
{
  std::vector<double> samples[3];
  vtkPointSplatLatticePlanes::Sample(positions, used, samples);
  const std::size_t count = samples[0].size();
  if (count < PointsOfWindow)
  {
    return false;
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    this->Sample.push_back({ { samples[0][i], samples[1][i], samples[2][i] } });
  }
  this->Tolerance = vtkPointSplatLatticePlanes::GetTolerance(samples);
  for (std::size_t k = 0; k < MostWindows && this->Windows < EnoughWindows; ++k)
  {
    const Vector& center = this->Sample[(2 * k + 1) * count / (2 * MostWindows)];
    if (!this->LookAt(center, vtkPointSplatLatticeFrame::GetWindow(positions, used, center)))
    {
      return false;
    }
  }
  if (!this->Choose())
  {
    return false;
  }
  this->Order();
  return true;
}

template <typename Number>
std::vector<Number> vtkPointSplatLatticeFrame::Turn(const std::vector<Number>& vectors) const
{
  std::vector<Number> turned(vectors.size());
  for (std::size_t i = 0; i < vectors.size(); i += 3)
  {
    for (int c = 0; c < 3; ++c)
    {
      const double* axis = this->Axes[c].X;
      turned[i + c] = static_cast<Number>(axis[0] * vectors[i] + axis[1] * vectors[i + 1] + axis[2] * vectors[i + 2]);
    }
  }
  return turned;
}

template std::vector<float> vtkPointSplatLatticeFrame::Turn(const std::vector<float>&) const;
template std::vector<double> vtkPointSplatLatticeFrame::Turn(const std::vector<double>&) const;

VTK_ABI_NAMESPACE_END
