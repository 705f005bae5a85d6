// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatShadowMeshes.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPointSplatCells.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"

#include <algorithm>
#include <cmath>

namespace
{
/// The triangles of all faces, as point ids.
std::vector<GLuint> Triangles(vtkPolyData* data)
{
  std::vector<GLuint> triangles;
  auto add = [&triangles](vtkIdType a, vtkIdType b, vtkIdType c) {
    triangles.insert(triangles.end(),
      { static_cast<GLuint>(a), static_cast<GLuint>(b), static_cast<GLuint>(c) });
  };
  vtkNew<vtkPolygon> polygon;
  vtkNew<vtkIdList> cut;
  vtkNew<vtkPoints> corners;
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  if (!vtkPointSplatCells::CanBeRead(data))
  {
    vtkErrorWithObjectMacro(data, "Cells reach beyond their own list: its faces cast no shadow. "
                                  "Check the offsets of its cell arrays.");
    return triangles;
  }
  const vtkIdType points = data->GetNumberOfPoints();
  vtkCellArray* faces = data->GetPolys();
  for (faces->InitTraversal(); faces->GetNextCell(count, ids);)
  {
    if (!vtkPointSplatCells::ArePoints(ids, count, points))
    {
      continue;
    }
    if (count <= 4)
    {
      for (vtkIdType k = 2; k < count; ++k)
      {
        add(ids[0], ids[k - 1], ids[k]);
      }
      continue;
    }
    polygon->Initialize(static_cast<int>(count), ids, data->GetPoints());
    polygon->Triangulate(0, cut, corners);
    for (vtkIdType k = 0; k + 2 < cut->GetNumberOfIds(); k += 3)
    {
      add(cut->GetId(k), cut->GetId(k + 1), cut->GetId(k + 2));
    }
  }
  vtkCellArray* strips = data->GetStrips();
  for (strips->InitTraversal(); strips->GetNextCell(count, ids);)
  {
    if (!vtkPointSplatCells::ArePoints(ids, count, points))
    {
      continue;
    }
    for (vtkIdType k = 2; k < count; ++k)
    {
      add(ids[k - 2], ids[k - 1], ids[k]);
    }
  }
  return triangles;
}
}

//------------------------------------------------------------------------------
void vtkPointSplatShadowMeshes::Fill(Buffers& buffers, vtkPolyData* data)
{
  std::vector<float> vertices;
  std::vector<GLuint> indices;
  if (data->GetPoints())
  {
    double bounds[6];
    data->GetBounds(bounds);
    for (int k = 0; k < 3; ++k)
    {
      const double middle = 0.5 * (bounds[2 * k] + bounds[2 * k + 1]);
      buffers.Origin[k] = std::isfinite(middle) ? middle : 0.0;
    }
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    {
      double p[3];
      data->GetPoint(i, p);
      for (int k = 0; k < 3; ++k)
      {
        vertices.push_back(static_cast<float>(p[k] - buffers.Origin[k]));
      }
    }
    indices = Triangles(data);
  }
  buffers.Time = data->GetMTime();
  buffers.Count = static_cast<GLsizei>(indices.size());
  buffers.Vertices.Upload(vertices);
  buffers.Indices.Upload(indices);
  buffers.VertexArray.Make();
  glBindVertexArray(buffers.VertexArray.Get());
  glBindBuffer(GL_ARRAY_BUFFER, buffers.Vertices.Get());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers.Indices.Get());
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  glEnableVertexAttribArray(0);
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

//------------------------------------------------------------------------------
void vtkPointSplatShadowMeshes::Upload(const std::vector<vtkPointSplatShadowMesh>& meshes)
{
  std::map<vtkPolyData*, Buffers> wanted;
  for (const vtkPointSplatShadowMesh& mesh : meshes)
  {
    if (wanted.count(mesh.Data) == 0)
    {
      Buffers& buffers = wanted[mesh.Data];
      std::swap(buffers, this->All[mesh.Data]);
      if (!buffers.VertexArray.IsMade() || buffers.Time != mesh.Data->GetMTime())
      {
        vtkPointSplatShadowMeshes::Fill(buffers, mesh.Data);
      }
    }
  }
  this->All.swap(wanted);
}
