// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatShadowMeshes.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
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
  vtkCellArray* faces = data->GetPolys();
  for (faces->InitTraversal(); faces->GetNextCell(count, ids);)
  {
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
    for (vtkIdType k = 2; k < count; ++k)
    {
      add(ids[k - 2], ids[k - 1], ids[k]);
    }
  }
  return triangles;
}
}

//------------------------------------------------------------------------------
void vtkPointSplatShadowMeshes::Upload(const std::vector<vtkPointSplatShadowMesh>& meshes)
{
  for (auto& entry : this->All)
  {
    entry.second.Used = false;
  }
  for (const vtkPointSplatShadowMesh& mesh : meshes)
  {
    Buffers& buffers = this->All[mesh.Data];
    buffers.Used = true;
    if (buffers.VertexArray && buffers.Time == mesh.Data->GetMTime())
    {
      continue;
    }
    vtkPointSplatShadowMeshes::Release(buffers);
    buffers.Time = mesh.Data->GetMTime();
    std::vector<float> vertices;
    std::vector<GLuint> indices;
    if (mesh.Data->GetPoints())
    {
      double bounds[6];
      mesh.Data->GetBounds(bounds);
      for (int k = 0; k < 3; ++k)
      {
        const double middle = 0.5 * (bounds[2 * k] + bounds[2 * k + 1]);
        buffers.Origin[k] = std::isfinite(middle) ? middle : 0.0;
      }
      for (vtkIdType i = 0; i < mesh.Data->GetNumberOfPoints(); ++i)
      {
        double p[3];
        mesh.Data->GetPoint(i, p);
        for (int k = 0; k < 3; ++k)
        {
          vertices.push_back(static_cast<float>(p[k] - buffers.Origin[k]));
        }
      }
      indices = Triangles(mesh.Data);
    }
    buffers.Count = static_cast<GLsizei>(indices.size());
    glGenVertexArrays(1, &buffers.VertexArray);
    glGenBuffers(1, &buffers.Vertices);
    glGenBuffers(1, &buffers.Indices);
    glBindVertexArray(buffers.VertexArray);
    glBindBuffer(GL_ARRAY_BUFFER, buffers.Vertices);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(float)),
      vertices.data(), GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers.Indices);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(GLuint)),
      indices.data(), GL_STATIC_DRAW);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    glEnableVertexAttribArray(0);
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
  }
  for (auto it = this->All.begin(); it != this->All.end();)
  {
    if (!it->second.Used)
    {
      vtkPointSplatShadowMeshes::Release(it->second);
      it = this->All.erase(it);
    }
    else
    {
      ++it;
    }
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatShadowMeshes::Release(Buffers& buffers)
{
  if (buffers.VertexArray)
  {
    glDeleteVertexArrays(1, &buffers.VertexArray);
    glDeleteBuffers(1, &buffers.Vertices);
    glDeleteBuffers(1, &buffers.Indices);
  }
  buffers = Buffers();
  buffers.Used = true;
}

//------------------------------------------------------------------------------
void vtkPointSplatShadowMeshes::Release()
{
  for (auto& entry : this->All)
  {
    vtkPointSplatShadowMeshes::Release(entry.second);
  }
  this->All.clear();
}
