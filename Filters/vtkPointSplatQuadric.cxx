// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatQuadric.h"

#include "vtkMath.h"
#include "vtkPointSplatCholesky.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
constexpr int Terms = 6;
constexpr int LinearTerms = 3;
/// Fewer have no residual that says what they know of the second order.
constexpr int LeastNeighbors = 8;
/// The kernel reaches a little past the farthest neighbour, so that it has a weight, too.
constexpr float Reach = 1.1f;
/// What keeps terms small that points in a row do not tell, of the sum of weights.
constexpr double LinearPenalty = 1e-9;
constexpr double QuadraticPenalty = 1e-3;

constexpr int Lanes = 8;
constexpr int Capacity = vtkPointSplatNeighbors::MaximumNumberOfNeighbors + Lanes;

/// Sums over neighbours of x^a y^b up to the fourth degree, of z times those up to the second, and of z^2; each lane for itself.
struct Sums
{
  static constexpr int Moments = 15, Heights = Moments, Square = Heights + Terms, Count = Square + 1;
  float Parts[Count][Lanes] = {};

  void Add(const float* x, const float* y, const float* z)
  {
    // Compilers turn loops over lanes into vectors, but not those over terms.
    float terms[Count][Lanes];
    for (int l = 0; l < Lanes; ++l)
    {
      const float xx = x[l] * x[l], xy = x[l] * y[l], yy = y[l] * y[l], zz = z[l] * z[l];
      const float falling = 1 - (xx + yy + zz) * (1 / (Reach * Reach));
      const float w = falling * falling, wz = w * z[l];
      const float wxx = w * xx, wxy = w * xy, wyy = w * yy;
      terms[0][l] = w;
      terms[1][l] = w * x[l];
      terms[2][l] = w * y[l];
      terms[3][l] = wxx;
      terms[4][l] = wxy;
      terms[5][l] = wyy;
      terms[6][l] = wxx * x[l];
      terms[7][l] = wxx * y[l];
      terms[8][l] = wyy * x[l];
      terms[9][l] = wyy * y[l];
      terms[10][l] = wxx * xx;
      terms[11][l] = wxx * xy;
      terms[12][l] = wxx * yy;
      terms[13][l] = wxy * yy;
      terms[14][l] = wyy * yy;
      terms[15][l] = wz;
      terms[16][l] = wz * x[l];
      terms[17][l] = wz * y[l];
      terms[18][l] = wz * xx;
      terms[19][l] = wz * xy;
      terms[20][l] = wz * yy;
      terms[21][l] = w * zz;
    }
    for (int t = 0; t < Count; ++t)
    {
      for (int l = 0; l < Lanes; ++l)
      {
        this->Parts[t][l] += terms[t][l];
      }
    }
  }

  double Get(int name) const
  {
    float sum = 0;
    for (int l = 0; l < Lanes; ++l)
    {
      sum += this->Parts[name][l];
    }
    return sum;
  }
};

/// Which of the sums is each entry of the normal equations' lower triangle, for the terms 1, x, y, x^2, x y, y^2.
constexpr int Entries[Terms][Terms] = { { 0 }, { 1, 3 }, { 2, 4, 5 }, { 3, 6, 7, 10 }, { 4, 7, 8, 11, 12 },
  { 5, 8, 9, 12, 13, 14 } };
}

bool vtkPointSplatQuadric::Fit(
  const vtkPointSplatNeighbors::Neighborhood& around, const float plane[3])
{
  if (around.Count < LeastNeighbors)
  {
    return false;
  }
  float one[3], two[3];
  vtkMath::Perpendiculars(plane, one, two, 0.0);
  const float inverse = 1 / std::sqrt(around.SquaredDistance[around.Count - 1]);
  float x[Capacity], y[Capacity], z[Capacity];
  const int padded = (around.Count + Lanes - 1) / Lanes * Lanes;
  for (int i = 0; i < around.Count; ++i)
  {
    const float offset[3] = { inverse * around.X[i], inverse * around.Y[i], inverse * around.Z[i] };
    x[i] = vtkMath::Dot(offset, one);
    y[i] = vtkMath::Dot(offset, two);
    z[i] = vtkMath::Dot(offset, plane);
  }
  for (int i = around.Count; i < padded; ++i)
  {
    x[i] = Reach; // where they weigh nothing
    y[i] = z[i] = 0;
  }
  Sums sums;
  for (int i = 0; i < padded; i += Lanes)
  {
    sums.Add(x + i, y + i, z + i);
  }
  double matrix[Terms][Terms] = {}, right[Terms];
  for (int r = 0; r < Terms; ++r)
  {
    right[r] = sums.Get(Sums::Heights + r);
    for (int c = 0; c <= r; ++c)
    {
      matrix[r][c] = sums.Get(Entries[r][c]);
    }
  }
  matrix[0][0] += 1; // the centre, the origin
  double squares = sums.Get(Sums::Square);
  const double weights = matrix[0][0];
  const double aside = std::hypot(matrix[1][0], matrix[2][0]) / weights;
  for (int r = 1; r < Terms; ++r)
  {
    matrix[r][r] += weights * (r < LinearTerms ? LinearPenalty : QuadraticPenalty);
  }
  if (!vtkPointSplatCholesky::Factor(matrix))
  {
    return false;
  }
  vtkPointSplatCholesky::SolveForward(matrix, right);
  double curved = 0;
  for (int r = 0; r < Terms; ++r)
  {
    squares -= right[r] * right[r];
    curved += r < LinearTerms ? 0 : right[r] * right[r];
  }
  const double variance = std::max(squares, 0.0) / (around.Count + 1 - Terms);
  const double byChance = (Terms - LinearTerms) * variance;
  const double shrink = curved > byChance ? 1 - byChance / curved : 0.0;
  for (int r = LinearTerms; r < Terms; ++r)
  {
    right[r] *= shrink;
  }
  vtkPointSplatCholesky::SolveBackward(matrix, right);
  float normal[3];
  for (int c = 0; c < 3; ++c)
  {
    normal[c] = static_cast<float>(plane[c] - right[1] * one[c] - right[2] * two[c]);
  }
  if (!(vtkMath::Normalize(normal) > 0))
  {
    return false;
  }
  std::copy_n(normal, 3, this->Normal);
  this->Aside = static_cast<float>(aside);
  const double perSpacing = std::sqrt(around.Count / vtkMath::Pi());
  this->Residual =
    static_cast<float>(perSpacing * std::sqrt(variance * (around.Count + 1) / weights));
  return true;
}

VTK_ABI_NAMESPACE_END
