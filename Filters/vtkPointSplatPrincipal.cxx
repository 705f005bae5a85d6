// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatPrincipal.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// Eigenvalues that differ by less, of the matrix's greatest entry, are the same, ...
constexpr double LeastSpread = 1e-12;
/// ... and rows whose products' squares are less are parallel.
constexpr double LeastProduct = 1e-20;
}

vtkPointSplatPrincipal::vtkPointSplatPrincipal(
  const Neighborhood& around, int count, bool withCentre)
{
  double sum[3] = { 0, 0, 0 }, m[6] = { 0, 0, 0, 0, 0, 0 };
  for (int i = 0; i < count; ++i)
  {
    const double x = around.X[i], y = around.Y[i], z = around.Z[i];
    sum[0] += x;
    sum[1] += y;
    sum[2] += z;
    m[0] += x * x;
    m[1] += x * y;
    m[2] += x * z;
    m[3] += y * y;
    m[4] += y * z;
    m[5] += z * z;
  }
  // The centre is the origin of the offsets.
  const double n = std::max(count + (withCentre ? 1 : 0), 1);
  m[0] -= sum[0] * sum[0] / n;
  m[1] -= sum[0] * sum[1] / n;
  m[2] -= sum[0] * sum[2] / n;
  m[3] -= sum[1] * sum[1] / n;
  m[4] -= sum[1] * sum[2] / n;
  m[5] -= sum[2] * sum[2] / n;
  const double scale = std::max({ std::abs(m[0]), std::abs(m[1]), std::abs(m[2]), std::abs(m[3]),
    std::abs(m[4]), std::abs(m[5]) });
  if (!(scale > 0) || !std::isfinite(scale))
  {
    return;
  }
  std::transform(m, m + 6, this->Matrix, [scale](double entry) { return entry / scale; });

  // Eigenvalues by the trigonometric solution of the characteristic polynomial.
  const double* a = this->Matrix;
  const double mean = (a[0] + a[3] + a[5]) / 3;
  const double xx = a[0] - mean, yy = a[3] - mean, zz = a[5] - mean;
  const double off = a[1] * a[1] + a[2] * a[2] + a[4] * a[4];
  const double p = std::sqrt((xx * xx + yy * yy + zz * zz + 2 * off) / 6);
  const double det = xx * (yy * zz - a[4] * a[4]) - a[1] * (a[1] * zz - a[4] * a[2]) +
    a[2] * (a[1] * a[4] - yy * a[2]);
  // A sixth of a turn at most; the least is a third of a turn on.
  const double angle =
    p > LeastSpread ? std::acos(std::clamp(det / (2 * p * p * p), -1.0, 1.0)) / 3 : 0.0;
  const double cosine = std::cos(angle), sine = std::sqrt(0.75) * std::sin(angle);
  this->Spread = p;
  this->Least = mean - p * (cosine + 2 * sine);
  const double values[3] = { mean + 2 * p * cosine, mean - p * (cosine - 2 * sine), this->Least };
  for (int k = 0; k < 3; ++k)
  {
    this->Variances[k] = static_cast<float>(std::max(values[k], 0.0) * scale / n);
  }
}

void vtkPointSplatPrincipal::GetNormal(float normal[3]) const
{
  normal[0] = normal[1] = 0;
  normal[2] = 1;
  if (!(this->Spread > LeastSpread))
  {
    return;
  }
  // The rows of A - lambda I span the plane across the eigenvector.
  const double* a = this->Matrix;
  const double r[3][3] = { { a[0] - this->Least, a[1], a[2] }, { a[1], a[3] - this->Least, a[4] },
    { a[2], a[4], a[5] - this->Least } };
  double best[3] = { 0, 0, 0 }, longest = 0;
  for (int i = 0; i < 3; ++i)
  {
    const double* u = r[i];
    const double* v = r[(i + 1) % 3];
    const double c[3] = { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
      u[0] * v[1] - u[1] * v[0] };
    const double length = c[0] * c[0] + c[1] * c[1] + c[2] * c[2];
    if (length > longest)
    {
      longest = length;
      std::copy(c, c + 3, best);
    }
  }
  if (longest < LeastProduct)
  {
    // Points in a row: something across the longest row, which is their direction.
    int row = 0;
    for (int i = 1; i < 3; ++i)
    {
      row = std::abs(r[i][i]) > std::abs(r[row][row]) ? i : row;
    }
    const double* u = r[row];
    const int smallest = std::abs(u[0]) < std::abs(u[1])
      ? (std::abs(u[0]) < std::abs(u[2]) ? 0 : 2)
      : (std::abs(u[1]) < std::abs(u[2]) ? 1 : 2);
    const int one = (smallest + 1) % 3, two = (smallest + 2) % 3;
    best[smallest] = 0;
    best[one] = u[two];
    best[two] = -u[one];
    longest = best[one] * best[one] + best[two] * best[two];
    if (!(longest > 0))
    {
      return;
    }
  }
  const double inverse = 1 / std::sqrt(longest);
  for (int i = 0; i < 3; ++i)
  {
    normal[i] = static_cast<float>(best[i] * inverse);
  }
}

VTK_ABI_NAMESPACE_END
