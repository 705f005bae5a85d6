// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Which patches of an item's mesh a view shows as triangles (Guennebaud, Barthe, Paulin 2006, section
// 5.2): those whose edges are longer in the image than the item says.
//
// 1. Patches in view are taken as triangles, or left to who draws splats.
// 2. When all are known, each triangle that crosses from patch to patch is drawn once, by the first of
//    its patches that is taken, so that splats and triangles overlap where they meet (section 5.1);
//    those beside patches that are not taken are marked. Splats without a triangle are drawn as well.
#ifndef vtkPointSplatPatches_h
#define vtkPointSplatPatches_h

#include "vtkPointSplatPixelSize.h"

#include <vector>

class vtkPointSplatPatches
{
public:
  vtkPointSplatPatches(const vtkPointSplatView& view, const vtkPointSplatItem& item);

  /// Whether a block of levels, or a patch, is to be shown by triangles.
  bool IsMagnified(const vtkPointSplatTriangles::Extent& extent) const;
  /// Takes a patch as triangles.
  void Take(uint32_t patch);
  /// Adds what was taken.
  void AddTo(vtkPointSplatRuns& chosen) const;

private:
  const vtkPointSplatTriangles& Triangles;
  vtkPointSplatPixelSize PixelSize;
  double Pixels;
  std::vector<uint32_t> Taken;
  std::vector<bool> IsTaken; // of all patches
};

#endif
