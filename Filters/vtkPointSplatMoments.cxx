// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatMoments.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
// Where points lie on a line, nothing tells how normals change across it: the share of the greater
// variance that is added to both.
constexpr double Ridge = 0.005;
// Of an ellipse the axes differ by no more than this.
constexpr double LeastRatio = 0.25;

using Tensor = double[6]; // XX, YY, ZZ, XY, YZ, XZ

/// a . M b
double Apply(const Tensor& m, const double a[3], const double b[3])
{
  return a[0] * (m[0] * b[0] + m[3] * b[1] + m[5] * b[2]) +
    a[1] * (m[3] * b[0] + m[1] * b[1] + m[4] * b[2]) +
    a[2] * (m[5] * b[0] + m[4] * b[1] + m[2] * b[2]);
}
}

//------------------------------------------------------------------------------
void vtkPointSplatMoments::Add(const vtkPointSplatHierarchy::Point& point)
{
  // Points without sizes count the same.
  const double radius = point.Radius;
  const double area = radius > 0.0 ? radius * radius : 1.0;
  const float* p = point.Position;
  const float* n = point.Normal;
  this->Count += 1.0;
  this->Area += area;
  for (int i = 0; i < 3; ++i)
  {
    this->Position[i] += area * p[i];
    this->Normal[i] += area * n[i];
    this->Products[i] += area * p[i] * static_cast<double>(p[i]);
    for (int j = 0; j < 3; ++j)
    {
      this->Mixed[i][j] += area * n[i] * static_cast<double>(p[j]);
    }
  }
  this->Products[3] += area * p[0] * static_cast<double>(p[1]);
  this->Products[4] += area * p[1] * static_cast<double>(p[2]);
  this->Products[5] += area * p[0] * static_cast<double>(p[2]);
  if (point.HasCurvature)
  {
    // A disk's variance along each of its axes is a quarter of its squared radius.
    const double spread = 0.25 * radius * radius * area;
    this->Spread += spread;
    for (int k = 0; k < 6; ++k)
    {
      this->Bend[k] += spread * point.Curvature[k];
    }
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatMoments::Add(const vtkPointSplatMoments& other)
{
  this->Count += other.Count;
  this->Area += other.Area;
  this->Spread += other.Spread;
  for (int i = 0; i < 3; ++i)
  {
    this->Position[i] += other.Position[i];
    this->Normal[i] += other.Normal[i];
    for (int j = 0; j < 3; ++j)
    {
      this->Mixed[i][j] += other.Mixed[i][j];
    }
  }
  for (int k = 0; k < 6; ++k)
  {
    this->Products[k] += other.Products[k];
    this->Bend[k] += other.Bend[k];
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatMoments::Describe(
  vtkPointSplatHierarchy::Splat& splat, bool ellipse, const float fallback[3]) const
{
  const double scale = 1.0 / this->Area;
  double p[3];
  double mean[3]; // of normals
  double normal[3];
  for (int i = 0; i < 3; ++i)
  {
    p[i] = scale * this->Position[i];
    mean[i] = normal[i] = scale * this->Normal[i];
  }
  const double length = vtkMath::Normalize(normal);
  for (int i = 0; i < 3 && length < 1e-6; ++i)
  {
    normal[i] = fallback[i];
  }
  const Tensor covariance = { scale * this->Products[0] - p[0] * p[0],
    scale * this->Products[1] - p[1] * p[1], scale * this->Products[2] - p[2] * p[2],
    scale * this->Products[3] - p[0] * p[1], scale * this->Products[4] - p[1] * p[2],
    scale * this->Products[5] - p[0] * p[2] };

  // In the tangent plane (section 4.3): its covariance Q, and C, the normals' with the positions.
  double axis[2][3];
  vtkMath::Perpendiculars(normal, axis[0], axis[1], 0.0);
  double q[2][2];
  double c[2][2];
  double bend[2][2];
  const double spread = scale * this->Spread;
  for (int a = 0; a < 2; ++a)
  {
    for (int b = 0; b < 2; ++b)
    {
      q[a][b] = Apply(covariance, axis[a], axis[b]);
      bend[a][b] = scale * Apply(this->Bend, axis[a], axis[b]);
      c[a][b] = 0.0;
      for (int i = 0; i < 3; ++i)
      {
        for (int j = 0; j < 3; ++j)
        {
          c[a][b] += axis[a][i] * axis[b][j] * (scale * this->Mixed[i][j] - mean[i] * p[j]);
        }
      }
    }
  }

  // The second fundamental form K, by least squares: n changes by K x, K (Q + spread) = C + bend.
  const double ridge = Ridge * std::max({ q[0][0], q[1][1], 0.0 }) + spread;
  const double w[2][2] = { { q[0][0] + ridge, q[0][1] }, { q[1][0], q[1][1] + ridge } };
  const double determinant = w[0][0] * w[1][1] - w[0][1] * w[1][0];
  double k[2][2] = { { 0.0, 0.0 }, { 0.0, 0.0 } };
  if (determinant > 0.0)
  {
    double full[2][2];
    for (int a = 0; a < 2; ++a)
    {
      const double x = c[a][0] + bend[a][0];
      const double y = c[a][1] + bend[a][1];
      full[a][0] = (x * w[1][1] - y * w[1][0]) / determinant;
      full[a][1] = (y * w[0][0] - x * w[0][1]) / determinant;
    }
    k[0][0] = full[0][0];
    k[1][1] = full[1][1];
    k[0][1] = k[1][0] = 0.5 * (full[0][1] + full[1][0]);
  }
  double explained = 0.0;
  double sag = 0.0;
  for (int a = 0; a < 2; ++a)
  {
    for (int b = 0; b < 2; ++b)
    {
      explained += k[a][b] * c[a][b];
      sag += 0.5 * k[a][b] * q[a][b];
    }
  }
  explained = std::max(0.0, explained);
  const double variance = std::max(0.0,
    1.0 - mean[0] * mean[0] - mean[1] * mean[1] - mean[2] * mean[2] - explained);
  splat.Variance = static_cast<float>(variance);
  if (spread <= 0.0)
  {
    // By chance alone three parameters explain a part of what two components of n normals have
    // beside two means; what is not four times as much may be noise.
    const double freedom = 2.0 * this->Count - 5.0;
    const double chance = freedom > 0.0 ? 12.0 * variance / freedom : explained;
    const double kept = explained > chance ? (explained - chance) / explained : 0.0;
    sag *= kept;
    for (auto& row : k)
    {
      row[0] *= kept;
      row[1] *= kept;
    }
  }

  // The ellipse's axes: the eigenvectors of Q, in the ratio of the deviations along them.
  const double half = 0.5 * (q[0][0] - q[1][1]);
  const double root = std::hypot(half, q[0][1]);
  const double middle = 0.5 * (q[0][0] + q[1][1]);
  double along[2] = { half > 0.0 ? half + root : q[0][1], half > 0.0 ? q[0][1] : root - half };
  const double norm = std::hypot(along[0], along[1]);
  along[0] = norm > 0.0 ? along[0] / norm : 1.0;
  along[1] = norm > 0.0 ? along[1] / norm : 0.0;
  splat.Shorter = ellipse && middle + root > 0.0
    ? static_cast<float>(
        std::max(LeastRatio, std::sqrt(std::max(0.0, (middle - root) / (middle + root)))))
    : 1.0f;
  const int index[6][2] = { { 0, 0 }, { 1, 1 }, { 2, 2 }, { 0, 1 }, { 1, 2 }, { 0, 2 } };
  for (int m = 0; m < 6; ++m)
  {
    const int i = index[m][0];
    const int j = index[m][1];
    splat.Curvature[m] = static_cast<float>(k[0][0] * axis[0][i] * axis[0][j] +
      k[1][1] * axis[1][i] * axis[1][j] +
      k[0][1] * (axis[0][i] * axis[1][j] + axis[1][i] * axis[0][j]));
  }
  for (int i = 0; i < 3; ++i)
  {
    splat.Position[i] = static_cast<float>(p[i] + sag * normal[i]);
    splat.Normal[i] = static_cast<float>(normal[i]);
    splat.Axis[i] = static_cast<float>(along[0] * axis[0][i] + along[1] * axis[1][i]);
  }
}

VTK_ABI_NAMESPACE_END
