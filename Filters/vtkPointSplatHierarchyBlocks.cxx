// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Of the hierarchy: its blocks.
#include "vtkPointSplatHierarchy.h"

#include "vtkPointSplatThreads.h"

#include <algorithm>
#include <cmath>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
using Index = vtkPointSplatHierarchy::Index;

/// Where a run may be parted: before some of its splats.
struct Edges
{
  const vtkPointSplatHierarchy& From;
  int Level;

  // Of points, at those of the first level's splats.
  Index At(Index edge) const
  {
    return this->Level > 0 ? edge
      : edge < this->From.GetNumberOfSplats(1) ? this->From.GetSplats(1)[edge].First
                                               : this->From.GetNumberOfSplats(0);
  }
  int Cut(Index edge) const
  {
    return this->From.GetSplats(std::max(this->Level, 1))[edge].Cut;
  }
};

/// Parts the run between two edges until blocks are small enough; found gets where each begins.
void Part(const Edges& edges, Index begin, Index end, std::vector<Index>& found)
{
  const Index count = edges.At(end) - edges.At(begin);
  if (count <= vtkPointSplatHierarchy::MostInBlock || end - begin < 2)
  {
    found.push_back(begin);
    return;
  }
  // In the middle half, where the largest cells meet, and of such in the middle.
  const double middle = 0.5 * (double(edges.At(begin)) + edges.At(end));
  Index best = begin + (end - begin) / 2;
  int least = std::numeric_limits<int>::max();
  double nearest = 0.0;
  for (Index edge = begin + 1; edge < end; ++edge)
  {
    const double off = std::abs(edges.At(edge) - middle);
    const int cut = edges.Cut(edge);
    if (off <= 0.25 * count && (cut < least || (cut == least && off < nearest)))
    {
      best = edge;
      least = cut;
      nearest = off;
    }
  }
  Part(edges, begin, best, found);
  Part(edges, best, end, found);
}
}

//------------------------------------------------------------------------------
void vtkPointSplatHierarchy::AddBlocks(int level, Index begin, Index end)
{
  const Edges edges{ *this, level };
  std::vector<Index> found;
  Part(edges, begin, end, found);
  found.push_back(end);
  for (size_t i = 0; i + 1 < found.size(); ++i)
  {
    Block block{};
    block.Level = level;
    block.First = edges.At(found[i]);
    block.Count = edges.At(found[i + 1]) - block.First;
    this->Blocks.push_back(block);
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatHierarchy::Summarise(const Source& source, Block& block) const
{
  double variance = 0.0;
  vtkPointSplatHierarchy::Fit(block, [&](Index i, Point& point) {
    if (block.Level == 0)
    {
      source.Read(this->Order[block.First + i], point);
      return;
    }
    const Splat& splat = this->GetSplats(block.Level)[block.First + i];
    std::copy_n(splat.Position, 3, point.Position);
    std::copy_n(splat.Normal, 3, point.Normal);
    point.Radius = splat.Radius;
    variance += splat.Variance;
  });
  block.Deviation = static_cast<float>(std::sqrt(variance / std::max<Index>(block.Count, 1)));
}

//------------------------------------------------------------------------------
bool vtkPointSplatHierarchy::MakeBlocks(
  const Source& source, const std::function<bool(double)>& progress)
{
  const int top = this->GetNumberOfLevels() - 1;
  if (!progress(0.9))
  {
    return false;
  }
  if (top > 0)
  {
    this->AddBlocks(top, 0, this->GetNumberOfSplats(top));
  }
  else
  {
    // Nothing says where cells end.
    for (Index first = 0; first < this->GetNumberOfSplats(0); first += MostInBlock)
    {
      Block block{};
      block.First = first;
      block.Count = std::min(MostInBlock, this->GetNumberOfSplats(0) - first);
      this->Blocks.push_back(block);
    }
  }
  this->Roots = static_cast<Index>(this->Blocks.size());
  for (size_t i = 0; i < this->Blocks.size(); ++i)
  {
    // By value: to add blocks moves them.
    const Block block = this->Blocks[i];
    const Index children = static_cast<Index>(this->Blocks.size());
    if (block.Level > 1)
    {
      this->AddBlocks(block.Level - 1, this->GetSplats(block.Level)[block.First].First,
        this->GetEnd(block.Level, block.First + block.Count - 1));
    }
    else if (block.Level == 1)
    {
      // Points are parted where the first level's splats begin.
      this->AddBlocks(0, block.First, block.First + block.Count);
    }
    this->Blocks[i].FirstChild = children;
    this->Blocks[i].ChildCount = static_cast<Index>(this->Blocks.size()) - children;
  }
  vtkPointSplatThreads::For(
    0, static_cast<vtkIdType>(this->Blocks.size()), 64, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType i = begin; i < end; ++i)
      {
        this->Summarise(source, this->Blocks[static_cast<size_t>(i)]);
      }
    });
  return progress(1.0);
}

VTK_ABI_NAMESPACE_END
