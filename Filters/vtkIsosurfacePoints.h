// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkIsosurfacePoints
 * @brief   oriented points on isosurfaces of a volume
 */
#ifndef vtkIsosurfacePoints_h
#define vtkIsosurfacePoints_h

#include "vtkFiltersPointSplattingModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkPointSplattingABI.h"

VTK_ABI_NAMESPACE_BEGIN

class VTKFILTERSPOINTSPLATTING_EXPORT vtkIsosurfacePoints : public vtkPolyDataAlgorithm
{
public:
  static vtkIsosurfacePoints* New();
  vtkTypeMacro(vtkIsosurfacePoints, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkIsosurfacePoints();
  ~vtkIsosurfacePoints() override;

  int FillInputPortInformation(int, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkIsosurfacePoints(const vtkIsosurfacePoints&) = delete;
  void operator=(const vtkIsosurfacePoints&) = delete;
};

VTK_ABI_NAMESPACE_END
#endif
