// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatTileLists.h"

#include "vtkPointSplatThreads.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <thread>

namespace
{
// As in vtkPointSplatRecord.glsl.
constexpr uint32_t Flat = 1;
constexpr uint32_t Bent = 2;
constexpr uint32_t Wide = 4;
constexpr uint32_t Triangle = 5;
constexpr uint32_t Clipped = 6;
constexpr int BlockShift = 4; // blocks of 16 x 16 tiles
constexpr int CellShift = 2;  // what is covered is told by cells of 4 x 4 tiles
// More threads would each need a count for every tile.
constexpr int MostParts = 16;

uint32_t KindOf(uint32_t last)
{
  return last >> 28;
}

/// Among which a tile lists it.
uint32_t ListedKindOf(uint32_t last)
{
  return KindOf(last) == Clipped ? Bent : KindOf(last);
}

uint32_t BucketOf(uint32_t first, uint32_t last)
{
  return first >> 25 | (last >> 25 & 7u) << 7;
}

glm::ivec2 TileOf(uint32_t word)
{
  return { static_cast<int>(word & 4095u), static_cast<int>(word >> 12 & 8191u) };
}

/// A number's bits, a zero between each.
uint32_t Spread(uint32_t x)
{
  x = (x | x << 8) & 0x00ff00ffu;
  x = (x | x << 4) & 0x0f0f0f0fu;
  x = (x | x << 2) & 0x33333333u;
  return (x | x << 1) & 0x55555555u;
}
}

//------------------------------------------------------------------------------
template <typename Function>
void vtkPointSplatTileLists::ForEachTile(const Listed& listed, const Function& function) const
{
  glm::ivec2 first = TileOf(listed.First);
  glm::ivec2 last = TileOf(listed.Last);
  int base = 0;
  int across = this->Grid.Tiles.x;
  if (KindOf(listed.Last) == Wide)
  {
    first = first >> BlockShift;
    last = last >> BlockShift;
    base = this->Grid.GetCount();
    across = this->Blocks.x;
  }
  for (int y = first.y; y <= last.y; ++y)
  {
    for (int x = first.x; x <= last.x; ++x)
    {
      function(static_cast<size_t>(base + y * across + x));
    }
  }
}

//------------------------------------------------------------------------------
template <typename Function>
void vtkPointSplatTileLists::ForParts(const Function& function) const
{
  vtkPointSplatThreads::For(0, this->Parts, 1, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType part = begin; part < end; ++part)
    {
      function(static_cast<size_t>(part));
    }
  });
}

//------------------------------------------------------------------------------
void vtkPointSplatTileLists::Count(
  const uint32_t* boxes, size_t boxWords, size_t splats, const vtkPointSplatTileGrid& grid)
{
  this->Grid = grid;
  this->Blocks = (grid.Tiles + (1 << BlockShift) - 1) >> BlockShift;
  this->Parts = std::clamp(vtkSMPTools::GetEstimatedNumberOfThreads(), 1, MostParts);
  const size_t parts = static_cast<size_t>(this->Parts);

  // By kind and bucket, each part of the splats after the ones before.
  auto keyOf = [boxes, boxWords](size_t i) {
    const uint32_t* box = boxes + boxWords * i;
    return ListedKindOf(box[1]) * Buckets + BucketOf(box[0], box[1]);
  };
  constexpr size_t Keys = (Triangle + 1) * Buckets;
  std::vector<std::array<uint32_t, Keys>> places(parts);
  auto begin = [splats, parts](size_t part) { return splats * part / parts; };
  this->ForParts([&](size_t part) {
    places[part].fill(0);
    for (size_t i = begin(part); i < begin(part + 1); ++i)
    {
      ++places[part][keyOf(i)];
    }
  });
  uint32_t sorted = 0;
  uint32_t curved = 0;    // the first one
  uint32_t triangles = 0; // likewise
  for (size_t key = Buckets; key < Keys; ++key) // what is not seen has the keys before
  {
    for (size_t part = 0; part < parts; ++part)
    {
      const uint32_t count = places[part][key];
      places[part][key] = sorted;
      sorted += count;
    }
    curved = key < (Bent + 1) * Buckets ? sorted : curved;
    triangles = key < Triangle * Buckets ? sorted : triangles;
  }
  this->HasTriangles = sorted > triangles;
  this->Sorted.resize(sorted);
  this->ForParts([&](size_t part) {
    for (size_t i = begin(part); i < begin(part + 1); ++i)
    {
      const size_t key = keyOf(i);
      if (key >= Buckets)
      {
        this->Sorted[places[part][key]++] = { static_cast<uint32_t>(i) |
            static_cast<uint32_t>(key % Buckets) << RecordBits,
          boxes[boxWords * i], boxes[boxWords * i + 1] };
      }
    }
  });

  // How many entries each part adds to each list, and of which kinds these are.
  const size_t tiles = static_cast<size_t>(grid.GetCount());
  const size_t lists = tiles + static_cast<size_t>(this->Blocks.x * this->Blocks.y);
  this->Places.resize(parts);
  std::vector<std::vector<uint32_t>> flats(parts);
  std::vector<std::vector<uint32_t>> bents(parts);
  std::vector<std::vector<uint32_t>> faces(parts);
  std::vector<std::vector<uint8_t>> endAtLines(parts);
  this->ForParts([&](size_t part) {
    this->Places[part].assign(lists, 0);
    flats[part].assign(tiles, 0);
    bents[part].assign(tiles, 0);
    faces[part].assign(tiles, 0);
    endAtLines[part].assign(tiles, 0);
    for (size_t i = sorted * part / parts; i < sorted * (part + 1) / parts; ++i)
    {
      const Listed& listed = this->Sorted[i];
      const uint32_t kind = KindOf(listed.Last);
      this->ForEachTile(listed, [&](size_t list) {
        ++this->Places[part][list];
        if (kind == Flat)
        {
          ++flats[part][list];
        }
        else if (kind == Bent)
        {
          ++bents[part][list];
        }
        else if (kind == Clipped)
        {
          ++bents[part][list];
          endAtLines[part][list] = 1;
        }
        else if (kind == Triangle)
        {
          ++faces[part][list];
        }
      });
    }
  });
  this->Starts.resize(lists + 1);
  this->Flats.assign(tiles, 0);
  this->Bents.assign(tiles, 0);
  this->Triangles.assign(tiles, 0);
  this->EndAtLines.assign(tiles, 0);
  bool anyEnds = false;
  uint32_t at = 0;
  for (size_t list = 0; list < lists; ++list)
  {
    this->Starts[list] = at;
    for (size_t part = 0; part < parts; ++part)
    {
      const uint32_t count = this->Places[part][list];
      this->Places[part][list] = at;
      at += count;
      if (list < tiles)
      {
        this->Flats[list] += flats[part][list];
        this->Bents[list] += bents[part][list];
        this->Triangles[list] += faces[part][list];
        this->EndAtLines[list] |= endAtLines[part][list];
        anyEnds = anyEnds || endAtLines[part][list] != 0;
      }
    }
  }
  this->Starts[lists] = at;
  this->Entries = at;
  this->Curved = triangles > curved || anyEnds;
}

//------------------------------------------------------------------------------
void vtkPointSplatTileLists::Fill(uint32_t* lists)
{
  const size_t sorted = this->Sorted.size();
  const size_t parts = static_cast<size_t>(this->Parts);
  this->ForParts([&](size_t part) {
    for (size_t i = sorted * part / parts; i < sorted * (part + 1) / parts; ++i)
    {
      const Listed& listed = this->Sorted[i];
      this->ForEachTile(
        listed, [&](size_t list) { lists[this->Places[part][list]++] = listed.Entry; });
    }
  });
}

//------------------------------------------------------------------------------
std::vector<uint32_t> vtkPointSplatTileLists::OrderTiles(const glm::ivec2& rows) const
{
  const glm::ivec4& window = this->Grid.Window;
  const int firstRow = std::max(rows.x, window.y);
  const int lastRow = std::min(rows.y, window.w);
  std::vector<glm::ivec2> blocks;
  for (int y = firstRow >> BlockShift; y <= lastRow >> BlockShift; ++y)
  {
    for (int x = window.x >> BlockShift; x <= window.z >> BlockShift; ++x)
    {
      blocks.emplace_back(x, y);
    }
  }
  auto curve = [](const glm::ivec2& block) {
    return Spread(static_cast<uint32_t>(block.x)) | Spread(static_cast<uint32_t>(block.y)) << 1;
  };
  std::sort(blocks.begin(), blocks.end(),
    [&curve](const glm::ivec2& a, const glm::ivec2& b) { return curve(a) < curve(b); });

  std::vector<uint32_t> order;
  for (const glm::ivec2& block : blocks)
  {
    const size_t firstOfBlock = order.size();
    const glm::ivec2 corner = block << BlockShift;
    const glm::ivec2 low = glm::max(corner, glm::ivec2(window.x, firstRow));
    const glm::ivec2 high =
      glm::min(corner + (1 << BlockShift) - 1, glm::ivec2(window.z, lastRow));
    for (int y = low.y; y <= high.y; ++y)
    {
      for (int x = low.x; x <= high.x; ++x)
      {
        if (!this->IsEmpty(this->TileAt(x, y)))
        {
          order.push_back(this->TileAt(x, y));
        }
      }
    }
    auto length = [this](uint32_t tile) { return this->Starts[tile + 1] - this->Starts[tile]; };
    std::stable_sort(order.begin() + static_cast<std::ptrdiff_t>(firstOfBlock), order.end(),
      [&length](uint32_t a, uint32_t b) { return length(a) > length(b); });
  }
  return order;
}

//------------------------------------------------------------------------------
size_t vtkPointSplatTileLists::BlockOf(uint32_t tile) const
{
  const glm::ivec2 at = glm::ivec2(static_cast<int>(tile) % this->Grid.Tiles.x,
                          static_cast<int>(tile) / this->Grid.Tiles.x) >>
    BlockShift;
  return static_cast<size_t>(this->Grid.GetCount() + at.y * this->Blocks.x + at.x);
}

//------------------------------------------------------------------------------
bool vtkPointSplatTileLists::IsEmpty(uint32_t tile) const
{
  const size_t block = this->BlockOf(tile);
  return this->Starts[tile] == this->Starts[tile + 1] &&
    this->Starts[block] == this->Starts[block + 1];
}

//------------------------------------------------------------------------------
bool vtkPointSplatTileLists::IsCurved(uint32_t tile) const
{
  const size_t block = this->BlockOf(tile);
  return this->EndAtLines[tile] != 0 ||
    this->Starts[tile] + this->Flats[tile] + this->Bents[tile] < this->Starts[tile + 1] ||
    this->Starts[block] < this->Starts[block + 1];
}

//------------------------------------------------------------------------------
vtkPointSplatTileLists::Span vtkPointSplatTileLists::GetSpan(uint32_t tile) const
{
  const uint32_t start = this->Starts[tile];
  const uint32_t curveds = start + this->Flats[tile] + this->Bents[tile];
  const uint32_t end = this->Starts[tile + 1];
  const size_t wide = this->BlockOf(tile);
  return { start, start + this->Flats[tile], curveds, end - this->Triangles[tile], end,
    this->Starts[wide], this->Starts[wide + 1], tile };
}

//------------------------------------------------------------------------------
void vtkPointSplatTileLists::WriteRow(const Span& span, uint32_t* row)
{
  const uint32_t words[TableWords] = { span.Flats, span.Bents, span.Curveds, span.Tile, span.End,
    span.Wides, span.WideEnd, span.Triangles + 1 };
  std::copy_n(words, TableWords, row);
}

//------------------------------------------------------------------------------
size_t vtkPointSplatTileLists::AddToTable(
  const glm::ivec2& rows, size_t groupSize, std::vector<uint32_t>& table) const
{
  std::vector<uint32_t> tiles = this->OrderTiles(rows);
  const auto firstCurved = this->HasCurved()
    ? std::stable_partition(
        tiles.begin(), tiles.end(), [this](uint32_t tile) { return !this->IsCurved(tile); })
    : tiles.end();
  const std::vector<uint32_t> curved(firstCurved, tiles.end());
  tiles.erase(firstCurved, tiles.end());
  const size_t before = table.size();
  this->Deal(tiles, groupSize, table);
  const size_t plain = (table.size() - before) / TableWords;
  this->Deal(curved, groupSize, table);
  return plain;
}

//------------------------------------------------------------------------------
void vtkPointSplatTileLists::Deal(
  const std::vector<uint32_t>& tiles, size_t groupSize, std::vector<uint32_t>& table) const
{
  const size_t groups = (tiles.size() + groupSize - 1) / groupSize;
  const size_t threads = std::max<size_t>(std::thread::hardware_concurrency(), 1);
  // Thread k takes groups k, k + threads, ...: each run of the table has what one thread takes.
  size_t to = table.size();
  table.resize(to + TableWords * groupSize * groups, 0);
  for (size_t thread = 0; thread < threads; ++thread)
  {
    for (size_t group = thread; group < groups; group += threads)
    {
      size_t row = to;
      for (size_t i = group * groupSize; i < std::min((group + 1) * groupSize, tiles.size()); ++i)
      {
        WriteRow(this->GetSpan(tiles[i]), table.data() + row);
        row += TableWords;
      }
      to += TableWords * groupSize;
    }
  }
}

//------------------------------------------------------------------------------
std::vector<glm::ivec4> vtkPointSplatTileLists::GetEmptyRuns() const
{
  const glm::ivec4& window = this->Grid.Window;
  std::vector<glm::ivec4> runs;
  for (int y = window.y; y <= window.w; ++y)
  {
    bool goesOn = false;
    for (int x = window.x; x <= window.z; ++x)
    {
      const bool empty = this->IsEmpty(this->TileAt(x, y));
      if (empty && !goesOn)
      {
        runs.emplace_back(x, y, x, y);
      }
      else if (empty)
      {
        runs.back().z = x;
      }
      goesOn = empty;
    }
  }
  return runs;
}

//------------------------------------------------------------------------------
std::vector<glm::ivec4> vtkPointSplatTileLists::GetCovered() const
{
  const glm::ivec4& window = this->Grid.Window;
  std::vector<glm::ivec4> rectangles;
  std::vector<size_t> above; // which of them end with the row of cells before
  for (int low = window.y >> CellShift << CellShift; low <= window.w; low += 1 << CellShift)
  {
    const glm::ivec2 rows(
      std::max(low, window.y), std::min(low + (1 << CellShift) - 1, window.w));
    std::vector<glm::ivec4> runs;
    for (int first = window.x >> CellShift << CellShift; first <= window.z;
         first += 1 << CellShift)
    {
      const glm::ivec4 cell(std::max(first, window.x), rows.x,
        std::min(first + (1 << CellShift) - 1, window.z), rows.y);
      bool covered = false;
      for (int y = cell.y; y <= cell.w && !covered; ++y)
      {
        for (int x = cell.x; x <= cell.z && !covered; ++x)
        {
          covered = !this->IsEmpty(this->TileAt(x, y));
        }
      }
      if (covered && !runs.empty() && runs.back().z == cell.x - 1)
      {
        runs.back().z = cell.z;
      }
      else if (covered)
      {
        runs.push_back(cell);
      }
    }
    std::vector<size_t> current;
    for (const glm::ivec4& run : runs)
    {
      const auto same = std::find_if(above.begin(), above.end(), [&](size_t i) {
        return rectangles[i].x == run.x && rectangles[i].z == run.z;
      });
      if (same != above.end())
      {
        rectangles[*same].w = run.w;
        current.push_back(*same);
      }
      else
      {
        current.push_back(rectangles.size());
        rectangles.push_back(run);
      }
    }
    above = current;
  }
  return rectangles;
}
