// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The array that a mapper's scalar mode names, and whether VTK can make colours of it. vtkMapper does
// not survive a lookup table that makes none of an array.
#ifndef vtkPointSplatScalars_h
#define vtkPointSplatScalars_h

#include "vtkPointSplattingABI.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkAbstractArray;
class vtkDataSet;
class vtkMapper;
VTK_ABI_NAMESPACE_END

class vtkPointSplatScalars
{
public:
  vtkPointSplatScalars(vtkMapper* mapper, vtkDataSet* data);

  /// Null where the data have none of that name.
  vtkAbstractArray* Array = nullptr;
  /// What they belong to: 0 points, 1 cells, 2 field data.
  int CellFlag = 0;
  /// Values that are colours themselves.
  bool AreDirect = false;
  /// False for direct scalars of bits, of signed char, or of more than 4 components.
  bool CanBeColours = true;
};

#endif
