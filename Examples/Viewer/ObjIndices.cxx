// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ObjIndices.h"

#include "Options.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace
{
/// Of vertices, texture coordinates or normals.
struct Kind
{
  const char* Name;
  long long Count = 0;
  // The greatest index so far, which may be given further down.
  long long Greatest = 0;
  long long Line = 0;
};

UserError Missing(const std::string& file, long long line, long long index, const Kind& kind)
{
  return UserError(file + ": line " + std::to_string(line) + " names " + kind.Name + " " +
    std::to_string(index) + " of " + std::to_string(kind.Count));
}

using Kinds = std::array<Kind, 3>;

/**
 * a, a/b, a//c or a/b/c.
 */
void CheckCorner(
  const std::string& corner, long long line, const std::string& file, Kinds& kinds)
{
  const char* at = corner.c_str();
  for (size_t kind = 0; kind < kinds.size(); ++kind)
  {
    char* after = nullptr;
    const long long index = std::strtoll(at, &after, 10);
    const bool none = after == at;
    if (none && !(kind == 1 && *at == '/'))
    {
      break;
    }
    Kind& named = kinds[kind];
    if (!none && (index == 0 || index < -named.Count))
    {
      throw Missing(file, line, index, named);
    }
    if (index > named.Greatest)
    {
      named.Greatest = index;
      named.Line = line;
    }
    if (!*after)
    {
      return;
    }
    if (*after != '/')
    {
      break;
    }
    at = after + 1;
  }
  throw UserError(file + ": line " + std::to_string(line) + ": '" + corner +
    "' is not a corner of a face");
}
}

//------------------------------------------------------------------------------
void CheckObjIndices(const std::string& file)
{
  Kinds kinds{ { { "vertex" }, { "texture coordinate" }, { "normal" } } };
  std::ifstream in(file, std::ios::binary);
  std::string line;
  for (long long number = 1; std::getline(in, line); ++number)
  {
    std::string more;
    while (line.find_last_not_of(" \t\r") != std::string::npos &&
      line[line.find_last_not_of(" \t\r")] == '\\' && std::getline(in, more))
    {
      line = line.substr(0, line.rfind('\\')) + ' ' + more;
      ++number;
    }
    const size_t at = std::min(line.find_first_not_of(" \t"), line.size());
    const size_t end = std::min(line.find_first_of(" \t", at), line.size());
    const std::string word = line.substr(at, end - at);
    if (word == "v" || word == "vt" || word == "vn")
    {
      ++kinds[word == "v" ? 0 : word == "vt" ? 1 : 2].Count;
    }
    if (word != "f" && word != "l" && word != "p")
    {
      continue;
    }
    std::istringstream corners(line.substr(end));
    for (std::string corner; corners >> corner && corner[0] != '#';)
    {
      CheckCorner(corner, number, file, kinds);
    }
  }
  for (const Kind& kind : kinds)
  {
    if (kind.Greatest > kind.Count)
    {
      throw Missing(file, kind.Line, kind.Greatest, kind);
    }
  }
}
