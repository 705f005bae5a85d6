// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkPointSplatCholesky.h
 * @brief small symmetric positive definite systems, as least squares give them
 *
 * An internal helper. A = L L^T is taken apart, and A x = b solved as L y = b and L^T x = y. Of a fit's normal equations the
 * square of y_i is by how much the i-th term lessens the sum of squared residuals, once those before it are fitted.
 */
#ifndef vtkPointSplatCholesky_h
#define vtkPointSplatCholesky_h

#include "vtkPointSplattingABI.h"
#include "vtkType.h"

#include <cmath>

VTK_ABI_NAMESPACE_BEGIN

namespace vtkPointSplatCholesky
{
/// Puts L into the lower triangle of A, which alone is read. False if A is not definite.
template <int N>
bool Factor(double (&a)[N][N])
{
  for (int j = 0; j < N; ++j)
  {
    double pivot = a[j][j];
    for (int k = 0; k < j; ++k)
    {
      pivot -= a[j][k] * a[j][k];
    }
    if (!(pivot > 0))
    {
      return false;
    }
    a[j][j] = std::sqrt(pivot);
    for (int i = j + 1; i < N; ++i)
    {
      for (int k = 0; k < j; ++k)
      {
        a[i][j] -= a[i][k] * a[j][k];
      }
      a[i][j] /= a[j][j];
    }
  }
  return true;
}

/// L y = b, in place.
template <int N>
void SolveForward(const double (&a)[N][N], double (&b)[N])
{
  for (int i = 0; i < N; ++i)
  {
    for (int k = 0; k < i; ++k)
    {
      b[i] -= a[i][k] * b[k];
    }
    b[i] /= a[i][i];
  }
}

/// L^T x = y, in place.
template <int N>
void SolveBackward(const double (&a)[N][N], double (&b)[N])
{
  for (int i = N - 1; i >= 0; --i)
  {
    for (int k = i + 1; k < N; ++k)
    {
      b[i] -= a[k][i] * b[k];
    }
    b[i] /= a[i][i];
  }
}
}

VTK_ABI_NAMESPACE_END
#endif
