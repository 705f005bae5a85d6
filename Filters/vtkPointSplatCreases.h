// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatCreases
 * @brief   the splats at the creases of a cloud: their clip lines and their disks
 *
 * An internal helper of vtkPointSplatEstimation; see the stages there.
 *
 * 1. Candidates, by vtkPointSplatCrease::IsLikely for the neighbours that disks are made of, are
 *    asked for their lines, as if nothing but smooth surface were around. Only these and the 32
 *    neighbours of those that have some are looked at closely.
 * 2. Their faces are fitted, to 32 neighbours (vtkPointSplatFace); of those in a row the others tell whether they
 *    are strips or edges. Points share a position, but not
 *    a normal, where a mesh was split at its edges: each such point has a face of its own.
 * 3. Those whose faces end are asked for their lines (vtkPointSplatCrease). Then these two stages
 *    are repeated for the neighbours of those that have some: a disk may reach farther than the
 *    nearest neighbours are, and next to a crease the faces of more points are known by then.
 * 4. The disk of a point with lines is estimated anew, from the neighbours on its own face and from
 *    their mirror images and its own at the lines: then it is as large as it would be if the face
 *    went on, and what lies between the points and the line is covered as the rest is, since of a
 *    point and its image the point itself is nearer to what is on its side. Points on the lines
 *    with averaged normals count among them, since they have a part of their splat on each face, but for
 *    those that are much denser than the face's points are far: their splats are as small as the denser face's.
 *    Points that are a little off the face, with no line on the way, as past an edge of few degrees, bound the disk, too.
 *    Where the neighbours on a face are those of one row, along an edge whose other face is denser than the next
 *    row is near, more neighbours are looked at, and the distance of that row is the spacing on this face.
 *    The same where a point on the edge, with an average of normals, is on a sparser face than the others.
 *    More are looked at, too, where the 32 are of one face and of the edge alone, whose normals are averages, but for fewer
 *    than say a line: the other face's points may be so sparse that hardly any of them is among these. Then the 128
 *    nearest count, however dense they are.
 * 5. Lines are kept where at least ten neighbours have some, and sixteen about the point or about
 *    one of its neighbours; of points that a mesh was split at, where four do.
 *
 * Memory is 25 bytes a face and 10 a slot, and nothing without candidates; smooth surfaces have
 * hardly any.
 */
#ifndef vtkPointSplatCreases_h
#define vtkPointSplatCreases_h

#include "vtkPointSplatCrease.h"
#include "vtkPointSplatDisk.h"

#include <vector>

class vtkAlgorithm;
class vtkFloatArray;

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatCreases
{
public:
  using Slot = vtkPointSplatNeighbors::Slot;

  /// A point that has a position, but not a normal, in common with the point of a slot.
  struct Twin
  {
    vtkIdType Id;
    Slot At;
    float Normal[3];
  };

  /// What stands in for the disk that was estimated without creases.
  struct Splat
  {
    Slot At;
    vtkIdType Id; // of a twin; -1 for the slot's own points
    float Axis1[3], Axis2[3], Normal[3];
    float Length1, Length2, Gap, Spacing; // as in vtkPointSplatDisk
    float Tensor[6], Strongest;           // as in vtkPointSplatFace
    float Clip[6], Fold[6];               // as in the arrays
  };

  /// A face of whose points one row at most is among the neighbours.
  struct Row
  {
    Slot At;
    vtkIdType Id; // as of a splat
    float Normal[3];
    float Along[3];    // its direction; 0 where there are none
    bool HasSplat = false;
    std::size_t Splat = 0; // if so, its number among those that were found
    bool Open = false;     // whether the next row is still to be found
    bool Hidden = false;   // whether it may end at a face that has no points among the neighbours
  };

  /// Faces whose normals agree so well (10 degrees) are one: others part by 20 at least.
  static constexpr float OwnCosine = 0.985f;

  /// normals: 3 floats a slot, unit length; tensors: 6, or null; spacings: one, of the nearest points, of whatever
  /// face.
  vtkPointSplatCreases(const vtkPointSplatNeighbors& neighbors, const float* normals,
    const float* tensors, const float* spacings, bool elliptical);

  /// candidates: of each slot, whether it is one. Returns false if self was aborted.
  bool Find(vtkAlgorithm* self, double from, double to,
    const std::vector<unsigned char>& candidates, std::vector<Twin> twins);

  /**
   * Fills the arrays of clip lines and of folds, of 6 components; folds stay empty without any.
   * slotOf: of each point.
   */
  void Write(const std::vector<Slot>& slotOf, vtkFloatArray* clips, vtkFloatArray* folds) const;

  /// What was found, in order of slots and ids.
  std::vector<Splat> Splats;

  /// Whether points of a slot have normals of several faces.
  bool HasTwins(Slot s) const;

  /// Whether a splat ends at lines, and whether it goes on behind one of these.
  static bool HasLine(const Splat& splat);
  static bool HasFold(const Splat& splat);

private:
  using Neighborhood = vtkPointSplatNeighbors::Neighborhood;

  /// Twice as far as the neighbours that disks are made of reach, and some.
  static constexpr int NumberOfNeighbors = 32;
  static float GetSpacing(const Neighborhood& around, int round);
  bool AddOthers(vtkAlgorithm* self, double progress, const std::vector<unsigned char>& wanted,
    std::vector<unsigned char>& all) const;
  bool FitFaces(
    vtkAlgorithm* self, double from, double to, std::vector<unsigned char>& wanted);
  bool FindStrips(
    vtkAlgorithm* self, double progress, Slot first, const std::vector<unsigned char>& rows);
  /// Whether a mesh was split at an edge through a point: this and others near have twins. Isosurfaces through samples of their
  /// volume have some here and there.
  bool IsSplit(const Neighborhood& around) const;
  /// The first twin of a slot, if it has some.
  std::vector<Twin>::const_iterator FindTwin(Slot s) const;
  struct Found
  {
    std::vector<Splat> Splats;
    std::vector<Row> Rows; // for which farther neighbours are to be looked at
  };
  void FindSplats(const Neighborhood& around, Found& found) const;
  bool FindSplat(const Neighborhood& around, float spacing, Row& row, Splat& splat) const;
  bool FitMeeting(const Neighborhood& around, const Row& row, const vtkPointSplatCrease& crease,
    vtkPointSplatFace& face, float plane[3]) const;
  /// Finds splats of rows again, with farther neighbours, the last ones there are or not. Returns whether no
  /// row is left.
  bool FindWider(const Neighborhood& around, bool last, Found& found) const;
  bool DescribeSplat(const Neighborhood& around, const float plane[3], const vtkPointSplatFace& face,
    vtkPointSplatCrease& crease, Splat& splat) const;
  bool ReachesOver(const Neighborhood& around, const float plane[3],
    const vtkPointSplatCrease::Line& line, float radius) const;

  const vtkPointSplatNeighbors& Neighbors;
  vtkPointSplatFaces Faces;
  std::vector<Twin> Twins;
  bool Elliptical;
};

VTK_ABI_NAMESPACE_END
#endif
