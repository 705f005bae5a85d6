// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatPixelLists.h"

#include "vtkPointSplatThreads.h"
#include "vtkPointSplatTileLists.h"

#include <algorithm>

namespace
{
using Span = vtkPointSplatTileLists::Span;

constexpr size_t PixelsAPart = 512;

/// Of some of the pixels.
struct PixelPart
{
  std::vector<uint32_t> Entries; // of all lists, and room for more
  uint32_t Count = 0;            // of entries
  uint32_t First = 0;            // of them among those of all parts
};

/// Keeps of the entries from begin to end those whose boxes have a pixel. Returns where they end.
uint32_t Keep(const vtkPointSplatPixelLists::Source& source, uint32_t begin, uint32_t end,
  const glm::uvec2& pixel, PixelPart& part)
{
  const size_t most = part.Count + (end - begin);
  if (part.Entries.size() < most)
  {
    part.Entries.resize(2 * most);
  }
  // Without a branch, which would be guessed wrong as often as not.
  uint32_t* to = part.Entries.data() + part.Count;
  for (uint32_t i = begin; i < end; ++i)
  {
    const uint32_t entry = source.Lists[i];
    const uint32_t* box = source.Boxes + 2 +
      vtkPointSplatPixelLists::BoxWords * vtkPointSplatTileLists::RecordOf(entry);
    *to = entry;
    to += (pixel.x >= (box[0] & 0xffffu)) & (pixel.x <= (box[1] & 0xffffu)) &
      (pixel.y >= box[0] >> 16) & (pixel.y <= box[1] >> 16);
  }
  part.Count = static_cast<uint32_t>(to - part.Entries.data());
  return part.Count;
}

/// Appends what a pixel's tile has for it. span: of the tile, then of what was appended.
void AddPixel(const vtkPointSplatPixelLists::Source& source, const glm::uvec2& pixel,
  PixelPart& part, Span& span)
{
  const Span tile = span;
  span.Flats = part.Count;
  span.Bents = Keep(source, tile.Flats, tile.Bents, pixel, part);
  span.Curveds = Keep(source, tile.Bents, tile.Curveds, pixel, part);
  span.Triangles = Keep(source, tile.Curveds, tile.Triangles, pixel, part);
  span.End = Keep(source, tile.Triangles, tile.End, pixel, part);
  span.Wides = span.End;
  span.WideEnd = Keep(source, tile.Wides, tile.WideEnd, pixel, part);
}
}

//------------------------------------------------------------------------------
size_t vtkPointSplatPixelLists::Make(
  const Source& source, const std::vector<uint32_t>& pixels, size_t first)
{
  const auto placeOf = [&](size_t i) {
    return glm::uvec2(pixels[i] % source.Width, pixels[i] / source.Width);
  };
  std::vector<Span> spans; // of tiles, then of pixels
  for (size_t i = first, listed = 0; i < pixels.size() && (i == first || listed < MostEntries); ++i)
  {
    const Span& tile =
      spans.emplace_back(source.Tiles.GetSpan(source.Tiles.GetTile(glm::ivec2(placeOf(i)))));
    listed += tile.End - tile.Flats + tile.WideEnd - tile.Wides;
  }
  const size_t count = spans.size();
  std::vector<PixelPart> parts((count + PixelsAPart - 1) / PixelsAPart);
  const auto forParts = [&parts, count](auto&& function) {
    vtkPointSplatThreads::For(
      0, static_cast<vtkIdType>(parts.size()), 1, [&](vtkIdType from, vtkIdType to) {
        for (size_t part = static_cast<size_t>(from); part < static_cast<size_t>(to); ++part)
        {
          function(parts[part], PixelsAPart * part, std::min(PixelsAPart * (part + 1), count));
        }
      });
  };
  forParts([&](PixelPart& part, size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i)
    {
      AddPixel(source, placeOf(first + i), part, spans[i]);
    }
  });
  uint32_t entries = 0;
  for (PixelPart& part : parts)
  {
    part.First = entries;
    entries += part.Count;
  }
  this->Entries.resize(entries);
  this->Table.resize(vtkPointSplatTileLists::TableWords * count);
  forParts([&](PixelPart& part, size_t begin, size_t end) {
    std::copy_n(part.Entries.begin(), part.Count, this->Entries.begin() + part.First);
    for (size_t i = begin; i < end; ++i)
    {
      Span& span = spans[i];
      for (uint32_t* place : { &span.Flats, &span.Bents, &span.Curveds, &span.Triangles, &span.End,
             &span.Wides, &span.WideEnd })
      {
        *place += part.First;
      }
      vtkPointSplatTileLists::WriteRow(
        span, this->Table.data() + vtkPointSplatTileLists::TableWords * i);
    }
  });
  return first + count;
}
