// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatDisks
 * @brief   the disks of all slots as they are found, and their bounds by one another
 *
 * An internal helper of vtkPointSplatEstimation; see the stages there.
 */
#ifndef vtkPointSplatDisks_h
#define vtkPointSplatDisks_h

#include "vtkPointSplatCreases.h"
#include "vtkPointSplatDisk.h"
#include "vtkPointSplatFans.h"
#include "vtkPointSplatLargeArray.h"
#include "vtkPointSplatSamplings.h"
#include "vtkPointSplatVoronoiCells.h"

#include <algorithm>
#include <limits>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatDisks : public vtkPointSplatVoronoiCells
{
public:
  /// usual: the spacing of most points.
  vtkPointSplatDisks(Slot slots, float usual, bool elliptical);

  /// Takes over what was found for a neighbourhood's centre. largest: length that it may have.
  void Set(const vtkPointSplatNeighbors::Neighborhood& around, const vtkPointSplatDisk& disk,
    float largest);
  /// Takes over how the surface turns in a neighbourhood's star, and how far that reaches, but for
  /// triangles in holes. grain: see vtkPointSplatSheet::Grain; a length.
  void SetStar(const vtkPointSplatNeighbors::Neighborhood& around, const vtkPointSplatDisk& disk,
    const float* normals, float grain);
  /// Where positions turn several times as steeply as normals do, as of points that are not quite on the surface, limits
  /// turns by what normals say: else each step between neighbours were a bend, to be filled with points.
  void TrustNormals();
  /// Takes over what a mesh's triangles say, of circular disks.
  void Set(Slot slot, const vtkPointSplatFans::Disk& disk);
  /// Takes over what was found at creases. Points beyond them that are much denser bound no disk.
  void Set(const vtkPointSplatCreases::Splat& splat);

  /// The radius at which a disk bends as much as it may.
  static float GetLargest(float curvature, float radius);

  bool IsAlone(Slot slot) const { return !(this->Length[slot] > 0); }
  void SetAlone(Slot slot) { this->Length[slot] = this->Gap[slot] = 0; }
  /// Whether a slot is so many times farther from all others than its neighbours are.
  bool IsOutlier(Slot slot, float times) const;
  /// Whether some witness has less than half of a slot's size. sizes: of each slot.
  bool HasSmallWitness(Slot slot, const vtkPointSplatLargeArray<float>& sizes) const;
  /// Whether the cell of some witness is closed.
  bool HasClosedWitness(Slot slot) const;
  /**
   * Whether the surface may end at a slot. Of a regular sampling: its cell is open, or may reach into a
   * hole by the spacing that there is farther inside, two thirds of that at a border, and by the least of those
   * around; if cells are stretched, it is open, or half as long again as another one around. Of a random one:
   * its cell is open, and that of some witness is not, as beside a border, along which others are open, and unlike in vegetation.
   */
  bool MayEnd(Slot slot) const;
  /// Whether a random sampling's cell is so wide that a border may go on into it from others.
  bool MayBeBay(Slot slot) const;
  /// The distance of a cell's vertex, in spacings around, from which on it may lie in a bay of the border: of points at random
  /// one in thirty is.
  static constexpr float BayLimit = 1.25f;
  /// Whether a closed cell is so wide that it may reach into a hole.
  bool MayReachHole(Slot slot) const { return this->Opening[slot] > this->GetSampling(slot).HoleLimit * this->Spacing[slot]; }
  /// Of the spacing at a border, which is larger than farther inside, what that is.
  float GetSpacingInside(Slot slot) const { return HoleShare * this->Spacing[slot]; }
  /// Finds the slots whose points are sparse, but as dense as all around, as where a mesh is coarser. Of spray, too, all around
  /// is as sparse, but alone.
  void FindSparse();
  bool IsSparse(Slot slot) const { return this->Sparse[slot] != 0; }
  /// The spacing past which a slot's neighbours are sparse: the usual one, or where all are sparse its own.
  float GetUsual(Slot slot) const { return this->Sparse[slot] ? this->BodySpacing[slot] : this->GetUsualOfPart(slot); }
  /// The same, wherever points are: that of its part, or if it is less of another one beside it.
  float GetUsualOfPart(Slot slot) const
  {
    float usual = this->GetSampling(slot).Usual;
    if (!this->Samplings.IsOne())
    {
      this->VisitWitnesses(
        slot, [&](Slot witness) { usual = std::min(usual, this->GetSampling(witness).Usual); });
    }
    return usual;
  }
  /// What the sampling of the slot's part is like.
  const vtkPointSplatSamplings::Sampling& GetSampling(Slot slot) const { return this->Samplings.Get(slot); }
  /// The radius that a disk has where it closes the gaps around; and whether that is too much for those beside.
  float GetReach(Slot slot) const { return std::max(this->Length[slot], this->Gap[slot]); }
  bool IsTooLarge(Slot slot) const { return this->GetReach(slot) > this->GetBound(slot); }
  /// Makes a disk of that length, which closes no gaps, and is not bounded by its witnesses.
  void Shrink(Slot slot, float length);
  /// Makes a disk at least that long, but no longer than the surface bends for.
  void Lengthen(Slot slot, float length);
  /// Makes of a closed cell an open one, of a disk of that length.
  void Open(Slot slot, float length);
  /// Whether at least half of the witnesses have a mark, or there are too few neighbours for any.
  bool AgreeWitnesses(Slot slot, const std::vector<unsigned char>& marks) const;

  /**
   * The two lines that clip a disk on a tube whose points are farther apart along it than it is wide: it
   * reaches to the next ring, and ends beside its axis before it leaves the tube. False where it does not.
   */
  bool GetTubeLines(Slot slot, float clip[6]) const;

  /// Makes a disk as large as the gap that it is to close.
  void Close(Slot slot);
  /// Closes all gaps, and gives points alone their bodies.
  void Finish();

  /// The length of the longer axis once all are bounded.
  float GetBounded(Slot slot) const;
  /// The curvature of a point alone that is a ball, as a tensor (vtkPointSplatArrays.h).
  void GetBall(Slot slot, float tensor[6]) const;

  vtkPointSplatLargeArray<float> Distance; // how far apart points are (vtkPointSplatDisk)
  vtkPointSplatLargeArray<float> Turn;     // by how much the surface turns to a neighbour, over its distance, at most
  vtkPointSplatLargeArray<float> Facing;   // the same by the neighbours' normals
  vtkPointSplatLargeArray<float> Farthest; // the distance of the farthest neighbour in the star
  vtkPointSplatLargeArray<float> Length;  // of the longer axis; 0 for a point alone
  vtkPointSplatLargeArray<float> Gap;     // what it must at least be to close the gaps around
  vtkPointSplatLargeArray<unsigned char> Whole; // whether all neighbours are of its sheet
  vtkPointSplatLargeArray<unsigned char> Few; // whether most neighbours are of other sheets
  vtkPointSplatLargeArray<float> NearSpacing; // of the nearest ones, of whatever sheet
  vtkPointSplatLargeArray<float> BodySpacing; // the same, on bodies of few points, too (vtkPointSplatSheet)
  vtkPointSplatLargeArray<float> Axes;    // both, unless circular
  vtkPointSplatLargeArray<float> Planes;  // their normals
  vtkPointSplatLargeArray<float> Curvatures; // tensors, if circular
  vtkPointSplatSamplings Samplings;

private:
  /// At a regular sampling's border the spacing is larger than farther inside: of HoleLimit counts this.
  static constexpr float HoleShare = 0.667f;
  float GetBound(Slot slot) const;

  vtkPointSplatLargeArray<unsigned char> Sparse; // as all around (FindSparse)
  vtkPointSplatLargeArray<unsigned char> Cut; // made smaller since the surface bends
  vtkPointSplatLargeArray<unsigned char> Graded; // of which something else says how large they are to be
  vtkPointSplatLargeArray<float> Nearest; // the distance to any neighbour
  float Body = 0; // the largest radius of a point alone
};

VTK_ABI_NAMESPACE_END
#endif
