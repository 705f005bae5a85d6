// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatEstimation.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkPointSplatEstimation);

vtkPointSplatEstimation::vtkPointSplatEstimation() = default;
vtkPointSplatEstimation::~vtkPointSplatEstimation() = default;

void vtkPointSplatEstimation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

int vtkPointSplatEstimation::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

int vtkPointSplatEstimation::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPointSet* input = vtkPointSet::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->SetPoints(input->GetPoints());
  output->GetPointData()->PassData(input->GetPointData());
  return 1;
}

VTK_ABI_NAMESPACE_END
