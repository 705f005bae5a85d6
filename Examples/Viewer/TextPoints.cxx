// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TextPoints.h"

#include "Options.h"
#include "PointColors.h"
#include "Progress.h"

#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

namespace
{
/**
 * All lines' numbers, one line after the other.
 */
struct Table
{
  std::vector<double> Values;
  size_t Columns = 0;

  size_t GetNumberOfRows() const { return this->Values.size() / this->Columns; }
  const double* Row(size_t row) const { return &this->Values[row * this->Columns]; }

  /**
   * Whether three columns hold unit vectors. Unknown normals are often zero or NaN.
   */
  bool HasNormalsAt(size_t column) const
  {
    if (column + 3 > this->Columns)
    {
      return false;
    }
    bool any = false;
    for (size_t i = 0; i < this->GetNumberOfRows(); ++i)
    {
      const double* n = this->Row(i) + column;
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
};

/**
 * The numbers of one line; false where something else is there.
 */
bool ParseLine(const std::string& line, std::vector<double>& numbers)
{
  numbers.clear();
  const char* at = line.c_str();
  while (*at)
  {
    char* end = nullptr;
    const double value = std::strtod(at, &end);
    if (end == at || (*end && !std::isspace(static_cast<unsigned char>(*end))))
    {
      return false;
    }
    numbers.push_back(value);
    at = end + std::strspn(end, " \t");
  }
  return true;
}

/**
 * Which columns are what; 0 is nowhere, since x is there.
 */
void FindColumns(const Table& table, size_t& normalAt, size_t& colourAt, size_t& scalarAt)
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
      (!normalAt || table.HasNormalsAt(normalAt)))
    {
      return;
    }
  }
  normalAt = colourAt = scalarAt = 0;
}

bool IsName(char c)
{
  return std::isalpha(static_cast<unsigned char>(c)) || c == '"';
}

Table ReadTable(const std::string& file, ProgressBar& progress)
{
  std::ifstream in(file, std::ios::binary);
  if (!in)
  {
    throw UserError(file + ": cannot be opened");
  }
  in.seekg(0, std::ios::end);
  const double size = static_cast<double>(in.tellg());
  in.seekg(0);

  Table table;
  std::vector<double> row;
  std::string line;
  bool names = false;
  bool count = false;
  for (long number = 1; std::getline(in, line); ++number)
  {
    std::replace_if(
      line.begin(), line.end(), [](char c) { return c == ',' || c == ';' || c == '\r'; }, ' ');
    const size_t start = line.find_first_not_of(" \t");
    if (start == std::string::npos || line[start] == '#' || line.compare(start, 2, "//") == 0)
    {
      continue;
    }
    const bool numbers = ParseLine(line.substr(start), row);
    const bool atTop = table.Columns == 0;
    if (atTop && !names && !numbers && IsName(line[start]))
    {
      names = true;
      continue;
    }
    if (atTop && !count && numbers && row.size() == 1)
    {
      count = true;
      continue;
    }
    if (!numbers)
    {
      throw UserError(file + ": line " + std::to_string(number) + " is not numbers");
    }
    if (table.Columns == 0)
    {
      table.Columns = row.size();
    }
    if (row.size() != table.Columns || table.Columns < 3)
    {
      throw UserError(file + ": line " + std::to_string(number) + " has " +
        std::to_string(row.size()) + " columns, not " +
        (table.Columns < 3 ? "at least 3" : std::to_string(table.Columns)));
    }
    table.Values.insert(table.Values.end(), row.begin(), row.end());
    if (number % 4096 == 0)
    {
      progress.Update(static_cast<double>(in.tellg()) / size);
    }
  }
  if (table.Values.empty())
  {
    throw UserError(file + ": has no points");
  }
  return table;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ReadTextPoints(const std::string& file, ProgressBar& progress)
{
  const Table table = ReadTable(file, progress);
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
    const float greatest = *std::max_element(colours.begin(), colours.end());
    data->GetPointData()->SetScalars(MakeColors(colours, greatest <= 1.0f ? 1.0 : 255.0));
  }
  return data;
}
