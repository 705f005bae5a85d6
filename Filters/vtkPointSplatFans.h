// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatFans
 * @brief   the triangles around each vertex of a mesh, and the disk that does its share in covering
 * them
 *
 * An internal helper of vtkPointSplatEstimation. A mesh says what a cloud has to be searched
 * for: which points are next to each other on the surface.
 *
 * 1. Polygons (as triangles with their first corner) and strips are read; cells that index
 *    points which are not there, or that take no part, are left out, and so is the second side of surfaces of
 *    which each triangle is there once for each side. Corners of one triangle, and ends of edges with both
 *    ends in common, that have a place and about a normal in common are one point: the first of them takes part, and the
 *    others share its disk. Isosurfaces through a sample of their volume leave the former; the latter lie along the seams
 *    of textures, and are all that a mesh has whose triangles share no points.
 * 2. A vertex' neighbours are the other corners of its triangles, and for its curvature the
 *    nearest of those of their triangles, twelve together. Its plane, and which
 *    neighbours say how the surface bends, are found as for points without a mesh
 *    (vtkPointSplatDisk, vtkPointSplatCurvature).
 * 3. The radius is LengthPerEdge of the mean distance of these neighbours, and at least
 *    LengthPerReach of what covering each triangle by its three disks together asks for
 *    (vtkPointSplatDisk::GetSquaredReach): blending kernels reach farther than disks do.
 *    Where triangles are long the curvature across is that of the points beside: they count in full, however far others are.
 * 4. Edges that belong to one triangle alone are the mesh's border. So are those at which it was split,
 *    as vtkPolyDataNormals splits it at creases: there each face ends, and the next one begins with points of its own. At these
 *    no crease is looked for.
 * 5. Where vtkPointSplatMesh splits it, copies of points follow these, and no crease is looked for anywhere.
 */
#ifndef vtkPointSplatFans_h
#define vtkPointSplatFans_h

#include "vtkPointSplatNeighbors.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkPolyData;

class vtkPointSplatFans
{
public:
  /**
   * Reads the mesh's triangles between points with used[id] not 0. Returns how many cells were left out since they
   * index points that are not there.
   */
  vtkIdType Read(vtkPolyData* mesh, const unsigned char* used);

  /// Makes one of points in one place, leaves out triangles that have no area by that, and finds the border. normals: 3
  /// floats a point, unit length or 0. Returns whether any were joined.
  bool Join(const float* normals);
  /// Whether two corners of some triangle are in one place.
  bool HasEdgesWithoutLength() const;
  /// Whether all triangles have points of their own.
  bool AreApart() const;

  /// Takes over triangles between points, 3 coordinates each; same: GetSame() of each, or empty.
  void Take(
    std::vector<double> positions, std::vector<vtkIdType> corners, std::vector<vtkIdType> same);

  /// The points and triangles, for filters.
  vtkSmartPointer<vtkPolyData> MakeMesh() const;

  /// Adds copies of points after them, and takes over corners of the same triangles, in the order that tells where these face.
  void Split(const std::vector<vtkIdType>& sources, std::vector<vtkIdType> corners);
  /// Whether it was split: then the order of corners tells where triangles face, counterclockwise as seen from where planes'
  /// normals point.
  bool IsSplit() const { return this->WasSplit; }

  void Clear() { *this = vtkPointSplatFans(); }
  bool IsEmpty() const { return this->Corners.empty(); }

  /// Whether all points with used[id] not 0 are triangles' corners and have a normal (3 floats a
  /// point, 0 where there is none), and there are any triangles.
  bool AreAll(const std::vector<unsigned char>& used, const float* normals) const;

  /// An edge of the border at a point.
  struct BorderEdge
  {
    vtkIdType Next;  // its other end
    vtkIdType Inner; // the third corner of its triangle
    bool Forward;    // whether that has its corners in the order of the edge and this one
  };

  /// The points with an edge that one triangle alone has, in order.
  const std::vector<vtkIdType>& GetBorder() const { return this->Border; }
  /// The edges of the border at a point.
  struct BorderEdges
  {
    const BorderEdge* First;
    std::size_t Count;

    const BorderEdge* begin() const { return this->First; }
    const BorderEdge* end() const { return this->First + this->Count; }
  };
  BorderEdges GetBorderEdges(vtkIdType id) const;
  /// The points of the border that have another one's place.
  std::vector<vtkIdType> FindSplit() const;
  const double* GetPosition(vtkIdType id) const { return this->Positions.data() + 3 * id; }
  bool IsSamePlace(vtkIdType a, vtkIdType b) const
  {
    return std::equal(this->GetPosition(a), this->GetPosition(a) + 3, this->GetPosition(b));
  }

  /// A triangle's longest edge, and the height above it.
  struct Shape
  {
    double Longest, Height;
  };
  Shape GetShape(const vtkIdType corners[3]) const;

  vtkIdType GetNumberOfPoints() const { return static_cast<vtkIdType>(this->Positions.size() / 3); }
  /// Three a triangle.
  const std::vector<vtkIdType>& GetCorners() const { return this->Corners; }
  vtkIdType GetNumberOfTriangles(vtkIdType id) const { return this->First[id + 1] - this->First[id]; }
  /// Calls visitor(id) for the other corners of a point's triangles, once for each triangle.
  template <typename Visitor>
  void VisitNeighbors(vtkIdType id, Visitor visitor) const
  {
    for (vtkIdType t = this->First[id]; t < this->First[id + 1]; ++t)
    {
      for (int k = 0; k < 3; ++k)
      {
        const vtkIdType other = this->Corners[3 * this->Triangles[t] + k];
        if (other != id)
        {
          visitor(other);
        }
      }
    }
  }

  /// Calls visitor(corners) for a point's triangles.
  template <typename Visitor>
  void VisitTriangles(vtkIdType id, Visitor visitor) const
  {
    for (vtkIdType t = this->First[id]; t < this->First[id + 1]; ++t)
    {
      visitor(this->Corners.data() + 3 * this->Triangles[t]);
    }
  }

  /// The point that takes part for a point, mostly itself.
  vtkIdType GetSame(vtkIdType id) const { return this->Same.empty() ? id : this->Same[id]; }

  /// Unmarks the points that are corners of triangles without area, and of no others: they are no part of the surface.
  void LeaveOutCollapsed(std::vector<unsigned char>& used) const;

  /// By how much triangles of a flat face may be off its plane, as a sine (0.1 degrees).
  static constexpr double FlatSine = 1.75e-3;

  /// Whether a point is a triangle's corner.
  bool Has(vtkIdType id) const
  {
    return !this->First.empty() && this->GetNumberOfTriangles(this->GetSame(id)) > 0;
  }

  /// How much the surface bends beside a disk that reaches far past that, which its curvature need not tell.
  struct Bend
  {
    float Amount = 0, Within = 0; // 1 / world units, or 0, and world units
    float Way[3] = { 0, 0, 0 };   // unit length
  };

  struct Disk
  {
    float Radius = 0;                            // world units
    float Plane[3] = { 0, 0, 0 };                // its normal, unit length
    float Curvature[6] = { 0, 0, 0, 0, 0, 0 };   // as vtkPointSplatCurvature's
    float Distance = 0, Turn = 0, Farthest = 0;  // as vtkPointSplatDisks'
    float Width = 0;  // the second neighbour's distance, or the least height of the widest triangle: how wide long ones are
    Bend Beside;
    bool Tip = false; // whether all triangles fall off steeply from its plane
    bool Creased = false; // whether a crease is likely to be near (vtkPointSplatCrease)
  };

  /// The disk of a triangle's corner that takes part. normals: 3 floats a point, unit length.
  Disk GetDisk(vtkIdType id, const float* normals) const;

private:
  void Add(vtkIdType a, vtkIdType b, vtkIdType c, const unsigned char* used);
  bool IsAtFlat(vtkIdType id) const;
  Bend FindBend(vtkIdType id, const float* normals, float radius) const;
  /// The other corners of a triangle at a point.
  static std::array<vtkIdType, 2> GetOthers(const vtkIdType corner[3], vtkIdType id)
  {
    return { { corner[0] == id ? corner[1] : corner[0], corner[2] == id ? corner[1] : corner[2] } };
  }
  bool Unite(vtkIdType a, vtkIdType b, const float* normals);
  void LeaveOutDoubles();
  void Merge();
  void Sort();
  void GetSingleEdges(vtkIdType id, std::vector<BorderEdge>& edges) const;
  void FindBorder();
  std::vector<vtkIdType> FindSeams() const;
  bool IsBefore(vtkIdType a, vtkIdType b) const;
  void SortByPlace(std::vector<vtkIdType>& ids) const;

  bool WasSplit = false;
  std::vector<double> Positions;    // 3 a point
  std::vector<vtkIdType> Corners;   // 3 a triangle, of points that take part
  std::vector<vtkIdType> Same;      // GetSame(), empty where that is id of all
  std::vector<vtkIdType> Collapsed; // corners of triangles without area; they may be of others, too
  std::vector<vtkIdType> First;     // of a point's triangles: where they begin in Fans
  std::vector<vtkIdType> Triangles; // by points
  static constexpr std::size_t Inside = static_cast<std::size_t>(-1);
  std::vector<std::size_t> InBorder;      // of each point, its place in Border, or Inside
  std::vector<vtkIdType> Border;          // points, in order
  std::vector<std::size_t> FirstOfBorder; // of these: where their edges begin in EdgesOfBorder
  std::vector<BorderEdge> EdgesOfBorder;
};

VTK_ABI_NAMESPACE_END
#endif
