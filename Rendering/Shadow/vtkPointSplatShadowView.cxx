// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatShadowView.h"

#include "vtkLight.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace
{
constexpr double Pi = 3.14159265358979323846;
// Pixels around the map in which holes at its rim have all their neighbours.
constexpr double Guard = 4.0;
// A frustum wider than this, as tangent, wastes its pixels: a cube takes its place.
constexpr double WidestTangent = 1.75;

/// Two unit vectors across a direction.
void Across(const glm::dvec3& direction, glm::dvec3& u, glm::dvec3& v)
{
  const glm::dvec3 other =
    std::abs(direction.z) < 0.7 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(1.0, 0.0, 0.0);
  u = glm::normalize(glm::cross(direction, other));
  v = glm::cross(direction, u);
}

/// The light's coordinates: rows u, v, direction about an origin.
glm::dmat4 Frame(const glm::dvec3& direction, const glm::dvec3& origin)
{
  glm::dvec3 u;
  glm::dvec3 v;
  Across(direction, u, v);
  glm::dmat4 frame(glm::transpose(glm::dmat3(u, v, direction)));
  frame[3] = glm::dvec4(-(glm::dmat3(frame) * origin), 1.0);
  return frame;
}

/// Uniform in [0, 1), the same on every machine (Steele, Lea, Flood 2014, SplitMix).
double Next(uint64_t& state)
{
  state += 0x9e3779b97f4a7c15u;
  uint64_t z = state;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1.0p-53;
}

/// From the unit square to the unit disk, areas kept (Shirley, Chiu 1997).
glm::dvec2 ToDisk(double s, double t)
{
  const double a = 2.0 * s - 1.0;
  const double b = 2.0 * t - 1.0;
  if (a == 0.0 && b == 0.0)
  {
    return glm::dvec2(0.0);
  }
  const bool wide = std::abs(a) > std::abs(b);
  const double r = wide ? a : b;
  const double phi = wide ? 0.25 * Pi * (b / a) : 0.5 * Pi - 0.25 * Pi * (a / b);
  return r * glm::dvec2(std::cos(phi), std::sin(phi));
}

/// Lays the map over low to high, in pixels of the wanted size, within bounds.
void Lay(vtkPointSplatShadowView& view, const glm::dvec2& low, const glm::dvec2& high,
  double pixel, int resolution, int maximum)
{
  const double longest = std::max(high.x - low.x, high.y - low.y);
  const double most = std::max(resolution > 0 ? std::min(resolution, maximum) : maximum, 16);
  const double finest = longest / (most - 2.0 * Guard - 1.0);
  view.PixelSize = resolution > 0 && finest > 0.0 ? finest : std::max(pixel, finest);
  if (!std::isfinite(longest) || !std::isnormal(view.PixelSize))
  {
    return;
  }
  view.Scale = glm::dvec2(1.0 / view.PixelSize);
  view.Offset = Guard - low * view.Scale;
  view.Size = glm::ivec2(glm::ceil((high - low) * view.Scale + 2.0 * Guard));
}
}

//------------------------------------------------------------------------------
bool vtkPointSplatShadowLight::operator==(const vtkPointSplatShadowLight& other) const
{
  return this->Positional == other.Positional && this->Position == other.Position &&
    this->Direction == other.Direction && this->ConeAngle == other.ConeAngle &&
    this->Radius == other.Radius;
}

//------------------------------------------------------------------------------
vtkPointSplatShadowLight vtkPointSplatShadowLight::From(vtkLight* light, double radius)
{
  vtkPointSplatShadowLight result;
  const double* p = light->GetTransformedPosition();
  result.Position = glm::dvec3(p[0], p[1], p[2]);
  const double* f = light->GetTransformedFocalPoint();
  const glm::dvec3 ray = glm::dvec3(f[0], f[1], f[2]) - result.Position;
  const double length = glm::length(ray);
  result.Direction = length > 0.0 ? ray / length : glm::dvec3(0.0, 0.0, -1.0);
  result.Positional = light->GetPositional() != 0;
  result.ConeAngle = result.Positional ? light->GetConeAngle() : 180.0;
  result.Radius = radius;
  return result;
}

//------------------------------------------------------------------------------
double vtkPointSplatShadowLight::GetTangent(const glm::dvec3& place) const
{
  if (this->Radius <= 0.0 || !this->Positional)
  {
    return std::max(this->Radius, 0.0);
  }
  return this->Radius / std::max(glm::distance(this->Position, place), this->Radius);
}

//------------------------------------------------------------------------------
bool vtkPointSplatShadowLight::IsFinite() const
{
  const glm::dvec3 sum = this->Position + this->Direction;
  return std::isfinite(sum.x) && std::isfinite(sum.y) && std::isfinite(sum.z);
}

//------------------------------------------------------------------------------
std::vector<vtkPointSplatShadowLight> vtkPointSplatShadowLight::Sample(
  int count, unsigned int seed) const
{
  std::vector<vtkPointSplatShadowLight> samples(static_cast<size_t>(std::max(count, 1)), *this);
  if (count <= 1 || this->Radius <= 0.0)
  {
    samples.resize(1);
    return samples;
  }
  glm::dvec3 u;
  glm::dvec3 v;
  Across(this->Direction, u, v);
  uint64_t state = seed;
  const int rows = static_cast<int>(std::lround(std::sqrt(count)));
  int k = 0;
  for (int row = 0; row < rows; ++row)
  {
    const int last = static_cast<int>(static_cast<int64_t>(row + 1) * count / rows);
    const int columns = last - k;
    const double bottom = static_cast<double>(k) / count;
    for (int column = 0; column < columns; ++column, ++k)
    {
      const double s = (column + Next(state)) / columns;
      const double t = bottom + Next(state) * columns / count;
      const glm::dvec2 at = this->Radius * ToDisk(s, t);
      vtkPointSplatShadowLight& sample = samples[static_cast<size_t>(k)];
      if (this->Positional)
      {
        sample.Position += at.x * u + at.y * v;
      }
      else
      {
        sample.Direction = glm::normalize(this->Direction + at.x * u + at.y * v);
      }
    }
  }
  return samples;
}

//------------------------------------------------------------------------------
vtkPointSplatShadowView vtkPointSplatShadowView::Fit(const vtkPointSplatShadowLight& light,
  const std::vector<glm::dvec3>& corners, double spacing, int resolution, int maximum)
{
  vtkPointSplatShadowView view;
  glm::dvec3 centre(0.0);
  for (const glm::dvec3& corner : corners)
  {
    centre += corner / static_cast<double>(corners.size());
  }
  view.Parallel = !light.Positional;
  const glm::dvec3 towards = centre - light.Position;
  glm::dvec3 axis = light.Direction;
  if (light.Positional && glm::dot(towards, towards) > 0.0)
  {
    axis = glm::normalize(towards);
  }
  view.WCLC = Frame(axis, light.Positional ? light.Position : centre);

  auto box = [&](glm::dvec3& low, glm::dvec3& high) {
    low = glm::dvec3(1e300);
    high = glm::dvec3(-1e300);
    for (const glm::dvec3& corner : corners)
    {
      glm::dvec3 p(view.WCLC * glm::dvec4(corner, 1.0));
      low.z = std::min(low.z, p.z);
      high.z = std::max(high.z, p.z);
      if (light.Positional)
      {
        p /= std::max(p.z, 1e-300);
      }
      low = glm::dvec3(glm::min(glm::dvec2(low), glm::dvec2(p)), low.z);
      high = glm::dvec3(glm::max(glm::dvec2(high), glm::dvec2(p)), high.z);
    }
  };
  glm::dvec3 low;
  glm::dvec3 high;
  box(low, high);
  if (view.Parallel)
  {
    view.WCLC[3].z -= low.z;
    view.Depth = high.z - low.z + spacing;
    Lay(view, glm::dvec2(low), glm::dvec2(high), spacing, resolution, maximum);
    return view;
  }

  double radius = 0.0;
  for (const glm::dvec3& corner : corners)
  {
    radius = std::max(radius, glm::length(corner - centre));
  }
  view.Depth = glm::length(towards) + radius + spacing;
  view.NearDistance = 1e-4 * view.Depth;
  const double distance = std::max(glm::length(towards), 0.5 * radius);
  const double cone =
    light.ConeAngle < 90.0 ? std::tan(light.ConeAngle * Pi / 180.0) : 2.0 * WidestTangent;
  const double widest = low.z > 0.0
    ? std::max({ std::abs(low.x), std::abs(low.y), std::abs(high.x), std::abs(high.y) })
    : 2.0 * WidestTangent;
  glm::dvec2 from(low);
  glm::dvec2 to(high);
  if (cone <= WidestTangent && cone < widest)
  {
    view.WCLC = Frame(light.Direction, light.Position);
    from = glm::dvec2(-cone);
    to = glm::dvec2(cone);
  }
  else if (widest > WidestTangent)
  {
    view.Cube = true;
    view.WCLC = Frame(glm::dvec3(0.0, 0.0, 1.0), light.Position);
    from = glm::dvec2(-1.0);
    to = glm::dvec2(1.0);
  }
  Lay(view, from, to, spacing / distance, resolution, maximum);
  view.Distance = distance;
  return view;
}
