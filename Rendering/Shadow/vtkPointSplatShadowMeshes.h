// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The triangles of ordinary meshes that stand in the light, as buffers: vertices of 3 floats,
// relative to the middle of the mesh, and 3 indices a triangle. Kept as long as the mesh is the
// same and in use.
#ifndef vtkPointSplatShadowMeshes_h
#define vtkPointSplatShadowMeshes_h

#include "vtkPointSplatBuffer.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <glm/glm.hpp>

#include <map>
#include <vector>

struct vtkPointSplatShadowMesh
{
  vtkSmartPointer<vtkPolyData> Data;
  glm::dmat4 MCWC{ 1.0 };
  std::vector<glm::dvec4> ClipPlanes; // world coordinates

  bool operator==(const vtkPointSplatShadowMesh& other) const
  {
    return this->Data == other.Data && this->MCWC == other.MCWC &&
      this->ClipPlanes == other.ClipPlanes;
  }
};

class vtkPointSplatShadowMeshes
{
public:
  struct Buffers
  {
    vtkPointSplatHandle VertexArray{ vtkPointSplatHandle::VertexArray };
    vtkPointSplatBuffer Vertices;
    vtkPointSplatBuffer Indices;
    GLsizei Count = 0; // of indices
    double Origin[3] = { 0.0, 0.0, 0.0 };
    vtkMTimeType Time = 0;
  };

  /// Makes the buffers of these meshes what they should be, and forgets others.
  void Upload(const std::vector<vtkPointSplatShadowMesh>& meshes);
  const Buffers& Get(vtkPolyData* data) { return this->All[data]; }
  void Release() { this->All.clear(); }

private:
  static void Fill(Buffers& buffers, vtkPolyData* data);

  std::map<vtkPolyData*, Buffers> All; // compared only
};

#endif
