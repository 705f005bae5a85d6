// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// What a cloud checks of points that are all finite, and sizes that are all positive.
#include "vtkPointSplatCloud.h"
#include "vtkPointSplatPacking.h"

#include "vtkDataArray.h"

#include <algorithm>
#include <cmath>

namespace
{
// Of the median radius to the spacing, beyond which sizes do not belong to these points. Estimated
// ones of scans, grids, isosurfaces, tubes and random points have 0.68 to 1.17 spacings, those of a
// grid that is twenty times finer one way than the other 3.
constexpr double LeastRadius = 0.25;
constexpr double LargestRadius = 4.0;
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
  if (ratio < LeastRadius || ratio > LargestRadius)
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
