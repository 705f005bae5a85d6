// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIsosurfaceSplat.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// What K, the form times the radius, may be at most: as vtkPointSplatProjection.glsl draws it.
constexpr double LargestDrawnBend = 1.0;
// From Testing/Accuracy/fit_constants.py:
/// How far the normal may turn from the centre to the rim of a disk, and what is left of one at least, however much
/// the surface bends: less leaves holes.
constexpr double LargestTurn = 0.6;
constexpr double LeastOfReach = 0.75;
}

void vtkIsosurfaceSplat::Bend(const double hessian[6], double slope)
{
  std::fill_n(this->Curvature, 6, 0.0);
  double a[3], b[3];
  vtkMath::Perpendiculars(this->Normal, a, b, 0);
  const double* h = hessian;
  auto form = [h, slope](const double u[3], const double v[3]) {
    return (h[0] * u[0] * v[0] + h[1] * u[1] * v[1] + h[2] * u[2] * v[2] +
             h[3] * (u[0] * v[1] + u[1] * v[0]) + h[4] * (u[1] * v[2] + u[2] * v[1]) +
             h[5] * (u[0] * v[2] + u[2] * v[0])) /
      slope;
  };
  // B in the basis of the tangents, as its mean and what its eigenvalues are off it.
  const double aa = form(a, a), bb = form(b, b), ab = form(a, b);
  const double mean = 0.5 * (aa + bb), half = 0.5 * (aa - bb);
  const double root = std::sqrt(half * half + ab * ab);
  const double strongest = std::abs(mean) + root;
  // NaN compares false; a slope of zero gives infinity.
  if (!(strongest > 0) || !std::isfinite(strongest) || !(this->Radius > 0))
  {
    return;
  }
  this->Radius = std::clamp(LargestTurn / strongest, LeastOfReach * this->Radius, this->Radius);
  const double limit = LargestDrawnBend / this->Radius;
  const double greater = std::clamp(mean + root, -limit, limit);
  const double lesser = std::clamp(mean - root, -limit, limit);
  const double middle = 0.5 * (greater + lesser);
  const double scale = root > 0 ? 0.5 * (greater - lesser) / root : 0.0;
  const double B[3] = { middle + scale * half, middle - scale * half, scale * ab };
  vtkIsosurfaceSplat::ToTensor(B, a, b, this->Curvature);
}

void vtkIsosurfaceSplat::ToTensor(
  const double form[3], const double a[3], const double b[3], double tensor[6])
{
  static const int rows[6] = { 0, 1, 2, 0, 1, 0 };
  static const int columns[6] = { 0, 1, 2, 1, 2, 2 };
  for (int k = 0; k < 6; ++k)
  {
    const int i = rows[k], j = columns[k];
    tensor[k] =
      form[0] * a[i] * a[j] + form[1] * b[i] * b[j] + form[2] * (b[i] * a[j] + a[i] * b[j]);
  }
}

VTK_ABI_NAMESPACE_END
