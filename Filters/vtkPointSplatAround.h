// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatAround
 * @brief   a point's neighbourhood, from a list of its neighbours that was kept
 *
 * An internal helper of vtkPointSplatProjection.
 */
#ifndef vtkPointSplatAround_h
#define vtkPointSplatAround_h

#include "vtkPointSplatNeighbors.h"

VTK_ABI_NAMESPACE_BEGIN

/// The neighbours of one slot, from their list.
struct vtkPointSplatAround
{
  using Slot = vtkPointSplatNeighbors::Slot;
  static constexpr int Capacity = vtkPointSplatNeighbors::MaximumNumberOfNeighbors;

  vtkPointSplatNeighbors::Neighborhood Take(
    const vtkPointSplatNeighbors& neighbors, Slot slot, const Slot* list, int k)
  {
    double centre[3], other[3];
    neighbors.GetPosition(slot, centre);
    int n = 0;
    for (; n < k && list[n] != vtkPointSplatNeighbors::None; ++n)
    {
      neighbors.GetPosition(list[n], other);
      this->X[n] = static_cast<float>(other[0] - centre[0]);
      this->Y[n] = static_cast<float>(other[1] - centre[1]);
      this->Z[n] = static_cast<float>(other[2] - centre[2]);
      this->Squared[n] =
        this->X[n] * this->X[n] + this->Y[n] * this->Y[n] + this->Z[n] * this->Z[n];
    }
    return { slot, n, list, this->X, this->Y, this->Z, this->Squared };
  }

  float X[Capacity], Y[Capacity], Z[Capacity], Squared[Capacity];
};

VTK_ABI_NAMESPACE_END
#endif
