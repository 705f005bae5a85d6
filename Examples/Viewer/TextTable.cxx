// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TextTable.h"

#include "Options.h"
#include "Progress.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <limits>

namespace
{
bool IsBlank(char c)
{
  return c == ' ' || c == '\t';
}

bool IsDigit(char c)
{
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/**
 * The lines of a file without what is no content.
 */
class LineReader
{
public:
  explicit LineReader(const std::string& file)
    : File(file)
    , In(file, std::ios::binary)
  {
    if (!this->In)
    {
      throw UserError(file + ": cannot be opened");
    }
    this->In.seekg(0, std::ios::end);
    this->Size = static_cast<double>(this->In.tellg());
    this->Rewind();
  }

  void Rewind()
  {
    this->In.clear();
    this->In.seekg(0);
    this->Number = 0;
    char mark[3] = {};
    this->In.read(mark, 3);
    const bool marked = std::memcmp(mark, "\xEF\xBB\xBF", 3) == 0;
    if (!std::memcmp(mark, "\xFF\xFE", 2) || !std::memcmp(mark, "\xFE\xFF", 2))
    {
      throw UserError(this->File + ": is UTF-16; save it as UTF-8");
    }
    this->In.clear();
    this->In.seekg(marked ? 3 : 0);
  }

  /**
   * The next line that has content, trimmed.
   */
  bool Next(std::string& line)
  {
    while (this->NextEnded(line))
    {
      ++this->Number;
      size_t end = line.find_first_of("#%");
      end = end == std::string::npos ? line.size() : end;
      const size_t start = line.find_first_not_of(" \t");
      if (start >= end || line.compare(start, 2, "//") == 0)
      {
        continue;
      }
      end = line.find_last_not_of(" \t", end - 1) + 1;
      line = line.substr(start, end - start);
      return true;
    }
    return false;
  }

  size_t GetNumber() const { return this->Number; }
  double GetProgress() { return static_cast<double>(this->In.tellg()) / this->Size; }

private:
  /// Up to \n, \r\n or \r.
  bool NextEnded(std::string& line)
  {
    line.clear();
    std::streambuf* in = this->In.rdbuf();
    int c = in->sbumpc();
    if (c == std::char_traits<char>::eof())
    {
      return false;
    }
    for (; c != std::char_traits<char>::eof() && c != '\n' && c != '\r'; c = in->sbumpc())
    {
      line.push_back(static_cast<char>(c));
    }
    if (c == '\r' && in->sgetc() == '\n')
    {
      in->sbumpc();
    }
    return true;
  }

  std::string File;
  std::ifstream In;
  double Size = 0.0;
  size_t Number = 0;
};

/**
 * How a file writes its numbers.
 */
struct Style
{
  char Separator = ' '; // ' ', ',' or ';'
  bool DecimalComma = false;
};

/// A blank in place of each comma that has a blank or an end beside it: those separate.
std::string WithoutLooseCommas(std::string line)
{
  for (size_t i = 0; i < line.size(); ++i)
  {
    if (line[i] == ',' &&
      (i == 0 || i + 1 == line.size() || IsBlank(line[i - 1]) || IsBlank(line[i + 1])))
    {
      line[i] = ' ';
    }
  }
  return line;
}

/**
 * Whether blanks separate at least three numbers, of which none has more than one comma, or a comma
 * and a point. commas: whether one has a comma.
 */
bool CanBlanksSeparate(const std::string& line, bool& commas)
{
  int tokens = 0;
  for (size_t at = 0; at < line.size(); ++tokens)
  {
    const size_t end = std::min(line.find_first_of(" \t", at), line.size());
    const auto inCommas = std::count(line.begin() + at, line.begin() + end, ',');
    const auto inPoints = std::count(line.begin() + at, line.begin() + end, '.');
    if (inCommas > 1 || (inCommas == 1 && inPoints > 0))
    {
      return false;
    }
    commas = commas || inCommas == 1;
    at = std::min(line.find_first_not_of(" \t", end), line.size());
  }
  return tokens >= 3;
}

/**
 * By the first lines of numbers.
 */
Style FindStyle(LineReader& lines)
{
  constexpr int enough = 1000;
  bool semicolons = false;
  bool commasOutside = false;
  bool commasQuoted = false;
  bool blanks = true;
  bool commasInNumbers = false;
  std::string line;
  for (int i = 0; i < enough && lines.Next(line); ++i)
  {
    const size_t first = line.find_first_not_of("\"+-.");
    if (first == std::string::npos || !IsDigit(line[first]))
    {
      continue;
    }
    bool quoted = false;
    for (char& c : line)
    {
      quoted = quoted != (c == '"');
      semicolons = semicolons || (c == ';' && !quoted);
      commasOutside = commasOutside || (c == ',' && !quoted);
      commasQuoted = commasQuoted || (c == ',' && quoted);
    }
    blanks = CanBlanksSeparate(WithoutLooseCommas(line), commasInNumbers) && blanks;
  }
  Style style;
  if (semicolons)
  {
    style.Separator = ';';
    style.DecimalComma = commasOutside || commasQuoted;
  }
  else if (commasOutside)
  {
    const bool decimal = blanks && commasInNumbers && !commasQuoted;
    style.Separator = decimal ? ' ' : ',';
    style.DecimalComma = decimal || commasQuoted;
  }
  else
  {
    style.DecimalComma = commasQuoted;
  }
  return style;
}

/**
 * The cells of a line. Several blanks separate once, several commas or semicolons as often as they
 * are; one at the end of the line has nothing behind it.
 */
void Split(const std::string& given, const Style& style, std::vector<std::string>& cells)
{
  cells.clear();
  const bool byBlanks = style.Separator == ' ';
  const std::string line = byBlanks && style.DecimalComma ? WithoutLooseCommas(given) : given;
  std::string cell;
  bool quoted = false;
  bool any = false;   // in this cell
  bool ended = false; // by blanks: a separator may follow
  for (const char c : line)
  {
    const bool blank = IsBlank(c) && !quoted;
    if (c == '"')
    {
      quoted = !quoted;
      any = true;
    }
    else if (!quoted && c == style.Separator && !byBlanks)
    {
      if (!ended)
      {
        cells.push_back(cell);
      }
      cell.clear();
      any = ended = false;
    }
    else if (blank)
    {
      // Within semicolons and commas blanks separate too.
      if (any)
      {
        cells.push_back(cell);
        cell.clear();
        ended = true;
      }
      any = false;
    }
    else
    {
      cell.push_back(c);
      any = true;
      ended = false;
    }
  }
  if (any)
  {
    cells.push_back(cell);
  }
}

/**
 * The names of a line. They may have blanks in them, where these do not separate the columns.
 */
std::vector<std::string> SplitNames(const std::string& line, const Style& style)
{
  Style names = style;
  if (style.Separator == ' ' && line.find('\t') != std::string::npos)
  {
    names.Separator = '\t';
  }
  std::vector<std::string> cells;
  if (names.Separator == ' ')
  {
    Split(line, style, cells);
    return cells;
  }
  std::string cell;
  bool quoted = false;
  const auto end = [&cells, &cell] {
    const size_t first = cell.find_first_not_of(" \t");
    const size_t last = cell.find_last_not_of(" \t");
    cells.push_back(first == std::string::npos ? "" : cell.substr(first, last + 1 - first));
    cell.clear();
  };
  for (const char c : line)
  {
    if (c == '"')
    {
      quoted = !quoted;
    }
    else if (c == names.Separator && !quoted)
    {
      end();
    }
    else
    {
      cell.push_back(c);
    }
  }
  if (!cell.empty())
  {
    end();
  }
  return cells;
}

bool ParseNumber(std::string& cell, const Style& style, double& number)
{
  const size_t start = cell.find_first_not_of(" \t");
  if (start == std::string::npos)
  {
    number = std::numeric_limits<double>::quiet_NaN();
    return true;
  }
  const size_t comma = style.DecimalComma ? cell.find(',') : std::string::npos;
  if (comma != std::string::npos)
  {
    if (cell.find('.') != std::string::npos)
    {
      return false;
    }
    cell[comma] = '.';
  }
  char* end = nullptr;
  number = std::strtod(cell.c_str() + start, &end);
  const bool good = end != cell.c_str() + start && !end[std::strspn(end, " \t")];
  if (comma != std::string::npos)
  {
    cell[comma] = ',';
  }
  return good;
}

/**
 * Throws where commas that separate leave what looks like decimals, as the 05 of 1,05: no program
 * writes whole numbers so.
 */
void RefuseFractions(const std::vector<std::string>& cells, const std::string& place)
{
  for (const std::string& cell : cells)
  {
    if (cell.size() > 1 && cell[0] == '0' && std::all_of(cell.begin(), cell.end(), IsDigit))
    {
      throw UserError(place + ": '" + cell +
        "' looks like decimals behind a comma; let semicolons or tabs separate the columns");
    }
  }
}

/// Of names, which may be quoted.
bool BeginsLikeAName(const std::string& line)
{
  const size_t first = line.find_first_not_of('"');
  const auto c = static_cast<unsigned char>(first == std::string::npos ? '"' : line[first]);
  return std::isalpha(c) || c >= 0x80 || c == '"' || c == '(' || c == '[' || c == '_';
}

/**
 * How many points are promised and not yet there.
 */
class Promise
{
public:
  bool IsKept() const { return this->Missing <= 0.0; }
  void Make(double count) { this->Count = this->Missing = count; }
  void Keep() { this->Missing -= 1.0; }
  std::string GetText() const
  {
    std::string text = std::to_string(this->Count);
    text.erase(text.find('.'));
    return text;
  }

private:
  double Count = 0.0;
  double Missing = 0.0;
};
}

//------------------------------------------------------------------------------
TextTable TextTable::Read(const std::string& file, ProgressBar& progress)
{
  LineReader lines(file);
  const Style style = FindStyle(lines);
  lines.Rewind();

  TextTable table;
  Promise promise;
  std::vector<double> row;
  std::vector<std::string> cells;
  std::string line;
  while (lines.Next(line))
  {
    const std::string place = file + ": line " + std::to_string(lines.GetNumber());
    Split(line, style, cells);
    row.resize(cells.size());
    size_t numbers = 0;
    while (numbers < cells.size() && ParseNumber(cells[numbers], style, row[numbers]))
    {
      ++numbers;
    }
    if (numbers < cells.size())
    {
      if (table.Columns == 0 && BeginsLikeAName(line))
      {
        table.Names = SplitNames(line, style);
        continue;
      }
      throw UserError(place + ": '" + cells[numbers] + "' is not a number");
    }
    if (row.size() == 1 && promise.IsKept() && row[0] >= 0.0 && row[0] == std::floor(row[0]))
    {
      promise.Make(row[0]);
      continue;
    }
    if (style.Separator == ',')
    {
      RefuseFractions(cells, place);
    }
    if (table.Columns == 0)
    {
      table.Columns = row.size();
    }
    if (row.size() != table.Columns || table.Columns < 3)
    {
      throw UserError(place + " has " + std::to_string(row.size()) + " columns, not " +
        (table.Columns < 3 ? "at least 3" : std::to_string(table.Columns)));
    }
    promise.Keep();
    table.Values.insert(table.Values.end(), row.begin(), row.end());
    if (lines.GetNumber() % 4096 == 0)
    {
      progress.Update(lines.GetProgress());
    }
  }
  if (table.Values.empty())
  {
    throw UserError(file + ": has no points");
  }
  if (!promise.IsKept())
  {
    throw UserError(file + ": promises " + promise.GetText() + " points and ends before; it has " +
      std::to_string(table.GetNumberOfRows()));
  }
  return table;
}
