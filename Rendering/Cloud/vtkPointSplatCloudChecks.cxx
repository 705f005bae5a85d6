// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// What a cloud checks of points that are all finite, and sizes that are all positive.
#include "vtkPointSplatCloud.h"
#include "vtkPointSplatPacking.h"

#include "vtkDataArray.h"
#include "vtkPointSplatThreads.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace
{
// Of the median radius to the spacing, beyond which sizes do not belong to these points. Estimated
// ones of scans, grids, isosurfaces, tubes and random points have 0.68 to 1.17 spacings, those of a
// grid that is twenty times finer one way than the other 3.
constexpr double LeastRadius = 0.25;
constexpr double LargestRadius = 4.0;
// The same to the distance of nearest points: a disk reaches these, however the sampling changes.
constexpr double LeastReach = 0.6;

/// The median distance of some splats to their nearest others that lie elsewhere.
double GetNearestDistance(const std::vector<uint32_t>& splats, size_t words)
{
  constexpr size_t samples = 64;
  const size_t count = splats.size() / words;
  const size_t step = std::max<size_t>(1, count / samples);
  const auto at = [&](size_t i) {
    std::array<float, 3> p;
    std::memcpy(p.data(), splats.data() + words * i, sizeof(p));
    return p;
  };
  std::vector<float> nearest((count + step - 1) / step, VTK_FLOAT_MAX);
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(nearest.size()), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType k = begin; k < end; ++k)
    {
      const std::array<float, 3> p = at(static_cast<size_t>(k) * step);
      for (size_t i = 0; i < count; ++i)
      {
        const std::array<float, 3> q = at(i);
        const float d[3] = { q[0] - p[0], q[1] - p[1], q[2] - p[2] };
        const float squared = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
        float& least = nearest[static_cast<size_t>(k)];
        least = squared > 0.0f ? std::min(least, squared) : least;
      }
    }
  });
  const auto middle = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2);
  std::nth_element(nearest.begin(), middle, nearest.end());
  return std::sqrt(*middle);
}
}

//------------------------------------------------------------------------------
void vtkPointSplatCloud::CheckRadii(vtkObject* owner) const
{
  constexpr vtkIdType enough = 100; // points, for a spacing
  const double spacing = this->MeasureSpacing();
  if (this->Count < enough || !(spacing > 0.0) || !(this->MedianRadius > 0.0))
  {
    return;
  }
  const double ratio = this->MedianRadius / spacing;
  if (ratio >= LeastRadius && ratio <= LargestRadius)
  {
    return;
  }
  // Points that are much denser here than there are told by their neighbours.
  const double reach =
    this->MedianRadius / GetNearestDistance(this->Splats, this->GetWordsPerSplat());
  if (reach < LeastReach || reach > LargestRadius)
  {
    vtkWarningWithObjectMacro(owner, << "The median SplatRadius is " << this->MedianRadius
                                     << ", and the points lie some " << spacing
                                     << " apart: were they scaled, or thinned, after their sizes "
                                        "were made? No filter of VTK's scales SplatRadius and "
                                        "SplatCurvature; run vtkPointSplatEstimation after it, or "
                                        "remove these arrays.");
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatCloud::LeaveOutFar(std::vector<vtkPointSplatPacking>& packings)
{
  // Floats hold seven digits. About an origin halfway to a point that is so far off, the others
  // lose more than three of them; and of what is farther, no window shows both.
  constexpr double spoiling = 1e3;
  constexpr double farthest = 1e6;
  constexpr vtkIdType samples = 1024; // of a block, for quartiles
  std::array<double, 3> middle{ { 0.0, 0.0, 0.0 } };
  double span = 0.0;
  double half = 0.0;
  for (size_t k = 0; k < 3; ++k)
  {
    std::vector<double> values;
    for (const vtkPointSplatPacking& packing : packings)
    {
      const vtkIdType n = packing.Points->GetNumberOfTuples();
      const vtkIdType step = std::max<vtkIdType>(1, n / samples);
      for (vtkIdType i = 0; i < n; i += step)
      {
        const double value = packing.Points->GetComponent(i, static_cast<int>(k));
        if (std::isfinite(value))
        {
          values.push_back(value);
        }
      }
    }
    if (values.size() < 4)
    {
      return;
    }
    std::sort(values.begin(), values.end());
    middle[k] = values[values.size() / 2];
    span = std::max(span, values[3 * values.size() / 4] - values[values.size() / 4]);
    half = std::max(half, 0.5 * this->High[k] - 0.5 * this->Low[k]);
  }
  if (!(span > 0.0) || !(half > spoiling * span))
  {
    return;
  }
  this->Origin = middle;
  const double reach = std::min(farthest * span, vtkPointSplatPacking::LargestLength);
  for (vtkPointSplatPacking& packing : packings)
  {
    packing.Reach = reach;
  }
  for (size_t k = 0; k < 3; ++k)
  {
    this->Low[k] = std::max(this->Low[k], middle[k] - reach);
    this->High[k] = std::min(this->High[k], middle[k] + reach);
  }
}
