// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The levels of a cloud: splats that stand for those below them (vtkPointSplatHierarchy.h), in the
// cloud's own form and behind its splats in the same buffers.
//
// 1. A thread makes the hierarchy from the packed splats, while these are drawn.
// 2. When it is there, the cloud's splats are put into its order, and those of all levels appended:
//    level 1, level 2, ... Their ids are those of one of the points that they stand for, and
//    their clip lines follow from these' (vtkPointSplatLevelLines.h). None stands for
//    points of two parts of the cloud, and each part's splats stay where they were among all.
//    What stands for one splat, such as a scan's outlier, is that one.
// 3. What splats have beside their shape, colours, values and factors of lights, is appended as
//    means over those below.
// 4. Blocks name runs of splats in the buffers: Block::First counts from the buffers' beginning. Those
//    where the surface ends are taken to be rough (vtkPointSplatRims.h).
#ifndef vtkPointSplatLevels_h
#define vtkPointSplatLevels_h

#include "vtkPointSplatHierarchy.h"
#include "vtkPointSplatSeams.h"

#include <atomic>
#include <cstdint>
#include <future>
#include <memory>
#include <vector>

class vtkPointSplatLevels
{
public:
  using Block = vtkPointSplatHierarchy::Block;

  vtkPointSplatLevels() = default;
  ~vtkPointSplatLevels();
  vtkPointSplatLevels(const vtkPointSplatLevels&) = delete;
  void operator=(const vtkPointSplatLevels&) = delete;

  /// Ends what is under way, and forgets the levels. Splats may change only after that.
  void Clear();
  /// Says, from any thread, that what is under way is not wanted any more.
  void Abort() { this->Stop = true; }
  /**
   * Begins to make levels of these splats, of some words each. ends: behind the last one of each
   * part, in ascending order. radius: of those that have none.
   */
  void Begin(const std::vector<uint32_t>& splats, size_t words, std::vector<uint32_t> ends,
    float radius);
  bool IsUnderWay() const { return this->Work.valid(); }
  /// Whether what was begun has come to an end.
  bool IsReady() const;
  /**
   * Takes the levels that are ready: orders splats and their clip lines, of four words, and appends
   * the levels' to both. Returns that order, by the splats' numbers before. Empty: there are no levels, and nothing is
   * changed.
   */
  std::vector<uint32_t> Take(std::vector<uint32_t>& splats, std::vector<uint32_t>& lines, size_t words);

  /// Brings a block to where its splats, in the order that these were taken in, were moved. radius: of those that have none.
  void Refit(size_t block, const std::vector<uint32_t>& splats, size_t words, float radius);
  /// Of a splat of any level above the points: the first of those in the level below, in the buffers.
  uint32_t GetFirst(size_t splat) const { return this->Firsts[splat - this->Points]; }

  bool AreMade() const { return !this->Blocks.empty(); }
  /// Those of the coarsest level come first.
  const std::vector<Block>& GetBlocks() const { return this->Blocks; }
  size_t GetNumberOfRoots() const { return this->Roots; }
  /// Splats of all levels above the first.
  size_t GetNumberOfSplats() const { return this->Firsts.size(); }

  /**
   * How much what a word a splat holds differs between the splats that one stands for and their
   * mean: rms over each block's splats, bytes and values as from 0 to 1; and where blocks of the
   * input meet, how much these differ (vtkPointSplatSeams.h). Null without data.
   */
  using Deviations = std::shared_ptr<const std::vector<float>>;
  Deviations MeasureDeviations(const std::vector<uint32_t>& data, bool values) const;

  ///@{
  /// Appends what the levels' splats have, where data has a word a splat: means of four bytes, means
  /// of values (vtkPointSplatCloud.h), or what the first of those below has.
  void AppendBytes(std::vector<uint32_t>& data) const;
  void AppendValues(std::vector<uint32_t>& data) const;
  void AppendFirst(std::vector<uint32_t>& data) const;
  ///@}

private:
  uint32_t GetEnd(int level, uint32_t splat) const;
  template <typename Mean>
  void Append(std::vector<uint32_t>& data, const Mean& mean) const;
  void AppendSplats(std::vector<uint32_t>& splats, std::vector<uint32_t>& lines, size_t words);

  std::future<bool> Work;
  std::atomic<bool> Stop{ false };
  vtkPointSplatHierarchy Hierarchy;
  vtkPointSplatSeams Seams;
  std::vector<bool> Rims; // of each block
  std::vector<Block> Blocks;
  size_t Roots = 0;
  size_t Points = 0;
  std::vector<uint32_t> Starts; // of each level in the buffers, and the end
  std::vector<uint32_t> Firsts; // of each splat above the points: the first one below, in the buffers
};

#endif
