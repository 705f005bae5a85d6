// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TextPoints.h"

#include "PointColors.h"
#include "Progress.h"
#include "TextColumns.h"
#include "TextTable.h"

#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <numeric>
#include <string>
#include <vector>

namespace
{
vtkSmartPointer<vtkFloatArray> MakeArray(const std::string& name, int components)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  return array;
}

float Of(const double* row, size_t column)
{
  return static_cast<float>(row[column]);
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ReadTextPoints(const std::string& file, ProgressBar& progress)
{
  const TextTable table = TextTable::Read(file, progress);
  const TextColumns columns = TextColumns::Find(table);
  const size_t rows = table.GetNumberOfRows();

  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(rows));
  const vtkSmartPointer<vtkFloatArray> normals = MakeArray("Normals", 3);
  const vtkSmartPointer<vtkFloatArray> radii = MakeArray("SplatRadius", 1);
  std::vector<vtkSmartPointer<vtkFloatArray>> others;
  for (const auto& other : columns.Others)
  {
    others.push_back(MakeArray(other.first, 1));
  }
  std::vector<float> colours;
  for (size_t i = 0; i < rows; ++i)
  {
    const double* row = table.Row(i);
    points->SetPoint(static_cast<vtkIdType>(i), row[columns.Point[0]], row[columns.Point[1]],
      row[columns.Point[2]]);
    if (const auto& at = columns.Normal)
    {
      normals->InsertNextTuple3(row[(*at)[0]], row[(*at)[1]], row[(*at)[2]]);
    }
    if (const auto& at = columns.Colour)
    {
      colours.insert(colours.end(), { Of(row, (*at)[0]), Of(row, (*at)[1]), Of(row, (*at)[2]) });
    }
    if (columns.Radius)
    {
      radii->InsertNextValue(Of(row, *columns.Radius));
    }
    for (size_t k = 0; k < others.size(); ++k)
    {
      others[k]->InsertNextValue(Of(row, columns.Others[k].second));
    }
  }

  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  if (columns.Normal)
  {
    data->GetPointData()->SetNormals(normals);
  }
  if (columns.Radius)
  {
    data->GetPointData()->AddArray(radii);
  }
  for (const vtkSmartPointer<vtkFloatArray>& other : others)
  {
    data->GetPointData()->AddArray(other);
  }
  if (columns.Colour)
  {
    // std::fmax passes over NaN.
    const float greatest = std::accumulate(
      colours.begin(), colours.end(), 0.0f, [](float a, float b) { return std::fmax(a, b); });
    const double white = greatest <= 1.0f ? 1.0 : greatest <= 255.0f ? 255.0 : 65535.0;
    data->GetPointData()->SetScalars(MakeColors(colours, white));
  }
  return data;
}
