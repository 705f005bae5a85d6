// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatNeighbors.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
using Key = vtkPointSplatNeighbors::Key;

/// Neighbours are looked for first where so many times as many are as are wanted, if the surface about is as dense
/// as in the leaf. Fewer would be too few for many points, which are searched for again; more take longer to go
/// through. From 1.4 to 1.8 the time is the same within noise (Testing/Benchmark/estimation.py).
constexpr double FoundPerWanted = 1.6;

Key MakeKey(float distance, std::uint32_t order)
{
  std::uint32_t bits;
  std::memcpy(&bits, &distance, sizeof(bits));
  const std::uint64_t both = std::uint64_t(bits) << 32 | order;
  Key key;
  std::memcpy(&key, &both, sizeof(key));
  return key;
}

std::uint64_t GetBits(Key key)
{
  std::uint64_t bits;
  std::memcpy(&bits, &key, sizeof(bits));
  return bits;
}

float GetDistance(Key key)
{
  const std::uint32_t bits = static_cast<std::uint32_t>(GetBits(key) >> 32);
  float distance;
  std::memcpy(&distance, &bits, sizeof(distance));
  return distance;
}

std::uint32_t GetOrder(Key key)
{
  return static_cast<std::uint32_t>(GetBits(key));
}

/// Of a neighbour that there is not, farther off than any.
Key NoKey()
{
  return MakeKey(std::numeric_limits<float>::infinity(), vtkPointSplatNeighbors::None);
}

/// Puts a key among k ascending ones, of which the last goes. Where it belongs is not to be foreseen: no branch
/// asks for it.
void Insert(Key key, int k, Key* keys)
{
  for (int at = k - 1; at > 0; --at)
  {
    const Key nearer = keys[at] < key ? keys[at] : key;
    keys[at] = keys[at - 1] > nearer ? keys[at - 1] : nearer;
  }
  keys[0] = keys[0] < key ? keys[0] : key;
}
}

void vtkPointSplatNeighbors::GetBox(std::uint32_t leaf, double bounds[6]) const
{
  for (int c = 0; c < 6; ++c)
  {
    bounds[c] = this->Leaves[leaf].Origin[c % 3] + this->Leaves[leaf].Bounds[c];
  }
}

double vtkPointSplatNeighbors::GetDiagonal(Slot leaf, int& count) const
{
  count = this->Leaves[leaf].Count;
  const float* b = this->Leaves[leaf].Bounds;
  const double d[3] = { double(b[3]) - b[0], double(b[4]) - b[1], double(b[5]) - b[2] };
  return std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
}

void vtkPointSplatNeighbors::GetPosition(Slot slot, double x[3]) const
{
  const Leaf& leaf = this->Leaves[slot / LeafSize];
  x[0] = leaf.Origin[0] + leaf.X[slot % LeafSize];
  x[1] = leaf.Origin[1] + leaf.Y[slot % LeafSize];
  x[2] = leaf.Origin[2] + leaf.Z[slot % LeafSize];
}

void vtkPointSplatNeighbors::Scan(const Leaf& from, std::uint32_t other, unsigned int lanes, int k,
  bool self, bool spread, Scratch& scratch) const
{
  const Leaf& leaf = this->Leaves[other];
  const float sx = static_cast<float>(leaf.Origin[0] - from.Origin[0]);
  const float sy = static_cast<float>(leaf.Origin[1] - from.Origin[1]);
  const float sz = static_cast<float>(leaf.Origin[2] - from.Origin[2]);
  const std::uint32_t first = static_cast<std::uint32_t>(scratch.Scanned.size()) * LeafSize;
  scratch.Scanned.push_back(other);
  for (int lane = 0; lane < from.Count; ++lane)
  {
    if (!(lanes >> lane & 1u))
    {
      continue;
    }
    const float x = from.X[lane] - sx, y = from.Y[lane] - sy, z = from.Z[lane] - sz;
    Key* keys = scratch.Keys.data() + lane * k;
    const float worst = GetDistance(keys[k - 1]);
    const float bx = std::max({ leaf.Bounds[0] - x, x - leaf.Bounds[3], 0.0f });
    const float by = std::max({ leaf.Bounds[1] - y, y - leaf.Bounds[4], 0.0f });
    const float bz = std::max({ leaf.Bounds[2] - z, z - leaf.Bounds[5], 0.0f });
    if (!(bx * bx + by * by + bz * bz < worst))
    {
      continue;
    }
    float squared[LeafSize];
    for (int i = 0; i < LeafSize; ++i)
    {
      const float dx = leaf.X[i] - x, dy = leaf.Y[i] - y, dz = leaf.Z[i] - z;
      squared[i] = dx * dx + dy * dy + dz * dz;
    }
    if (self)
    {
      squared[lane] = 0;
    }
    // Distinct points whose distance underflows are as good as the same point, as which this one is counted, too.
    int near[LeafSize];
    int count = 0;
    for (int i = 0; i < LeafSize; ++i)
    {
      near[count] = i;
      count += squared[i] < worst && squared[i] > 0 ? 1 : 0;
    }
    if (spread && count > 1)
    {
      near[0] = *std::min_element(
        near, near + count, [&](int a, int b) { return squared[a] < squared[b]; });
      count = 1;
    }
    for (int c = 0; c < count; ++c)
    {
      Insert(MakeKey(squared[near[c]], first + near[c]), k, keys);
    }
  }
}

/// The leaves next to a leaf in the tree's order: some, and as many as have enough points, which may be more where
/// points share their places.
void vtkPointSplatNeighbors::SetAround(std::uint32_t leafId, int k, bool spread, Scratch& scratch) const
{
  const std::uint32_t leaves = static_cast<std::uint32_t>(this->Leaves.size());
  const std::uint32_t least = spread ? k : 1 + k / 16;
  std::uint32_t first = leafId, last = leafId;
  int points = this->Leaves[leafId].Count - 1;
  for (std::uint32_t step = 0; step < leaves && (step < least || points < k); ++step)
  {
    points += first > 0 ? this->Leaves[--first].Count : 0;
    points += last + 1 < leaves ? this->Leaves[++last].Count : 0;
  }
  scratch.First = first;
  scratch.Last = last;
}

/// Scans a leaf itself, those around it, and all others that then may have points nearer to those of the lanes than these'
/// last neighbours.
void vtkPointSplatNeighbors::ScanLeaves(
  std::uint32_t leafId, unsigned int lanes, int k, bool spread, Scratch& scratch) const
{
  const Leaf& leaf = this->Leaves[leafId];
  this->Scan(leaf, leafId, lanes, k, true, spread, scratch);
  for (std::uint32_t other = scratch.First; other <= scratch.Last; ++other)
  {
    if (other != leafId)
    {
      this->Scan(leaf, other, lanes, k, false, spread, scratch);
    }
  }
  float worst = 0;
  double bounds[6];
  for (int c = 0; c < 6; ++c)
  {
    bounds[c] = c < 3 ? std::numeric_limits<double>::max() : std::numeric_limits<double>::lowest();
  }
  for (int lane = 0; lane < leaf.Count; ++lane)
  {
    if (lanes >> lane & 1u)
    {
      worst = std::max(worst, GetDistance(scratch.Keys[lane * k + k - 1]));
      const float local[3] = { leaf.X[lane], leaf.Y[lane], leaf.Z[lane] };
      for (int c = 0; c < 3; ++c)
      {
        bounds[c] = std::min(bounds[c], leaf.Origin[c] + local[c]);
        bounds[c + 3] = std::max(bounds[c + 3], leaf.Origin[c] + local[c]);
      }
    }
  }

  scratch.Leaves.clear();
  const std::uint32_t numberOfNodes = static_cast<std::uint32_t>(this->Nodes.size());
  for (std::uint32_t n = 0; n < numberOfNodes;)
  {
    const Node& node = this->Nodes[n];
    if (!(GetSquaredDistance(bounds, node.Bounds) <= worst))
    {
      n = node.Skip;
      continue;
    }
    if (node.Leaf != None && (node.Leaf < scratch.First || node.Leaf > scratch.Last))
    {
      scratch.Leaves.push_back(node.Leaf);
    }
    ++n;
  }
  for (std::uint32_t other : scratch.Leaves)
  {
    this->Scan(leaf, other, lanes, k, false, spread, scratch);
  }
}

/// Looks for the lanes' neighbours within a radius; returns the lanes that have fewer than k there.
unsigned int vtkPointSplatNeighbors::SearchWithin(
  double squared, std::uint32_t leafId, unsigned int lanes, int k, Scratch& scratch) const
{
  if (!(squared > 0 && squared < std::numeric_limits<float>::max()))
  {
    return lanes;
  }
  const Key last = MakeKey(static_cast<float>(squared), None);
  std::fill(scratch.Keys.begin(), scratch.Keys.end(), last);
  this->ScanLeaves(leafId, lanes, k, false, scratch);
  for (int lane = 0; lane < LeafSize; ++lane)
  {
    lanes &= scratch.Keys[lane * k + k - 1] == last ? AllLanes : ~(1u << lane);
  }
  return lanes;
}

void vtkPointSplatNeighbors::SearchLeaf(
  std::uint32_t leafId, unsigned int lanes, int k, bool spread, Scratch& scratch) const
{
  scratch.Keys.assign(static_cast<std::size_t>(k) * LeafSize, NoKey());
  scratch.Scanned.clear();
  this->SetAround(leafId, k, spread, scratch);
  if (!spread)
  {
    int count;
    const double diagonal = this->GetDiagonal(leafId, count);
    // A leaf is about a square of the surface: half of the squared diagonal is its area.
    const double area = 0.5 * diagonal * diagonal * k / count;
    lanes =
      this->SearchWithin(FoundPerWanted * area / vtkMath::Pi(), leafId, lanes, k, scratch);
  }
  if (lanes)
  {
    for (int lane = 0; lane < LeafSize; ++lane)
    {
      if (lanes >> lane & 1u)
      {
        std::fill_n(scratch.Keys.begin() + static_cast<std::ptrdiff_t>(lane) * k, k, NoKey());
      }
    }
    this->ScanLeaves(leafId, lanes, k, spread, scratch);
  }
  for (Key& key : scratch.Keys)
  {
    const std::uint32_t order = GetOrder(key);
    if (order != None)
    {
      key = MakeKey(
        GetDistance(key), scratch.Scanned[order / LeafSize] * LeafSize + order % LeafSize);
    }
  }
}

void vtkPointSplatNeighbors::Keep(Scratch& scratch)
{
  scratch.Nearest = scratch.Keys;
}

int vtkPointSplatNeighbors::Merge(int k, Scratch& scratch)
{
  const int nearest = std::min(k, NumberOfSpreadNeighbors);
  const int count = nearest + NumberOfSpreadNeighbors;
  std::vector<Key> merged(static_cast<std::size_t>(count) * LeafSize, NoKey());
  for (int lane = 0; lane < LeafSize; ++lane)
  {
    const auto begin = merged.begin() + static_cast<std::ptrdiff_t>(lane) * count;
    std::copy_n(scratch.Nearest.begin() + static_cast<std::ptrdiff_t>(lane) * k, nearest, begin);
    std::copy_n(scratch.Keys.begin() + static_cast<std::ptrdiff_t>(lane) * NumberOfSpreadNeighbors,
      NumberOfSpreadNeighbors, begin + nearest);
    std::sort(begin, begin + count);
    std::fill(std::unique(begin, begin + count), begin + count, NoKey());
  }
  scratch.Keys.swap(merged);
  return count;
}

vtkPointSplatNeighbors::Neighborhood vtkPointSplatNeighbors::Describe(
  std::uint32_t leafId, int lane, int k, Scratch& scratch) const
{
  scratch.X.resize(k);
  scratch.Y.resize(k);
  scratch.Z.resize(k);
  scratch.Distances.resize(k);
  scratch.Slots.resize(k);
  const Leaf& leaf = this->Leaves[leafId];
  const Key* keys = scratch.Keys.data() + lane * k;
  int count = 0;
  for (; count < k && GetDistance(keys[count]) < std::numeric_limits<float>::infinity(); ++count)
  {
    const Slot slot = GetOrder(keys[count]);
    const Leaf& other = this->Leaves[slot / LeafSize];
    const Slot i = slot % LeafSize;
    scratch.Distances[count] = GetDistance(keys[count]);
    scratch.Slots[count] = slot;
    scratch.X[count] = other.X[i] - (leaf.X[lane] - float(other.Origin[0] - leaf.Origin[0]));
    scratch.Y[count] = other.Y[i] - (leaf.Y[lane] - float(other.Origin[1] - leaf.Origin[1]));
    scratch.Z[count] = other.Z[i] - (leaf.Z[lane] - float(other.Origin[2] - leaf.Origin[2]));
  }
  return { leafId * LeafSize + lane, count, scratch.Slots.data(), scratch.X.data(),
    scratch.Y.data(), scratch.Z.data(), scratch.Distances.data() };
}

VTK_ABI_NAMESPACE_END
