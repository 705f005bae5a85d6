// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Progress on the terminal.
#ifndef Progress_h
#define Progress_h

#include <string>

class vtkAlgorithm;

/**
 * One line on stderr while it lives, if that is a terminal and quiet is false.
 */
class ProgressBar
{
public:
  ProgressBar(const std::string& label, bool quiet);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  void operator=(const ProgressBar&) = delete;

  /**
   * How much is done, from 0 to 1. Draws only what changes.
   */
  void Update(double done);
  void Clear();

private:
  std::string Label;
  bool Enabled;
  int Percent = -1;
};

/**
 * A bar for the filter whenever it runs.
 */
void ShowProgress(vtkAlgorithm* algorithm, const std::string& label, bool quiet);

#endif
