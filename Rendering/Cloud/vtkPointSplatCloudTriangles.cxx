// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Of the cloud: the triangles between its splats.
#include "vtkPointSplatCloud.h"

#include "vtkPolyData.h"

//------------------------------------------------------------------------------
void vtkPointSplatCloud::MakeTriangles()
{
  Key key{ { nullptr, this->SplatTime.GetMTime() } };
  std::vector<vtkPointSplatTriangles::Mesh> meshes;
  for (const Block& block : this->Blocks)
  {
    auto mesh = vtkPolyData::SafeDownCast(block.Data);
    // Ids of polygons follow those of vertices and lines.
    key.emplace_back(nullptr, mesh ? mesh->GetNumberOfVerts() + mesh->GetNumberOfLines() : 0);
    meshes.push_back({ mesh, block.First, block.Count, block.Copies.get() });
  }
  if (key == this->TrianglesMadeFrom)
  {
    return;
  }
  this->MoveAll();
  this->Triangles.Make(
    meshes, { this->Splats, this->GetWordsPerSplat(), this->Count, this->Levels });
  this->TrianglesMadeFrom = std::move(key);
  this->TriangleTime.Modified();
}

//------------------------------------------------------------------------------
const vtkPointSplatBuffer& vtkPointSplatCloud::UploadTriangles()
{
  Buffers& buffers = this->Upload();
  if (this->TriangleTime > buffers.TriangleTime)
  {
    buffers.Triangles.Upload(this->Triangles.GetCorners());
    buffers.TriangleTime.Modified();
  }
  return buffers.Triangles;
}
