// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatDisk
 * @brief   the disk about a point that does its share in covering the surface
 *
 * An internal helper of vtkPointSplatEstimation; see the stages there.
 */
#ifndef vtkPointSplatDisk_h
#define vtkPointSplatDisk_h

#include "vtkPointSplatSheet.h"

#include <cmath>

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

  /// The first axis' length at which the disk covers its part of the gaps between the neighbours.
  float Gap = 0;
  /// The neighbours that the disk is made of.
  vtkPointSplatSheet Sheet;

  /**
   * Finds the disk of the neighbourhood's centre. normals: 3 floats a slot, unit length; usual: the
   * spacing past which points are sparse; holeLimit: how many times Spacing away a vertex of the cell lies in a hole
   * of the surface. Returns whether neighbours of its sheet are all around. Lengths are 0 if
   * there is none.
   */
  bool Estimate(const vtkPointSplatNeighbors::Neighborhood& around, const float* normals,
    bool elliptical, float usual, float holeLimit);

  /// Makes the disk no larger than that, whatever it covers.
  void Limit(float most);

  /**
   * Finds no more than Normal and Sheet. countNear: how many of the neighbours lie as near as they
   * do at that spacing.
   */
  void SelectSheet(const vtkPointSplatNeighbors::Neighborhood& around, int countNear,
    const float* normals, float spacing);

  /**
   * How far, squared, the part of a triangle reaches that is nearer to a corner than the rest is to
   * the other two: to the circumcentre of an acute one; of an obtuse one, whose circumcentre lies
   * outside, to where bisectors leave it. aa, bb, ab: products of the ways a and b to the other
   * corners; circumscribed2: the squared radius of the circumcircle.
   */
  static float GetSquaredReach(float aa, float bb, float ab, float circumscribed2);

  /**
   * How far away the farthest vertex of the last estimate's cell is, if there is just one run of
   * vertices farther away than that; 0 otherwise. next: the neighbours before and behind it,
   * counterclockwise about Normal.
   */
  float FindBorder(float most, int next[2]) const;

  /**
   * Calls visitor(a, b, reach) for the triangles of the last estimate's cell, one a vertex: the centre's star. a, b:
   * their other corners' places in the neighbourhood; reach: the distance of their circumcentre.
   */
  template <typename Visitor>
  void VisitTriangles(const Visitor& visitor) const
  {
    for (int j = 0; j < this->Size && this->Sheet.Count > 0; ++j)
    {
      const Vertex& vertex = this->Cell[j];
      const int a = this->Cell[j > 0 ? j - 1 : this->Size - 1].Edge;
      if (a != Frame && vertex.Edge != Frame && a != vertex.Edge)
      {
        visitor(this->Sheet.Members[a], this->Sheet.Members[vertex.Edge],
          std::sqrt(vertex.X * vertex.X + vertex.Y * vertex.Y));
      }
    }
  }

  /// How far apart points are by their neighbours' squared distances, nearest first (Distance).
  static float GetDistance(const float* squared, int count, float spacing);

  /// Whether so many nearest neighbours lie in a row rather than all around or to one side.
  bool InRow(int nearest) const;

  /// The distance to the sixth neighbour, or the last if there are fewer, in the plane where
  /// the disk is round.
  float Spacing = 0;
  /// The distance, there, of the cell's farthest vertex; 0 if neighbours are not all around.
  float Opening = 0;
  /// How far apart points are here: the mean distance of the star's neighbours that are no more than
  /// twice as far as the third of them, but not much less than Spacing, which a few that lie together are.
  float Distance = 0;

private:
  static constexpr int MaximumNumberOfVertices =
    vtkPointSplatNeighbors::MaximumNumberOfNeighbors + 8;

  struct Vertex
  {
    float X, Y;
    int Edge; // what made the edge from this vertex to the next: a neighbour, or this:
  };
  static constexpr int Frame = -1; // the square that the clipping starts from

  void ChoosePlane(
    const vtkPointSplatNeighbors::Neighborhood& around, int countNear, const float* normals);
  void Project(const vtkPointSplatNeighbors::Neighborhood& around);
  void Whiten();
  void Clip(float nx, float ny, float offset, int edge, float& farthest);
  bool ClipByBisectors(int count);
  float MeanDistance(float most) const;
  float Reach(float known, bool closed) const;
  float Farthest(float most) const;
  float MeasureDistance() const;

  float Scale1, Scale2; // world units of the plane's two coordinates
  float U[vtkPointSplatNeighbors::MaximumNumberOfNeighbors];
  float V[vtkPointSplatNeighbors::MaximumNumberOfNeighbors];
  // The cell is in one of these, and clipped into the other.
  Vertex Cells[2][MaximumNumberOfVertices];
  Vertex* Cell;
  int Size; // of Cell
};

VTK_ABI_NAMESPACE_END
#endif
