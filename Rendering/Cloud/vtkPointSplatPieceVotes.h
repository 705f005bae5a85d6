// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether blocks of points that meet are pieces of one cloud, as their points see it, or bodies that touch.
//
// 1. Of up to a thousand points of each block the 16 nearest ones are found among the points of all blocks. Points with other
//    blocks' among them vote.
// 2. Those lie on the point's sheet whose normals are within 45 degrees of its own and that are within 17 degrees
//    of its plane, or twice what its own block's are, where these are noise. It votes for a piece where others lie on its sheet all
//    around; where its own block leaves a side open, to which others on its sheet go on; and where hardly any point is of its own
//    block and others are on its sheet. It votes against where most others are not on its sheet, as where bodies touch.
// 3. Blocks with a share of votes for pieces of LeastShare at least are pieces, of one cloud with the blocks that those
//    who voted for that have beside them, if these are pieces or most of their own votes are not against that, as of the many points around a few.
//
// Of blocks that points are dealt out to nine of ten votes are for pieces, however noisy they are; of those that a cloud was cut in along
// planes, a third of the votes at the cut, and none is against. Of bodies that touch, cross or lie a spacing apart one in
// thirty is for pieces.
//
// Points that are hidden, or not finite, with a normal that is none, take no part, nor do those that lie farther off than the
// middle nine tenths of all span: among so few cells the locator has they would be found slowly.
#ifndef vtkPointSplatPieceVotes_h
#define vtkPointSplatPieceVotes_h

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStaticPointLocator.h"

#include "vtkPointSplattingABI.h"

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkIdList;
class vtkPointSet;
VTK_ABI_NAMESPACE_END

class vtkPointSplatPieceVotes
{
public:
  /// All have normals, or none has.
  explicit vtkPointSplatPieceVotes(const std::vector<vtkPointSet*>& blocks);

  /// Pairs of blocks that are pieces of one cloud.
  std::vector<std::pair<size_t, size_t>> Count() const;

private:
  struct Votes;

  /// What a point sees of a neighbour.
  struct View
  {
    double Angle; // in the tangent plane
    double Slope; // off that plane
    double Facing; // cosine
    size_t Block;
  };

  /// Takes those of a block's points that may take part, from low to high.
  void Take(vtkPointSet* block, const std::array<double, 3>& low, const std::array<double, 3>& high);
  void Ask(size_t block, Votes& votes) const;
  /// around: those of its own block first.
  static void Vote(size_t block, const std::vector<View>& around, Votes& votes);
  /// The middle one of what a point sees of its own block's; nothing wrong where there are few.
  static double MiddleOf(const std::vector<View>& around, size_t own, double View::*what);
  std::vector<View> Look(vtkIdType point, vtkIdList* nearest) const;
  size_t BlockOf(vtkIdType point) const;
  /// Its own, or that of the plane through the nearest points.
  void GetNormal(vtkIdType point, vtkIdList* nearest, double n[3]) const;
  double GetFacing(const double n[3], vtkIdType other) const;

  vtkNew<vtkPolyData> All;
  std::vector<vtkIdType> Ends; // behind each block's last point
  vtkNew<vtkDoubleArray> Normals; // empty: none
  vtkNew<vtkStaticPointLocator> Locator;
};

#endif
