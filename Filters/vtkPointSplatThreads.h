// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkPointSplatThreads.h
 * @brief parallel loops that are compiled once
 */
#ifndef vtkPointSplatThreads_h
#define vtkPointSplatThreads_h

#include "vtkFiltersPointSplattingModule.h" // For export macro
#include "vtkPointSplattingABI.h"
#include "vtkType.h"

#include <functional>

VTK_ABI_NAMESPACE_BEGIN

/**
 * vtkSMPTools::For, which runs work(begin, end) on parts of [first, last), of `grain` or more at a
 * time where one is given. No template, since VTK compiles a loop once for each way to run threads:
 * a quarter of the time in which these modules, with a hundred loops, would be compiled.
 */
namespace vtkPointSplatThreads
{
using Work = std::function<void(vtkIdType, vtkIdType)>;

VTKFILTERSPOINTSPLATTING_EXPORT void For(vtkIdType first, vtkIdType last, const Work& work);
VTKFILTERSPOINTSPLATTING_EXPORT void For(
  vtkIdType first, vtkIdType last, vtkIdType grain, const Work& work);
}

VTK_ABI_NAMESPACE_END
#endif
