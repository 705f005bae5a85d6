// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Where sensors' positions are given, estimated normals face them.
#include "Expect.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSplatArrays.h"
#include "vtkPointSplatEstimation.h"
#include "vtkPointSplatProjection.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTestErrorObserver.h"

#include <cmath>
#include <iostream>
#include <limits>
#include <string>

namespace
{
constexpr int Side = 30;
/// Of the sensors that saw squares beside one another: above or below.
constexpr double Sides[3] = { 1, -1, 1 };

/// Three squares, the first and the last of which were seen from above, the second from below.
vtkSmartPointer<vtkPolyData> Squares()
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkIntArray> scans;
  scans->SetName(vtkPointSplatArrays::Scan);
  for (int scan = 0; scan < 3; ++scan)
  {
    for (int i = 0; i < Side * Side; ++i)
    {
      points->InsertNextPoint(i % Side + 100 * scan, i / Side, 0);
      scans->InsertNextValue(scan);
    }
  }
  data->SetPoints(points);
  data->GetPointData()->AddArray(scans);
  return data;
}

vtkSmartPointer<vtkDoubleArray> Array(const char* name, int components, vtkIdType tuples)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  array->FillValue(0);
  return array;
}

vtkSmartPointer<vtkDoubleArray> Positions()
{
  auto positions = Array(vtkPointSplatArrays::Sensor, 3, 3);
  for (int scan = 0; scan < 3; ++scan)
  {
    positions->SetTuple3(scan, 100 * scan + 10, 10, 50 * Sides[scan]);
  }
  return positions;
}

/// How many of a filter's normals look to where the sensors were.
vtkIdType Facing(vtkPolyData* out)
{
  vtkIdType facing = 0;
  for (vtkIdType i = 0; i < out->GetNumberOfPoints(); ++i)
  {
    const double z = out->GetPointData()->GetNormals()->GetComponent(i, 2);
    facing += z * Sides[i / (Side * Side)] > 0.99;
  }
  return facing;
}

template <typename Filter>
void Good(const std::string& name)
{
  auto data = Squares();
  vtkNew<Filter> filter;
  data->GetFieldData()->AddArray(Positions());
  filter->SetInputData(data);
  filter->Update();
  Expect(Facing(filter->GetOutput()) == data->GetNumberOfPoints(), name + ": a sensor a scan");

  // A position a point, but for every other point nobody knows it.
  auto each = Array(vtkPointSplatArrays::Sensor, 3, data->GetNumberOfPoints());
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    const int scan = static_cast<int>(i / (Side * Side));
    const double known = i % 2 ? std::numeric_limits<double>::quiet_NaN() : 50 * Sides[scan];
    each->SetTuple3(i, 100 * scan + 10, 10, known);
  }
  data->GetFieldData()->RemoveArray(vtkPointSplatArrays::Sensor);
  data->GetPointData()->AddArray(each);
  data->Modified();
  filter->Update();
  Expect(Facing(filter->GetOutput()) == data->GetNumberOfPoints(), name + ": a sensor a point");
}

/// Each is an error that names the array, and normals are there all the same.
template <typename Filter>
void Bad(const std::string& name, vtkPolyData* data, const std::string& text)
{
  vtkNew<Filter> filter;
  vtkNew<vtkTest::ErrorObserver> errors;
  filter->AddObserver(vtkCommand::ErrorEvent, errors);
  filter->SetInputData(data);
  filter->Update();
  Expect(errors->GetErrorMessage().find(text) != std::string::npos,
    name + ": no error that says " + text + ", but: " + errors->GetErrorMessage());
  Expect(filter->GetOutput()->GetNumberOfPoints() == data->GetNumberOfPoints(),
    name + ": no output");
}

template <typename Filter>
void AllBad()
{
  auto data = Squares();
  data->GetFieldData()->AddArray(Array(vtkPointSplatArrays::Sensor, 3, 2));
  Bad<Filter>("too few scans", data, "goes from 0 to 2");

  data = Squares();
  data->GetFieldData()->AddArray(Array(vtkPointSplatArrays::Sensor, 2, 3));
  Bad<Filter>("two components", data, "2 components");

  data = Squares();
  data->GetFieldData()->AddArray(Positions());
  data->GetPointData()->RemoveArray(vtkPointSplatArrays::Scan);
  Bad<Filter>("no scans", data, "there is no point array ScanId");

  data = Squares();
  vtkNew<vtkStringArray> words;
  words->SetName(vtkPointSplatArrays::Sensor);
  words->SetNumberOfValues(data->GetNumberOfPoints());
  data->GetPointData()->AddArray(words);
  Bad<Filter>("words", data, "of string");
}

void Viewpoint()
{
  auto data = Squares();
  data->GetFieldData()->AddArray(Positions());
  vtkNew<vtkPointSplatEstimation> estimation;
  estimation->SetOrientationToViewpoint();
  estimation->SetViewpoint(100, 0, 500);
  estimation->SetInputData(data);
  estimation->Update();
  Expect(Facing(estimation->GetOutput()) == 2 * Side * Side, "the viewpoint does not decide");
}
}

int TestSplatSensors(int, char*[])
{
  Good<vtkPointSplatEstimation>("estimation");
  Good<vtkPointSplatProjection>("projection");
  AllBad<vtkPointSplatEstimation>();
  AllBad<vtkPointSplatProjection>();
  Viewpoint();
  return failures ? EXIT_FAILURE : EXIT_SUCCESS;
}
