// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatBorders
 * @brief   the clip lines of the splats at the borders of a cloud's surface
 *
 * An internal helper of vtkPointSplatEstimation; see the stages there. The border is that of the
 * alpha shape (Edelsbrunner, Kirkpatrick, Seidel 1983, On the Shape of a Set of Points in the
 * Plane), alpha being the distance from which on a vertex of a Voronoi cell lies in a hole
 * (vtkPointSplatSamplings, in the upper quartile of the spacings around). Where a regular sampling's
 * cells are long in one place and square in another, it is no more than twice the median of what the cells around reach.
 *
 * 1. A candidate is looked at with its 32 nearest neighbours, or 128 where these lie in a row, or to one side alone of
 *    a cell that is closed, since they are denser there. Where
 *    just one run of its cell's vertices is farther than alpha, the surface ends between the two neighbours whose bisectors
 *    lead into that run and out of it: they are the next points along the border.
 * 2. Points of other sheets that lie in that sector, within two spacings, say that the surface goes
 *    on there, at a crease, around a tube or past a seam: then it is no border.
 * 3. Points are linked where one is the next of the other. A chain is a border if a vertex is
 *    farther than twice alpha, or of a regular sampling than one and a half times alpha and than gaps that are closed, in at least
 *    eight of its points' cells: others are gaps in the sampling. So are cells that are no wider than that by the
 *    spacing at their farthest vertex, as where points become sparser from one row to the next, unless cells are long in one
 *    place and square in another.
 * 4. The splat is clipped by the lines through the point and each of the next ones where the face
 *    between them has a convex corner. Where the corner is reflex, one line cuts across it, as far
 *    off as half of the way to the nearer of the next points, since a splat keeps what all of its
 *    lines do (vtkPointSplatBorderPlane.h).
 * 5. What is past the lines is not drawn, so the disk may be as large as the triangles inside need: in
 *    the border row of points that are much denser along rows, as wide as the way to the next row.
 *    Splats farther inside that reach over the border, as where points are denser across it than along,
 *    are clipped by the lines of the nearest points on it, as are its points beside its corners.
 * 6. Where points are at random a border goes on into cells that are as wide as a gap, in bays that its points on the other side
 *    close, if it is there without these. What few neighbours leave open is sure to be no gap if nothing of the sheet is as far as
 *    that in the sector: other sheets' points may be.
 * 7. Random samplings may end somewhere between their last points and the surface's border. There alpha
 *    is as wide as the gaps that are closed, and candidates, as where alpha is that wide in a regular one, are looked at with 64
 *    neighbours, or where the gap is wider than these reach with the nearest points of the leaves around. Each splat that reaches
 *    over the border ends at one line across the mean of the ways out of the surface there, past the
 *    outermost point beside it by as much as the last points scatter about a parabola: not at all where
 *    these are the vertices of a mesh's border. Where these ways do not agree, at corners and in bays, lines are those of 4.
 *
 * Memory is 56 bytes a point at a border and two bytes a slot; candidates are points whose cells are
 * open or reach into holes, which smooth closed surfaces have hardly any of.
 */
#ifndef vtkPointSplatBorders_h
#define vtkPointSplatBorders_h

#include "vtkPointSplatDisks.h"

#include "vtkSMPThreadLocal.h"

#include <atomic>
#include <vector>

class vtkAlgorithm;
class vtkFloatArray;

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatBorderPlane;

class vtkPointSplatBorders
{
public:
  using Slot = vtkPointSplatNeighbors::Slot;

  /// How far, in radii, what draws a disk reaches.
  static constexpr float KernelReach = 1.5f;

  /// normals: 3 floats a slot, of the disks' planes.
  vtkPointSplatBorders(
    const vtkPointSplatNeighbors& neighbors, const float* normals, const vtkPointSplatDisks& disks);

  /// candidates: of each slot, whether the surface may end there or its border have a bay, as far as its disk tells that. Returns
  /// false if self was aborted.
  bool Find(vtkAlgorithm* self, bool elliptical, const std::vector<unsigned char>& candidates);

  /// Takes ends back, of slots in ascending order, at which the surface goes on.
  void Reopen(const std::vector<Slot>& slots);

  /**
   * Of a regular sampling: makes disks that are clipped as large as the triangles there need; what is
   * past the line is not drawn. Of a random one: puts one straight line a splat in the place of those
   * through the points, for all splats that reach over it. To be called before disks are closed.
   * Returns false if self was aborted.
   */
  bool Finish(vtkAlgorithm* self, vtkPointSplatDisks& disks);

  /// Whether the surface ends at a slot, and in that direction, of any length, by what Find() found.
  bool IsEnd(Slot slot) const { return FindAt(this->Rim, slot) != nullptr; }
  bool IsOutside(Slot slot, const float direction[3]) const;

  /// Lines of several directions, within some reach of a point.
  struct Lines
  {
    float Reach;
    int Count = 0;
    float Out[2][3]; // unit length
    float Distance[2];

    /// As in the array of clip lines.
    void Write(float clip[6]) const;
  };
  /**
   * Adds a line of another point, as in the array of clip lines; place: where that lies; n: the normal of the
   * disk's plane. Returns false where it is not within reach, or its direction is known.
   */
  static bool AddLine(const float line[3], const float place[3], const float n[3], Lines& lines);

  /// From how many spacings on what is open is surely no gap of a regular sampling; 0 of a random one, whose gaps
  /// its HoleLimit bounds.
  float GetWidestGap(Slot slot) const;

  /// Adds the lines, if any, of points that have none to the array of clip lines, of 6 components,
  /// which is made if it has no tuples. slotOf: of each point.
  void Write(const std::vector<Slot>& slotOf, vtkFloatArray* clips) const;

  /// Makes the array of clip lines, of so many points without any, if it has no tuples.
  static void MakeLines(vtkFloatArray* clips, vtkIdType count);

private:
  using Neighborhood = vtkPointSplatNeighbors::Neighborhood;

  /// At a border these reach as far as half of them do elsewhere, past four spacings.
  static constexpr int NumberOfNeighbors = 32;

  /// Where the surface ends at a slot.
  struct End
  {
    Slot At;
    Slot Next[2];
    bool Sure; // that this is no gap of the sampling
    bool Bay;  // whether it is no wider than gaps are, and an end only as one of a border's others
    float Clip[6]; // as in the array
    float Out[3];  // from the surface, unit length
    float Gap;     // what its disk must at least be to cover the triangles there
  };

  /// What is a gap of some sampling.
  struct Gaps
  {
    explicit Gaps(const vtkPointSplatSamplings::Sampling& sampling);
    float Alpha;      // in spacings
    float LeastReach; // in alphas, of a cell that is none
    bool Wide;        // whether that may be farther than NumberOfNeighbors reach
  };
  Gaps GetGaps(Slot slot) const { return Gaps(this->Disks.GetSampling(slot)); }

  /// From which distance on a vertex of a Voronoi cell lies in a hole, of limits in spacings; 0 where none around has a cell.
  float GetAlpha(const Neighborhood& around, float limit) const;
  bool FindEnd(const Neighborhood& around, const vtkPointSplatDisk& disk, End& end) const;
  /// The angle that an end's next points leave open in its plane, and where it begins: at the first of them.
  double GetSector(const vtkPointSplatBorderPlane& plane, const End& end, double& from) const;
  /// Whether there is nothing of the sheet in that sector, as far as a border is sure to reach, in neighbours that reach as far.
  bool IsVoid(const Neighborhood& around, const End& end) const;
  static const End* FindAt(const std::vector<End>& ends, Slot slot);
  const End* GetEnd(Slot slot) const { return FindAt(this->Ends, slot); }
  void Take(vtkSMPThreadLocal<std::vector<End>>& found);
  void Confirm();
  void Sort();
  /// How far a slot's disk, once it is closed, is drawn.
  float GetReach(Slot slot) const;
  /// The slots whose disks reach the point of an end, and these.
  bool FindNear(vtkAlgorithm* self, std::vector<std::atomic<bool>>& near) const;
  /// False where the splat has no other lines than before.
  bool ClipAsNearest(const Neighborhood& around, End& clip) const;
  bool ClipBeside(vtkAlgorithm* self);
  bool Straighten(vtkAlgorithm* self);
  bool Cut(const Neighborhood& around, End& cut) const;

  const vtkPointSplatNeighbors& Neighbors;
  const float* Normals;
  const vtkPointSplatDisks& Disks;
  std::vector<End> Ends; // in order of slots
  std::vector<End> Rim;  // the same, as they were found
};

VTK_ABI_NAMESPACE_END
#endif
