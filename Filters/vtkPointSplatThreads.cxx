// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatThreads.h"

#include "vtkSMPTools.h"

VTK_ABI_NAMESPACE_BEGIN

void vtkPointSplatThreads::For(vtkIdType first, vtkIdType last, const Work& work)
{
  vtkPointSplatThreads::For(first, last, 0, work);
}

void vtkPointSplatThreads::For(vtkIdType first, vtkIdType last, vtkIdType grain, const Work& work)
{
  vtkSMPTools::For(first, last, grain, work);
}

VTK_ABI_NAMESPACE_END
