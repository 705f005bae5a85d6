// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatMapper.h"
#include "vtkObjectFactory.h"
#include "vtkUnsignedCharArray.h"

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkPointSplatMapper);

vtkPointSplatMapper::vtkPointSplatMapper() = default;
vtkPointSplatMapper::~vtkPointSplatMapper() = default;

void vtkPointSplatMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

void vtkPointSplatMapper::RenderPiece(vtkRenderer*, vtkActor*) {}
vtkSmartPointer<vtkUnsignedCharArray> vtkPointSplatMapper::MapPointColours(vtkDataSet*, int&) { return nullptr; }

VTK_ABI_NAMESPACE_END
