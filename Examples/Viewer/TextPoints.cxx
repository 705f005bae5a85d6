// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TextPoints.h"

#include "PointColors.h"
#include "Progress.h"
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
/**
 * Whether three columns hold unit vectors. Unknown normals are often zero or NaN.
 */
bool HasNormalsAt(const TextTable& table, size_t column)
{
  if (column + 3 > table.Columns)
  {
    return false;
  }
  bool any = false;
  for (size_t i = 0; i < table.GetNumberOfRows(); ++i)
  {
    const double* n = table.Row(i) + column;
    const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    if (std::abs(length - 1.0) <= 0.01)
    {
      any = true;
    }
    else if (length > 0.0) // false for NaN too
    {
      return false;
    }
  }
  return any;
}

/**
 * Which columns are what; 0 is nowhere, since x is there.
 */
void FindColumns(const TextTable& table, size_t& normalAt, size_t& colourAt, size_t& scalarAt)
{
  // What may follow x y z: (n)ormal, (c)olour, (s)calar; the first that fits is taken.
  // Columns behind are passed over, but not where a scalar would then be guessed.
  for (const std::string layout :
    { "snc", "scn", "ncs", "cns", "nc", "cn", "sn", "ns", "sc", "n", "c", "s" })
  {
    normalAt = colourAt = scalarAt = 0;
    size_t column = 3;
    for (const char kind : layout)
    {
      (kind == 'n' ? normalAt : kind == 'c' ? colourAt : scalarAt) = column;
      column += kind == 's' ? 1 : 3;
    }
    if ((scalarAt ? column == table.Columns : column <= table.Columns) &&
      (!normalAt || HasNormalsAt(table, normalAt)))
    {
      return;
    }
  }
  normalAt = colourAt = scalarAt = 0;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ReadTextPoints(const std::string& file, ProgressBar& progress)
{
  const TextTable table = TextTable::Read(file, progress);
  const size_t rows = table.GetNumberOfRows();

  size_t normalAt = 0;
  size_t colourAt = 0;
  size_t scalarAt = 0;
  FindColumns(table, normalAt, colourAt, scalarAt);

  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(rows));
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> scalars;
  scalars->SetName("Intensity");
  std::vector<float> colours;
  for (size_t i = 0; i < rows; ++i)
  {
    const double* row = table.Row(i);
    points->SetPoint(static_cast<vtkIdType>(i), row);
    if (normalAt)
    {
      normals->InsertNextTuple(row + normalAt);
    }
    if (colourAt)
    {
      colours.insert(colours.end(), row + colourAt, row + colourAt + 3);
    }
    if (scalarAt)
    {
      scalars->InsertNextTuple(row + scalarAt);
    }
  }

  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  if (normalAt)
  {
    data->GetPointData()->SetNormals(normals);
  }
  if (scalarAt)
  {
    data->GetPointData()->AddArray(scalars);
  }
  if (colourAt)
  {
    // std::fmax passes over NaN.
    const float greatest = std::accumulate(
      colours.begin(), colours.end(), 0.0f, [](float a, float b) { return std::fmax(a, b); });
    data->GetPointData()->SetScalars(MakeColors(colours, greatest <= 1.0f ? 1.0 : 255.0));
  }
  return data;
}
