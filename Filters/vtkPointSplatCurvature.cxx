// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatCurvature.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// The fit counts in full where it explains this part of the equations' right hand sides.
constexpr double FullAgreement = 0.5;
/// Of a fit that counts in full this much: splats that bend a little less than the surface
/// overlap, where ones that bend more would leave cracks.
constexpr double Caution = 0.9;
/// Neighbours nearer than this part of the spacing count less: what their normals differ by is noise.
constexpr double Softening = 0.35;
/// Keeps the equations solvable where the neighbours lie in a row.
constexpr double Damping = 1e-4;

/// Least squares for B11, B12, B22 from the header's equations.
struct Equations
{
  // Of the symmetric matrix: 00, 01, 02, 11, 12, 22.
  double Matrix[6] = {};
  double Right[3] = {};
  double Total = 0; // of the squared right hand sides

  /// The change of the normal, x along a and y along b, over the step (u, v).
  void AddTurn(double u, double v, double x, double y, double weight)
  {
    const double wu = weight * u, wv = weight * v;
    const double uu = wu * u, uv = wu * v, vv = wv * v;
    this->Matrix[0] += uu;
    this->Matrix[1] += uv;
    this->Matrix[3] += uu + vv;
    this->Matrix[4] += uv;
    this->Matrix[5] += vv;
    this->Right[0] += wu * x;
    this->Right[1] += wv * x + wu * y;
    this->Right[2] += wv * y;
    this->Total += weight * (x * x + y * y);
  }

  /// The height -h / 2 over the step (u, v).
  void AddHeight(double u, double v, double h, double weight)
  {
    const double c[3] = { u * u, 2 * u * v, v * v };
    const double wc[3] = { weight * c[0], weight * c[1], weight * c[2] };
    this->Matrix[0] += wc[0] * c[0];
    this->Matrix[1] += wc[0] * c[1];
    this->Matrix[2] += wc[0] * c[2];
    this->Matrix[3] += wc[1] * c[1];
    this->Matrix[4] += wc[1] * c[2];
    this->Matrix[5] += wc[2] * c[2];
    for (int i = 0; i < 3; ++i)
    {
      this->Right[i] += wc[i] * h;
    }
    this->Total += weight * h * h;
  }

  void Solve(double x[3]) const
  {
    const double damp = Damping * (this->Matrix[0] + this->Matrix[3] + this->Matrix[5]);
    const double* m = this->Matrix;
    const double matrix[3][3] = { { m[0] + damp, m[1], m[2] }, { m[1], m[3] + damp, m[4] },
      { m[2], m[4], m[5] + damp } };
    double inverse[3][3];
    vtkMath::Invert3x3(matrix, inverse);
    vtkMath::Multiply3x3(inverse, this->Right, x);
  }
};
}

void vtkPointSplatCurvature::Estimate(const vtkPointSplatNeighbors::Neighborhood& around,
  const float* normals, const float centre[3],
  const vtkPointSplatSheet& sheet, float radius)
{
  std::fill_n(this->Tensor, 6, 0.0f);
  this->Strongest = 0;
  const double n[3] = { centre[0], centre[1], centre[2] };
  double a[3], b[3];
  vtkMath::Perpendiculars(n, a, b, 0);
  const double soft = Softening * std::max(sheet.Spacing, radius);
  const double softening = soft * soft;
  Equations equations;
  for (int k = 0; k < sheet.Count; ++k)
  {
    const int i = sheet.Members[k];
    const float* other = normals + std::size_t(3) * around.Slots[i];
    const double m[3] = { other[0], other[1], other[2] };
    const double squared = around.SquaredDistance[i];
    const double d[3] = { around.X[i], around.Y[i], around.Z[i] };
    const double cosine = vtkMath::Dot(m, n);
    const double u = vtkMath::Dot(d, a), v = vtkMath::Dot(d, b), h = vtkMath::Dot(d, n);
    const double side = cosine * squared < 2 * h * vtkMath::Dot(d, m) ? -1 : 1;
    const double weight = 1 / (squared + softening);
    equations.AddTurn(u, v, side * vtkMath::Dot(m, a), side * vtkMath::Dot(m, b), weight);
    equations.AddHeight(u, v, -2 * h, cosine * cosine * weight / squared);
  }
  if (!(equations.Total > 0))
  {
    return;
  }
  double B[3];
  equations.Solve(B);
  const double explained = vtkMath::Dot(B, equations.Right) / equations.Total;
  const double part = Caution * std::clamp(explained / FullAgreement, 0.0, 1.0);
  const double mean = 0.5 * (B[0] + B[2]);
  const double strongest = (std::abs(mean) + std::hypot(0.5 * (B[0] - B[2]), B[1]));
  // Singular equations give what is not finite, and points next to each other what no float is.
  if (!(strongest <= VTK_FLOAT_MAX))
  {
    return;
  }
  this->Strongest = static_cast<float>(strongest);
  static const int rows[6] = { 0, 1, 2, 0, 1, 0 };
  static const int columns[6] = { 0, 1, 2, 1, 2, 2 };
  for (int k = 0; k < 6; ++k)
  {
    const int i = rows[k], j = columns[k];
    const double element = part *
      (B[0] * a[i] * a[j] + B[1] * (a[i] * b[j] + a[j] * b[i]) + B[2] * b[i] * b[j]);
    this->Tensor[k] = static_cast<float>(element);
  }
}

float vtkPointSplatCurvature::GetBend(const float tensor[6])
{
  float squared = 0;
  for (int c = 0; c < 6; ++c)
  {
    squared += (c < 3 ? 1 : 2) * tensor[c] * tensor[c];
  }
  return std::sqrt(squared);
}

VTK_ABI_NAMESPACE_END
