// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatCodes.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace
{
constexpr double LargestBend = 1.0; // as in vtkPointSplatProjection.glsl

/// Where the parabola meets the circle, in radii of the splat: at the rim of its blending kernel.
constexpr double MeetingReach = 1.5;
/// ... and no farther than this part of the circle's radius.
constexpr double LargestMeeting = 0.95;

/**
 * The bend of a parabola in place of a circle's arc of radius 1 / k in splat's radii. With the
 * same curvature the parabola leaves the circle, so that splats on thin tubes would stand off them;
 * it meets it at the distance t / k with 2 (1 - sqrt(1 - t^2)) / t^2 times the curvature.
 */
double BendOfCircle(double k)
{
  const double t = std::min(MeetingReach * std::abs(k), LargestMeeting);
  const double steeper = 2.0 / (1.0 + std::sqrt(1.0 - t * t));
  return std::clamp(steeper * k, -LargestBend, LargestBend);
}

/// Lines nearer to a splat's centre than a millionth of its axes count as so near.
constexpr double SteepestLine = 1e6;
}

namespace vtkPointSplatCodes
{
uint32_t Bits(double value)
{
  const float single = static_cast<float>(value);
  uint32_t bits;
  std::memcpy(&bits, &single, sizeof(bits));
  return bits;
}

uint32_t CodeNormal(const double n[3])
{
  const double sum = std::abs(n[0]) + std::abs(n[1]) + std::abs(n[2]);
  double x = n[0] / sum;
  double y = n[1] / sum;
  if (n[2] < 0.0)
  {
    const double folded = std::copysign(1.0 - std::abs(y), x);
    y = std::copysign(1.0 - std::abs(x), y);
    x = folded;
  }
  const auto quantise = [](double v) {
    return static_cast<uint32_t>(static_cast<uint16_t>(static_cast<int16_t>(std::lround(v * 32767.0))));
  };
  return quantise(x) | (quantise(y) << 16);
}

/**
 * The unit vector that decodeNormal() in vtkPointSplatOctahedron.glsl makes of a
 * code: the tangents that go by it are then the same here and there.
 */
void DecodeNormal(uint32_t code, double n[3])
{
  n[0] = static_cast<int16_t>(code & 0xffffu) / 32767.0;
  n[1] = static_cast<int16_t>(code >> 16) / 32767.0;
  n[2] = 1.0 - std::abs(n[0]) - std::abs(n[1]);
  const double fold = std::max(-n[2], 0.0);
  n[0] += n[0] >= 0.0 ? -fold : fold;
  n[1] += n[1] >= 0.0 ? -fold : fold;
  vtkMath::Normalize(n);
}

void TangentsOf(uint32_t planeCode, double s[3], double t[3])
{
  double n[3];
  DecodeNormal(planeCode, n);
  const bool slanted = std::abs(n[2]) < 0.7;
  const double other[3] = { slanted ? 0.0 : 1.0, 0.0, slanted ? 1.0 : 0.0 };
  vtkMath::Cross(n, other, s);
  vtkMath::Normalize(s);
  vtkMath::Cross(n, s, t);
}

void AxesOf(const uint32_t* splat, bool circular, double s[3], double t[3])
{
  if (circular)
  {
    float radius;
    std::memcpy(&radius, splat + 3, sizeof(radius));
    TangentsOf(splat[4], s, t);
    vtkMath::MultiplyScalar(s, radius);
    vtkMath::MultiplyScalar(t, radius);
    return;
  }
  float axes[8];
  std::memcpy(axes, splat + 8, sizeof(axes));
  std::copy_n(axes, 3, s);
  std::copy_n(axes + 4, 3, t);
}

uint32_t CodeBend(uint32_t planeCode, const double curvature[6], double radius)
{
  double s[3];
  double t[3];
  TangentsOf(planeCode, s, t);
  const double* c = curvature;
  const auto form = [c, radius](const double a[3], const double b[3]) {
    return radius *
      (c[0] * a[0] * b[0] + c[1] * a[1] * b[1] + c[2] * a[2] * b[2] +
        c[3] * (a[0] * b[1] + a[1] * b[0]) + c[4] * (a[1] * b[2] + a[2] * b[1]) +
        c[5] * (a[0] * b[2] + a[2] * b[0]));
  };
  const double half = 0.5 * (form(s, s) - form(t, t));
  const double mean = 0.5 * (form(s, s) + form(t, t));
  const double mixed = form(s, t);
  const double root = std::hypot(half, mixed);
  if (!std::isfinite(root) || !std::isfinite(mean))
  {
    return 0;
  }
  const double greater = BendOfCircle(mean + root);
  const double lesser = BendOfCircle(mean - root);
  const double scale = root > 0.0 ? 0.5 * (greater - lesser) / root : 0.0;
  const double middle = 0.5 * (greater + lesser);
  const auto quantise = [](double v) {
    return static_cast<uint32_t>(std::lround(v / LargestBend * BendSteps)) & 1023u;
  };
  return quantise(middle + scale * half) | (quantise(scale * mixed) << 10) |
    (quantise(middle - scale * half) << 20);
}

void CodeLine(const double c[3], const double s[3], const double t[3], uint32_t line[2])
{
  double u = vtkMath::Dot(c, s);
  double v = vtkMath::Dot(c, t);
  const double length = std::hypot(u, v);
  if (!std::isfinite(length))
  {
    u = v = 0.0;
  }
  else if (length > SteepestLine)
  {
    u *= SteepestLine / length;
    v *= SteepestLine / length;
  }
  line[0] = Bits(u);
  line[1] = Bits(v);
}
}
