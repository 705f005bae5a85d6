// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkIsosurfaceOutput
 * @brief   the arrays of one of vtkIsosurfacePoints' output data sets
 *
 * Internal.
 */
#ifndef vtkIsosurfaceOutput_h
#define vtkIsosurfaceOutput_h

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIsosurfaceExtraction.h"
#include "vtkPointData.h"
#include "vtkPointSplatArrays.h"
#include "vtkPointSplattingABI.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

VTK_ABI_NAMESPACE_BEGIN

struct vtkIsosurfaceOutput
{
  vtkSmartPointer<vtkPoints> Points = vtkSmartPointer<vtkPoints>::New();
  vtkSmartPointer<vtkFloatArray> Normals = vtkSmartPointer<vtkFloatArray>::New();
  vtkSmartPointer<vtkDoubleArray> Isovalues = vtkSmartPointer<vtkDoubleArray>::New();
  vtkSmartPointer<vtkFloatArray> Radii; // both or none of these
  vtkSmartPointer<vtkFloatArray> Curvatures;
  vtkSmartPointer<vtkFloatArray> Clips; // or none

  vtkIsosurfaceOutput(vtkIdType count, bool precise, bool sizes)
  {
    if (sizes)
    {
      this->Radii = vtkSmartPointer<vtkFloatArray>::New();
      this->Radii->SetName(vtkPointSplatArrays::Radius);
      this->Radii->SetNumberOfTuples(count);
      this->Curvatures = vtkSmartPointer<vtkFloatArray>::New();
      this->Curvatures->SetName(vtkPointSplatArrays::Curvature);
      this->Curvatures->SetNumberOfComponents(6);
      this->Curvatures->SetNumberOfTuples(count);
    }
    this->Points->SetDataType(precise ? VTK_DOUBLE : VTK_FLOAT);
    this->Points->SetNumberOfPoints(count);
    this->Normals->SetName("Normals");
    this->Normals->SetNumberOfComponents(3);
    this->Normals->SetNumberOfTuples(count);
    this->Isovalues->SetName(vtkPointSplatArrays::Isovalue);
    this->Isovalues->SetNumberOfTuples(count);
  }

  vtkIsosurfaceExtraction::Target GetTarget(vtkIdType first) const
  {
    vtkIsosurfaceExtraction::Target target;
    target.Normals = this->Normals->GetPointer(0) + 3 * first;
    if (this->Radii)
    {
      target.Radii = this->Radii->GetPointer(0) + first;
      target.Curvatures = this->Curvatures->GetPointer(0) + 6 * first;
    }
    void* points = this->Points->GetVoidPointer(0);
    if (this->Points->GetDataType() == VTK_DOUBLE)
    {
      target.PrecisePoints = static_cast<double*>(points) + 3 * first;
    }
    else
    {
      target.Points = static_cast<float*>(points) + 3 * first;
    }
    return target;
  }

  void MoveTo(vtkPolyData* output) const
  {
    output->SetPoints(this->Points);
    output->GetPointData()->SetNormals(this->Normals);
    output->GetPointData()->AddArray(this->Isovalues);
    if (this->Radii)
    {
      output->GetPointData()->AddArray(this->Radii);
      output->GetPointData()->AddArray(this->Curvatures);
    }
    if (this->Clips)
    {
      output->GetPointData()->AddArray(this->Clips);
    }
  }
};

VTK_ABI_NAMESPACE_END
#endif
