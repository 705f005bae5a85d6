// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Sums up one layer of points that are projected as single pixels (Dobrev, Rosenthal, Linsen 2010,
// section 3.1), by compute shaders and atomic operations, ten times faster than the rasteriser of a
// CPU:
// 1. The nearest depth at each pixel.
// 2. Sums over all points of that layer; those that may have a part in the next layer are listed,
//    so that each layer projects fewer.
// 3. For hardware selection, the ids.
// Buffers beside vtkPointSplatSums: of each item two lists, a count and an index a point.
#ifndef vtkPointSplatPointSums_h
#define vtkPointSplatPointSums_h

#include "vtkPointSplatPeel.h"
#include "vtkPointSplatRequest.h"
#include "vtkPointSplatSums.h"

#include <map>
#include <string>
#include <vector>

class vtkPointSplatPointSums
{
public:
  /// Whether sums of this size fit the context's bounds.
  static bool Fits(const glm::ivec2& size);

  /// empty: whether there was nothing to peel. False, with GetError(), where shaders do not build.
  bool Project(const vtkPointSplatRequest& request, const vtkPointSplatPeel& peel,
    vtkPointSplatSums& sums, bool& empty);

  const std::string& GetError() const { return this->Error; }
  vtkIdType GetMemorySize() const; // bytes
  void Release();

private:
  /// Points that earlier layers have left, and those that this one leaves.
  struct Lists
  {
    vtkPointSplatBuffer Buffers[2];
    vtkIdType Count = 0;
  };
  bool DrawAll(const vtkPointSplatRequest& request, const vtkPointSplatPeel& peel,
    const vtkPointSplatSums& sums, const std::string& file);
  void PrepareLists(const vtkPointSplatRequest& request, int layer);

  std::map<std::string, vtkPointSplatProgram> Programs; // by file and defines
  std::vector<Lists> ItemLists;
  vtkPointSplatBuffer Blocks;
  vtkPointSplatBuffer Found;
  std::string Error;
};

#endif
