// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatBatches.h"

#include "vtkAlgorithm.h"
#include "vtkFiltersPointSplattingConfigure.h"
#include "vtkPointSplatThreads.h"
#include "vtkSMPTools.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN

bool vtkPointSplatBatches::IsAborted(vtkAlgorithm* self)
{
#if PointSplatting_HAVE_CHECK_ABORT
  return self->CheckAbort();
#else
  return self->GetAbortExecute() != 0;
#endif
}

bool vtkPointSplatBatches::For(vtkAlgorithm* self, vtkIdType count, vtkIdType grain, double from,
  double to, const vtkPointSplatThreads::Work& work)
{
  const vtkIdType numberOfBatches = 16;
  const vtkIdType batch = std::max<vtkIdType>((count + numberOfBatches - 1) / numberOfBatches,
    4 * grain * vtkSMPTools::GetEstimatedNumberOfThreads());
  for (vtkIdType begin = 0; begin < count; begin += batch)
  {
    self->UpdateProgress(from + (to - from) * begin / count);
    if (vtkPointSplatBatches::IsAborted(self))
    {
      return false;
    }
    vtkPointSplatThreads::For(begin, std::min(begin + batch, count), grain, work);
  }
  self->UpdateProgress(to);
  return !vtkPointSplatBatches::IsAborted(self);
}

VTK_ABI_NAMESPACE_END
