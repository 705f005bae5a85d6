// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Which columns of a text are what.
#ifndef TextColumns_h
#define TextColumns_h

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

struct TextTable;

/**
 * By the names above the columns, if there are x, y and z among them, in any order and case, with or
 * without a unit in brackets ("X [m]"):
 * - x, y, z; or Points:0 to 2, as ParaView writes.
 * - nx, ny, nz; normal_x, ...; Normals:0 to 2. Without such names three unit vectors' columns that
 *   follow z are normals, unless they are known by other names.
 * - r, g, b; red, green, blue; RGB:0 to 2: from 0 to 1, to 255 or to 65535.
 * - radius; SplatRadius.
 * - All others are arrays by their own names.
 *
 * Without such names by their order: x y z, then normals, colours, both in either order, or neither,
 * with one scalar before or behind those, "Intensity": three columns are normals if they are unit
 * vectors within 1 % (or zero), else colours.
 */
struct TextColumns
{
  using Three = std::array<size_t, 3>;

  Three Point{ { 0, 1, 2 } };
  std::optional<Three> Normal;
  std::optional<Three> Colour;
  std::optional<size_t> Radius;
  std::vector<std::pair<std::string, size_t>> Others;

  static TextColumns Find(const TextTable& table);
};

#endif
