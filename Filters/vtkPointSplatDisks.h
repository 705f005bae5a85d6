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

#include <algorithm>
#include <limits>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatDisks
{
public:
  using Slot = vtkPointSplatNeighbors::Slot;

  vtkPointSplatDisks(Slot slots, bool elliptical);

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
  bool MayReachHole(Slot slot) const { return this->Opening[slot] > this->HoleLimit * this->Spacing[slot]; }
  /// Of the spacing at a border, which is larger than farther inside, what that is.
  float GetSpacingInside(Slot slot) const { return HoleShare * this->Spacing[slot]; }
  /// Finds the slots whose points are sparse, but as dense as all around, as where a mesh is coarser. Of spray, too, all around
  /// is as sparse, but alone.
  void FindSparse();
  bool IsSparse(Slot slot) const { return this->Sparse[slot] != 0; }
  /// The spacing past which a slot's neighbours are sparse: the usual one, or where all are sparse its own.
  float GetUsual(Slot slot) const { return this->Sparse[slot] ? this->BodySpacing[slot] : this->Usual; }
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
   * Finds both limits, Stretched, and whether the sampling is as regular as a mesh's vertices are: all over, or from one point
   * to the next, as where a mesh is coarser in one place than in another. Random samplings differ as much there as all over.
   */
  void FindLimits();

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

  /// An element of some order; values are shuffled.
  static float GetQuantile(std::vector<float>& values, double q);
  /// What is known, which is more than 0, of so many slots: of MostSamples of them at most, all over the cloud.
  template <typename Getter>
  static std::vector<float> GetSamples(std::size_t slots, const Getter& get)
  {
    // An odd stride: all lanes of leaves are among them.
    const std::size_t stride = std::max<std::size_t>(1, slots / MostSamples) | 1;
    std::vector<float> samples;
    for (std::size_t s = 0; s < slots; s += stride)
    {
      const float value = get(s);
      if (value > 0)
      {
        samples.push_back(value);
      }
    }
    return samples;
  }

  vtkPointSplatLargeArray<float> Distance; // how far apart points are (vtkPointSplatDisk)
  vtkPointSplatLargeArray<float> Turn;     // by how much the surface turns to a neighbour, over its distance, at most
  vtkPointSplatLargeArray<float> Facing;   // the same by the neighbours' normals
  vtkPointSplatLargeArray<float> Farthest; // the distance of the farthest neighbour in the star
  vtkPointSplatLargeArray<float> Length;  // of the longer axis; 0 for a point alone
  vtkPointSplatLargeArray<float> Gap;     // what it must at least be to close the gaps around
  vtkPointSplatLargeArray<float> Opening; // the distance of its cell's farthest vertex, 0 for an open cell
  vtkPointSplatLargeArray<unsigned char> Whole; // whether all neighbours are of its sheet
  vtkPointSplatLargeArray<unsigned char> Few; // whether most neighbours are of other sheets
  vtkPointSplatLargeArray<float> Spacing; // of the neighbours that the disk is made of
  vtkPointSplatLargeArray<float> NearSpacing; // of the nearest ones, of whatever sheet
  vtkPointSplatLargeArray<float> BodySpacing; // the same, on bodies of few points, too (vtkPointSplatSheet)
  vtkPointSplatLargeArray<float> Axes;    // both, unless circular
  vtkPointSplatLargeArray<float> Planes;  // their normals
  vtkPointSplatLargeArray<float> Curvatures; // tensors, if circular
  float Usual = std::numeric_limits<float>::max(); // the spacing of most points, where it tells what is sparse
  /// The distance of a cell's vertex, in spacings, past which it lies in a hole of the surface.
  float HoleLimit = std::numeric_limits<float>::max();
  float BorderLimit = std::numeric_limits<float>::max(); // the same for it to be one that splats end at
  bool Regular = false;
  bool Even = false; // sizes next to one another are the same
  bool Stretched = false; // regular, with cells that are long in one place and not in another

private:
  static constexpr std::size_t MostSamples = std::size_t(1) << 20;
  /// At a regular sampling's border the spacing is larger than farther inside: of HoleLimit counts this.
  static constexpr float HoleShare = 0.667f;
  /// The neighbours, by rank, that bound a disk.
  static constexpr int NumberOfWitnesses = 4;
  template <typename Visitor>
  void VisitWitnesses(Slot slot, const Visitor& visit) const;
  float GetBound(Slot slot) const;
  /// The largest spacing of a slot and its witnesses: of a few points that lie together it is that of those around.
  float GetSpacingAround(Slot slot) const;
  /// The 95th percentile, in medians, of the disks' sizes over those of their witnesses.
  float GetLocalSpread() const;

  vtkPointSplatLargeArray<unsigned char> Sparse; // as all around (FindSparse)
  vtkPointSplatLargeArray<unsigned char> Cut; // made smaller since the surface bends
  vtkPointSplatLargeArray<unsigned char> Graded; // of which something else says how large they are to be
  vtkPointSplatLargeArray<float> Nearest; // the distance to any neighbour
  vtkPointSplatLargeArray<Slot> Witnesses;
  float Body = 0; // the largest radius of a point alone
};

VTK_ABI_NAMESPACE_END
#endif
