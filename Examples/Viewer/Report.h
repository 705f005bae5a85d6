// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// What splatview --json writes.
#ifndef Report_h
#define Report_h

#include "Scene.h"

#include <string>
#include <vector>

class vtkRenderWindow;

double Median(std::vector<double> values);

/**
 * Points, every automatic choice, frame times in milliseconds, and what drew them.
 * Throws UserError where the file cannot be written.
 */
void WriteReport(const std::string& file, const Scene& scene, vtkRenderWindow* window,
  const std::vector<double>& milliseconds);

#endif
