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
 *    them is convex. Where it is reflex the surface is what either line leaves, and not both: the point has two splats, with a
 *    line each. One line across it, as of vtkPointSplatBorders, is enough where that goes past the corner by less than MostPast of
 *    the radius, and is all there is without fill points. Where a
 *    seam meets the border it has one edge there, and one line. Edges go to the next point of the border that
 *    is a five hundredth of the disk's radius off, or of its triangles' width: what is nearer says nothing of where the border goes.
 * 2. Lines that are left to a point, of two, go along the nearest edges that end at points of its
 *    triangles, or of those beyond, as far as its kernel reaches, also between the ends of longer ones, and which it is
 *    beside: a mesh that was cut has points as near to its border as it likes, whose disks are as large as others, and one whose
 *    triangles are long along the border has several rows of them. A point's own two lines
 *    become one in between if that leaves room for another and they are less than 10 degrees apart.
 * 3. A point where more than two edges of the border meet has next to no room, since two lines do not end its disk, and ends no
 *    edges of 2. The end of a slit, as meshes have that were split along a part of an edge, is left as it is.
 * 4. Where a face is narrow, or its outline turns within a disk's reach, a disk that has its two lines reaches past other edges.
 *    Its room is the radius with which its kernel goes past none by more than MostPast of its reach. What it leaves open then is
 *    for fill points.
 * 5. Fill points have lines and room in the same way, by the edges near to the vertices that they lie between, or where these are
 *    many by those of their body that are near to them (vtkPointSplatMeshOutline.h). Of these as of other edges only those count
 *    whose triangle faces as the disk does, if the order of corners tells that: a thin body's other side ends no disk.
 */
#ifndef vtkPointSplatMeshBorders_h
#define vtkPointSplatMeshBorders_h

#include "vtkPointSplatFans.h"
#include "vtkPointSplatMeshOutline.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
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

  struct Disk
  {
    const double* X;     // world coordinates
    const float* Normal; // of its plane, unit length
    float Radius;        // world units
  };
  /// How a disk ends.
  struct End
  {
    vtkIdType Id = -1;
    float Clip[6] = { 0, 0, 0, 0, 0, 0 };  // as in the array
    float Other[6] = { 0, 0, 0, 0, 0, 0 }; // those of a second splat in its place, if it has a line
    float Room = std::numeric_limits<float>::max(); // the largest radius with which it does not reach past other edges
    bool IsTwo() const { return Other[0] != 0 || Other[1] != 0 || Other[2] != 0; }
  };
  /// Of each point those on the border that it is near to, or to an edge at them, in order.
  struct Near
  {
    std::vector<std::size_t> First; // of each point's, and the end of the last one's
    std::vector<vtkIdType> Border;
  };
  /// Each point on the border is near to itself.
  Near FindNear() const;
  /// Those of the points near the border, in order. two: whether there may be second splats.
  std::vector<End> FindEnds(const Near& near, bool two) const;
  /// Adds the lines of points that have none to the array of clip lines, of 6 components, which is
  /// made if it has no tuples and any point has lines.
  void Write(const std::vector<End>& ends, vtkFloatArray* clips) const;

  /// Vertices of the body that a disk is of, around it, and the border near to those.
  struct Place
  {
    std::vector<vtkIdType> Vertices;
    const Near& Known;
    vtkPointSplatMeshOutline& Outline;
  };
  /// That of a disk between points.
  End FindEnd(const Disk& disk, const Place& place) const;

private:
  /// The border from a point on.
  struct Side
  {
    vtkIdType End = 0; // a point of it
    float Way[3] = { 0, 0, 0 }; // to that
    float Facing = 0; // cosine of the triangle's normal, whose side the surface's is left of it, and the disk's
    float Alike = 0;  // of the normal that the order of its corners tells, or if that tells none, of either one
    bool Own = false; // whether the disk is of a point between its ends
    /// Whether the surface lies to the left of it, as seen from where the disk's normal points.
    bool IsLeft() const { return this->Facing > 0; }
  };
  void Face(vtkIdType from, const vtkPointSplatFans::BorderEdge& edge, const float normal[3], Side& side) const;
  Side Walk(vtkIdType id, const vtkPointSplatFans::BorderEdge& edge, const float normal[3], float least) const;
  bool FindOwnLines(vtkIdType id, float least, bool two, End& end) const;
  float GetLeast(vtkIdType id) const;
  float GetReach(vtkIdType id) const;
  float GetDistance(vtkIdType border, vtkIdType id) const;
  /// An edge of the border near to a disk, in its plane.
  struct Edge
  {
    float Start[3], Way[3]; // from the disk's centre, and from there to the other end
    float Out[3];           // from the surface, unit length
    float Length, Distance; // of its line
    float Alike;            // as a Side's
    bool Own;               // as a Side's

    /// How far off, of its length, a fill point may lie that was put on it.
    static constexpr float Rounding = 1e-5f;
    bool IsThrough() const { return std::abs(Distance) <= Rounding * Length; }
    /// Where on its way it is nearest to the centre.
    float GetPlace() const
    {
      return -(Start[0] * Way[0] + Start[1] * Way[1] + Start[2] * Way[2]) / (Length * Length);
    }
    bool IsOn() const { return IsThrough() && GetPlace() >= -Rounding && GetPlace() <= 1 + Rounding; }
    /// Past its ends the border may turn away.
    bool IsBeside() const { return GetPlace() > -PastEnds && GetPlace() < 1 + PastEnds; }
  };
  /// How far past the ends of an edge a point may lie that is beside it, of its length.
  static constexpr float PastEnds = 0.25f;
  void AddEdge(const Disk& disk, vtkIdType from, const Side& side, std::vector<Edge>& edges) const;
  void AddPiece(
    const Disk& disk, const vtkPointSplatMeshOutline::Piece& piece, bool own, std::vector<Edge>& edges) const;
  static bool FindBorders(const Place& place, std::vector<vtkIdType>& borders);
  static void PutInOrder(std::vector<Edge>& edges);
  static void TakeLines(float least, const std::vector<Edge>& edges, float clip[6]);
  static std::array<float, 8> FindPassed(const Edge& edge, const float clip[6], float reach, const float part[2]);
  static float GetRoom(const Edge& edge, const float clip[6], float radius);
  static void Take(const Disk& disk, const std::vector<Edge>& edges, float clip[6], float& room);
  void AddNearLines(const Near& near, float least, End& end) const;
  void GetOffset(const double from[3], vtkIdType to, float d[3]) const;

  const vtkPointSplatFans& Fans;
  vtkFloatArray* Radii;
  vtkFloatArray* Planes;
};

VTK_ABI_NAMESPACE_END
#endif
