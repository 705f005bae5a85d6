// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Of the octree's reader: the tree of blocks of a file, and the cut through it that is read.
#ifndef vtkPointSplatOctreeCut_h
#define vtkPointSplatOctreeCut_h

#include "vtkPointSplatHDF5.h"

#include "vtkBoundingBox.h"

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

class vtkPointSplatOctreeView;

class vtkPointSplatOctreeCut
{
public:
  /**
   * What a piece's level has: coordinates first, then point data.
   */
  struct Level
  {
    vtkPointSplatHDF5::Handle Group;
    std::vector<vtkPointSplatHDF5::ArrayHead> Heads;
  };
  /// The splats of a piece's level that are read, in their order.
  using Runs = std::map<std::pair<int, int>, std::vector<vtkPointSplatHDF5::Run>>;

  /**
   * Which cut.
   */
  struct Wish
  {
    vtkIdType Room;     // splats at most; 0: any number
    vtkBoundingBox Box; // an invalid one holds everything
    // Who looks, and how large splats may be that are seen, radii in pixels. None: all are too large.
    const vtkPointSplatOctreeView* View;
    double Pixels;
  };

  /// Reads the tree of a piece. False: what the file has cannot be right.
  bool AddPiece(hid_t file, int piece);
  Runs Make(const Wish& wish) const;
  static vtkIdType CountOf(const std::vector<vtkPointSplatHDF5::Run>& runs);
  static vtkIdType CountOf(const Runs& runs);
  /// How many splats two cuts have in common.
  static vtkIdType CountOfCommon(const Runs& one, const Runs& other);
  const Level& GetLevel(int piece, int level) const { return this->Levels.at({ piece, level }); }

private:
  struct Block
  {
    int Piece;
    int Level;
    vtkPointSplatHDF5::Run Splats;
    size_t FirstChild;
    size_t ChildCount;
    vtkBoundingBox Box;
    float Radius; // the largest
  };

  bool AddBlocks(hid_t piece, int number, const std::vector<vtkIdType>& sizes);
  /// How large its splats are, for the order in which blocks give way; those off the view never do.
  static double SizeOf(const Block& block, const Wish& wish);
  /// Those of the children that reach into the box, and how many splats they have.
  vtkIdType ChildrenOf(
    const Block& block, const vtkBoundingBox& box, std::vector<size_t>& children) const;

  std::map<std::pair<int, int>, Level> Levels;
  std::vector<Block> Blocks;
  std::vector<size_t> Roots;
};

#endif
