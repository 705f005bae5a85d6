// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Which splats each tile of the image has, made by the processor from the boxes that the projection
// wrote (vtkPointSplatRecord.glsl). For drivers whose buffers are in main memory anyway.
//
// 1. Splats are sorted by kind, and within a kind by the bucket of their nearest depth; by counting,
//    so that equal ones stay in the order they have, whatever threads do.
// 2. In this order each is appended to the list of every tile that its box touches; wide ones, whose
//    boxes have hundreds of tiles, to those of blocks of 16 x 16 tiles. So each list has its kinds
//    one after the other, nearest buckets first.
//    Triangles (vtkPointSplatTrianglesCS.glsl) come after a tile's splats.
// 3. Tiles that have some are put into an order in which tiles close to each other, whose splats are in the caches,
//    follow one another, and among them those with lists of like lengths, since invocations go in
//    lockstep; tiles with curved or clipped splats or triangles come after all others, so that these
//    can be drawn by a program that knows none; work groups are dealt out to the driver's threads, which take runs of
//    them.
#ifndef vtkPointSplatTileLists_h
#define vtkPointSplatTileLists_h

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

/**
 * The tiles of an image, of 2^Shift pixels along each side.
 */
struct vtkPointSplatTileGrid
{
  glm::ivec2 Shift{ 2, 2 };
  glm::ivec2 Tiles{ 0, 0 };
  glm::ivec4 Window{ 0 }; // tiles that may have something: first x, y, last x, y

  int GetCount() const { return this->Tiles.x * this->Tiles.y; }
};

class vtkPointSplatTileLists
{
public:
  /// Of depths; as in vtkPointSplatRecord.glsl.
  static constexpr uint32_t Buckets = 1024;
  /// Words a tile in the table.
  static constexpr size_t TableWords = 8;

  /**
   * Sorts and counts; boxes: so many words a splat, of which the first two are of tiles.
   */
  void Count(
    const uint32_t* boxes, size_t boxWords, size_t splats, const vtkPointSplatTileGrid& grid);
  /// Entries of all lists, after Count().
  size_t GetNumberOfEntries() const { return this->Entries; }
  /// Whether there are triangles, or splats that are curved or end at clip lines.
  bool HasCurved() const { return this->Curved || this->HasTriangles; }
  /// Of splats alone.
  bool HasCurvedSplats() const { return this->Curved; }

  /// Writes the lists: GetNumberOfEntries() words.
  void Fill(uint32_t* lists);

  /// Where each kind of splat of a tile begins in the lists, and where the last ones end.
  struct Span
  {
    uint32_t Flats;
    uint32_t Bents;
    uint32_t Curveds;
    uint32_t Triangles;
    uint32_t End;
    uint32_t Wides;
    uint32_t WideEnd;
    uint32_t Tile;
  };
  Span GetSpan(uint32_t tile) const;
  /// As the table has it: TableWords words.
  static void WriteRow(const Span& span, uint32_t* row);
  /// Of an entry of a list.
  static uint32_t RecordOf(uint32_t entry) { return entry & ((1u << RecordBits) - 1u); }
  /// Of a pixel.
  uint32_t GetTile(const glm::ivec2& pixel) const
  {
    return this->TileAt(pixel.x >> this->Grid.Shift.x, pixel.y >> this->Grid.Shift.y);
  }

  /**
   * The tiles of the grid's window in some rows of it that have splats, and where these are in the lists: first
   * of the flat, bent and curved ones, tile; end, first of the wide ones, their end, first of the
   * triangles and 1 more. Appended to a
   * table, those without curved, clipped and wide ones first, and either padded with zeros to whole work
   * groups of so many invocations. rows: first and last, whole blocks of 16. Returns how many rows
   * of the table those without take.
   */
  size_t AddToTable(const glm::ivec2& rows, size_t groupSize, std::vector<uint32_t>& table) const;

  ///@{
  /**
   * Of the grid's window, after Count(): runs of tiles in a row that have no splats; and rectangles of
   * tiles, apart from one another, in which all lie that have some. First tile's x, y, last one's.
   */
  std::vector<glm::ivec4> GetEmptyRuns() const;
  std::vector<glm::ivec4> GetCovered() const;
  ///@}

private:
  static constexpr uint32_t RecordBits = 22; // as in vtkPointSplatRecord.glsl
  struct Listed
  {
    uint32_t Entry; // of lists: bucket, and splat
    uint32_t First; // of its box
    uint32_t Last;
  };
  template <typename Function>
  void ForEachTile(const Listed& listed, const Function& function) const;
  uint32_t TileAt(int x, int y) const { return static_cast<uint32_t>(y * this->Grid.Tiles.x + x); }
  std::vector<uint32_t> OrderTiles(const glm::ivec2& rows) const;
  size_t BlockOf(uint32_t tile) const; // its list
  bool IsEmpty(uint32_t tile) const;
  bool IsCurved(uint32_t tile) const; // or has clipped splats or triangles
  void Deal(
    const std::vector<uint32_t>& tiles, size_t groupSize, std::vector<uint32_t>& table) const;
  template <typename Function>
  void ForParts(const Function& function) const;

  vtkPointSplatTileGrid Grid;
  glm::ivec2 Blocks{ 0, 0 };
  int Parts = 1;
  std::vector<Listed> Sorted;
  // Of each part of the sorted splats, for each tile and then for each block, how many entries it
  // adds, and then where it adds them.
  std::vector<std::vector<uint32_t>> Places;
  std::vector<uint32_t> Starts; // of tiles' and blocks' lists, and the end
  std::vector<uint32_t> Flats;  // of tiles
  std::vector<uint32_t> Bents;
  std::vector<uint32_t> Triangles;
  std::vector<uint8_t> EndAtLines; // whether some of a tile's bent ones end at clip lines
  size_t Entries = 0;
  bool Curved = false; // some splats, or clipped
  bool HasTriangles = false;
};

#endif
