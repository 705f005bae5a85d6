// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Which blocks of a mapper's input are pieces of one cloud, and what splats are made from of all of them
// together.
//
// A block's own points tell nothing of what goes on in the next one: pieces of a surface would each have a
// border where they meet, and where points are dealt out to blocks at random, as to the ranks of a simulation,
// each block would be a cloud of its own, as sparse as blocks are many.
// But bodies that touch, or lie one in the other, know best for themselves where they end.
// 1. Pieces are blocks of points alone, without splats' sizes, given groups, sensors or duplicate points (whose
//    neighbours are there already), all with normals or all without. Only those are looked at whose bounding boxes meet,
//    widened by half a spacing: that of the block's points if they were spread over its box's sides.
// 2. Their points say whether they are pieces of one cloud (vtkPointSplatPieceVotes.h).
// 3. Points and normals of the pieces of one cloud, one after the other, are given to
//    vtkPointSplatPacking::Collect(), as if they were one data set.
// 4. Each piece gets its own points' part of that, and the fill points that are nearest to these. What such points have of
//    others' ends, such as colours, they get from their own piece's alone.
#ifndef vtkPointSplatPieces_h
#define vtkPointSplatPieces_h

#include "vtkPointSplatPacking.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vtkPointSplatPieces
{
/// Whether splats of a level may stand for this block's points and another's: nothing but points' arrays tells how it is
/// drawn, neither triangles nor given groups.
bool MayMix(vtkPointSet* block);

/**
 * Whether blocks lie among one another, as those that points were dealt out to, or rows of a grid: of squares two spacings wide,
 * more than half have splats of several. splats: packed, of some words each; ends: behind the last one of each block.
 */
bool AreMixed(const std::vector<uint32_t>& splats, size_t words, const std::vector<uint32_t>& ends,
  double spacing);

/// The numbers of the blocks of each cloud, ascending, by its first one. A block that is no piece is alone.
std::vector<std::vector<size_t>> Find(
  const std::vector<vtkPointSet*>& blocks, const vtkPointSplatPacking::Wanted& wanted);

/// What vtkPointSplatPacking::Collect() says of each block of one cloud.
std::vector<vtkPointSplatPacking> Collect(vtkObject* owner, const std::vector<vtkPointSet*>& blocks,
  const vtkPointSplatPacking::Wanted& wanted);
}

#endif
