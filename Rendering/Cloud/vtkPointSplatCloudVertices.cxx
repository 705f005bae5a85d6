// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Of the cloud: its points as plain vertices.
#include "vtkPointSplatCloud.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstring>

//------------------------------------------------------------------------------
uint32_t vtkPointSplatCloud::ColourOf(vtkIdType splat) const
{
  const uint32_t colour = this->Colours[static_cast<size_t>(splat)];
  if (this->ValueTable.empty())
  {
    return colour;
  }
  if (colour >> 31)
  {
    return this->ValueTable.back(); // no value
  }
  float value;
  std::memcpy(&value, &colour, 4);
  const double entry = value * this->ValueScale[0] + this->ValueScale[1];
  const double last = static_cast<double>(this->ValueTable.size()) - 2.0;
  return this->ValueTable[static_cast<size_t>(std::clamp(entry, 0.0, last))];
}

//------------------------------------------------------------------------------
void vtkPointSplatCloud::MakeVertices(vtkPolyData* vertices) const
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetName("Colors");
  colours->SetNumberOfComponents(4);
  vtkNew<vtkCellArray> cells;
  for (const Block& block : this->Blocks)
  {
    // Folded splats are several of one point.
    std::vector<vtkIdType> splatOf(static_cast<size_t>(block.Data->GetNumberOfPoints()), -1);
    for (vtkIdType k = block.First; k < block.First + block.Count; ++k)
    {
      const size_t i = this->SplatOf(k);
      const vtkIdType number = this->NumberOf(block, i);
      if (number < block.Data->GetNumberOfPoints()) // no fill point
      {
        splatOf[static_cast<size_t>(number)] = static_cast<vtkIdType>(i);
      }
    }
    vtkDataArray* own = block.Data->GetPointData()->GetNormals();
    for (size_t id = 0; id < splatOf.size(); ++id)
    {
      if (splatOf[id] < 0)
      {
        continue;
      }
      double p[3];
      block.Data->GetPoint(static_cast<vtkIdType>(id), p);
      const vtkIdType vertex = points->InsertNextPoint(p);
      cells->InsertNextCell(1, &vertex);
      if (own)
      {
        normals->InsertNextTuple(static_cast<vtkIdType>(id), own);
      }
      if (this->HasColours())
      {
        const uint32_t c = this->ColourOf(splatOf[id]);
        colours->InsertNextTuple4(c & 255u, c >> 8 & 255u, c >> 16 & 255u, c >> 24);
      }
    }
  }
  vertices->Initialize();
  vertices->SetPoints(points);
  vertices->SetVerts(cells);
  if (normals->GetNumberOfTuples() == points->GetNumberOfPoints())
  {
    vertices->GetPointData()->SetNormals(normals);
  }
  if (this->HasColours())
  {
    vertices->GetPointData()->SetScalars(colours);
  }
}
