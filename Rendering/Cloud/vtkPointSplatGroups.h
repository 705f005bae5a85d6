// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// A cloud's splats in groups (Zhang, Pajarola 2006): such that overlap little, for deferred
// blending, or such that each cover the surface, for sorted transparency.
//
// The input's `SplatGroup` is taken where it serves: for sorted transparency only where the field
// array `SplatGroupCoverage` says that each group covers the surface. Otherwise groups are made by
// vtkPointSplatGrouping:
// - for deferred blending with all three relaxations of section 4.1: splats in one plane (1), where
//   no colours, values, factors, coordinates or clip lines of their own tell them apart; normals
//   that point in opposite directions (2); the factor c (3);
// - for sorted transparency with the extended grouping of section 4.2.2: radii that are enlarged,
//   each group's such that equation 8 holds (vtkPointSplatCoverage.h). Copies (method 1) come with inputs that have them. Of the
//   relaxations (2) alone is right there: splats in one plane must be in different groups for each
//   to cover that plane.
// Within a group splats are in Morton order, and every 16 of them make a leaf, which is sorted as
// one (section 5.2.1 has a BSP tree).
#ifndef vtkPointSplatGroups_h
#define vtkPointSplatGroups_h

#include "vtkTimeStamp.h"
#include "vtkType.h"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "vtkPointSplattingABI.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkPointSet;
VTK_ABI_NAMESPACE_END

class vtkPointSplatGroups
{
public:
  /**
   * How splats are divided: such that those nearer than Factor * Reach times their radii are
   * apart; or into Number groups with the least overlap, each of which covers the surface when
   * its splats grow by GetScale(). Alike: whether splats in one plane look the same.
   */
  struct Request
  {
    double Factor = 1.0;
    double Reach = 1.0;
    int Number = 0;
    bool Alike = false;
    bool operator==(const Request& other) const
    {
      return this->Factor == other.Factor && this->Reach == other.Reach &&
        this->Number == other.Number && this->Alike == other.Alike;
    }
  };

  /// Splats as vtkPointSplatCloud packs them, in Morton order, and the blocks that they came from.
  struct Splats
  {
    struct Block
    {
      vtkPointSet* Data;
      vtkIdType First;
      vtkIdType Count;
    };
    const std::vector<uint32_t>& Packed;
    size_t Words;
    std::array<double, 3> Origin;
    std::vector<Block> Blocks;
  };

  /**
   * A run of splats in the groups' order that lie close together, and their middle in the cloud's
   * coordinates.
   */
  struct Leaf
  {
    vtkIdType First;
    vtkIdType Count;
    double Centre[3];
  };

  /// Done anew only when splats or the request change. False where that cannot be done.
  bool Make(const Splats& splats, vtkMTimeType splatTime, const Request& request);

  ///@{
  /// How much larger a group's splats are drawn than they are, and the most of all groups.
  double GetScale(int group) const;
  double GetLargestScale() const;
  ///@}
  int GetNumberOfGroups() const
  {
    return this->Starts.empty() ? 0 : static_cast<int>(this->Starts.size()) - 1;
  }
  /// The first splat of a group, and how many it has.
  std::pair<vtkIdType, vtkIdType> GetGroup(int group) const;
  const std::vector<Leaf>& GetLeaves(int group) const;
  /// The splats, group by group.
  const std::vector<uint32_t>& GetOrder() const { return this->Order; }
  vtkMTimeType GetMTime() const { return this->Time.GetMTime(); }

  /// Data of some words a splat, in the groups' order.
  std::vector<uint32_t> Ordered(const std::vector<uint32_t>& data, size_t words) const;

private:
  bool TakeGiven(const Splats& splats, bool covering, std::vector<int>& groups) const;
  bool Find(const Splats& splats, std::vector<int>& groups);
  void MakeLeaves(const Splats& splats);

  Request Asked;
  std::vector<double> Scales; // of groups that were enlarged
  std::vector<uint32_t> Order;
  std::vector<vtkIdType> Starts; // of groups in that order, and the end
  std::vector<std::vector<Leaf>> Leaves;
  vtkTimeStamp Time;
};

#endif
