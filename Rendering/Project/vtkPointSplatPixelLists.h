// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Which splats and triangles of its tile's lists a pixel may show, so that only these are tried on
// its samples: a third of the tile's or less. Made by the processor, as vtkPointSplatTileLists.
#ifndef vtkPointSplatPixelLists_h
#define vtkPointSplatPixelLists_h

#include <cstddef>
#include <cstdint>
#include <vector>

class vtkPointSplatTileLists;

class vtkPointSplatPixelLists
{
public:
  /// What lists are made from.
  struct Source
  {
    const vtkPointSplatTileLists& Tiles;
    const uint32_t* Lists; // that it filled
    const uint32_t* Boxes; // BoxWords a splat, vtkPointSplatRecord.glsl
    uint32_t Width;        // of the image, pixels
  };
  /// Words a box that tells pixels, too.
  static constexpr size_t BoxWords = 4;

  /**
   * Of pixels (y times the image's width plus x) from the first one on, as many as it takes until
   * their tiles have MostEntries together. Returns where they end.
   */
  size_t Make(const Source& source, const std::vector<uint32_t>& pixels, size_t first);
  static constexpr size_t MostEntries = size_t(1) << 24;

  /// A row a pixel, as vtkPointSplatTileLists::WriteRow() writes it of a tile.
  const std::vector<uint32_t>& GetTable() const { return this->Table; }
  /// The lists, one after the other.
  const std::vector<uint32_t>& GetEntries() const { return this->Entries; }

private:
  std::vector<uint32_t> Table;
  std::vector<uint32_t> Entries;
};

#endif
