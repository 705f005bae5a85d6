// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatMesh
 * @brief   the triangles between points, with a copy of a point for each face that it is a corner of
 *
 * An internal helper of vtkPointSplatEstimation. A disk at a sharp edge is in the plane of one of the faces that end there.
 *
 * 1. *Triangles* are those of polygons and strips (vtkPointSplatFans.h), or, if there are none, of the isosurfaces whose vertices
 *    the points are (vtkPointSplatLattice.h), along the axes or turned (vtkPointSplatLatticeFrame.h). If they share no points, those of one place and normal count as shared.
 * 2. *Split.* Of a point where several faces end (vtkPointSplatMeshFaces.h) the first one has it, and each other one a copy.
 * 3. *Planes.* Each has its face's normal for its disk, and a point of one face alone its given one if that is within 10 degrees:
 *    it tells more than triangles do, but for an isosurface that bends within a voxel, whose gradients are of another surface.
 * 4. *Normals* to shade with stay as they are given, as a mesh's do; where there are none, they are the faces' of a mesh that has
 *    flat faces, and else the mean of the triangles'.
 */
#ifndef vtkPointSplatMesh_h
#define vtkPointSplatMesh_h

#include "vtkPointSplatFans.h"
#include "vtkPointSplattingABI.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <vector>

class vtkPointSet;
class vtkPolyData;

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatMeshFaces;

class vtkPointSplatMesh
{
public:
  /// Finds the triangles; none if cells index points that are not there: whoever reads them again tells of these.
  void Read(vtkPointSet* input);

  /// Returns whether there are several faces at some points. None is split if some points are no triangles' corners.
  bool Split();

  vtkPointSplatFans Fans;
  bool OfLattice = false; // whether its triangles are those of an isosurface's vertices

  // What there is if it was split:
  vtkSmartPointer<vtkPolyData> Points; // the input's, and copies, with planes' normals and ghosts, and no other arrays
  std::vector<vtkIdType> Sources;      // of the copies
  std::vector<float> Normals;          // to shade with, 3 a point of the input, unit length; empty if they are the planes'
  vtkIdType NumberOfMended = 0;        // of these
  bool TellsFront = false;             // whether the order of corners tells which side of a plane is the front, whatever normals tell

  /// That of a point or copy, if there are any.
  const float* GetNormal(vtkIdType id) const
  {
    const vtkIdType own = static_cast<vtkIdType>(this->Normals.size() / 3);
    return this->Normals.data() + 3 * (id < own ? id : this->Sources[id - own]);
  }

private:
  bool ReadNormals();
  void FindLattice();
  void CompleteNormals(bool ofFaces);
  void Copy(const vtkPointSplatMeshFaces& faces, std::vector<vtkIdType>& corners, std::vector<float>& planes);
  void TakeGiven(std::vector<float>& planes) const;

  vtkPointSet* Input = nullptr;
  std::vector<unsigned char> Used;
};

VTK_ABI_NAMESPACE_END
#endif
