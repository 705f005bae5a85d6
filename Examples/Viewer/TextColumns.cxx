// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TextColumns.h"

#include "TextTable.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>

namespace
{
using Three = TextColumns::Three;

/**
 * Whether three columns hold unit vectors. Unknown normals are often zero or NaN.
 */
bool HasNormalsAt(const TextTable& table, size_t column)
{
  if (column + 3 > table.Columns)
  {
    return false;
  }
  bool any = false;
  for (size_t i = 0; i < table.GetNumberOfRows(); ++i)
  {
    const double* n = table.Row(i) + column;
    const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    if (std::abs(length - 1.0) <= 0.01)
    {
      any = true;
    }
    else if (length > 0.0) // false for NaN too
    {
      return false;
    }
  }
  return any;
}

Three From(size_t column)
{
  return { { column, column + 1, column + 2 } };
}

TextColumns FindByOrder(const TextTable& table)
{
  // What may follow x y z: (n)ormal, (c)olour, (s)calar; the first that fits is taken.
  // Columns behind are passed over, but not where a scalar would then be guessed.
  for (const std::string layout :
    { "snc", "scn", "ncs", "cns", "nc", "cn", "sn", "ns", "sc", "n", "c", "s" })
  {
    TextColumns found;
    size_t column = 3;
    for (const char kind : layout)
    {
      if (kind == 's')
      {
        found.Others.emplace_back("Intensity", column);
      }
      else
      {
        (kind == 'n' ? found.Normal : found.Colour) = From(column);
      }
      column += kind == 's' ? 1 : 3;
    }
    const bool fits = found.Others.empty() ? column <= table.Columns : column == table.Columns;
    if (fits && (!found.Normal || HasNormalsAt(table, (*found.Normal)[0])))
    {
      return found;
    }
  }
  return TextColumns();
}

/// In small letters, without a unit in brackets, blanks and underscores.
std::string Plain(const std::string& name)
{
  std::string plain;
  for (const char c : name.substr(0, name.find_first_of("[(")))
  {
    if (c != ' ' && c != '_')
    {
      plain.push_back(static_cast<char>(std::tolower(static_cast<unsigned char>(c))));
    }
  }
  return plain;
}

/**
 * The columns of names; of several with one name the first.
 */
class Names
{
public:
  explicit Names(const std::vector<std::string>& names)
  {
    for (size_t i = 0; i < names.size(); ++i)
    {
      this->At.emplace(Plain(names[i]), i);
    }
  }
  /// The first of the triples that is there, whole; it is used then.
  std::optional<Three> Take(const std::vector<std::array<const char*, 3>>& triples)
  {
    for (const auto& triple : triples)
    {
      if (this->At.count(triple[0]) && this->At.count(triple[1]) && this->At.count(triple[2]))
      {
        const Three found{ { this->At[triple[0]], this->At[triple[1]], this->At[triple[2]] } };
        this->Used.insert(found.begin(), found.end());
        return found;
      }
    }
    return std::nullopt;
  }
  std::optional<size_t> Take(const std::vector<const char*>& names)
  {
    for (const char* name : names)
    {
      const auto found = this->At.find(name);
      if (found != this->At.end())
      {
        this->Used.insert(found->second);
        return found->second;
      }
    }
    return std::nullopt;
  }
  bool IsUsed(size_t column) const { return this->Used.count(column) > 0; }
  void Use(const Three& columns) { this->Used.insert(columns.begin(), columns.end()); }

private:
  std::map<std::string, size_t> At;
  std::set<size_t> Used;
};
}

//------------------------------------------------------------------------------
TextColumns TextColumns::Find(const TextTable& table)
{
  Names names(table.Names);
  const std::optional<Three> point =
    names.Take({ { "x", "y", "z" }, { "points:0", "points:1", "points:2" } });
  if (!point || table.Names.size() != table.Columns)
  {
    return FindByOrder(table);
  }
  TextColumns found;
  found.Point = *point;
  found.Normal = names.Take({ { "nx", "ny", "nz" }, { "normalx", "normaly", "normalz" },
    { "normals:0", "normals:1", "normals:2" } });
  found.Colour = names.Take(
    { { "r", "g", "b" }, { "red", "green", "blue" }, { "rgb:0", "rgb:1", "rgb:2" } });
  found.Radius = names.Take(std::vector<const char*>{ "splatradius", "radius" });
  const size_t next = found.Point[2] + 1;
  if (!found.Normal && HasNormalsAt(table, next))
  {
    const Three guess = From(next);
    if (std::none_of(
          guess.begin(), guess.end(), [&names](size_t column) { return names.IsUsed(column); }))
    {
      found.Normal = guess;
      names.Use(guess);
    }
  }
  for (size_t i = 0; i < table.Columns; ++i)
  {
    if (!names.IsUsed(i) && !table.Names[i].empty())
    {
      found.Others.emplace_back(table.Names[i], i);
    }
  }
  return found;
}
