// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatSensors.h"

#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPointSplatArrays.h"

#include <cmath>
#include <sstream>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// A field's array of some name as numbers. One that is no such thing is an error.
vtkDataArray* GetNumbers(vtkFieldData* field, const char* name, const char* kind, int components,
  vtkIdType tuples, std::string& error)
{
  vtkAbstractArray* any = field->GetAbstractArray(name);
  vtkDataArray* array = vtkArrayDownCast<vtkDataArray>(any);
  if (!any)
  {
    return nullptr;
  }
  if (!array || array->GetNumberOfComponents() != components ||
    (tuples >= 0 && array->GetNumberOfTuples() != tuples))
  {
    std::ostringstream text;
    text << "The " << kind << " array " << name << " has " << any->GetNumberOfComponents()
         << " components and " << any->GetNumberOfTuples() << " tuples of "
         << any->GetDataTypeAsString() << "; it should have " << components << " numbers";
    if (tuples >= 0)
    {
      text << " for each of " << tuples << " points";
    }
    text << ". Normals are oriented without sensors.";
    error = text.str();
    return nullptr;
  }
  return array;
}
}

vtkPointSplatSensors::vtkPointSplatSensors(vtkPointSet* input, std::string& error)
{
  const vtkIdType points = input->GetNumberOfPoints();
  vtkPointData* data = input->GetPointData();
  error.clear();
  this->Positions =
    GetNumbers(data, vtkPointSplatArrays::Sensor, "point", 3, points, error);
  if (this->Positions || !error.empty())
  {
    return;
  }
  vtkDataArray* positions =
    GetNumbers(input->GetFieldData(), vtkPointSplatArrays::Sensor, "field", 3, -1, error);
  if (!positions)
  {
    return;
  }
  vtkDataArray* scans = GetNumbers(data, vtkPointSplatArrays::Scan, "point", 1, points, error);
  if (!scans)
  {
    if (error.empty())
    {
      error = std::string("The field array ") + vtkPointSplatArrays::Sensor +
        " has a position for each scan, but there is no point array " +
        vtkPointSplatArrays::Scan +
        " that says which scan a point is of. Normals are oriented without sensors.";
    }
    return;
  }
  if (points > 0)
  {
    double range[2];
    scans->GetRange(range);
    if (!(range[0] >= 0 && range[1] < positions->GetNumberOfTuples()))
    {
      std::ostringstream text;
      text << "The point array " << vtkPointSplatArrays::Scan << " goes from " << range[0] << " to "
           << range[1] << ", but the field array " << vtkPointSplatArrays::Sensor << " has "
           << positions->GetNumberOfTuples()
           << " positions, for scans from 0 on. Normals are oriented without sensors.";
      error = text.str();
      return;
    }
  }
  this->Positions = positions;
  this->Scans = scans;
}

bool vtkPointSplatSensors::Get(vtkIdType id, double x[3]) const
{
  vtkIdType tuple = id;
  if (this->Scans)
  {
    const double scan = this->Scans->GetComponent(id, 0);
    // NaN compares false, and a range of an array leaves it out.
    if (!(scan >= 0))
    {
      return false;
    }
    tuple = static_cast<vtkIdType>(scan);
  }
  // Not GetTuple(), which is not for several threads.
  bool finite = true;
  for (int c = 0; c < 3; ++c)
  {
    x[c] = this->Positions->GetComponent(tuple, c);
    finite = finite && std::isfinite(x[c]);
  }
  return finite;
}

VTK_ABI_NAMESPACE_END
