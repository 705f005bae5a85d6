// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatNeighbors
 * @brief   the nearest neighbours of every point of a cloud
 *
 * An internal helper of the filters, and of ParaView's: it answers the query "k nearest neighbours" for all
 * points at once, which is faster than one query after the other.
 *
 * 1. Points are split at the median of the longest side of their bounding box until at
 *    most LeafSize are together. Points at the same position, to within what floats round
 *    (2^-21 of the side over which the middle half of the points extends), always fall on the
 *    same side and become one *slot*; the others of them are known by GetSlots() only. So
 *    duplicates, and those that sums of floats left beside one another, as at a sphere's pole,
 *    neither hide the true neighbours nor slow the search down.
 * 2. A leaf stores its positions as floats relative to its own origin (a double), so that
 *    neighbours are exact to float's precision of their *distance*, wherever the cloud lies
 *    and whatever outliers it has.
 * 3. For a leaf, neighbours are looked for within the radius in which there are more than enough of them, if the
 *    surface about is as dense as in the leaf; one walk over the tree collects the leaves within it for all its
 *    points. Those that have too few there are searched for again: candidates from the leaves next to it in the
 *    tree's order, as many leaves as have enough points, bound the radius.
 *
 * Nodes lie in depth-first order with the index of the next node to visit when one is
 * skipped, so the walk needs no stack.
 */
#ifndef vtkPointSplatNeighbors_h
#define vtkPointSplatNeighbors_h

#include "vtkDataArray.h"
#include "vtkFiltersPointSplattingModule.h" // For export macro
#include "vtkPointSplatBatches.h"
#include "vtkPointSplatLargeArray.h"
#include "vtkSMPThreadLocal.h"
#include "vtkType.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class VTKFILTERSPOINTSPLATTING_EXPORT vtkPointSplatNeighbors
{
public:
  using Slot = std::uint32_t;
  static constexpr int LeafSize = 16;
  static constexpr int MaximumNumberOfNeighbors = 128;
  static constexpr int NumberOfSpreadNeighbors = 64;
  static constexpr Slot None = std::numeric_limits<Slot>::max();

  /// A neighbour's squared distance, whose bits are the upper half, and below them its slot or when it was found: as
  /// doubles these are in the order of distances, which are none below zero, and comparing them needs no branch.
  using Key = double;

  /// The neighbours of one slot, nearest first, none at the same position.
  struct Neighborhood
  {
    Slot Center;
    int Count;
    const Slot* Slots;
    /// Offsets from the centre, and their squared lengths, in world units.
    const float *X, *Y, *Z;
    const float* SquaredDistance;
  };

  /**
   * Sorts the points (3 components, any type) in. A point takes part if used[id] is not 0.
   */
  void Build(vtkDataArray* points, const unsigned char* used);

  /// Slots are numbered from 0; some numbers below this one are empty.
  Slot GetNumberOfSlots() const { return static_cast<Slot>(this->Ids.size()); }
  /// The point id of a slot, or -1 where it is empty.
  vtkIdType GetId(Slot slot) const { return this->Ids[slot]; }
  /// The slot of each point; None for one that takes no part.
  const std::vector<Slot>& GetSlots() const { return this->SlotOfPoint; }
  /// The position of a slot in world coordinates.
  void GetPosition(Slot slot, double x[3]) const;

  /**
   * Calls visit(neighborhood, round) for each slot that is wanted(slot), slots in parallel:
   * in round 0 with its k nearest neighbours; where it returns false, in round 1 with four
   * times as many; where it returns false again, in round 2 with the nearest point of each of
   * the leaves around, which reach farther than a dense row of points does. Moves self's
   * progress from `from` to `to`; returns false if aborted.
   */
  template <typename Visitor, typename Predicate>
  bool Visit(vtkAlgorithm* self, double from, double to, int k, const Visitor& visit,
    const Predicate& wanted) const
  {
    return this->VisitRounds<false>(self, from, to, k, visit, wanted);
  }
  template <typename Visitor>
  bool Visit(vtkAlgorithm* self, double from, double to, int k, const Visitor& visit) const
  {
    return this->Visit(self, from, to, k, visit, [](Slot) { return true; });
  }
  /// The same, but that round 2 has up to NumberOfSpreadNeighbors of the nearest ones, too: where points are
  /// dense on one side a leaf may have its sparse ones behind them.
  template <typename Visitor, typename Predicate>
  bool VisitWidely(vtkAlgorithm* self, double from, double to, int k, const Visitor& visit,
    const Predicate& wanted) const
  {
    return this->VisitRounds<true>(self, from, to, k, visit, wanted);
  }

  /// What to give to Visit() as what is wanted: the slots of about so many leaves, all over the cloud.
  auto WantSome(Slot leaves) const
  {
    const Slot all = (this->GetNumberOfSlots() + LeafSize - 1) / LeafSize;
    return [stride = std::max<Slot>(1, all / leaves)](Slot slot) { return slot / LeafSize % stride == 0; };
  }

  /**
   * Calls visit(other) for each leaf, among them itself, whose box is within `distance` of a
   * leaf's box, until it returns false. Slots slot / LeafSize are in the same leaf.
   */
  template <typename Visitor>
  void VisitLeaves(Slot leaf, double distance, const Visitor& visit) const;
  /// The diagonal of a leaf's box, and how many slots it has.
  double GetDiagonal(Slot leaf, int& count) const;

private:
  struct Node
  {
    double Bounds[6];
    std::uint32_t Skip;
    std::uint32_t Leaf; // None for an inner node
  };
  struct Leaf
  {
    double Origin[3];
    float Bounds[6]; // relative to Origin: minima, maxima
    float X[LeafSize], Y[LeafSize], Z[LeafSize];
    int Count;
  };
  struct Scratch
  {
    std::vector<Key> Keys;    // k for each lane, ascending
    std::vector<Key> Nearest; // of another search
    std::vector<std::uint32_t> Leaves, Scanned;
    std::uint32_t First, Last; // of the leaves around
    std::vector<float> X, Y, Z, Distances; // of one neighbourhood
    std::vector<Slot> Slots;
  };
  struct Builder;

  static constexpr unsigned int AllLanes = (1u << LeafSize) - 1;

  void GetBox(std::uint32_t leaf, double bounds[6]) const;
  /// The squared distance of two boxes.
  static double GetSquaredDistance(const double a[6], const double b[6])
  {
    double sum = 0;
    for (int c = 0; c < 3; ++c)
    {
      const double d = std::max(std::max(a[c] - b[c + 3], b[c] - a[c + 3]), 0.0);
      sum += d * d;
    }
    return sum;
  }

  // spread: at most one neighbour a leaf.
  void SearchLeaf(
    std::uint32_t leaf, unsigned int lanes, int k, bool spread, Scratch& scratch) const;
  // Which leaves are next to one in the tree's order.
  void SetAround(std::uint32_t leaf, int k, bool spread, Scratch& scratch) const;
  void ScanLeaves(
    std::uint32_t leaf, unsigned int lanes, int k, bool spread, Scratch& scratch) const;
  // Returns the lanes that have fewer than k neighbours within the radius.
  unsigned int SearchWithin(
    double squared, std::uint32_t leaf, unsigned int lanes, int k, Scratch& scratch) const;
  void Scan(const Leaf& from, std::uint32_t other, unsigned int lanes, int k, bool self,
    bool spread, Scratch& scratch) const;
  static void Keep(Scratch& scratch);
  /// Adds those that were kept, of k a lane, and returns how many a lane has.
  static int Merge(int k, Scratch& scratch);
  Neighborhood Describe(std::uint32_t leaf, int lane, int k, Scratch& scratch) const;
  template <bool Widely, typename Visitor, typename Predicate>
  bool VisitRounds(vtkAlgorithm* self, double from, double to, int k, const Visitor& visit,
    const Predicate& wanted) const;

  std::vector<Node> Nodes;
  vtkPointSplatLargeArray<Leaf> Leaves;
  vtkPointSplatLargeArray<vtkIdType> Ids;
  std::vector<Slot> SlotOfPoint;
};

template <typename Visitor>
void vtkPointSplatNeighbors::VisitLeaves(Slot leaf, double distance, const Visitor& visit) const
{
  double box[6];
  this->GetBox(leaf, box);
  const std::uint32_t numberOfNodes = static_cast<std::uint32_t>(this->Nodes.size());
  for (std::uint32_t n = 0; n < numberOfNodes;)
  {
    const Node& node = this->Nodes[n];
    if (!(GetSquaredDistance(box, node.Bounds) <= distance * distance))
    {
      n = node.Skip;
      continue;
    }
    if (node.Leaf != None && !visit(node.Leaf))
    {
      return;
    }
    ++n;
  }
}

template <bool Widely, typename Visitor, typename Predicate>
bool vtkPointSplatNeighbors::VisitRounds(vtkAlgorithm* self, double from, double to, int k,
  const Visitor& visit, const Predicate& wanted) const
{
  vtkSMPThreadLocal<Scratch> scratches;
  const int more = std::min(4 * k, MaximumNumberOfNeighbors);
  auto functor = [&](vtkIdType begin, vtkIdType end) {
    Scratch& scratch = scratches.Local();
    for (vtkIdType leaf = begin; leaf < end; ++leaf)
    {
      const std::uint32_t leafId = static_cast<std::uint32_t>(leaf);
      unsigned int lanes = 0;
      for (int lane = 0; lane < this->Leaves[leaf].Count; ++lane)
      {
        lanes |= wanted(leafId * LeafSize + lane) ? 1u << lane : 0u;
      }
      for (int round = 0; round < 3 && lanes; ++round)
      {
        int count = round == 0 ? k : round == 1 ? more : NumberOfSpreadNeighbors;
        if (Widely && round == 2)
        {
          Keep(scratch);
        }
        this->SearchLeaf(leafId, lanes, count, round == 2, scratch);
        if (Widely && round == 2)
        {
          count = Merge(more, scratch);
        }
        for (int lane = 0; lane < LeafSize; ++lane)
        {
          if ((lanes >> lane & 1u) &&
            visit(this->Describe(leafId, lane, count, scratch), round))
          {
            lanes &= ~(1u << lane);
          }
        }
      }
    }
  };
  return vtkPointSplatBatches::For(
    self, static_cast<vtkIdType>(this->Leaves.size()), 64, from, to, functor);
}

VTK_ABI_NAMESPACE_END
#endif
