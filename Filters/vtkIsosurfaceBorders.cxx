// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIsosurfaceBorders.h"

#include "vtkMath.h"
#include "vtkPointSplatBorderPlane.h"
#include "vtkPointSplatBorders.h"
#include "vtkPointSplatThreads.h"

#include <algorithm>
#include <atomic>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN

vtkIsosurfaceBorders::vtkIsosurfaceBorders(
  const vtkIsosurfaceGrid& grid, const std::array<bool, 6>& ends)
  : Ends(ends)
{
  double axes[3][3], inverse[3][3];
  for (int r = 0; r < 3; ++r)
  {
    std::copy_n(grid.ToWorld[r], 3, axes[r]);
    this->Last[r] = static_cast<double>(grid.Dimensions[r] - 1);
  }
  vtkMath::Invert3x3(axes, inverse);
  for (int r = 0; r < 3; ++r)
  {
    std::copy_n(inverse[r], 3, this->Gradients[r]);
    this->Steepest[r] = vtkMath::Norm(inverse[r]);
    this->Gradients[r][3] = 0;
    for (int c = 0; c < 3; ++c)
    {
      this->Gradients[r][3] -= inverse[r][c] * grid.ToWorld[c][3];
    }
  }
}

/// Returns whether there is any.
bool vtkIsosurfaceBorders::FindLines(
  const double x[3], const float n[3], double reach, float clip[6]) const
{
  std::fill_n(clip, 6, 0.0f);
  double sizes[2] = { 1 / reach, 1 / reach }; // of the lines' vectors: farther ones cut nothing off
  for (int face = 0; face < 6; ++face)
  {
    const double* g = this->Gradients[face / 2];
    const double index = vtkMath::Dot(g, x) + g[3];
    const double distance = face % 2 ? this->Last[face / 2] - index : index;
    if (distance > reach * this->Steepest[face / 2])
    {
      continue;
    }
    const double side = face % 2 ? 1 : -1;
    // Of lines through the point itself vectors would not be finite.
    const double scale =
      side / std::max<double>(distance, vtkPointSplatBorderPlane::LeastDistance);
    const double across = g[0] * n[0] + g[1] * n[1] + g[2] * n[2];
    double line[3];
    for (int c = 0; c < 3; ++c)
    {
      line[c] = scale * (g[c] - across * n[c]);
    }
    const double size = vtkMath::Norm(line);
    const int at = size > sizes[0] ? 0 : 1;
    if (!this->Ends[face] || !(size > sizes[at]) || !std::isfinite(size))
    {
      continue;
    }
    if (at == 0)
    {
      std::copy_n(clip, 3, clip + 3);
      sizes[1] = sizes[0];
    }
    sizes[at] = size;
    std::copy_n(line, 3, clip + 3 * at);
  }
  return sizes[0] > 1 / reach;
}

void vtkIsosurfaceBorders::Clip(vtkIsosurfaceOutput& output) const
{
  const vtkIdType count = output.Points->GetNumberOfPoints();
  if (!output.Radii || count == 0)
  {
    return;
  }
  const auto find = [&](vtkIdType id, float clip[6]) {
    double x[3];
    output.Points->GetPoint(id, x);
    return this->FindLines(x, output.Normals->GetPointer(3 * id),
      vtkPointSplatBorders::KernelReach * output.Radii->GetValue(id), clip);
  };
  std::atomic<bool> any{ false };
  vtkPointSplatThreads::For(0, count, [&](vtkIdType begin, vtkIdType end) {
    float clip[6];
    for (vtkIdType id = begin; id < end && !any; ++id)
    {
      if (find(id, clip))
      {
        any = true;
      }
    }
  });
  if (!any)
  {
    return;
  }
  output.Clips = vtkSmartPointer<vtkFloatArray>::New();
  output.Clips->SetName(vtkPointSplatArrays::Clip);
  output.Clips->SetNumberOfComponents(6);
  output.Clips->SetNumberOfTuples(count);
  vtkPointSplatThreads::For(0, count, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType id = begin; id < end; ++id)
    {
      find(id, output.Clips->GetPointer(6 * id));
    }
  });
}

VTK_ABI_NAMESPACE_END
