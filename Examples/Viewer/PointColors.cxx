// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PointColors.h"

#include "vtkUnsignedCharArray.h"

#include <algorithm>

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnsignedCharArray> MakeColors(const std::vector<float>& rgb, double greatest)
{
  auto colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colors->SetName("RGB");
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(static_cast<vtkIdType>(rgb.size() / 3));
  std::transform(rgb.begin(), rgb.end(), colors->GetPointer(0), [greatest](float value) {
    // In this order, NaN becomes 0.
    return static_cast<unsigned char>(
      0.5 + std::min(255.0, std::max(0.0, 255.0 * value / greatest)));
  });
  return colors;
}
