// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatMeshBorders
 * @brief   the clip lines of the splats at the borders of a mesh
 *
 * An internal helper of vtkPointSplatEstimation. A mesh knows where it ends: at edges that one
 * triangle alone has (vtkPointSplatFans.h).
 *
 * 1. A point on the border is clipped by the lines along its two edges where the corner between
 *    them is convex, and by one across it where it is reflex, as vtkPointSplatBorders does. Where a
 *    seam meets the border it has one edge there, and one line. Edges go to the next point of the border that
 *    is a tenth of the disk's radius off: what is nearer says nothing of where the border goes.
 * 2. Lines that are left to a point, of two, go along the nearest edges that end at points of its
 *    triangles, or of those beyond as far as its kernel reaches, and which it is beside: a mesh that was
 *    cut has points as near to its border as it likes, whose disks are as large as others, and one whose
 *    triangles are long along the border has several rows of them. A point's own two lines
 *    become one in between if that leaves room for another and they are less than 10 degrees apart.
 * 3. A point where more than two edges of the border meet is left as it is, and ends no edges of 2.
 */
#ifndef vtkPointSplatMeshBorders_h
#define vtkPointSplatMeshBorders_h

#include "vtkPointSplatFans.h"

#include <vector>

class vtkFloatArray;

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatMeshBorders
{
public:
  /// radii: of the disks, 0 where none is drawn; planes: their normals.
  vtkPointSplatMeshBorders(
    const vtkPointSplatFans& fans, vtkFloatArray* radii, vtkFloatArray* planes)
    : Fans(fans)
    , Radii(radii)
    , Planes(planes)
  {
  }

  /// Adds the lines of points that have none to the array of clip lines, of 6 components, which is
  /// made if it has no tuples and any point has lines.
  void Write(vtkFloatArray* clips) const;

private:
  /// The border from a point on.
  struct Side
  {
    vtkIdType End = 0; // a point of it
    float Way[3] = { 0, 0, 0 }; // to that
    bool Left = false; // whether the surface lies to the left of it, as seen from where the normal points
  };
  Side Walk(vtkIdType id, const vtkPointSplatFans::BorderEdge& edge, const float normal[3], float least) const;
  bool FindOwnLines(vtkIdType id, float clip[6]) const;
  /// A point, and one on the border that is near to it.
  struct Near
  {
    vtkIdType Id;
    vtkIdType Border;
    bool operator<(const Near& other) const
    {
      return this->Id != other.Id ? this->Id < other.Id : this->Border < other.Border;
    }
  };
  std::vector<Near> FindNear() const;
  float GetReach(vtkIdType id) const;
  void AddNearLines(const Near* first, const Near* last, float clip[6]) const;
  void GetOffset(vtkIdType from, vtkIdType to, float d[3]) const;

  const vtkPointSplatFans& Fans;
  vtkFloatArray* Radii;
  vtkFloatArray* Planes;
};

VTK_ABI_NAMESPACE_END
#endif
