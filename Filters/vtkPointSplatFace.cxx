// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatFace.h"

#include "vtkPointSplatCurvature.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// The sine of the angle (9 degrees) by which normals may be off those of the face: less than those
/// at an edge of 30 degrees, which are between its faces'.
constexpr float LargestSine = 0.16f;
/// How far points may be off the face, in their distance: half of what that turn makes.
constexpr float LargestHeight = 0.08f;
/// How far, in spacings, neighbours say how a face bends to begin with.
constexpr float FirstReach = 1.5f;
/// How far a surface of second order is a good guess.
constexpr float LastReach = 4.0f;
/// The fewest neighbours that make a face.
constexpr int FewestMembers = 4;
/// And that make a row (Testing/Accuracy/fit_constants.py).
constexpr int FewestInRow = 2;
/// Or many must say it, as on the walls of holes of few spacings' radius (Testing/Accuracy/fit_constants.py).
constexpr int ManyMembers = 12;
/// Neighbours lie in a row if their squared distances across it are less than this part of those
/// along it.
constexpr float RowSpread = 0.04f;
}

void vtkPointSplatFace::Multiply(const float t[6], const float d[3], float result[3])
{
  result[0] = t[0] * d[0] + t[3] * d[1] + t[5] * d[2];
  result[1] = t[3] * d[0] + t[1] * d[1] + t[4] * d[2];
  result[2] = t[5] * d[0] + t[4] * d[1] + t[2] * d[2];
}

/// The neighbours within reach that are on the surface that the tensor says.
void vtkPointSplatFace::Select(const vtkPointSplatNeighbors::Neighborhood& around,
  const float* normals, const float n[3], float reach)
{
  this->Members.Count = this->NumberOfOthers = 0;
  float residual = 0;
  for (int i = 0; i < around.Count && around.SquaredDistance[i] <= reach * reach; ++i)
  {
    const float* m = normals + std::size_t(3) * around.Slots[i];
    const float d[3] = { around.X[i], around.Y[i], around.Z[i] };
    float turned[3];
    Multiply(this->Tensor, d, turned);
    const float height = n[0] * d[0] + n[1] * d[1] + n[2] * d[2] +
      0.5f * (turned[0] * d[0] + turned[1] * d[1] + turned[2] * d[2]);
    if (height * height > LargestHeight * LargestHeight * around.SquaredDistance[i])
    {
      ++this->NumberOfOthers;
      continue;
    }
    for (int c = 0; c < 3; ++c)
    {
      turned[c] += n[c];
    }
    const float squared =
      turned[0] * turned[0] + turned[1] * turned[1] + turned[2] * turned[2];
    const float cosine = turned[0] * m[0] + turned[1] * m[1] + turned[2] * m[2];
    // Whichever side the neighbour's normal points to.
    if (cosine * cosine >= (1 - LargestSine * LargestSine) * squared)
    {
      this->Members.Members[this->Members.Count++] = i;
      residual += 1 - cosine * cosine / squared;
    }
    else
    {
      ++this->NumberOfOthers;
    }
  }
  // Rounding may leave less than nothing of normals that agree.
  this->Deviation = std::sqrt(std::max(residual, 0.0f) / std::max(this->Members.Count, 1));
  this->Members.Near = this->Members.Count;
}

bool vtkPointSplatFace::IsSpread(const vtkPointSplatNeighbors::Neighborhood& around) const
{
  if (this->Members.Count < FewestMembers)
  {
    return false;
  }
  // The direction of the farthest one stands for that of the row.
  const int last = this->Members.Members[this->Members.Count - 1];
  const float e[3] = { around.X[last], around.Y[last], around.Z[last] };
  float along = 0, all = 0;
  for (int k = 0; k < this->Members.Count; ++k)
  {
    const int i = this->Members.Members[k];
    const float dot = e[0] * around.X[i] + e[1] * around.Y[i] + e[2] * around.Z[i];
    along += dot * dot / around.SquaredDistance[last];
    all += around.SquaredDistance[i];
  }
  return all - along > RowSpread * all;
}

void vtkPointSplatFace::Fit(const vtkPointSplatNeighbors::Neighborhood& around,
  const float* normals, const float n[3], float spacing)
{
  std::fill_n(this->Tensor, 6, 0.0f);
  this->Strongest = 0;
  this->Members.Spacing = spacing;
  bool few = false;
  for (const float reach : { FirstReach * spacing, LastReach * spacing })
  {
    this->Select(around, normals, n, reach);
    if (this->Members.Count < FewestMembers)
    {
      // Beside a crease the nearest may all be on the other face.
      few = true;
      continue;
    }
    vtkPointSplatCurvature curvature;
    curvature.Estimate(around, normals, n, this->Members);
    std::copy_n(curvature.Tensor, 6, this->Tensor);
    this->Strongest = curvature.Strongest;
  }
  this->Select(around, normals, n, LastReach * spacing);
  this->Sound = this->IsSpread(around) &&
    (!few || this->Deviation < FlatDeviation || this->Members.Count >= ManyMembers);
  this->Row =
    !this->Sound && this->Members.Count >= FewestInRow && this->Deviation < FlatDeviation;
}

VTK_ABI_NAMESPACE_END
