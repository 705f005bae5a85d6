// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// A cloud that is gathered point by point, with normals.
#ifndef Gathered_h
#define Gathered_h

#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

/// A cloud in the making.
class Gathered
{
public:
  Gathered()
  {
    this->Normals->SetName("Normals");
    this->Normals->SetNumberOfComponents(3);
    this->Cloud->SetPoints(this->Points);
    this->Cloud->GetPointData()->SetNormals(this->Normals);
  }
  void Add(const double x[3], const double n[3])
  {
    this->Points->InsertNextPoint(x);
    this->Normals->InsertNextTuple(n);
  }
  const vtkSmartPointer<vtkPolyData> Cloud = vtkSmartPointer<vtkPolyData>::New();

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkFloatArray> Normals;
};

#endif
