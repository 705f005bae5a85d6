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

/// Least squares for three unknowns.
struct Equations
{
  double Matrix[3][3] = {};
  double Right[3] = {};
  double Total = 0; // of the squared right hand sides

  void Add(double c0, double c1, double c2, double right, double weight)
  {
    const double c[3] = { c0, c1, c2 };
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        this->Matrix[i][j] += weight * c[i] * c[j];
      }
      this->Right[i] += weight * c[i] * right;
    }
    this->Total += weight * right * right;
  }

  void Solve(double x[3])
  {
    const double trace = this->Matrix[0][0] + this->Matrix[1][1] + this->Matrix[2][2];
    double inverse[3][3];
    for (int i = 0; i < 3; ++i)
    {
      this->Matrix[i][i] += Damping * trace;
    }
    vtkMath::Invert3x3(this->Matrix, inverse);
    vtkMath::Multiply3x3(inverse, this->Right, x);
  }
};
}

void vtkPointSplatCurvature::Estimate(const vtkPointSplatNeighbors::Neighborhood& around,
  const float* normals, const float centre[3],
  const vtkPointSplatSheet& sheet)
{
  std::fill_n(this->Tensor, 6, 0.0f);
  this->Strongest = 0;
  const double n[3] = { centre[0], centre[1], centre[2] };
  double a[3], b[3];
  vtkMath::Perpendiculars(n, a, b, 0);
  const double soft = Softening * sheet.Spacing;
  const double softening = soft * soft;
  Equations equations;
  for (int k = 0; k < sheet.Count; ++k)
  {
    const int i = sheet.Members[k];
    const float* other = normals + std::size_t(3) * around.Slots[i];
    double m[3] = { other[0], other[1], other[2] };
    const double squared = around.SquaredDistance[i];
    const double d[3] = { around.X[i], around.Y[i], around.Z[i] };
    const double cosine = vtkMath::Dot(m, n);
    const double u = vtkMath::Dot(d, a), v = vtkMath::Dot(d, b), h = vtkMath::Dot(d, n);
    const double side = cosine * squared < 2 * h * vtkMath::Dot(d, m) ? -1 : 1;
    const double weight = 1 / (squared + softening);
    equations.Add(u, v, 0, side * vtkMath::Dot(m, a), weight);
    equations.Add(0, u, v, side * vtkMath::Dot(m, b), weight);
    equations.Add(u * u, 2 * u * v, v * v, -2 * h, cosine * cosine * weight / squared);
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

VTK_ABI_NAMESPACE_END
