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
 * 1. A mesh has faces if of its edges of more than 30 degrees 45 in a hundred are those of triangles that lie in a plane with one
 *    beside them, to a tenth of a degree, as of what CAD makes: 46 to 100 do, however small and few the flat faces are. Of scans,
 *    isosurfaces and modelled animals it is 0 to 26, of a coarse isosurface of a volume of bytes 38: their edges are of one
 *    surface, however sharp.
 * 2. Faces end at edges of more than 30 degrees, where vtkPolyDataNormals splits. There a point that is the corner of
 *    several faces has copies (Split()), unless triangles have points of their own, as in files of the STL format.
 * 3. Points that are one have one normal: where a mesh is made of pieces, as of the sides of a
 *    body, the pieces' normals tell whether they are; where each triangle has points of its own, faces do, if there are any.
 */
#ifndef vtkPointSplatMeshNormals_h
#define vtkPointSplatMeshNormals_h

#include "vtkPointSplattingABI.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <vector>

class vtkPolyData;

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatFans;

class vtkPointSplatMeshNormals
{
public:
  /// Joins the mesh, after setting normals (3 floats a point, unit length) of triangles' corners that have 0 there.
  /// Returns whether it set any.
  static bool Complete(vtkPointSplatFans& fans, float* normals);

  /**
   * A mesh with the points of one without normals, and after them copies of those that are corners of several faces; with
   * normals and ghosts, and no other arrays. sources: of the copies. None is made if there are no copies, or if some points
   * are no triangles' corners; then fans are those of the mesh, if they were read and all of its cells are good.
   */
  static vtkSmartPointer<vtkPolyData> Split(
    vtkPolyData* mesh, vtkPointSplatFans& fans, std::vector<vtkIdType>& sources);
};

VTK_ABI_NAMESPACE_END
#endif
