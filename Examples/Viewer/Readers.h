// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// From a file's name to its data.
#ifndef Readers_h
#define Readers_h

#include "vtkSmartPointer.h"

#include <string>

class vtkAlgorithm;
class vtkDataObject;

/**
 * A vtkImageData, or a vtkPointSet with its normals if it has any. Throws UserError.
 */
vtkSmartPointer<vtkDataObject> ReadFile(const std::string& file, bool quiet);

/**
 * Draws the filter's progress on the terminal, if there is one, while it runs.
 */
void ShowProgress(vtkAlgorithm* algorithm, const std::string& label, bool quiet);

/**
 * Keeps VTK's errors and warnings, so that what a user sees is one line.
 */
class MessageKeeper
{
public:
  MessageKeeper();
  ~MessageKeeper();
  MessageKeeper(const MessageKeeper&) = delete;
  void operator=(const MessageKeeper&) = delete;

  /**
   * The first error since the last call, in one line, or an empty string.
   */
  static std::string TakeError();
};

#endif
