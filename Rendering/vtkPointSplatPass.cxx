// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatPass.h"
#include "vtkObjectFactory.h"

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkPointSplatPass);

vtkPointSplatPass::vtkPointSplatPass() = default;
vtkPointSplatPass::~vtkPointSplatPass() = default;

void vtkPointSplatPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

void vtkPointSplatPass::Render(const vtkRenderState*) {}

VTK_ABI_NAMESPACE_END
