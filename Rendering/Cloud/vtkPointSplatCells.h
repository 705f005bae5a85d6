// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Cells as users may make them: VTK takes them as they are.
#ifndef vtkPointSplatCells_h
#define vtkPointSplatCells_h

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace vtkPointSplatCells
{
/**
 * The lists of cells that a data set's kind has; some may be null.
 */
inline std::vector<vtkCellArray*> GetLists(vtkPointSet* data)
{
  if (auto mesh = vtkPolyData::SafeDownCast(data))
  {
    return { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(), mesh->GetStrips() };
  }
  auto grid = vtkUnstructuredGrid::SafeDownCast(data);
  return grid ? std::vector<vtkCellArray*>{ grid->GetCells() } : std::vector<vtkCellArray*>();
}

/**
 * Whether there are cells that say how large splats are.
 */
inline bool HasFaces(vtkPointSet* data)
{
  vtkPolyData* mesh = vtkPolyData::SafeDownCast(data);
  return mesh && (mesh->GetNumberOfPolys() > 0 || mesh->GetNumberOfStrips() > 0);
}

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
  const std::vector<vtkCellArray*> lists = GetLists(data);
  return std::all_of(
    lists.begin(), lists.end(), [](vtkCellArray* cells) { return CanBeRead(cells); });
}

/**
 * The array that blanks cells, or null if there is none that can be used.
 */
inline vtkUnsignedCharArray* GetGhosts(vtkPointSet* data)
{
  auto ghosts = vtkArrayDownCast<vtkUnsignedCharArray>(
    data->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  const bool good = ghosts && ghosts->GetNumberOfTuples() == data->GetNumberOfCells() &&
    ghosts->GetNumberOfComponents() == 1;
  return good ? ghosts : nullptr;
}

/**
 * Whether a cell is blanked, or another rank's to draw.
 */
inline bool IsGhost(vtkUnsignedCharArray* ghosts, vtkIdType cell)
{
  return ghosts &&
    (ghosts->GetValue(cell) &
      (vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::DUPLICATECELL)) != 0;
}

/**
 * The points that cells use, a byte each, where there are cells and they leave any out: those are
 * not shown, as vtkPolyDataMapper does not, nor are those of ghost cells alone. Nothing where cells
 * use all points, or, being bad, none.
 */
inline std::vector<unsigned char> MarkUsed(vtkPointSet* data)
{
  const std::vector<vtkCellArray*> lists = GetLists(data);
  const vtkIdType count = data->GetNumberOfPoints();
  std::vector<unsigned char> used;
  if (lists.empty() || data->GetNumberOfCells() == 0 || !CanBeRead(data))
  {
    return used;
  }
  used.resize(static_cast<std::size_t>(count), 0);
  vtkUnsignedCharArray* ghosts = GetGhosts(data);
  bool ghost = false;
  vtkIdType id = 0; // of a cell, in all lists
  for (vtkCellArray* cells : lists)
  {
    for (vtkIdType cell = 0; cells && cell < cells->GetNumberOfCells(); ++cell, ++id)
    {
      if (IsGhost(ghosts, id))
      {
        ghost = true;
        continue;
      }
      vtkIdType size;
      const vtkIdType* ids;
      cells->GetCellAtId(cell, size, ids);
      for (vtkIdType i = 0; i < size; ++i)
      {
        if (ids[i] >= 0 && ids[i] < count)
        {
          used[static_cast<std::size_t>(ids[i])] = 1;
        }
      }
    }
  }
  const auto shown = std::count(used.begin(), used.end(), 1);
  return (shown == 0 && !ghost) || shown == count ? std::vector<unsigned char>() : used;
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
