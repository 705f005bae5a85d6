// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatMeshNormals
 * @brief   normals of a mesh's vertices that have none, from its triangles
 *
 * An internal helper of vtkPointSplatEstimation. These are vtkPolyDataNormals': the
 * mean of the normals of a vertex' triangles, which are turned the same way as those beside them
 * before.
 *
 * Points that are one have one normal: where a mesh is made of pieces, as of the sides of a
 * body, the pieces' normals tell whether they are; where each triangle has points of its own, as in files of the STL format,
 * flat faces do, if there are any (vtkPointSplatMeshFaces.h). Where triangles share points, vtkPointSplatMesh splits these.
 */
#ifndef vtkPointSplatMeshNormals_h
#define vtkPointSplatMeshNormals_h

#include "vtkPointSplattingABI.h"
#include "vtkType.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatFans;

class vtkPointSplatMeshNormals
{
public:
  /// How near to that of triangles a given normal is that tells of the surface, as a cosine (10 degrees; fitted by
  /// Testing/Accuracy/fit_constants.py).
  static constexpr float AlikeCosine = 0.985f;

  /// Whether any corner of a triangle has no normal.
  static bool AreMissing(const vtkPointSplatFans& fans, const float* normals);

  /// Joins the mesh, after setting normals (3 floats a point, unit length) of triangles' corners that have 0 there.
  /// Returns whether it set any.
  static bool Complete(vtkPointSplatFans& fans, float* normals);

  /**
   * Sets those that cancelled to the mean of their triangles' normals, turned to one side. Of a vertex on a seam two of the
   * triangles run the same way along an edge, and the mean of theirs as they are points anywhere. Returns how many.
   */
  static vtkIdType MendSeams(const vtkPointSplatFans& fans, float* normals);

  /// Sets those of used points to the mean of their neighbours': where a volume has no gradient its isosurface has no normal.
  static void TakeNeighbors(const vtkPointSplatFans& fans, const std::vector<unsigned char>& used, float* normals);
};

VTK_ABI_NAMESPACE_END
#endif
