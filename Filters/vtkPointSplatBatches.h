// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkPointSplatBatches.h
 * @brief a parallel loop that reports progress and can be aborted
 */
#ifndef vtkPointSplatBatches_h
#define vtkPointSplatBatches_h

#include "vtkAlgorithm.h"
#include "vtkFiltersPointSplattingConfigure.h"
#include "vtkPointSplattingABI.h"
#include "vtkSMPTools.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN

namespace vtkPointSplatBatches
{
/// Whether somebody asked the algorithm to stop.
inline bool IsAborted(vtkAlgorithm* self)
{
#if PointSplatting_HAVE_CHECK_ABORT
  return self->CheckAbort();
#else
  return self->GetAbortExecute() != 0;
#endif
}

/**
 * Runs functor(begin, end) over [0, count) like vtkSMPTools::For, in batches between
 * which the calling thread moves self's progress from `from` to `to` and looks whether
 * it is to stop. A batch is large enough to give each thread several times `grain`. Returns
 * false when it was stopped.
 */
template <typename Functor>
bool For(
  vtkAlgorithm* self, vtkIdType count, vtkIdType grain, double from, double to, Functor& functor)
{
  const vtkIdType numberOfBatches = 16;
  const vtkIdType batch = std::max<vtkIdType>((count + numberOfBatches - 1) / numberOfBatches,
    4 * grain * vtkSMPTools::GetEstimatedNumberOfThreads());
  for (vtkIdType begin = 0; begin < count; begin += batch)
  {
    self->UpdateProgress(from + (to - from) * begin / count);
    if (IsAborted(self))
    {
      return false;
    }
    vtkSMPTools::For(begin, std::min(begin + batch, count), grain, functor);
  }
  self->UpdateProgress(to);
  return !IsAborted(self);
}
}

VTK_ABI_NAMESPACE_END
#endif
