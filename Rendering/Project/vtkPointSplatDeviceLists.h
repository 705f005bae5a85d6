// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Which splats each tile of the image has, made by compute shaders on the device that has the boxes.
//
// 1. Each splat is counted in the lists of the tiles that its box touches, one a kind; wide ones in
//    those of blocks of 16 x 16 tiles (vtkPointSplatBinCS.glsl).
// 2. The counts are summed up, in parts (vtkPointSplatScanCS.glsl); how many entries there are comes
//    back to the processor, which makes room for them.
// 3. Each splat is put into its lists, in any order, and each list of more than one entry is sorted
//    (vtkPointSplatSortListsCS.glsl), so that lists are the same in each run.
#ifndef vtkPointSplatDeviceLists_h
#define vtkPointSplatDeviceLists_h

#include "vtkPointSplatBuffer.h"
#include "vtkPointSplatProgram.h"
#include "vtkPointSplatTileLists.h"

#include <array>
#include <string>

class vtkPointSplatDeviceLists
{
public:
  /// Counts; triangles: whether there are some, which have lists of their own. False, with GetError(), where a shader does not compile.
  bool Count(const vtkPointSplatBuffer& boxes, size_t splats, const vtkPointSplatTileGrid& grid,
    bool triangles);
  /// Entries of all lists, after Count().
  size_t GetNumberOfEntries() const { return this->Entries; }
  /// Makes the lists of what was counted.
  void Fill(const vtkPointSplatBuffer& boxes, vtkPointSplatBuffer& lists);

  /// A texture (R32UI): where each kind of each tile, and then each block, begins, and the end.
  GLuint GetStarts() const { return this->Starts.GetTexture(); }
  vtkIdType GetMemorySize() const
  {
    return this->Counts.GetSize() + this->Starts.GetSize() + this->Sums.GetSize() +
      this->Sortables.GetSize();
  }
  const std::string& GetError() const { return this->Error; }
  void Release();

private:
  struct Stage
  {
    vtkPointSplatProgram* Program;
    const char* File;
    const char* Defines;
  };
  std::array<Stage, 6> GetStages();
  bool Build();
  void Run(vtkPointSplatProgram& program, const vtkPointSplatBuffer& boxes);
  void SumUp();

  vtkPointSplatProgram CountProgram;
  vtkPointSplatProgram PartsProgram;
  vtkPointSplatProgram SumsProgram;
  vtkPointSplatProgram ScanProgram;
  vtkPointSplatProgram FillProgram;
  vtkPointSplatProgram SortProgram;
  vtkPointSplatBuffer Counts{ GL_R32UI };
  vtkPointSplatBuffer Starts{ GL_R32UI };
  vtkPointSplatBuffer Sums;
  vtkPointSplatBuffer Sortables{ GL_R32UI }; // how many, and which lists have something to sort
  vtkPointSplatTileGrid Grid;
  int Kinds = 3; // that have a list in each tile
  size_t Splats = 0;
  GLuint ListCount = 0;
  size_t Entries = 0;
  std::string Error;
};

#endif
