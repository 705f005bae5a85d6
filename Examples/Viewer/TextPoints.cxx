// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TextPoints.h"

#include "Options.h"

#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <vector>

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ReadTextPoints(const std::string& file)
{
  std::ifstream in(file);
  if (!in)
  {
    throw UserError(file + ": cannot be opened");
  }
  std::vector<double> values;
  size_t columns = 0;
  std::string line;
  for (long number = 1; std::getline(in, line); ++number)
  {
    std::replace_if(
      line.begin(), line.end(), [](char c) { return c == ',' || c == ';' || c == '\r'; }, ' ');
    const size_t start = line.find_first_not_of(" \t");
    if (start == std::string::npos || line[start] == '#' || line.compare(start, 2, "//") == 0)
    {
      continue;
    }
    std::vector<double> row;
    const char* at = line.c_str() + start;
    while (*at)
    {
      char* end = nullptr;
      const double value = std::strtod(at, &end);
      if (end == at)
      {
        throw UserError(file + ": line " + std::to_string(number) + " is not numbers");
      }
      row.push_back(value);
      at = end;
      while (*at == ' ' || *at == '\t')
      {
        ++at;
      }
    }
    if (row.size() == 1 && values.empty())
    {
      continue; // the count
    }
    if (columns == 0)
    {
      columns = row.size();
    }
    if (row.size() != columns || columns < 3)
    {
      throw UserError(file + ": line " + std::to_string(number) + " has " +
        std::to_string(row.size()) + " columns, not " + std::to_string(std::max<size_t>(columns, 3)));
    }
    values.insert(values.end(), row.begin(), row.end());
  }
  if (values.empty())
  {
    throw UserError(file + ": has no points");
  }

  const size_t count = values.size() / columns;
  // With an intensity the further columns begin one later.
  const size_t extra = columns == 4 || columns == 7 ? 4 : 3;
  const size_t further = columns - extra;
  bool unit = further >= 3;
  for (size_t i = 0; unit && i < count; ++i)
  {
    const double* v = &values[i * columns + extra];
    unit = std::abs(v[0] * v[0] + v[1] * v[1] + v[2] * v[2] - 1.0) < 0.02;
  }
  const bool normals = further >= 6 || unit;
  const size_t colourAt = normals ? extra + 3 : extra;
  const bool colours = columns >= colourAt + 3;

  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkFloatArray> normalArray;
  normalArray->SetName("Normals");
  normalArray->SetNumberOfComponents(3);
  vtkNew<vtkUnsignedCharArray> colourArray;
  colourArray->SetName("RGB");
  colourArray->SetNumberOfComponents(3);
  for (size_t i = 0; i < count; ++i)
  {
    const double* v = &values[i * columns];
    points->InsertNextPoint(v);
    if (normals)
    {
      normalArray->InsertNextTuple(v + extra);
    }
    if (colours)
    {
      for (size_t k = 0; k < 3; ++k)
      {
        const double c = std::clamp(v[colourAt + k], 0.0, 255.0);
        colourArray->InsertNextValue(static_cast<unsigned char>(c));
      }
    }
  }
  data->SetPoints(points);
  if (normals)
  {
    data->GetPointData()->SetNormals(normalArray);
  }
  if (colours)
  {
    data->GetPointData()->SetScalars(colourArray);
  }
  return data;
}
