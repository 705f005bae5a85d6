// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatOctreeCut.h"

#include "vtkPointSplatArrays.h"
#include "vtkPointSplatOctreeView.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace
{
using namespace vtkPointSplatHDF5;

/// The numbers of a group's arrays, by their names; an array that cannot be read has none.
std::map<std::string, std::vector<double>> NumbersOf(hid_t group)
{
  std::map<std::string, std::vector<double>> all;
  const std::vector<ArrayHead> heads = ReadHeads(group);
  for (size_t a = 0; a < heads.size(); ++a)
  {
    const auto array = ReadArray(group, static_cast<int>(a), heads[a]);
    if (auto* data = vtkDataArray::SafeDownCast(array))
    {
      std::vector<double>& numbers = all[heads[a].Name];
      numbers.resize(static_cast<size_t>(data->GetNumberOfValues()));
      for (vtkIdType i = 0; i < data->GetNumberOfTuples() && data->GetNumberOfComponents() > 0; ++i)
      {
        data->GetTuple(i, &numbers[static_cast<size_t>(i * data->GetNumberOfComponents())]);
      }
    }
  }
  return all;
}

/// Of whole numbers that HDF5 holds.
bool IsWithin(double number, double least, double most)
{
  return number >= least && number <= most; // NaN is not
}

bool Meets(const vtkBoundingBox& wanted, const vtkBoundingBox& box)
{
  return !wanted.IsValid() || wanted.Intersects(box) != 0;
}
}

//------------------------------------------------------------------------------
bool vtkPointSplatOctreeCut::AddPiece(hid_t file, int number)
{
  const Handle piece = OpenGroup(file, "Piece" + std::to_string(number));
  std::vector<long long> points(1);
  std::vector<long long> levels(1);
  std::vector<double> bounds(6);
  if (!piece || !ReadNumbers(piece, "Points", points) || !ReadNumbers(piece, "Levels", levels) ||
    !ReadNumbers(piece, "Bounds", bounds) || levels[0] < 1 || levels[0] > 64)
  {
    return false;
  }
  std::vector<vtkIdType> sizes;
  for (int level = 0; level < levels[0]; ++level)
  {
    Level own;
    own.Group = OpenGroup(piece, "Level" + std::to_string(level));
    own.Heads = ReadHeads(own.Group);
    if (own.Heads.empty() || own.Heads[0].Components != 3)
    {
      return false;
    }
    sizes.push_back(own.Heads[0].Tuples);
    this->Levels[{ number, level }] = std::move(own);
  }
  if (sizes[0] != points[0])
  {
    return false;
  }
  if (levels[0] > 1)
  {
    return this->AddBlocks(piece, number, sizes);
  }
  this->Roots.push_back(this->Blocks.size());
  this->Blocks.push_back(
    { number, 0, { 0, sizes[0] }, 0, 0, vtkBoundingBox(bounds.data()), 0.0f });
  return true;
}

//------------------------------------------------------------------------------
bool vtkPointSplatOctreeCut::AddBlocks(
  hid_t piece, int number, const std::vector<vtkIdType>& sizes)
{
  const Handle group = OpenGroup(piece, "Blocks");
  if (!group)
  {
    return false;
  }
  std::map<std::string, std::vector<double>> numbers = NumbersOf(group);
  const std::vector<double>& ranges = numbers[vtkPointSplatArrays::BlockRange];
  const std::vector<double>& children = numbers[vtkPointSplatArrays::BlockChildren];
  const std::vector<double>& boxes = numbers[vtkPointSplatArrays::BlockBounds];
  const std::vector<double>& radii = numbers[vtkPointSplatArrays::BlockSize];
  const std::vector<double>& origin = numbers[vtkPointSplatArrays::BlockOrigin];
  const size_t count = ranges.size() / 3;
  if (count == 0 || children.size() != 2 * count || boxes.size() != 6 * count ||
    radii.size() != 3 * count || origin.size() != 3)
  {
    return false;
  }
  const size_t first = this->Blocks.size();
  size_t roots = count;
  for (size_t i = 0; i < count; ++i)
  {
    const double* range = &ranges[3 * i];
    const double* child = &children[2 * i];
    const bool inner = child[1] > 0.0;
    // Children come after their parents, so that no way down is a circle.
    if (!IsWithin(range[0], 0.0, sizes.size() - 1.0) ||
      !IsWithin(range[1], 0.0, static_cast<double>(sizes[static_cast<size_t>(range[0])])) ||
      !IsWithin(range[2], 0.0, static_cast<double>(sizes[static_cast<size_t>(range[0])]) - range[1]) ||
      (inner &&
        (!IsWithin(child[0], i + 1.0, count - 1.0) || !IsWithin(child[1], 1.0, count - child[0]))))
    {
      return false;
    }
    Block block{ number, static_cast<int>(range[0]),
      { static_cast<vtkIdType>(range[1]), static_cast<vtkIdType>(range[2]) }, 0, 0,
      vtkBoundingBox(),
      // A size that is none is in no order with others.
      std::isnan(radii[3 * i]) ? std::numeric_limits<float>::infinity()
                               : static_cast<float>(radii[3 * i]) };
    if (inner)
    {
      block.FirstChild = first + static_cast<size_t>(child[0]);
      block.ChildCount = static_cast<size_t>(child[1]);
      roots = std::min(roots, static_cast<size_t>(child[0]));
    }
    const double* box = &boxes[6 * i];
    const double reach = std::isfinite(block.Radius) ? block.Radius : 0.0;
    for (int end = 0; end < 2; ++end)
    {
      const double off = end ? reach : -reach;
      block.Box.AddPoint(
        origin[0] + box[end] + off, origin[1] + box[2 + end] + off, origin[2] + box[4 + end] + off);
    }
    this->Blocks.push_back(block);
  }
  for (size_t i = 0; i < roots; ++i)
  {
    this->Roots.push_back(first + i);
  }
  return true;
}

//------------------------------------------------------------------------------
vtkIdType vtkPointSplatOctreeCut::ChildrenOf(
  const Block& block, const vtkBoundingBox& box, std::vector<size_t>& children) const
{
  vtkIdType splats = 0;
  children.clear();
  for (size_t c = block.FirstChild; c < block.FirstChild + block.ChildCount; ++c)
  {
    if (Meets(box, this->Blocks[c].Box))
    {
      splats += this->Blocks[c].Splats.Count;
      children.push_back(c);
    }
  }
  return splats;
}

//------------------------------------------------------------------------------
double vtkPointSplatOctreeCut::SizeOf(const Block& block, const Wish& wish)
{
  if (!wish.View)
  {
    return block.Radius;
  }
  return wish.View->IsOutside(block.Box) ? 0.0 : wish.View->PixelsOf(block.Box, block.Radius);
}

//------------------------------------------------------------------------------
vtkPointSplatOctreeCut::Runs vtkPointSplatOctreeCut::Make(const Wish& wish) const
{
  struct Candidate
  {
    double Size;
    float Radius; // decides where the eye is in several blocks
    size_t Place;
    bool operator<(const Candidate& other) const
    {
      return this->Size != other.Size ? this->Size < other.Size
        : this->Radius != other.Radius ? this->Radius < other.Radius
                                       : this->Place > other.Place;
    }
  };
  std::priority_queue<Candidate> open;
  vtkIdType splats = 0;
  const auto add = [&](size_t place) {
    const Block& block = this->Blocks[place];
    open.push({ SizeOf(block, wish), block.Radius, place });
    splats += block.Splats.Count;
  };
  for (size_t root : this->Roots)
  {
    if (Meets(wish.Box, this->Blocks[root].Box))
    {
      add(root);
    }
  }
  Runs runs;
  std::vector<size_t> children;
  while (!open.empty())
  {
    const Candidate candidate = open.top();
    open.pop();
    const Block& block = this->Blocks[candidate.Place];
    const bool large = !wish.View || candidate.Size > wish.Pixels;
    const vtkIdType below = this->ChildrenOf(block, wish.Box, children);
    if (large && block.ChildCount > 0 &&
      (wish.Room == 0 || splats - block.Splats.Count + below <= wish.Room))
    {
      splats -= block.Splats.Count;
      for (size_t child : children)
      {
        add(child);
      }
      continue;
    }
    runs[{ block.Piece, block.Level }].push_back(block.Splats);
  }
  for (auto& one : runs)
  {
    std::vector<Run>& own = one.second;
    std::sort(own.begin(), own.end(), [](const Run& a, const Run& b) { return a.First < b.First; });
    size_t last = 0;
    for (size_t i = 1; i < own.size(); ++i)
    {
      if (own[last].First + own[last].Count == own[i].First)
      {
        own[last].Count += own[i].Count;
      }
      else
      {
        own[++last] = own[i];
      }
    }
    own.resize(std::min(own.size(), last + 1));
  }
  return runs;
}

//------------------------------------------------------------------------------
vtkIdType vtkPointSplatOctreeCut::CountOf(const std::vector<Run>& runs)
{
  vtkIdType count = 0;
  for (const Run& run : runs)
  {
    count += run.Count;
  }
  return count;
}

//------------------------------------------------------------------------------
vtkIdType vtkPointSplatOctreeCut::CountOf(const Runs& runs)
{
  vtkIdType count = 0;
  for (const auto& one : runs)
  {
    count += vtkPointSplatOctreeCut::CountOf(one.second);
  }
  return count;
}

//------------------------------------------------------------------------------
vtkIdType vtkPointSplatOctreeCut::CountOfCommon(const Runs& one, const Runs& other)
{
  vtkIdType count = 0;
  for (const auto& own : one)
  {
    const auto theirs = other.find(own.first);
    if (theirs == other.end())
    {
      continue;
    }
    auto second = theirs->second.begin();
    for (const Run& first : own.second)
    {
      while (second != theirs->second.end() && second->First + second->Count <= first.First)
      {
        ++second;
      }
      for (auto at = second;
           at != theirs->second.end() && at->First < first.First + first.Count; ++at)
      {
        count += std::min(first.First + first.Count, at->First + at->Count) -
          std::max(first.First, at->First);
      }
    }
  }
  return count;
}
