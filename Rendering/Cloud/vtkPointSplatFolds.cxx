// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatFolds.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

vtkPointSplatFolds::vtkPointSplatFolds(
  const double fold[6], const double clip[6], const double normal[3], const double plane[3])
{
  if (std::all_of(fold, fold + 6, [](double v) { return v == 0.0; }))
  {
    return;
  }
  std::copy_n(clip, 6, this->Clip);
  std::copy_n(plane, 3, this->Plane);
  if (!Turn(this->Plane, normal))
  {
    return;
  }
  for (int k = 0; k < 2; ++k)
  {
    std::copy_n(fold + 3 * k, 3, this->Normals[k]);
    const double length = vtkMath::Norm(this->Clip + 3 * k);
    this->Has[k] = Turn(this->Normals[k], normal) && std::isfinite(length) && length > 0.0;
    if (this->Has[k])
    {
      // On a convex edge a face ends towards where the other one faces.
      this->Convex[k] = vtkMath::Dot(this->Normals[k], this->Clip + 3 * k) > 0.0;
    }
  }
}

void vtkPointSplatFolds::GetLines(int part, double c[6]) const
{
  const int other = 1 - part;
  this->Meet(part, this->Plane, part, c);
  std::fill_n(c + 3, 3, 0.0);
  // Where one edge of a corner is convex and one is not, nothing says which the third is.
  if (this->Has[other] && this->Convex[part] == this->Convex[other])
  {
    this->Meet(part, this->Normals[other], other, c + 3);
  }
}

/// Makes a normal one of unit length on the side of another; false if it is none.
bool vtkPointSplatFolds::Turn(double n[3], const double side[3])
{
  const double length = vtkMath::Normalize(n);
  if (!(length > 0.0) || !std::isfinite(length))
  {
    return false;
  }
  vtkMath::MultiplyScalar(n, vtkMath::Dot(n, side) < 0.0 ? -1.0 : 1.0);
  return true;
}

/// The line in a part's plane where another plane meets it, as far away as one of the given lines.
void vtkPointSplatFolds::Meet(int part, const double other[3], int like, double c[3]) const
{
  const double* n = this->Normals[part];
  const double along = vtkMath::Dot(n, other);
  for (int k = 0; k < 3; ++k)
  {
    c[k] = (this->Convex[part] ? 1.0 : -1.0) * (other[k] - along * n[k]);
  }
  vtkMath::Normalize(c);
  vtkMath::MultiplyScalar(c, vtkMath::Norm(this->Clip + 3 * like));
}
