// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatDisk
 * @brief   the smallest disk about a point that does its share in covering the surface
 *
 * An internal helper of vtkPointSplatEstimation; see the stages there.
 */
#ifndef vtkPointSplatDisk_h
#define vtkPointSplatDisk_h

#include "vtkPointSplatNeighbors.h"

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatDisk
{
public:
  /// The disk: its two half axes, perpendicular to each other and to the normal.
  float Axis1[3], Axis2[3];
  /// The normal of the disk's plane: the point's, or where the neighbours lie far off its
  /// tangent plane the normal of the plane that fits them, turned to the side of the point's.
  float Normal[3];
  /// The half axes' lengths, the first the longer; both the radius for a circle.
  float Length1 = 0, Length2 = 0;

  /**
   * Finds the disk of the neighbourhood's centre. normals: 3 floats a slot, unit length.
   * Returns whether the neighbours close the cell all around. Where they do not, nothing is
   * found unless `border` is set: then the disk is that of a point on a border, and reaches
   * no farther than the `nearby` nearest of them. Vertices of the cell farther than `limit`
   * times the spacing are left out: there is a hole. Lengths are 0 if there is no neighbour.
   */
  bool Estimate(const vtkPointSplatNeighbors::Neighborhood& around, const float* normals,
    bool elliptical, int nearby, bool border, float limit);

  /// Whether the neighbours lie in a row rather than all around or to one side.
  bool InRow() const;

  /// The distance to the sixth neighbour, or the last if there are fewer, in the plane where
  /// the disk is round.
  float Spacing = 0;

private:
  static constexpr int MaximumNumberOfVertices =
    vtkPointSplatNeighbors::MaximumNumberOfNeighbors + 8;

  struct Vertex
  {
    float X, Y;
    int Edge; // what made the edge from this vertex to the next: a neighbour, or one of these:
  };
  static constexpr int Frame = -1; // the square that the clipping starts from
  static constexpr int Hull = -2;  // the border of the hull of the neighbours

  void ChoosePlane(
    const vtkPointSplatNeighbors::Neighborhood& around, const float* normals);
  void Project(const vtkPointSplatNeighbors::Neighborhood& around, const float* normals);
  void Whiten();
  void Clip(float nx, float ny, float offset, int edge);
  bool ClipByBisectors();
  void ClipByHull();
  float FarthestVertex(float limit) const;

  float Scale1, Scale2; // world units of the plane's two coordinates
  int Count;            // neighbours in use
  float U[vtkPointSplatNeighbors::MaximumNumberOfNeighbors];
  float V[vtkPointSplatNeighbors::MaximumNumberOfNeighbors];
  Vertex Cell[MaximumNumberOfVertices];
  int Size; // of Cell
  float Reach;
};

VTK_ABI_NAMESPACE_END
#endif
