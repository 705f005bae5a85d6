// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// How large lengths of an item are in the image, at the corner of a box that is nearest to the eye.
#ifndef vtkPointSplatPixelSize_h
#define vtkPointSplatPixelSize_h

#include "vtkPointSplatItem.h"

#include <algorithm>
#include <cstddef>

class vtkPointSplatPixelSize
{
public:
  vtkPointSplatPixelSize(const vtkPointSplatView& view, const vtkPointSplatItem& item);

  /// Pixels that one unit of length takes; box: in the coordinates of the cloud's buffers.
  template <typename Box>
  double At(const Box& box) const
  {
    double w = this->RowW.w;
    for (int k = 0; k < 3; ++k)
    {
      const size_t i = static_cast<size_t>(k);
      w += this->RowW[k] * (this->RowW[k] > 0.0 ? box.Low[i] : box.High[i]);
    }
    return this->PixelsPerUnit / std::max(w, this->LeastW);
  }

private:
  glm::dvec4 RowW;      // of a point its w
  double LeastW;        // on the near plane
  double PixelsPerUnit; // over w
};

#endif
