// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatLatticePlanes.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// So many points, about, are looked at.
constexpr std::size_t MostSampled = 1 << 14;
/// The part of coordinates, at least, that others share: of a flat body's isosurface few lie on planes along it.
constexpr double LeastRepeated = 0.05;
/// How many coordinates, at least, tell distances from plane to plane; how many of these are tried, from how many coordinates
/// that no planes tried before have.
constexpr std::size_t LeastOften = 8;
constexpr std::size_t MostDistances = 8;
constexpr std::size_t MostTried = 4;
/// Distances are kept by which this part of the coordinates are planes' that are by the best one: by half of the right
/// distance, or as far as flat faces are from planes, more of them are than by the right one.
constexpr double LikeBest = 0.3; // this and the others: Testing/Cxx/TestSplatLattice.cxx
/// A plane's coordinates are the same but for rounding, of the largest one; and no plane is found where so many times that
/// is as much as the distance to the next.
constexpr double Rounding = 4e-7;
constexpr double LeastStep = 100;
/// All points of a mask, and more of its cut's, are on planes half as far apart as well; what leaves out more than so many times what
/// others do is no lattice.
constexpr std::size_t LikeLeastOff = 4;
/// A coordinate that is farther from the first plane, in distances, is none.
constexpr double MostPlanes = 1e9;

struct Value
{
  double X;
  std::size_t Count;
};

/// The coordinates, LeastOften or more, that half of the points have that share theirs, in the order of how many do.
std::vector<double> GetOften(const std::vector<Value>& values, double power)
{
  const auto getWeight = [power](const Value& value) {
    return value.Count > 1 ? std::pow(static_cast<double>(value.Count), power) : 0.0;
  };
  double all = 0, sum = 0;
  for (const Value& value : values)
  {
    all += getWeight(value);
  }
  std::vector<double> often;
  for (std::size_t i = 0; i < values.size() && (2 * sum < all || i < LeastOften); ++i)
  {
    often.push_back(values[i].X);
    sum += getWeight(values[i]);
  }
  return often;
}

/// The distances from a coordinate to the next that occur most often, and twice these: a mask's coordinates are those of planes
/// and half way between.
std::vector<double> GetSteps(std::vector<double> coordinates, double tolerance)
{
  std::sort(coordinates.begin(), coordinates.end());
  for (std::size_t i = coordinates.size() - 1; i > 0; --i)
  {
    coordinates[i] -= coordinates[i - 1];
  }
  std::sort(coordinates.begin() + 1, coordinates.end());
  std::vector<Value> steps;
  for (std::size_t i = 1; i < coordinates.size(); ++i)
  {
    if (coordinates[i] <= LeastStep * tolerance)
    {
      continue;
    }
    if (steps.empty() || coordinates[i] - steps.back().X > 2 * tolerance)
    {
      steps.push_back({ coordinates[i], 0 });
    }
    ++steps.back().Count;
  }
  std::sort(steps.begin(), steps.end(),
    [](const Value& a, const Value& b) { return a.Count != b.Count ? a.Count > b.Count : a.X > b.X; });
  std::vector<double> found;
  for (std::size_t i = 0; i < std::min(MostDistances, steps.size()); ++i)
  {
    found.insert(found.end(), { steps[i].X, 2 * steps[i].X });
  }
  return found;
}

/// Whether a coordinate is one of the planes'.
bool HasAny(const std::vector<vtkPointSplatLatticePlanes>& all, double x)
{
  std::int64_t plane;
  return std::any_of(all.begin(), all.end(), [&](const auto& planes) { return planes.Has(x, plane); });
}
}

std::int64_t vtkPointSplatLatticePlanes::GetFloor(double x) const
{
  const double floor = std::floor((x - this->First) / this->Distance);
  return static_cast<std::int64_t>(std::clamp(floor, -MostPlanes, MostPlanes));
}

double vtkPointSplatLatticePlanes::GetPart(double x) const
{
  const double index = (x - this->First) / this->Distance;
  return index - std::floor(index);
}

bool vtkPointSplatLatticePlanes::Has(double x, std::int64_t& plane) const
{
  const double nearest = std::round((x - this->First) / this->Distance);
  if (!(std::abs(nearest) < MostPlanes))
  {
    return false;
  }
  plane = static_cast<std::int64_t>(nearest);
  return std::abs(this->First + nearest * this->Distance - x) <= this->Tolerance;
}

/// Makes the distance more exact by planes farther and farther off. often: coordinates that mostly are planes'.
void vtkPointSplatLatticePlanes::Refine(std::vector<double> often)
{
  std::sort(often.begin(), often.end(),
    [this](double a, double b) { return std::abs(a - this->First) < std::abs(b - this->First); });
  double known = 1; // so many planes off
  for (const double x : often)
  {
    const double count = std::abs(std::round((x - this->First) / this->Distance));
    const double error = std::abs(std::abs(x - this->First) - count * this->Distance);
    if (count > known && error <= this->Tolerance * (1 + count / known))
    {
      this->Distance = std::abs(x - this->First) / count;
      known = count;
    }
  }
}

std::size_t vtkPointSplatLatticePlanes::GetStride(std::size_t count)
{
  return std::max<std::size_t>(1, count / MostSampled) | 1;
}

void vtkPointSplatLatticePlanes::Sample(
  const std::vector<double>& positions, const std::vector<unsigned char>& used, std::vector<double> samples[3])
{
  const std::size_t stride = vtkPointSplatLatticePlanes::GetStride(used.size());
  for (std::size_t id = 0; id < used.size(); id += stride)
  {
    for (int c = 0; c < 3 && used[id]; ++c)
    {
      samples[c].push_back(positions[3 * id + c]);
    }
  }
}

double vtkPointSplatLatticePlanes::GetTolerance(const std::vector<double> samples[3])
{
  double largest = 0;
  for (int c = 0; c < 3; ++c)
  {
    for (const double x : samples[c])
    {
      largest = std::max(largest, std::abs(x));
    }
  }
  return Rounding * largest;
}

/// What may be the planes across an axis, those farthest apart first. sample: coordinates along it.
std::vector<vtkPointSplatLatticePlanes> vtkPointSplatLatticePlanes::Find(std::vector<double> sample, double tolerance)
{
  std::sort(sample.begin(), sample.end());
  std::vector<Value> values;
  std::size_t repeated = 0;
  const auto getCoordinate = [](double x) { return x; };
  vtkPointSplatLatticePlanes::Visit(sample, tolerance, getCoordinate, [&](auto first, auto last) {
    const std::size_t count = last - first;
    values.push_back({ first[count / 2], count });
    repeated += count > 1 ? count : 0;
  });
  std::vector<vtkPointSplatLatticePlanes> found;
  if (repeated < LeastRepeated * sample.size())
  {
    return found;
  }
  std::sort(values.begin(), values.end(),
    [](const Value& a, const Value& b) { return a.Count != b.Count ? a.Count > b.Count : a.X < b.X; });
  // Flat faces have as many points as some planes, or as a lot of them.
  for (const double power : { 1.0, 0.5 })
  {
    const std::vector<double> often = GetOften(values, power);
    for (const double distance : GetSteps(often, tolerance))
    {
      std::vector<vtkPointSplatLatticePlanes> tried;
      for (std::size_t i = 0; i < often.size() && tried.size() < MostTried; ++i)
      {
        if (HasAny(tried, often[i]))
        {
          continue;
        }
        vtkPointSplatLatticePlanes planes;
        planes.First = often[i];
        planes.Distance = distance;
        planes.Tolerance = tolerance;
        planes.Refine(often);
        std::int64_t plane;
        for (const Value& value : values)
        {
          planes.Points += planes.Has(value.X, plane) ? value.Count : 0;
        }
        tried.push_back(planes);
      }
      found.insert(found.end(), tried.begin(), tried.end());
    }
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.Points > b.Points; });
  std::vector<vtkPointSplatLatticePlanes> kept;
  for (const vtkPointSplatLatticePlanes& planes : found)
  {
    const bool known = std::any_of(kept.begin(), kept.end(), [&](const auto& other) {
      std::int64_t plane;
      return std::abs(other.Distance - planes.Distance) <= 2 * planes.Tolerance && other.Has(planes.First, plane);
    });
    if (!known && planes.Points >= LikeBest * found.front().Points)
    {
      kept.push_back(planes);
    }
  }
  std::sort(kept.begin(), kept.end(), [](const auto& a, const auto& b) { return a.Distance > b.Distance; });
  return kept;
}

/// Of how many points not two coordinates, or all three, are planes', up to more than most.
std::size_t vtkPointSplatLatticePlanes::CountOff(
  const std::vector<double> samples[3], const vtkPointSplatLatticePlanes axes[3], std::size_t most)
{
  std::size_t off = 0;
  for (std::size_t i = 0; i < samples[0].size() && off <= most; ++i)
  {
    int on = 0;
    for (int c = 0; c < 3; ++c)
    {
      std::int64_t plane;
      on += axes[c].Has(samples[c][i], plane) ? 1 : 0;
    }
    off += on < 2 ? 1 : 0;
  }
  return off;
}

/// The widest planes that two coordinates of each point are, or of about as many as of any. samples: along each axis.
double vtkPointSplatLatticePlanes::Choose(
  const std::vector<double> samples[3], vtkPointSplatLatticePlanes axes[3])
{
  std::vector<vtkPointSplatLatticePlanes> found[3];
  const double tolerance = vtkPointSplatLatticePlanes::GetTolerance(samples);
  for (int c = 0; c < 3; ++c)
  {
    found[c] = Find(samples[c], tolerance);
    if (found[c].empty())
    {
      return 0;
    }
  }
  struct Tried
  {
    const vtkPointSplatLatticePlanes* Axes[3];
    double Voxel;
    std::size_t Off;
  };
  std::vector<Tried> all;
  std::size_t most = static_cast<std::size_t>(MostOff * samples[0].size());
  for (const vtkPointSplatLatticePlanes& x : found[0])
  {
    for (const vtkPointSplatLatticePlanes& y : found[1])
    {
      for (const vtkPointSplatLatticePlanes& z : found[2])
      {
        if (x.Points + y.Points + z.Points + 2 * most < 2 * samples[0].size())
        {
          continue; // too few coordinates are planes' for two of nearly each point to be
        }
        const vtkPointSplatLatticePlanes tried[3] = { x, y, z };
        const std::size_t off = CountOff(samples, tried, most);
        if (off <= most)
        {
          all.push_back({ { &x, &y, &z }, x.Distance * y.Distance * z.Distance, off });
          most = std::min(most, LikeLeastOff * off);
        }
      }
    }
  }
  double largest = 0;
  for (const Tried& tried : all)
  {
    if (tried.Off <= most && tried.Voxel > largest)
    {
      largest = tried.Voxel;
      for (int c = 0; c < 3; ++c)
      {
        axes[c] = *tried.Axes[c];
      }
    }
  }
  return largest;
}

VTK_ABI_NAMESPACE_END
