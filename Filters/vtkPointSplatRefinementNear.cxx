// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Which fill points or sites lie near to a place: a table of cells of the sizes of what lies in them.
#include "vtkPointSplatRefinement.h"

#include "vtkMath.h"
#include "vtkPointSplatMortonCells.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN

// Those that are fitted by hand are from Testing/Accuracy/fit_constants.py.
namespace
{
/// How near to a fill point's place, in its size, another point stands for it.
constexpr double ShareOfSize = 0.4;
/// ... if its normal is within 37 degrees: it is not of another sheet.
constexpr float LikeNormal = 0.8f;
/// Where a cell's level lies in its key: bits of places that are far from one another.
constexpr int LevelShift = 60;
/// Of the places of a block of four cells a side.
constexpr int BlockBits = 6;
/// How wide the table of cells is at first, a power of two.
constexpr std::size_t LeastTable = 1024;
}

/// The place along the curve, and in its upper bits the level.
vtkPointSplatRefinement::Key vtkPointSplatRefinement::GetKey(const Cell& cell)
{
  return vtkPointSplatMortonCells::GetPlace(cell.Place.data()) ^ static_cast<Key>(cell.Level) << LevelShift;
}

/// Cells of a block are side by side in the table, as what is looked for one after the other is, and blocks anywhere: of a
/// plane alone the curve has but few places.
std::size_t vtkPointSplatRefinement::GetIndex(Key key) const
{
  const Key block = (key >> BlockBits) * 0x9e3779b97f4a7c15u;
  return ((block ^ block >> 32) << BlockBits | (key & ((Key(1) << BlockBits) - 1))) & (this->Table.size() - 1);
}

/// Cells of a level are twice as wide as its smallest sizes.
vtkPointSplatRefinement::Cell vtkPointSplatRefinement::FindCell(const double x[3], int level)
{
  Cell cell{ level, { { 0, 0, 0 } } };
  for (int c = 0; c < 3; ++c)
  {
    const double place = std::floor(std::ldexp(x[c], -level - 1));
    // Where coordinates are so large that floats hold no cells all are one.
    cell.Place[c] = std::abs(place) < 1e18 ? static_cast<std::int64_t>(place) : 0;
  }
  return cell;
}

void vtkPointSplatRefinement::Insert(Index index, const double x[3], float size)
{
  const int level = std::ilogb(size);
  for (const int near : { level - 1, level, level + 1 })
  {
    this->Entries.push_back({ GetKey(FindCell(x, near)), index, None });
    if (this->Entries.size() <= this->Table.size())
    {
      this->Enter(this->Entries.size() - 1);
      continue;
    }
    const std::size_t width = std::max<std::size_t>(LeastTable, 2 * this->Table.size());
    this->Table.assign(width, None);
    for (std::size_t entry = 0; entry < this->Entries.size(); ++entry)
    {
      this->Enter(entry);
    }
  }
}

/// Puts an entry before the others at its place of the table.
void vtkPointSplatRefinement::Enter(std::size_t entry)
{
  std::size_t& first = this->Table[this->GetIndex(this->Entries[entry].In)];
  this->Entries[entry].Next = first;
  first = entry;
}

/// Gives a point's position, and returns its normal.
const float* vtkPointSplatRefinement::GetPlace(Index index, double x[3]) const
{
  if (index >= FirstIndex)
  {
    const Point& point = this->Points[index - FirstIndex];
    std::copy_n(point.X, 3, x);
    return point.Normal;
  }
  const Site site = static_cast<Site>(index);
  this->Stars.GetPosition(site, x);
  return this->Normals + std::size_t(3) * site;
}

/// Whether a point is on the same side as another of an edge at which a mesh was split: ends of theirs in one place are two
/// there. And whether it shares an end with it: of a mesh what shares none may lie across a gap, of a cloud two sites may just
/// see triangles in different ways.
bool vtkPointSplatRefinement::IsOfOne(const Point& point, Index other) const
{
  const Site site = static_cast<Site>(other);
  const Point* fill = other >= FirstIndex ? &this->Points[other - FirstIndex] : nullptr;
  const Site* ends = fill ? fill->Ends : &site;
  const int count = fill ? fill->Count : 1;
  bool shared = !this->GetRoom;
  for (int k = 0; k < point.Count; ++k)
  {
    double x[3], y[3];
    this->Stars.GetPosition(point.Ends[k], x);
    for (int l = 0; l < count; ++l)
    {
      if (point.Ends[k] == ends[l])
      {
        shared = true;
        continue;
      }
      this->Stars.GetPosition(ends[l], y);
      if (std::equal(x, x + 3, y))
      {
        return false;
      }
    }
  }
  return shared;
}

bool vtkPointSplatRefinement::FindNear(const Point& point, Index& found) const
{
  const int level = std::ilogb(point.Size);
  double corner[3];
  for (int c = 0; c < 3; ++c)
  {
    corner[c] = point.X[c] - std::ldexp(1.0, level);
  }
  const Cell first = FindCell(corner, level);
  double least = std::pow(ShareOfSize * point.Size, 2);
  bool any = false;
  for (int k = 0; k < 8; ++k)
  {
    Cell cell = first;
    for (int c = 0; c < 3; ++c)
    {
      cell.Place[c] += (k >> c) & 1;
    }
    const Key key = GetKey(cell);
    for (std::size_t at = this->Table.empty() ? None : this->Table[this->GetIndex(key)]; at != None;
         at = this->Entries[at].Next)
    {
      const Entry& entry = this->Entries[at];
      if (entry.In != key)
      {
        continue;
      }
      double x[3];
      const float* normal = this->GetPlace(entry.Of, x);
      const double squared = vtkMath::Distance2BetweenPoints(point.X, x);
      // Of two that are as near it is the same one, whatever order they are found in.
      if ((squared < least || (any && squared == least && entry.Of < found)) &&
        vtkMath::Dot(point.Normal, normal) > LikeNormal && this->IsOfOne(point, entry.Of))
      {
        least = squared;
        found = entry.Of;
        any = true;
      }
    }
  }
  return any;
}

VTK_ABI_NAMESPACE_END
