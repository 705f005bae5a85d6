// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatPixelSize.h"

//------------------------------------------------------------------------------
vtkPointSplatPixelSize::vtkPointSplatPixelSize(
  const vtkPointSplatView& view, const vtkPointSplatItem& item)
  : RowW(glm::transpose(item.GetMCVC(view)) * glm::dvec4(view.PixelW))
  , LeastW(std::max(view.PixelW.w - view.PixelW.z * view.Near, 1e-30))
  , PixelsPerUnit(glm::length(glm::dvec3(view.PixelX)) * item.GetMeanStretch())
{
}
