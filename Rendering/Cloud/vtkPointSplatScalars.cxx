// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatScalars.h"

#include "vtkAbstractArray.h"
#include "vtkMapper.h"
#include "vtkUnsignedCharArray.h"

//------------------------------------------------------------------------------
vtkPointSplatScalars::vtkPointSplatScalars(vtkMapper* mapper, vtkDataSet* data)
{
  this->Array = vtkAbstractMapper::GetAbstractScalars(data, mapper->GetScalarMode(),
    mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), this->CellFlag);
  if (!this->Array)
  {
    return;
  }
  const int mode = mapper->GetColorMode();
  this->AreDirect = mode == VTK_COLOR_MODE_DIRECT_SCALARS ||
    (mode == VTK_COLOR_MODE_DEFAULT && vtkUnsignedCharArray::SafeDownCast(this->Array));
  const int type = this->Array->GetDataType();
  this->CanBeColours = !this->AreDirect ||
    (this->Array->GetNumberOfComponents() <= 4 && type != VTK_BIT && type != VTK_CHAR &&
      type != VTK_SIGNED_CHAR);
}
