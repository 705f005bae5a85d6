// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatOverlap.h"

#include "vtkPointSplatMortonCells.h"
#include "vtkPointSplatThreads.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
using Index = vtkPointSplatOverlap::Index;

constexpr Index Chunk = 2048;

/**
 * The splats whose radii have the same binary exponent, sorted into cells.
 */
struct Level
{
  double Width = 0; // of a cell
  std::vector<Index> Splats;
  std::vector<std::uint64_t> Keys; // of their cells, ascending
  std::vector<Index> Table;        // hash table of the first splat of each cell
  std::uint64_t Mask = 0;

  static constexpr Index None = std::numeric_limits<Index>::max();

  std::uint64_t Hash(std::uint64_t key) const
  {
    key *= 0x9e3779b97f4a7c15ull;
    return (key >> 32) & this->Mask;
  }

  void Sort(const double* positions, const double origin[3])
  {
    std::vector<std::pair<std::uint64_t, Index>> entries(this->Splats.size());
    vtkPointSplatThreads::For(
      0, static_cast<vtkIdType>(entries.size()), [&](vtkIdType begin, vtkIdType end) {
        for (vtkIdType e = begin; e < end; ++e)
        {
          std::int64_t cell[3];
          this->FindCell(positions + 3 * std::size_t(this->Splats[e]), origin, cell);
          entries[e] = { vtkPointSplatMortonCells::GetPlace(cell), this->Splats[e] };
        }
      });
    vtkSMPTools::Sort(entries.begin(), entries.end());
    this->Keys.resize(entries.size());
    std::uint64_t size = 16;
    while (size < 2 * entries.size())
    {
      size *= 2;
    }
    this->Mask = size - 1;
    this->Table.assign(size, None);
    for (std::size_t e = 0; e < entries.size(); ++e)
    {
      this->Keys[e] = entries[e].first;
      this->Splats[e] = entries[e].second;
      if (e == 0 || entries[e].first != entries[e - 1].first)
      {
        std::uint64_t at = this->Hash(entries[e].first);
        while (this->Table[at] != None)
        {
          at = (at + 1) & this->Mask;
        }
        this->Table[at] = static_cast<Index>(e);
      }
    }
  }

  void FindCell(const double* p, const double origin[3], std::int64_t cell[3]) const
  {
    for (int k = 0; k < 3; ++k)
    {
      // A cloud wider than 2^62 cells: any cell will do, see vtkPointSplatMortonCells.h.
      cell[k] = static_cast<std::int64_t>(
        std::min(std::floor((p[k] - origin[k]) / this->Width), 4.6e18));
    }
  }

  /// The first splat of a cell, in the sorted order; None if it is empty.
  Index Find(std::uint64_t key) const
  {
    std::uint64_t at = this->Hash(key);
    while (this->Table[at] != None && this->Keys[this->Table[at]] != key)
    {
      at = (at + 1) & this->Mask;
    }
    return this->Table[at];
  }
};

/// Calls found(e) for the sorted splats of a level in the cells around a place, if forward
/// only in those that come after the cell of the place in a scan, the place's own not among them.
template <typename Found>
void Around(const Level& level, const double* p, const double origin[3], bool forward,
  const Found& found)
{
  std::int64_t cell[3];
  level.FindCell(p, origin, cell);
  std::uint64_t spread[3][3];
  for (int k = 0; k < 3; ++k)
  {
    for (int d = 0; d < 3; ++d)
    {
      spread[k][d] = vtkPointSplatMortonCells::Spread(cell[k] + d - 1) << k;
    }
  }
  for (int c = forward ? 14 : 0; c < 27; ++c)
  {
    const std::uint64_t key = spread[0][c % 3] | spread[1][c / 3 % 3] | spread[2][c / 9];
    Index e = level.Find(key);
    if (e != Level::None)
    {
      for (; e < level.Keys.size() && level.Keys[e] == key; ++e)
      {
        found(e);
      }
    }
  }
}
}

//------------------------------------------------------------------------------
bool vtkPointSplatOverlap::Build(const double* positions, const double* radii, Index count,
  double factor, std::size_t mostEdges, const std::function<bool(Index, Index)>& keep)
{
  this->Offsets.assign(std::size_t(count) + 1, 0);
  this->Neighbors.clear();
  if (count == 0)
  {
    return true;
  }

  // 1. Levels and cells
  double origin[3] = { positions[0], positions[1], positions[2] };
  std::map<int, std::unique_ptr<Level>> byExponent;
  for (Index i = 0; i < count; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      origin[k] = std::min(origin[k], positions[3 * std::size_t(i) + k]);
    }
    std::unique_ptr<Level>& level = byExponent[std::ilogb(radii[i])];
    if (!level)
    {
      level.reset(new Level);
    }
    level->Splats.push_back(i);
    level->Width = std::max(level->Width, 2 * factor * radii[i]);
  }
  std::vector<const Level*> levels;
  for (auto& entry : byExponent)
  {
    // Slightly wider, so that rounding moves nothing that overlaps two cells away.
    entry.second->Width = entry.second->Width > 0 ? 1.000001 * entry.second->Width : 1.0;
    entry.second->Sort(positions, origin);
    levels.push_back(entry.second.get());
  }

  // 2. Pairs, chunk by chunk
  struct Task
  {
    std::size_t Level;
    Index Begin;
  };
  std::vector<Task> tasks;
  for (std::size_t l = 0; l < levels.size(); ++l)
  {
    for (std::size_t begin = 0; begin < levels[l]->Splats.size(); begin += Chunk)
    {
      tasks.push_back({ l, static_cast<Index>(begin) });
    }
  }
  std::vector<std::vector<std::pair<Index, Index>>> pairs(tasks.size());
  std::atomic<std::size_t> edges{ 0 };
  auto search = [&](vtkIdType first, vtkIdType last) {
    for (vtkIdType t = first; t < last; ++t)
    {
      const Level& own = *levels[tasks[t].Level];
      const Index end =
        std::min<Index>(tasks[t].Begin + Chunk, static_cast<Index>(own.Splats.size()));
      std::vector<std::pair<Index, Index>>& out = pairs[t];
      std::size_t reported = 0;
      for (Index e = tasks[t].Begin; e < end; ++e)
      {
        const Index i = own.Splats[e];
        const double* p = positions + 3 * std::size_t(i);
        auto test = [&](Index j) {
          const double* q = positions + 3 * std::size_t(j);
          const double d[3] = { q[0] - p[0], q[1] - p[1], q[2] - p[2] };
          const double reach = factor * (radii[i] + radii[j]);
          if (d[0] * d[0] + d[1] * d[1] + d[2] * d[2] < reach * reach && (!keep || keep(i, j)))
          {
            out.emplace_back(i, j);
          }
        };
        for (Index f = e + 1; f < own.Splats.size() && own.Keys[f] == own.Keys[e]; ++f)
        {
          test(own.Splats[f]);
          if (out.size() - reported > mostEdges)
          {
            break;
          }
        }
        for (std::size_t l = tasks[t].Level; l < levels.size(); ++l)
        {
          Around(*levels[l], p, origin, l == tasks[t].Level,
            [&](Index f) { test(levels[l]->Splats[f]); });
        }
        edges += out.size() - reported;
        reported = out.size();
        if (edges > mostEdges)
        {
          return;
        }
      }
    }
  };
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(tasks.size()), 1, search);
  if (edges > mostEdges)
  {
    return false;
  }

  // 3. Rows
  std::vector<std::atomic<Index>> cursors(count);
  auto each = [&](const std::function<void(const std::pair<Index, Index>&)>& visit) {
    vtkPointSplatThreads::For(0, static_cast<vtkIdType>(pairs.size()), 1, [&](vtkIdType a, vtkIdType b) {
      for (vtkIdType t = a; t < b; ++t)
      {
        for (const auto& pair : pairs[t])
        {
          visit(pair);
        }
      }
    });
  };
  each([&](const std::pair<Index, Index>& pair) {
    cursors[pair.first].fetch_add(1, std::memory_order_relaxed);
    cursors[pair.second].fetch_add(1, std::memory_order_relaxed);
  });
  for (Index i = 0; i < count; ++i)
  {
    this->Offsets[i + 1] = this->Offsets[i] + cursors[i];
    cursors[i] = 0;
  }
  this->Neighbors.resize(this->Offsets[count]);
  each([&](const std::pair<Index, Index>& pair) {
    this->Neighbors[this->Offsets[pair.first] +
      cursors[pair.first].fetch_add(1, std::memory_order_relaxed)] = pair.second;
    this->Neighbors[this->Offsets[pair.second] +
      cursors[pair.second].fetch_add(1, std::memory_order_relaxed)] = pair.first;
  });
  return true;
}

VTK_ABI_NAMESPACE_END
