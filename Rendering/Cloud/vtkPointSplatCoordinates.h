// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Texture coordinates of splats, and how these change over each, so that a texture whose texels are
// finer than the points' spacing is where a mesh of the points has it.
//
// 1. For each splat the nearest points are found, and their offsets are taken to its axes.
// 2. The linear change that fits their coordinates best, by least squares whose weights fall with
//    the squared distance, and faster out of the splat's plane: of a folded splat's parts each has
//    that of its own face.
// 3. Where that does not fit, coordinates jump, as at a seam or from chart to chart of an atlas, or
//    turn sharply. Then pairs of neighbours each propose a change; that with the least typical
//    error, a quantile of all (Rousseeuw 1984, Least median of squares regression), tells whose
//    coordinates go on from the point's own, and these alone are fitted. Coordinates that jump by
//    whole numbers, as those of textures that repeat, are tried without the jump too.
//
// A splat's code, four words: the two coordinates, floats, or NaN where it has none; their changes
// along its first and second axis, by its length, two halves each.
#ifndef vtkPointSplatCoordinates_h
#define vtkPointSplatCoordinates_h

#include "vtkType.h"

#include "vtkPointSplattingABI.h"

#include <cstddef>
#include <cstdint>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
VTK_ABI_NAMESPACE_END

class vtkPointSplatCoordinates
{
public:
  /// The first of two words of what has no coordinates.
  static constexpr uint32_t None = 0x7fc00000u;
  static constexpr size_t Words = 4;

  /**
   * Packed splats of a block (vtkPointSplatCloud.h).
   */
  struct Splats
  {
    const uint32_t* Data;
    size_t WordsPerSplat;
    vtkIdType Count;
    bool Circular;
  };

  /// coordinates: of one to three components, of which two count; codes: Words a splat.
  static void Make(const Splats& splats, vtkDataArray* coordinates, uint32_t* codes);
  /// The directions of tangents, 3 components, as CodeNormal() has them, a word a splat.
  static void MakeTangents(const Splats& splats, vtkDataArray* tangents, uint32_t* codes);
};

#endif
