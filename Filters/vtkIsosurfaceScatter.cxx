// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIsosurfaceScatter.h"

#include "vtkAlgorithm.h"
#include "vtkIsosurfaceThinning.h"
#include "vtkMath.h"
#include "vtkPointSplatThreads.h"

#include <algorithm>
#include <cmath>
#include <map>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// Points keep this part of the wanted spacing as their least distance.
constexpr double DistancePerSpacing = 0.8;
/// The samples' spacing is divided by at most this.
constexpr double MostDivisions = 16;
/// New points are looked for around those there are, at this many least distances.
constexpr double RingRadius = 1.25;
constexpr int RingSize = 10;
/// So many points look for others at a time; the next ones see what these have found.
constexpr std::size_t RoundSize = 65536;
constexpr int MostSteps = 6;
/// Of the distance that points keep, a splat's radius: see vtkIsosurfaceSamples.
constexpr double RadiusPerDistance = 1.1;
/// What part of a point's distance to others it may be off the surface.
constexpr double Settled = 1e-3;
/// What part of a link, or of a ring's radius, a point may be moved.
constexpr double FarthestMove = 0.5;
/// Beyond so many times its size a cube's number has no meaning in a double.
constexpr double FarthestCube = 1e15;

/// Makes a vector a unit one, however long or short it is; false where it has no direction.
bool Normalize(double x[3])
{
  const double largest = std::max({ std::abs(x[0]), std::abs(x[1]), std::abs(x[2]) });
  if (!(largest > 0) || !std::isfinite(largest))
  {
    return false;
  }
  for (int c = 0; c < 3; ++c)
  {
    x[c] /= largest;
  }
  const double length = vtkMath::Norm(x);
  for (int c = 0; c < 3; ++c)
  {
    x[c] /= length;
  }
  return true;
}

/// Whether space can be divided into cubes of a size where the point lies.
template <typename Point>
bool HasCube(const Point& point, double size)
{
  return std::max({ std::abs(point.Position[0]), std::abs(point.Position[1]),
           std::abs(point.Position[2]) }) < FarthestCube * size;
}
}

/**
 * The points of one isosurface. No two are nearer than the lesser of their distances. Points
 * whose distances are alike but for a factor of two share a vtkIsosurfaceThinning.
 */
class vtkIsosurfaceScatter::Surface
{
public:
  std::vector<Point> Points;

  bool HasNear(const Point& point) const
  {
    const vtkIsosurfaceThinning::Sample sample = GetSample(point);
    for (const auto& [level, thinning] : this->Levels)
    {
      const double distance = std::ldexp(1.0, level + 1);
      if (HasCube(point, distance) && thinning.HasNear(sample, std::min(point.Distance, distance)))
      {
        return true;
      }
    }
    return false;
  }

  void Add(const Point& point)
  {
    const int level = std::ilogb(point.Distance);
    this->Levels.try_emplace(level, std::ldexp(1.0, level + 1))
      .first->second.Add(GetSample(point));
    this->Points.push_back(point);
  }

private:
  static vtkIsosurfaceThinning::Sample GetSample(const Point& point)
  {
    vtkIsosurfaceThinning::Sample sample;
    for (int c = 0; c < 3; ++c)
    {
      sample.Position[c] = point.Position[c];
      sample.Side[c] = static_cast<float>(point.Gradient[c]);
    }
    return sample;
  }

  std::map<int, vtkIsosurfaceThinning> Levels;
};

vtkIsosurfaceScatter::vtkIsosurfaceScatter(std::unique_ptr<vtkIsosurfaceScatterField> field,
  const std::vector<double>& isovalues, const Settings& settings)
  : Field(std::move(field))
  , Isovalues(isovalues)
  , Chosen(settings)
  , Surfaces(isovalues.size())
{
}

vtkIsosurfaceScatter::~vtkIsosurfaceScatter() = default;

double vtkIsosurfaceScatter::GetDistance(Node node) const
{
  const double spacing = this->Field->GetSpacing(node);
  return DistancePerSpacing *
    (this->Chosen.Spacing > 0 ? std::max(this->Chosen.Spacing, spacing / MostDivisions) : spacing);
}

bool vtkIsosurfaceScatter::Find(
  vtkAlgorithm* self, double from, double to, std::vector<vtkIdType>& counts)
{
  const double connected = from + 0.5 * (to - from);
  if (!this->Field->Connect(self, from, connected, this->Isovalues,
        this->Chosen.NumberOfNeighbors, this->Chosen.Radius))
  {
    return false;
  }
  counts.assign(this->Isovalues.size(), 0);
  for (std::size_t v = 0; v < this->Isovalues.size(); ++v)
  {
    const double at = connected + (to - connected) * v / this->Isovalues.size();
    self->UpdateProgress(at);
    if (vtkPointSplatBatches::IsAborted(self))
    {
      return false;
    }
    std::vector<Point> found;
    this->FindOnPairs(v, found);
    // In the samples' order one row of points after the other would be filled, with wider gaps.
    vtkIsosurfaceThinning::Shuffle(found);
    Surface surface;
    for (const Point& point : found)
    {
      if (!surface.HasNear(point))
      {
        surface.Add(point);
      }
    }
    if (this->Chosen.Correction && !this->Grow(self, v, surface, at))
    {
      return false;
    }
    // Where samples come from several processes, a point is the nearest sample's.
    std::vector<Point>& points = surface.Points;
    points.erase(std::remove_if(points.begin(), points.end(),
                   [this](const Point& point) { return !this->Field->IsOwn(point.Nearest); }),
      points.end());
    counts[v] = static_cast<vtkIdType>(points.size());
    this->Surfaces[v] = std::move(points);
  }
  return true;
}

/// One point for each pair of linked samples that the isovalue separates.
void vtkIsosurfaceScatter::FindOnPairs(std::size_t v, std::vector<Point>& points) const
{
  const double isovalue = this->Isovalues[v];
  const vtkIdType nodes = this->Field->GetNumberOfNodes();
  std::vector<std::size_t> first(nodes + 1, 0);
  vtkPointSplatThreads::For(0, nodes, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType node = begin; node < end; ++node)
    {
      this->Field->VisitPairs(static_cast<Node>(node), isovalue,
        [&](const vtkIsosurfaceScatterField::Pair&) { ++first[node + 1]; });
    }
  });
  for (vtkIdType node = 0; node < nodes; ++node)
  {
    first[node + 1] += first[node];
  }
  points.resize(first[nodes]);
  vtkPointSplatThreads::For(0, nodes, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType node = begin; node < end; ++node)
    {
      std::size_t at = first[node];
      this->Field->VisitPairs(static_cast<Node>(node), isovalue,
        [&](const vtkIsosurfaceScatterField::Pair& pair) {
          points[at++] = this->PlaceOnPair(isovalue, pair);
        });
    }
  });
}

vtkIsosurfaceScatter::Point vtkIsosurfaceScatter::PlaceOnPair(
  double isovalue, const vtkIsosurfaceScatterField::Pair& pair) const
{
  const Node to = this->Field->GetNode(pair.To);
  const double values[2] = { this->Field->GetValue(this->Field->GetSlot(pair.From)),
    this->Field->GetValue(pair.To) };
  double ends[2][3];
  this->Field->GetPosition(this->Field->GetSlot(pair.From), ends[0]);
  this->Field->GetPosition(pair.To, ends[1]);
  // Halved, since the difference of the largest numbers is none.
  const double t =
    (0.5 * isovalue - 0.5 * values[0]) / (0.5 * values[1] - 0.5 * values[0]);
  const double* gradients[2] = { this->Field->GetGradient(pair.From),
    this->Field->GetGradient(to == vtkIsosurfaceScatterField::None ? pair.From : to) };
  Point point;
  double along[3];
  for (int c = 0; c < 3; ++c)
  {
    point.Position[c] = (1 - t) * ends[0][c] + t * ends[1][c];
    point.Gradient[c] = (1 - t) * gradients[0][c] + t * gradients[1][c];
    along[c] = values[1] > values[0] ? ends[1][c] - ends[0][c] : ends[0][c] - ends[1][c];
  }
  if (!Normalize(point.Gradient))
  {
    std::copy(along, along + 3, point.Gradient);
    Normalize(point.Gradient);
  }
  point.Nearest = to != vtkIsosurfaceScatterField::None && t > 0.5 ? to : pair.From;
  point.Distance = this->GetDistance(point.Nearest);
  if (this->Chosen.Correction)
  {
    Point corrected = point;
    if (this->Approach(isovalue, FarthestMove * vtkMath::Norm(along), corrected))
    {
      point = corrected;
    }
  }
  point.Usable = true;
  point.HasGap = false;
  return point;
}

/// Newton steps along the gradient, not farther than `limit`; false where they do not settle.
bool vtkIsosurfaceScatter::Approach(double isovalue, double limit, Point& point) const
{
  const double start[3] = { point.Position[0], point.Position[1], point.Position[2] };
  for (int step = 0; step < MostSteps; ++step)
  {
    this->Field->Approach(point.Position, point.Nearest);
    vtkIsosurfaceScatterField::Value value;
    if (!this->Field->Evaluate(isovalue, point.Position, point.Nearest, value) ||
      !value.Straddled)
    {
      return false;
    }
    double direction[3] = { value.Gradient[0], value.Gradient[1], value.Gradient[2] };
    if (!Normalize(direction))
    {
      return false;
    }
    const double move = value.Difference / vtkMath::Dot(value.Gradient, direction);
    double moved[3];
    for (int c = 0; c < 3; ++c)
    {
      point.Gradient[c] = direction[c];
      point.Position[c] -= move * direction[c];
      moved[c] = point.Position[c] - start[c];
    }
    if (!(vtkMath::Norm(moved) <= limit))
    {
      return false;
    }
    if (std::abs(move) <= Settled * point.Distance)
    {
      return true;
    }
  }
  return false;
}

/// Adds points beside those there are until no gap is left. Points of one round do not see each
/// other until they are added, one after the other.
bool vtkIsosurfaceScatter::Grow(
  vtkAlgorithm* self, std::size_t v, Surface& surface, double at) const
{
  std::vector<Point> found;
  std::size_t begin = 0;
  while (begin < surface.Points.size())
  {
    const std::size_t end = std::min(begin + RoundSize, surface.Points.size());
    found.resize(RingSize * (end - begin));
    auto look = [&](vtkIdType first, vtkIdType last) {
      for (vtkIdType i = first; i < last; ++i)
      {
        const Point& from = surface.Points[begin + i];
        bool gap = false;
        double u[3], w[3];
        vtkMath::Perpendiculars(from.Gradient, u, w, 0.0);
        for (int r = 0; r < RingSize; ++r)
        {
          Point& point = found[RingSize * i + r];
          point = from;
          const double angle = 2 * vtkMath::Pi() * r / RingSize;
          const double a = RingRadius * from.Distance * std::cos(angle);
          const double b = RingRadius * from.Distance * std::sin(angle);
          for (int c = 0; c < 3; ++c)
          {
            point.Position[c] += a * u[c] + b * w[c];
          }
          // Most places are taken, which is sooner known than where exactly they are.
          point.Usable = HasCube(point, point.Distance) && !surface.HasNear(point);
          if (point.Usable)
          {
            const double start[3] = { point.Position[0], point.Position[1], point.Position[2] };
            point = this->PlaceBeside(this->Isovalues[v], from, start);
            gap = gap || point.HasGap;
          }
        }
        surface.Points[begin + i].HasGap = gap;
      }
    };
    if (!vtkPointSplatBatches::For(self, static_cast<vtkIdType>(end - begin), 64, at, at, look))
    {
      return false;
    }
    for (const Point& point : found)
    {
      if (point.Usable && !surface.HasNear(point))
      {
        surface.Add(point);
      }
    }
    begin = end;
  }
  return true;
}

vtkIsosurfaceScatter::Point vtkIsosurfaceScatter::PlaceBeside(
  double isovalue, const Point& from, const double start[3]) const
{
  Point point = from;
  std::copy(start, start + 3, point.Position);
  const bool settled =
    this->Approach(isovalue, FarthestMove * RingRadius * from.Distance, point) &&
    vtkMath::Dot(point.Gradient, from.Gradient) > 0;
  point.HasGap = !settled;
  point.Usable = settled && this->Field->Surrounds(point.Nearest, point.Position);
  point.Distance = this->GetDistance(point.Nearest);
  return point;
}

bool vtkIsosurfaceScatter::Write(
  vtkAlgorithm* self, double from, double to, const std::vector<Target>& targets) const
{
  for (std::size_t v = 0; v < targets.size(); ++v)
  {
    const std::vector<Point>& points = this->Surfaces[v];
    auto write = [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const Point& point = points[i];
        vtkIsosurfaceSplat splat;
        for (int c = 0; c < 3; ++c)
        {
          splat.Position[c] = point.Position[c];
          splat.Normal[c] = -point.Gradient[c];
        }
        if (targets[v].HasSizes())
        {
          this->Shape(v, point, splat);
        }
        targets[v].Put(i, splat);
      }
    };
    const double step = (to - from) / targets.size();
    if (!vtkPointSplatBatches::For(self, static_cast<vtkIdType>(points.size()), 1024,
          from + v * step, from + (v + 1) * step, write))
    {
      return false;
    }
  }
  return true;
}

void vtkIsosurfaceScatter::Shape(
  std::size_t v, const Point& point, vtkIsosurfaceSplat& splat) const
{
  // A place that stayed empty is for the disk beside it to cover.
  splat.Radius = RadiusPerDistance * (point.HasGap ? RingRadius : 1.0) * point.Distance;
  vtkIsosurfaceScatterField::Value value;
  if (this->Field->Evaluate(this->Isovalues[v], point.Position, point.Nearest, value))
  {
    for (double& element : value.Hessian)
    {
      element = -element;
    }
    splat.Bend(value.Hessian, -vtkMath::Dot(value.Gradient, splat.Normal));
  }
}

VTK_ABI_NAMESPACE_END
