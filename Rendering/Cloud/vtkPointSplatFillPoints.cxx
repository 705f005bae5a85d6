// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatFillPoints.h"

#include <algorithm>
#include <utility>

//------------------------------------------------------------------------------
vtkPointSplatFillPoints::Place vtkPointSplatFillPoints::PlaceOf(const uint32_t* splat)
{
  return { splat[7], { { splat[0], splat[1], splat[2] } } };
}

//------------------------------------------------------------------------------
void vtkPointSplatFillPoints::Make(
  vtkIdType own, List points, const uint32_t* splats, size_t words)
{
  this->Points = std::move(points);
  this->Numbers.clear();
  for (size_t i = 0; i < this->Points.size(); ++i)
  {
    const vtkIdType number = own + static_cast<vtkIdType>(i);
    Place place = PlaceOf(splats + words * static_cast<size_t>(number));
    place.Nearest = static_cast<uint32_t>(this->Points[i].Ends[0]);
    this->Numbers.emplace_back(place, number);
  }
  std::sort(this->Numbers.begin(), this->Numbers.end());
}

//------------------------------------------------------------------------------
vtkIdType vtkPointSplatFillPoints::GetNumber(const uint32_t* splat) const
{
  const Place place = PlaceOf(splat);
  const auto at = std::lower_bound(this->Numbers.begin(), this->Numbers.end(), place,
    [](const auto& entry, const Place& wanted) { return entry.first < wanted; });
  return at != this->Numbers.end() && !(place < at->first) ? at->second
                                                           : static_cast<vtkIdType>(splat[7]);
}
