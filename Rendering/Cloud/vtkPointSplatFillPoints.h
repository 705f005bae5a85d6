// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The fill points of a block (vtkPointSplatEstimation::SetFillGaps): splats between points, which have the number
// of the nearest one, and of colours and the like what lies between those of up to three.
//
// They are told from other splats of that point by their place, whatever order splats are in, and are
// numbered behind the block's own points.
#ifndef vtkPointSplatFillPoints_h
#define vtkPointSplatFillPoints_h

#include "vtkDataArray.h"
#include "vtkPointSplatEstimation.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstdint>
#include <vector>

class vtkPointSplatFillPoints
{
public:
  using List = std::vector<vtkPointSplatEstimation::FillPoint>;

  /// splats: packed, of `words` words each, in the order of the block's own points and then of the fill points,
  /// whose number is in their last one.
  void Make(vtkIdType own, List points, const uint32_t* splats, size_t words);

  /// The number of a packed splat's point: of the block's own, or of a fill point behind these.
  vtkIdType GetNumber(const uint32_t* splat) const;

  /// A tuple for each number: an array of the block's points, and what fill points have of it.
  template <typename Array>
  vtkSmartPointer<Array> Extend(Array* array) const
  {
    return array ? Array::SafeDownCast(
                     vtkPointSplatEstimation::WithFillPoints(array, this->Points).Get())
                 : nullptr;
  }

private:
  struct Place
  {
    uint32_t Nearest;
    std::array<uint32_t, 3> Position; // floats, as their bits
    bool operator<(const Place& other) const
    {
      return this->Nearest != other.Nearest ? this->Nearest < other.Nearest
                                            : this->Position < other.Position;
    }
  };
  static Place PlaceOf(const uint32_t* splat);

  List Points;
  std::vector<std::pair<Place, vtkIdType>> Numbers; // in the order of places
};

#endif
