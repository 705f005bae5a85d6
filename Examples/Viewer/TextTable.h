// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Numbers in text, as spreadsheets, scanners and programs write them.
#ifndef TextTable_h
#define TextTable_h

#include <string>
#include <vector>

class ProgressBar;

/**
 * All lines' numbers, one line after the other, as many in each.
 *
 * Columns are separated by blanks or tabs, by commas, or by semicolons. Commas mark decimals where
 * semicolons, tabs or blanks separate the columns. Numbers may be quoted. A cell with nothing in it
 * is NaN. A byte order mark, empty lines, comments (from # or % on, or lines that begin with //) and
 * lines of names at the top are passed over; lines end as on any system.
 *
 * A number alone in its line, before the points, is how many follow; several such parts may come
 * one after the other (.pts).
 */
struct TextTable
{
  std::vector<double> Values;
  size_t Columns = 0;
  /// The cells of the last line of names before the numbers; empty without one.
  std::vector<std::string> Names;

  size_t GetNumberOfRows() const { return this->Values.size() / this->Columns; }
  const double* Row(size_t row) const { return &this->Values[row * this->Columns]; }

  /**
   * At least one row of three columns. Throws UserError, which names the line, where lines differ
   * in length or hold what is no number, where fewer points follow than are promised, and where commas
   * may mark decimals as well as columns.
   */
  static TextTable Read(const std::string& file, ProgressBar& progress);
};

#endif
