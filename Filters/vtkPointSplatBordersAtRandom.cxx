// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The lines at which a random sampling's splats end.
#include "vtkPointSplatBorders.h"

#include "vtkAlgorithm.h"
#include "vtkMath.h"
#include "vtkPointSplatBorderPlane.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
// These are from Testing/Accuracy/fit_constants.py.
/// How far past the outermost of a random sampling's points its surface ends, in standard deviations of
/// the last points from a line: random ones are somewhere before its border, a mesh's on it. And in
/// spacings, at most.
constexpr float PerScatter = 2.0f;
constexpr float RandomMargin = 0.3f;
/// Ends of one border agree on where it goes on by this mean: beside a narrow gap or strip they don't.
constexpr float LeastAgreed = 0.8f;

/// How far a border's points lie off the parabola that fits them best: the standard deviation; all, where
/// they are too few to tell.
float GetScatter(const std::vector<float>& along, const std::vector<float>& across)
{
  const int count = static_cast<int>(along.size());
  const float longest = std::accumulate(along.begin(), along.end(), 0.0f,
    [](float most, float x) { return std::max(most, std::abs(x)); });
  if (count < 4 || !(longest > 0))
  {
    return std::numeric_limits<float>::max();
  }
  // Powers of 1, x, x^2, and what these make of the heights.
  double powers[3][3] = {}, heights[3] = {}, coefficients[3];
  for (int i = 0; i < count; ++i)
  {
    const double x = along[i] / longest;
    const double p[3] = { 1, x, x * x };
    for (int k = 0; k < 3; ++k)
    {
      heights[k] += p[k] * across[i];
      for (int l = 0; l < 3; ++l)
      {
        powers[k][l] += p[k] * p[l];
      }
    }
  }
  if (!(std::abs(vtkMath::Determinant3x3(powers)) > 1e-6))
  {
    return std::numeric_limits<float>::max();
  }
  vtkMath::LinearSolve3x3(powers, heights, coefficients);
  double squares = 0;
  for (int i = 0; i < count; ++i)
  {
    const double x = along[i] / longest;
    const double off = across[i] - coefficients[0] - x * (coefficients[1] + x * coefficients[2]);
    squares += off * off;
  }
  return static_cast<float>(std::sqrt(squares / (count - 3)));
}
}

bool vtkPointSplatBorders::Cut(const Neighborhood& around, End& cut) const
{
  const float reach = KernelReach * this->Disks.Length[around.Center];
  const float* n = this->Normals + std::size_t(3) * around.Center;
  struct Near
  {
    float X[3];
    const End* Of;
  };
  std::vector<Near> ends;
  const End* own = this->GetEnd(around.Center);
  if (own)
  {
    ends.push_back({ { 0, 0, 0 }, own });
  }
  const float spacing = this->Disks.Spacing[around.Center];
  const float farthest = 2 * reach + spacing;
  for (int i = 0; i < around.Count && around.SquaredDistance[i] < farthest * farthest; ++i)
  {
    if (const End* end = this->GetEnd(around.Slots[i]))
    {
      ends.push_back({ { around.X[i], around.Y[i], around.Z[i] }, end });
    }
  }
  float out[3] = { 0, 0, 0 };
  for (const Near& end : ends)
  {
    for (int c = 0; c < 3; ++c)
    {
      out[c] += end.Of->Out[c] / static_cast<float>(ends.size());
    }
  }
  if (!(vtkMath::Norm(out) > LeastAgreed))
  {
    // At a corner of the border, or in a bay: no one line is along it.
    return this->ClipAsNearest(around, cut) || own;
  }
  const float off = vtkMath::Dot(out, n);
  for (int c = 0; c < 3; ++c)
  {
    out[c] -= off * n[c];
  }
  if (!(vtkMath::Normalize(out) > 0))
  {
    return false;
  }
  float side[3];
  vtkMath::Cross(n, out, side);
  float distance = 0;
  std::vector<float> along, across;
  for (const Near& end : ends)
  {
    along.push_back(vtkMath::Dot(end.X, side));
    across.push_back(vtkMath::Dot(end.X, out));
    if (std::abs(along.back()) <= reach)
    {
      distance = std::max(distance, across.back());
    }
  }
  distance += std::clamp(PerScatter * GetScatter(along, across),
    vtkPointSplatBorderPlane::LeastDistance * spacing, RandomMargin * spacing);
  if (!(distance < reach))
  {
    return false;
  }
  cut = End();
  cut.At = around.Center;
  for (int c = 0; c < 3; ++c)
  {
    cut.Clip[c] = out[c] / distance;
  }
  return true;
}

bool vtkPointSplatBorders::Straighten(vtkAlgorithm* self)
{
  std::vector<std::atomic<bool>> near(this->Disks.Spacing.size());
  vtkSMPThreadLocal<std::vector<End>> found;
  auto cut = [&](const Neighborhood& around, int) {
    End end;
    if (!this->Disks.IsAlone(around.Center) && this->Cut(around, end))
    {
      found.Local().push_back(end);
    }
    return true;
  };
  const double progress = self->GetProgress();
  if (!this->FindNear(self, near) ||
    !this->Neighbors.Visit(self, progress, progress, NumberOfNeighbors, cut,
      [&near](Slot s) { return near[s].load(std::memory_order_relaxed); }))
  {
    return false;
  }
  this->Take(found);
  return true;
}

VTK_ABI_NAMESPACE_END
