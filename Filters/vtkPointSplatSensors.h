// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatSensors
 * @brief   where the scanner stood that saw a point
 *
 * An internal helper of the filters, and of ParaView's. The input says it in one of two ways:
 * - the point array `SensorPosition`, 3 components, world units: a position for each point; or
 * - the field array `SensorPosition`, 3 components, world units: a position for each scan; with
 *   the point array `ScanId`, 1 component: a point's scan, counted from 0.
 * A position that is not finite is that of a sensor nobody knows.
 */
#ifndef vtkPointSplatSensors_h
#define vtkPointSplatSensors_h

#include "vtkDataArray.h"
#include "vtkFiltersPointSplattingModule.h" // For export macro
#include "vtkPointSplattingABI.h"
#include "vtkSmartPointer.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSet;

class VTKFILTERSPOINTSPLATTING_EXPORT vtkPointSplatSensors
{
public:
  /**
   * Takes the arrays of the input. Where they cannot be used, `error` says why and what to do, and
   * there are no sensors; without such arrays there are none either, and no error.
   */
  explicit vtkPointSplatSensors(vtkPointSet* input, std::string& error);

  bool IsEmpty() const { return !this->Positions; }
  /// The position of the sensor that saw a point; false where it is not known.
  bool Get(vtkIdType id, double x[3]) const;

private:
  vtkSmartPointer<vtkDataArray> Positions;
  vtkSmartPointer<vtkDataArray> Scans; // or none, where there is a position for each point
};

VTK_ABI_NAMESPACE_END
#endif
