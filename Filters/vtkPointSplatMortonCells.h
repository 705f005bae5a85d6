// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkPointSplatMortonCells.h
 * @brief places of a grid's cells along Morton's curve, which fills space
 *
 * An internal helper of vtkPointSplatOverlap and vtkPointSplatRefinement.
 */
#ifndef vtkPointSplatMortonCells_h
#define vtkPointSplatMortonCells_h

#include "vtkPointSplattingABI.h"

#include <cstdint>

VTK_ABI_NAMESPACE_BEGIN

namespace vtkPointSplatMortonCells
{
/// Bits of a cell's coordinate. Coordinates beyond are wrapped: then far cells share a place.
inline constexpr std::int64_t CellBits = 21;

/// The bits of a cell's coordinate, two zeros between each.
inline std::uint64_t Spread(std::int64_t cell)
{
  std::uint64_t x = static_cast<std::uint64_t>(cell) & ((1ull << CellBits) - 1);
  x = (x | (x << 32)) & 0x1f00000000ffffull;
  x = (x | (x << 16)) & 0x1f0000ff0000ffull;
  x = (x | (x << 8)) & 0x100f00f00f00f00full;
  x = (x | (x << 4)) & 0x10c30c30c30c30c3ull;
  x = (x | (x << 2)) & 0x1249249249249249ull;
  return x;
}

inline std::uint64_t GetPlace(const std::int64_t cell[3])
{
  return Spread(cell[0]) | Spread(cell[1]) << 1 | Spread(cell[2]) << 2;
}
}

VTK_ABI_NAMESPACE_END
#endif
