// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatHierarchy
 * @brief   levels of ever fewer, larger splats that stand for points, and blocks of them
 *
 * What vtkPointSplatOctree and the mapper share: from points with normals and radii to a
 * multiresolution hierarchy of them (Pajarola, Sainz, Guidotti 2004, Confetti: Object-Space Point
 * Blending and Splatting, sections 3 and 4). It knows neither data sets nor OpenGL.
 *
 * 1. *Division.* As in the paper's point octree the points, not space, say where a cell is divided;
 *    but in halves of equal numbers, across the longest side of their bounding box, three halvings
 *    being an octree's one. So a surface's cells have nearly the same number of points, and splats
 *    that stand for them weigh the same in what is blended. Cells of more than 4096 points are
 *    divided at a sample's median. Where the points have parts, such as the blocks of a data set,
 *    each part is a cell at first: no splat stands for points of two, and the parts' points stay
 *    where they are among all.
 * 2. *Levels.* Cells of some 4 points make the splats of level 1, cells of some 16 those of level
 *    2, and so on: the cells' numbers grow by 4, as a surface is divided by an octree. A cell is no
 *    splat unless its points lie on one sheet: normals within a cone, no gap between them that the
 *    radii do not cover. What is not is divided between the sheets, or across the gap; cells with
 *    less points than the level below allows are splats anyway.
 * 3. *Splats.* Position, normal and the homogeneous covariance are sums over a cell's points,
 *    summed upward (section 4.2, equations 2 to 4), by areas: the squared radii. With them go
 *    sums of products of normals and positions, by which the normals' linear change over the cell,
 *    the second fundamental form, is fitted, and how far they deviate from that. The disk's centre
 *    is the apex of the paraboloid; its radius such that it covers the disks of the
 *    level below (section 4.3); or its axes, in the ratio of the covariance in the tangent plane.
 * 4. *Blocks.* From the coarsest level down, each block's part of the level below is divided in
 *    blocks of at most 160 splats, where cells end. So a block and those below it hold the same
 *    points, all levels have the points' order, and any cut through the tree of blocks shows each
 *    point once. A block has its bounding box, its largest radius, a cone about its normals, and the
 *    deviation of these.
 *
 * Cells are worked on in parallel; the result does not depend on the number of threads. Memory:
 * 24 bytes a point while it is made, some 30 a point for the levels, which are about a third of the
 * points in number, and 1 for the blocks.
 *
 * Bad input: points that Read() refuses take no part. Points that lie on no surface (noise, whose
 * cells are on no sheet) have no levels but their own: GetNumberOfLevels() is 1.
 */
#ifndef vtkPointSplatHierarchy_h
#define vtkPointSplatHierarchy_h

#include "vtkFiltersPointSplattingModule.h" // For export macro
#include "vtkMath.h"
#include "vtkPointSplattingABI.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class VTKFILTERSPOINTSPLATTING_EXPORT vtkPointSplatHierarchy
{
public:
  using Index = uint32_t;

  /**
   * What is read of a point; lengths in one unit, normals of unit length.
   */
  struct Point
  {
    float Position[3];
    float Normal[3];
    float Radius = 0.0f;
    float Curvature[6] = { 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f }; // as SplatCurvature has it
    bool HasCurvature = false;
  };

  /**
   * Where points come from; many threads read at once.
   */
  class VTKFILTERSPOINTSPLATTING_EXPORT Source
  {
  public:
    virtual ~Source();
    /// False: the point takes no part.
    virtual bool Read(Index id, Point& point) const = 0;
  };

  /**
   * A splat of a level above the points'.
   */
  struct Splat
  {
    float Position[3];
    float Radius; // of the longer axis
    float Normal[3];
    float Shorter; // the shorter axis, as a share of the longer one
    float Axis[3]; // the longer one, unit length
    float Curvature[6];
    float Variance;    // of the normals, about their linear change over the splat
    Index First;       // of those that it stands for, in the level below
    // How often the points were divided before it was parted from the one before; 0 between parts.
    unsigned char Cut;
  };

  /**
   * A run of splats of one level, and the blocks that hold those which they stand for.
   */
  struct Block
  {
    float Low[3];
    float High[3];  // of the bounding box of the centres
    float Radius;   // the largest
    float MeanRadius;
    float Cone[3];  // the axis of a cone that holds all normals, unit length
    float Angle;    // and the angle from it to the cone's side
    float Deviation; // rms, of normals from their linear change over the splats: how rough it is
    Index First;
    Index Count;
    Index FirstChild;
    Index ChildCount;
    int Level;
  };

  /// Splats of a block, at most.
  static constexpr Index MostInBlock = 160;

  /**
   * Makes levels and blocks of the points from 0 on; ends: behind each part's last one, in
   * ascending order. ellipses: splats have two axes, else one radius. progress gets the share that
   * is done, from 0 to 1, by the calling thread, and says whether to go on. False: it did not.
   */
  bool Make(const Source& source, const std::vector<Index>& ends, bool ellipses,
    const std::function<bool(double)>& progress);

  /// The points that take part, in the hierarchy's order: their ids.
  const std::vector<Index>& GetOrder() const { return this->Order; }
  /// With that of the points, which is 0.
  int GetNumberOfLevels() const { return static_cast<int>(this->Levels.size()) + 1; }
  /// Of a level above the points'.
  const std::vector<Splat>& GetSplats(int level) const
  {
    return this->Levels[static_cast<size_t>(level) - 1];
  }
  Index GetNumberOfSplats(int level) const
  {
    return static_cast<Index>(level == 0 ? this->Order.size() : this->GetSplats(level).size());
  }
  /// Behind the last one of those that a splat stands for.
  Index GetEnd(int level, Index splat) const
  {
    const std::vector<Splat>& splats = this->GetSplats(level);
    return splat + 1 < splats.size() ? splats[splat + 1].First
                                     : this->GetNumberOfSplats(level - 1);
  }
  /// Those of the coarsest level come first.
  const std::vector<Block>& GetBlocks() const { return this->Blocks; }
  Index GetNumberOfRoots() const { return this->Roots; }
  /**
   * Calls join(block, child) with the places of each block and each of its children among all, from
   * the finest level up: a block's own children come before it is one.
   */
  template <typename Join>
  static void JoinUpward(const std::vector<Block>& blocks, const Join& join)
  {
    // Children lie behind their parents.
    for (size_t b = blocks.size(); b-- > 0;)
    {
      for (Index child = 0; blocks[b].Level > 0 && child < blocks[b].ChildCount; ++child)
      {
        join(b, size_t(blocks[b].FirstChild) + child);
      }
    }
  }

  /**
   * Fits a block's box, radii and cone to its splats. read(i, point) sets position, normal and radius of the
   * block's i-th.
   */
  template <typename Read>
  static void Fit(Block& block, const Read& read)
  {
    std::fill_n(block.Low, 3, VTK_FLOAT_MAX);
    std::fill_n(block.High, 3, -VTK_FLOAT_MAX);
    block.Radius = 0.0f;
    double cone[3] = { 0.0, 0.0, 0.0 };
    double radii = 0.0;
    std::vector<float> normals;
    normals.reserve(3 * static_cast<size_t>(block.Count));
    for (Index i = 0; i < block.Count; ++i)
    {
      Point point;
      read(i, point);
      for (int k = 0; k < 3; ++k)
      {
        block.Low[k] = std::min(block.Low[k], point.Position[k]);
        block.High[k] = std::max(block.High[k], point.Position[k]);
        cone[k] += point.Normal[k];
        normals.push_back(point.Normal[k]);
      }
      block.Radius = std::max(block.Radius, point.Radius);
      radii += point.Radius;
    }
    block.MeanRadius = static_cast<float>(radii / std::max<Index>(block.Count, 1));
    vtkMath::Normalize(cone);
    double least = 1.0;
    for (size_t i = 0; i < normals.size(); i += 3)
    {
      least = std::min(
        least, cone[0] * normals[i] + cone[1] * normals[i + 1] + cone[2] * normals[i + 2]);
    }
    std::copy_n(cone, 3, block.Cone);
    block.Angle = static_cast<float>(std::acos(std::max(least, -1.0)));
  }

private:
  struct Item;
  class Builder;
  bool MakeBlocks(const Source& source, const std::function<bool(double)>& progress);
  void AddBlocks(int level, Index begin, Index end);
  void Summarise(const Source& source, Block& block) const;

  std::vector<Index> Order;
  std::vector<std::vector<Splat>> Levels;
  std::vector<Block> Blocks;
  Index Roots = 0;
};

VTK_ABI_NAMESPACE_END
#endif
