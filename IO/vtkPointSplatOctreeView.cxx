// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatOctreeView.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkMatrix4x4.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
/// Of what a row makes of a box's points, the value at its centre and how far others are from it.
std::array<double, 2> RangeOf(const std::array<double, 4>& row, const vtkBoundingBox& box)
{
  double centre[3];
  double lengths[3];
  box.GetCenter(centre);
  box.GetLengths(lengths);
  std::array<double, 2> range{ row[3], 0.0 };
  for (size_t k = 0; k < 3; ++k)
  {
    range[0] += row[k] * centre[k];
    range[1] += std::abs(row[k]) * 0.5 * lengths[k];
  }
  return range;
}

double LengthOf(const std::array<double, 4>& row)
{
  return std::hypot(row[0], row[1], row[2]);
}
}

//------------------------------------------------------------------------------
vtkPointSplatOctreeView::vtkPointSplatOctreeView(vtkCamera* camera, int width, int height)
  : Pixels{ 0.5 * width, 0.5 * height }
{
  const vtkMatrix4x4* place = camera->GetViewTransformMatrix();
  std::copy(place->GetData(), place->GetData() + 16, this->Place.begin());
  const double aspect = static_cast<double>(width) / height;
  const vtkMatrix4x4* lens = camera->GetProjectionTransformMatrix(aspect, -1.0, 1.0);
  constexpr int rows[] = { 0, 1, 3 };
  for (size_t r = 0; r < 3; ++r)
  {
    const double* row = lens->GetData() + 4 * rows[r];
    std::copy(row, row + 4, this->Lens[r].begin());
  }
  this->Combine();
}

//------------------------------------------------------------------------------
void vtkPointSplatOctreeView::Combine()
{
  for (size_t r = 0; r < 3; ++r)
  {
    for (size_t column = 0; column < 4; ++column)
    {
      this->Rows[r][column] = 0.0;
      for (size_t k = 0; k < 4; ++k)
      {
        this->Rows[r][column] += this->Lens[r][k] * this->Place[4 * k + column];
      }
    }
  }
}

//------------------------------------------------------------------------------
bool vtkPointSplatOctreeView::IsValid() const
{
  return std::all_of(this->Rows.begin(), this->Rows.end(), [](const Row& row) {
    return std::all_of(row.begin(), row.end(), [](double x) { return std::isfinite(x); });
  }) && LengthOf(this->Rows[0]) > 0.0 && LengthOf(this->Rows[1]) > 0.0;
}

//------------------------------------------------------------------------------
bool vtkPointSplatOctreeView::IsOutside(const vtkBoundingBox& box) const
{
  for (size_t r = 0; r < 2; ++r)
  {
    for (const double sign : { -1.0, 1.0 })
    {
      Row side;
      for (size_t k = 0; k < 4; ++k)
      {
        side[k] = this->Rows[2][k] + sign * this->Rows[r][k];
      }
      const std::array<double, 2> range = RangeOf(side, box);
      if (range[0] + range[1] < 0.0)
      {
        return true;
      }
    }
  }
  return false;
}

//------------------------------------------------------------------------------
double vtkPointSplatOctreeView::PixelsOf(const vtkBoundingBox& box, double radius) const
{
  const std::array<double, 2> range = RangeOf(this->Rows[2], box);
  const double nearest = range[0] - range[1];
  const double size = radius *
    std::max(LengthOf(this->Rows[0]) * this->Pixels[0], LengthOf(this->Rows[1]) * this->Pixels[1]);
  return nearest > 0.0 && std::isfinite(size) ? size / nearest
                                              : std::numeric_limits<double>::infinity();
}

//------------------------------------------------------------------------------
vtkPointSplatOctreeView vtkPointSplatOctreeView::After(const vtkPointSplatOctreeView& before) const
{
  vtkPointSplatOctreeView after = *this;
  // From one kind of projection to the other there is no way to go on.
  if (!this->IsValid() || !before.IsValid() || this->Lens[2] != before.Lens[2])
  {
    return after;
  }
  std::array<double, 16> step;
  vtkMatrix4x4::Invert(before.Place.data(), step.data());
  vtkMatrix4x4::Multiply4x4(this->Place.data(), step.data(), step.data());
  vtkMatrix4x4::Multiply4x4(step.data(), this->Place.data(), after.Place.data());
  for (size_t r = 0; r < 2; ++r)
  {
    const double zoom = LengthOf(this->Lens[r]) / LengthOf(before.Lens[r]);
    for (double& number : after.Lens[r])
    {
      number *= zoom;
    }
  }
  after.Combine();
  return after;
}

//------------------------------------------------------------------------------
bool vtkPointSplatOctreeView::operator==(const vtkPointSplatOctreeView& other) const
{
  return this->Rows == other.Rows && this->Pixels == other.Pixels;
}
