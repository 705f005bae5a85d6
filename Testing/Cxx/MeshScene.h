// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Meshes that tests of vtkPointSplatEstimation make, and what it makes of them.
#ifndef MeshScene_h
#define MeshScene_h

#include "Expect.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSplatArrays.h"
#include "vtkPointSplatEstimation.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <cmath>

namespace MeshScene
{
inline vtkFloatArray* Array(vtkPolyData* data, const char* name)
{
  return vtkFloatArray::SafeDownCast(data->GetPointData()->GetArray(name));
}

/// The estimation of a data set, and how often it warned.
struct Estimated
{
  vtkNew<vtkPointSplatEstimation> Filter;
  int Warnings = 0;

  explicit Estimated(vtkPolyData* data)
  {
    vtkNew<vtkCallbackCommand> count;
    count->SetClientData(&this->Warnings);
    count->SetCallback([](vtkObject*, unsigned long, void* warnings, void*) {
      ++*static_cast<int*>(warnings);
    });
    this->Filter->AddObserver(vtkCommand::WarningEvent, count);
    this->Filter->SetInputData(data);
    this->Filter->Update();
  }
  float Radius(vtkIdType id)
  {
    return Array(this->Filter->GetOutput(), vtkPointSplatArrays::Radius)->GetValue(id);
  }
};

inline vtkSmartPointer<vtkPolyData> MakeSphere(double radius)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(48);
  sphere->SetPhiResolution(32);
  sphere->Update();
  return sphere->GetOutput();
}

/// A square of n x n points in the plane z, its normals up or down, its triangles' edges from 1.
inline void AddSquare(vtkPolyData* data, int n, double z, double side)
{
  const vtkIdType first = data->GetNumberOfPoints();
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      data->GetPoints()->InsertNextPoint(i, j, z);
      data->GetPointData()->GetNormals()->InsertNextTuple3(0, 0, side);
    }
  }
  for (int j = 0; j + 1 < n; ++j)
  {
    for (int i = 0; i + 1 < n; ++i)
    {
      const vtkIdType a = first + i + n * j;
      const vtkIdType quad[4] = { a, a + 1, a + n + 1, a + n };
      data->GetPolys()->InsertNextCell(4, quad);
    }
  }
}

/// A disc in the plane z = 0 as one polygon of so many corners, its normals up, about a place on the line x = y.
inline void AddDisc(vtkPolyData* data, vtkIdType corners, double centre, double radius)
{
  data->GetPolys()->InsertNextCell(static_cast<int>(corners));
  for (vtkIdType k = 0; k < corners; ++k)
  {
    const double angle = 2 * vtkMath::Pi() * k / corners;
    data->GetPolys()->InsertCellPoint(data->GetPoints()->InsertNextPoint(
      centre + radius * std::cos(angle), centre + radius * std::sin(angle), 0));
    data->GetPointData()->GetNormals()->InsertNextTuple3(0, 0, 1);
  }
}

/// Makes a data set's cells anew of those that change(cell, ids), which may change them, says to keep.
template <typename Change>
inline void ChangeCells(vtkPolyData* data, const Change& change)
{
  vtkNew<vtkCellArray> changed;
  for (vtkIdType cell = 0; cell < data->GetNumberOfPolys(); ++cell)
  {
    vtkNew<vtkIdList> ids;
    data->GetPolys()->GetCellAtId(cell, ids);
    if (change(cell, ids))
    {
      changed->InsertNextCell(ids);
    }
  }
  data->SetPolys(changed);
}

inline vtkSmartPointer<vtkPolyData> MakeEmpty()
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  vtkNew<vtkCellArray> cells;
  data->SetPoints(points);
  data->GetPointData()->SetNormals(normals);
  data->SetPolys(cells);
  return data;
}

/// A mesh with points of its own for each triangle.
inline vtkSmartPointer<vtkPolyData> MakeSoup(vtkPolyData* mesh)
{
  vtkSmartPointer<vtkPolyData> soup = MakeEmpty();
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> ids;
    mesh->GetCellPoints(cell, ids);
    soup->GetPolys()->InsertNextCell(3);
    for (vtkIdType k = 0; k < 3; ++k)
    {
      soup->GetPointData()->GetNormals()->InsertNextTuple(
        mesh->GetPointData()->GetNormals()->GetTuple(ids->GetId(k)));
      soup->GetPolys()->InsertCellPoint(soup->GetPoints()->InsertNextPoint(mesh->GetPoint(ids->GetId(k))));
    }
  }
  return soup;
}

/// How far disks, so many times as large, of a mesh in the plane z reach past x = 0, where it ends.
inline double GetFarthest(Estimated& estimated, double times = 1)
{
  vtkPolyData* splats = estimated.Filter->GetOutput();
  vtkFloatArray* clips = Array(splats, vtkPointSplatArrays::Clip);
  double farthest = 0;
  for (vtkIdType id = 0; id < splats->GetNumberOfPoints(); ++id)
  {
    double clip[6], x[3];
    clips->GetTuple(id, clip);
    splats->GetPoint(id, x);
    for (int k = 0; k < 360; ++k)
    {
      const double angle = vtkMath::RadiansFromDegrees(static_cast<double>(k));
      const double r = times * estimated.Radius(id);
      const double d[3] = { r * std::cos(angle), r * std::sin(angle), 0 };
      const bool kept = vtkMath::Dot(clip, d) <= 1 && vtkMath::Dot(clip + 3, d) <= 1;
      farthest = kept ? std::max(farthest, -(x[0] + d[0])) : farthest;
    }
  }
  return farthest;
}
}

#endif
