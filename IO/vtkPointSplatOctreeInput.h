// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A file of vtkPointSplatOctreeWriter's that is open to be read, with its tree.
#ifndef vtkPointSplatOctreeInput_h
#define vtkPointSplatOctreeInput_h

#include "vtkPointSplatHDF5.h"
#include "vtkPointSplatOctreeCut.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

class vtkPointSplatOctreeInput
{
public:
  /// Opens it, and reads what its root says.
  explicit vtkPointSplatOctreeInput(const char* name);

  /// What is wrong; empty where all is well.
  const std::string& GetError() const { return this->Error; }
  /// Whether the name still means this file, which nobody has written since.
  bool Is(const char* name) const;
  /// Reads the blocks of all pieces, once. False: the file is damaged.
  bool ReadTree();
  const vtkPointSplatOctreeCut& GetTree() const { return this->Tree; }

  hid_t GetData() const { return this->Data; }
  long long GetNumberOfPieces() const { return this->Pieces[0]; }
  long long GetNumberOfPoints() const { return this->Points[0]; }
  const std::vector<double>& GetBounds() const { return this->Bounds; }

private:
  /**
   * By which a file that was written anew is known.
   */
  struct Stamp
  {
    std::filesystem::file_time_type Time;
    std::uintmax_t Size;
  };
  static Stamp StampOf(const std::string& name);

  const std::string Name;
  const Stamp Opened;
  vtkPointSplatHDF5::Handle Data;
  std::string Error;
  std::vector<long long> Pieces{ 0 };
  std::vector<long long> Points{ 0 };
  std::vector<double> Bounds = std::vector<double>(6);
  bool HasTree = false;
  // After the file, so that its groups are closed before that.
  vtkPointSplatOctreeCut Tree;
};

#endif
