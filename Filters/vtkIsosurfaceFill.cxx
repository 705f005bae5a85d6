// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIsosurfaceFill.h"

#include "vtkIsosurfaceSplat.h"
#include "vtkMath.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// The cosine by which normals turn at least, from Testing/Accuracy/fit_constants.py.
constexpr double BentCosine = 0.97;
/// Across an outline that is long and narrow it is not known how normals change: what the least sum
/// of squares of offsets is, by the sum along both axes.
constexpr double LeastSquares = 0.01;
}

bool vtkIsosurfaceFill::IsBent(int count, const double (*normals)[3])
{
  for (int i = 0; i < count; ++i)
  {
    for (int other = 0; other < i; ++other)
    {
      if (vtkMath::Dot(normals[i], normals[other]) < BentCosine)
      {
        return true;
      }
    }
  }
  return false;
}

bool vtkIsosurfaceFill::Fit(int count, const double (*offsets)[3], const double (*normals)[3])
{
  double mean[3] = { 0, 0, 0 };
  for (int i = 0; i < count; ++i)
  {
    vtkMath::Add(mean, normals[i], mean);
  }
  if (!(vtkMath::Normalize(mean) > 0))
  {
    return false;
  }
  std::copy_n(mean, 3, this->Normal);
  double axes[2][3], form[3], sums[3] = { 0, 0, 0 }, squares[3][3] = {};
  vtkMath::Perpendiculars(mean, axes[0], axes[1], 0);
  for (int i = 0; i < count; ++i)
  {
    const double d[2] = { vtkMath::Dot(offsets[i], axes[0]), vtkMath::Dot(offsets[i], axes[1]) };
    // B_11 d_1 + B_12 d_2 is the normal's component along the first axis,
    // B_22 d_2 + B_12 d_1 that along the second.
    const double equations[2][3] = { { d[0], 0, d[1] }, { 0, d[1], d[0] } };
    for (int k = 0; k < 2; ++k)
    {
      const double turn = vtkMath::Dot(normals[i], axes[k]);
      for (int r = 0; r < 3; ++r)
      {
        sums[r] += equations[k][r] * turn;
        for (int c = 0; c < 3; ++c)
        {
          squares[r][c] += equations[k][r] * equations[k][c];
        }
      }
    }
  }
  const double least = LeastSquares * squares[2][2];
  for (int c = 0; c < 3; ++c)
  {
    squares[c][c] += least;
  }
  vtkMath::LinearSolve3x3(squares, sums, form);
  double tensor[6];
  vtkIsosurfaceSplat::ToTensor(form, axes[0], axes[1], tensor);
  for (int k = 0; k < 6; ++k)
  {
    this->Form[k] = static_cast<float>(tensor[k]);
  }
  return true;
}

void vtkIsosurfaceFill::Apply(vtkIsosurfaceSplat& splat) const
{
  std::copy_n(this->Normal, 3, splat.Normal);
  double form[6];
  std::copy_n(this->Form, 6, form);
  splat.Bend(form, 1.0);
}

VTK_ABI_NAMESPACE_END
