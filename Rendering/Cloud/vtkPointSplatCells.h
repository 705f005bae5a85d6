// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Cells as users may make them: VTK takes them as they are.
#ifndef vtkPointSplatCells_h
#define vtkPointSplatCells_h

#include "vtkCellArray.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace vtkPointSplatCells
{
/**
 * Whether each cell lies within its list, so that it can be asked for its points' ids. Those may
 * be of points that are not there.
 */
inline bool CanBeRead(vtkCellArray* cells)
{
  return !cells || cells->GetNumberOfCells() == 0 || cells->IsValid();
}

inline bool CanBeRead(vtkPointSet* data)
{
  if (auto mesh = vtkPolyData::SafeDownCast(data))
  {
    return CanBeRead(mesh->GetVerts()) && CanBeRead(mesh->GetLines()) &&
      CanBeRead(mesh->GetPolys()) && CanBeRead(mesh->GetStrips());
  }
  auto grid = vtkUnstructuredGrid::SafeDownCast(data);
  return !grid || CanBeRead(grid->GetCells());
}

/**
 * Whether the points of all of a cell's ids are there.
 */
inline bool ArePoints(const vtkIdType* ids, vtkIdType count, vtkIdType points)
{
  return std::all_of(ids, ids + count, [points](vtkIdType id) { return id >= 0 && id < points; });
}
}

#endif
