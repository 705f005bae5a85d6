// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIsosurfacePoints.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkIsosurfacePoints);

vtkIsosurfacePoints::vtkIsosurfacePoints() = default;
vtkIsosurfacePoints::~vtkIsosurfacePoints() = default;

void vtkIsosurfacePoints::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

int vtkIsosurfacePoints::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkIsosurfacePoints::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector*)
{
  return 1;
}

VTK_ABI_NAMESPACE_END
