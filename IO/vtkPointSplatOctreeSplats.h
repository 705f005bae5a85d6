// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Of the octree's reader: the arrays of a cut's splats, read by way of a cache.
#ifndef vtkPointSplatOctreeSplats_h
#define vtkPointSplatOctreeSplats_h

#include "vtkPointSplatChunkCache.h"
#include "vtkPointSplatOctreeCut.h"

#include <vector>

class vtkPointSplatOctreeSplats
{
public:
  vtkPointSplatOctreeSplats(
    const vtkPointSplatOctreeCut& tree, const vtkPointSplatOctreeCut::Runs& runs);

  vtkIdType GetNumberOfSplats() const { return this->Count; }
  /// Those that all levels of the cut have. Coordinates come first; where there are none something is
  /// wrong with the file.
  size_t GetNumberOfArrays() const { return this->Arrays.size(); }
  const vtkPointSplatHDF5::ArrayHead& GetHead(size_t array) const;
  /// None: it cannot be read.
  vtkSmartPointer<vtkAbstractArray> Read(size_t array, vtkPointSplatChunkCache& cache) const;

  /// All chunks of all arrays that hold the cut's splats.
  std::vector<vtkPointSplatChunkCache::Key> GetChunks() const;
  /// A chunk from the file; none: it cannot be read.
  static vtkSmartPointer<vtkAbstractArray> ReadChunk(
    const vtkPointSplatOctreeCut& tree, const vtkPointSplatChunkCache::Key& key);

private:
  /**
   * A level of a piece, of which some runs are read.
   */
  struct Source
  {
    vtkIdType Piece;
    vtkIdType LevelNumber;
    const vtkPointSplatOctreeCut::Level* Level;
    std::vector<vtkPointSplatHDF5::Run> Runs;
    vtkIdType Count; // of all runs
  };
  /**
   * Where tuples go: into an array that has them, from one on.
   */
  struct Place
  {
    vtkAbstractArray* Array;
    vtkIdType First;
  };
  /// Of an array of the first source its number in each source; empty where one has none, or one of
  /// another kind.
  std::vector<size_t> NumbersOf(size_t wanted) const;
  /// False: a source's tuples cannot be read.
  static bool Fill(
    const Source& source, size_t number, const Place& to, vtkPointSplatChunkCache& cache);

  std::vector<Source> Sources;
  std::vector<std::vector<size_t>> Arrays; // of each its number in each source
  vtkIdType Count = 0;
};

#endif
