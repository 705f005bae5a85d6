// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatMeshFaces
 * @brief   the faces of a mesh, which end at its sharp edges
 *
 * An internal helper of vtkPointSplatEstimation.
 *
 * 1. A mesh has flat faces if of its edges of more than 30 degrees 45 in a hundred are those of triangles that lie in a plane
 *    with one beside them, to a tenth of a degree, as of what CAD makes: 46 to 100 do, however small and few the flat faces are.
 *    Of scans, isosurfaces and modelled animals it is 0 to 32, of a coarse isosurface of a volume of bytes 38. Or if of these edges
 *    fewer than ten in a hundred are of less than 45 degrees, so that bends and sharp edges are two things: of round teeth, cut
 *    off flat, it is one, of scans and animals 29 to 88.
 * 2. Flat faces end at edges of more than 30 degrees, where vtkPolyDataNormals splits. Other surfaces are round up to 45
 *    degrees: what is sharper is no bend that disks follow.
 * 3. Triangles that are thinner than a tenth of their length tell nothing of a round surface: around a point those beside them
 *    meet as if there were none in between.
 * 4. A face's normal at a corner is, as vtkPolyDataNormals', the mean of those of the triangles around it that are of one face.
 *    These are turned the same way as those beside them before; or, where points have normals, to the side that the order of
 *    corners tells, if that is the normals' side at nine of ten or they are a lattice's, and else to the normals'. A face of
 *    needles alone, which have the normals of rounding, has none where points do.
 */
#ifndef vtkPointSplatMeshFaces_h
#define vtkPointSplatMeshFaces_h

#include "vtkPointSplattingABI.h"
#include "vtkType.h"

#include <cstddef>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatFans;

class vtkPointSplatMeshFaces
{
public:
  /// What is sharper ends a face, flat or round, in degrees (the second from Testing/Accuracy/fit_constants.py).
  static constexpr double FlatAngle = 30;
  static constexpr double RoundAngle = 45;

  /// What the edges of a mesh tell.
  struct Edges
  {
    bool OfFlat = false;  // whether the mesh has flat faces
    bool AreSharp = false; // whether there are any at which faces end
    bool Ordered = false; // whether the order of corners tells how triangles face, whatever normals tell; Look() does not know
    double GetAngle() const { return this->OfFlat ? FlatAngle : RoundAngle; }
  };
  static Edges Look(const vtkPointSplatFans& mesh);

  static constexpr vtkIdType None = -1;

  /// joined: the mesh, as it is after Join(). normals: of points, 3 floats each, unit length or 0; or null.
  vtkPointSplatMeshFaces(
    const vtkPointSplatFans& mesh, const vtkPointSplatFans& joined, const Edges& edges, const float* normals);

  /// The face's corner that one of a triangle is, in the order of the mesh's; None of triangles without area.
  vtkIdType GetCorner(std::size_t i) const { return this->Corners[i]; }
  /// Whether the order of corners tells how all triangles face, and none that share an edge contradict one another: of scans that
  /// were merged they do.
  bool TellFront() const { return this->AreOrdered; }
  /// Whether the order of a triangle's corners is against how it faces.
  bool IsTurned(std::size_t triangle) const { return this->Turned[triangle] != 0; }
  /// Gives the normal there, of unit length; returns whether there is one.
  bool GetNormal(vtkIdType corner, float normal[3]) const;

private:
  std::vector<vtkIdType> Corners;
  std::vector<unsigned char> Turned; // of each triangle
  bool AreOrdered = false;
  std::vector<float> Normals; // 3 a face's corner, unit length or 0
};

VTK_ABI_NAMESPACE_END
#endif
