// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatItemTable.h"

#include <algorithm>

namespace
{
constexpr size_t Texels = 12; // as in vtkPointSplatItemTable.glsl
}

//------------------------------------------------------------------------------
void vtkPointSplatItemTable::Upload(
  const std::vector<vtkPointSplatItem>& items, const vtkPointSplatView& view)
{
  size_t slots = 0;
  for (const vtkPointSplatItem& item : items)
  {
    slots = std::max(slots, static_cast<size_t>(item.Slot) + 1);
  }
  std::vector<uint32_t> values;
  std::vector<glm::vec4> table(Texels * slots, glm::vec4(0.0f));
  for (const vtkPointSplatItem& item : items)
  {
    glm::vec4* row = table.data() + Texels * static_cast<size_t>(item.Slot);
    const std::vector<glm::dvec4> planes = item.GetClipPlanesVC(view);
    row[0] = glm::vec4(item.Opacities, planes.size(), item.IsPoints ? 1.0f : 0.0f);
    row[1] = item.Colour;
    row[2] = glm::vec4(item.Kernel.Shape, item.Kernel.Support, item.Kernel.Plateau ? 1.0f : 0.0f);
    row[3] = glm::vec4(item.IsPoints ? item.Points.Layer : item.LargestLayer,
      item.Points.LayerPixels, item.Points.Spacing, item.Points.Silhouettes ? 1.0f : 0.0f);
    std::copy(planes.begin(), planes.end(), row + 4);
    row[10] = item.GetValueMap(values.size());
    row[11] = glm::vec4(item.IsFlat ? 1.0f : 0.0f, item.Look.EdgeWidth,
      item.Look.Repeats ? 1.0f : 0.0f, 0.0f);
    const std::vector<uint32_t>& own = item.Cloud->GetValueTable();
    values.insert(values.end(), own.begin(), own.end());
  }
  this->Table.Upload(table);
  if (!values.empty())
  {
    this->ValueTables.Upload(values);
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatItemTable::Release()
{
  this->Table.Release();
  this->ValueTables.Release();
}
