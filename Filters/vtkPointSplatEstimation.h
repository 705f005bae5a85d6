// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatEstimation
 * @brief   normals and splat radii for points
 */
#ifndef vtkPointSplatEstimation_h
#define vtkPointSplatEstimation_h

#include "vtkFiltersPointSplattingModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkPointSplattingABI.h"

VTK_ABI_NAMESPACE_BEGIN

class VTKFILTERSPOINTSPLATTING_EXPORT vtkPointSplatEstimation : public vtkPolyDataAlgorithm
{
public:
  static vtkPointSplatEstimation* New();
  vtkTypeMacro(vtkPointSplatEstimation, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkPointSplatEstimation();
  ~vtkPointSplatEstimation() override;

  int FillInputPortInformation(int, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkPointSplatEstimation(const vtkPointSplatEstimation&) = delete;
  void operator=(const vtkPointSplatEstimation&) = delete;
};

VTK_ABI_NAMESPACE_END
#endif
