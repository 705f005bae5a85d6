// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatBodies
 * @brief   the points that no surface goes through
 *
 * An internal helper of vtkPointSplatEstimation; see stage 7 there. Points along a curve, points
 * that fill a volume and outliers far from all others have no plane. They are bodies alone.
 *
 * 1. Points without given normals are looked at with their nearest neighbours, whose variances
 *    along their principal axes tell. On a curve the second is next to nothing, and with the
 *    neighbours' neighbours too, since a few points at random may lie in a row. (Those in rows that are a surface's are
 *    taken for given, vtkPointSplatRows.h.) In a volume the
 *    third is not much less than the others, the planes that fit neighbouring points have little to
 *    do with one another, and both is so with most of the neighbours as well, since thick noise
 *    about a surface has such places too. An outlier is farther from the others than these are from one
 *    another.
 * 2. Points with given normals are on a curve where no more neighbours than a row of them were
 *    found on any side. So are those of a surface's border row, of scan lines that are many times
 *    as dense along them as from one to the next. But their sheet has points with neighbours all
 *    around, the rows beside: of the nearest one such a border point takes the size. Where a curve
 *    bends or jumps, a few of its points have some of its farther parts all around: on a sheet of rows
 *    not they alone have, but some of the witnesses too.
 */
#ifndef vtkPointSplatBodies_h
#define vtkPointSplatBodies_h

#include "vtkPointSplatDisks.h"

#include <atomic>
#include <cstddef>
#include <mutex>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkAlgorithm;

class vtkPointSplatBodies
{
public:
  using Slot = vtkPointSplatNeighbors::Slot;
  using Neighborhood = vtkPointSplatNeighbors::Neighborhood;

  explicit vtkPointSplatBodies(Slot slots);

  /// Looks at a point without given normal. normals: 3 floats a slot, the estimated ones; onSurface: of each slot whether its
  /// neighbours are on a surface (vtkPointSplatNormals.h): where most are, on tubes as well, they fill no volume.
  void Look(const Neighborhood& around, const float* normals, const std::vector<unsigned char>& onSurface);

  /// Looks at the nearest, so many, of a point whose neighbours lie in a row.
  void LookAtRow(const Neighborhood& around, int nearest);
  /// Takes a point of a row, with the farthest neighbours that were found. length: of its disk by
  /// the nearest.
  void AddRow(const Neighborhood& around, const vtkPointSplatSheet& sheet, float length);

  /// Takes back what AddRow() was told of the slots that are marked, which are looked at once more.
  void ForgetRows(const std::vector<unsigned char>& slots);

  /**
   * Makes disks of length 0 of the bodies, and of border rows' as large as those in the next row.
   * count: of neighbours, as in the looks. Returns false if aborted.
   */
  bool Finish(vtkAlgorithm* self, double from, double to,
    const vtkPointSplatNeighbors& neighbors, int count, vtkPointSplatDisks& disks);

private:
  static constexpr std::size_t NumberOfModels = 16;
  static constexpr std::size_t NumberOfNearest = 8;
  struct Row
  {
    Slot At;
    Slot Models[NumberOfModels]; // of its sheet: the nearest, and the nearest beside the row
    float Length;                // by its nearest neighbours alone
  };

  bool IsPartOfCurve(Slot slot, const vtkPointSplatDisks& disks) const;

  std::vector<unsigned char> OnCurve;
  std::vector<unsigned char> InRow; // as are ends of curves, which may have another part beside
  std::vector<unsigned char> Scattered;     // by the look at it alone
  std::vector<std::atomic<bool>> Suspected; // slots with a neighbour that is
  std::vector<unsigned char> Guessed;       // slots without given normal
  std::atomic<bool> AnyScattered{ false };
  std::vector<Row> Rows;
  std::mutex RowsMutex;
};

VTK_ABI_NAMESPACE_END
#endif
