// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkPointSplatBatches.h
 * @brief a parallel loop that reports progress and can be aborted
 */
#ifndef vtkPointSplatBatches_h
#define vtkPointSplatBatches_h

#include "vtkFiltersPointSplattingModule.h" // For export macro
#include "vtkPointSplatThreads.h"
#include "vtkPointSplattingABI.h"
#include "vtkType.h"

class vtkAlgorithm;

VTK_ABI_NAMESPACE_BEGIN

namespace vtkPointSplatBatches
{
/// Whether somebody asked the algorithm to stop.
VTKFILTERSPOINTSPLATTING_EXPORT bool IsAborted(vtkAlgorithm* self);

/**
 * Runs work(begin, end) over [0, count) like vtkPointSplatThreads::For, in batches between
 * which the calling thread moves self's progress from `from` to `to` and looks whether
 * it is to stop. A batch is large enough to give each thread several times `grain`. Returns
 * false when it was stopped.
 */
VTKFILTERSPOINTSPLATTING_EXPORT bool For(vtkAlgorithm* self, vtkIdType count, vtkIdType grain,
  double from, double to, const vtkPointSplatThreads::Work& work);
}

VTK_ABI_NAMESPACE_END
#endif
