// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Draws an item's splats by the rasteriser, with a program in use whose vertex shader is
// vtkPointSplatQuadVS (a quad a splat, by instances) or vtkPointSplatPointVS (a pixel a point).
#ifndef vtkPointSplatQuads_h
#define vtkPointSplatQuads_h

#include "vtkPointSplatItem.h"

class vtkPointSplatProgram;

class vtkPointSplatQuads
{
public:
  /// Sets the uniforms of both vertex shaders. tagMask: the bits of tags in coded depths.
  static void SetUniforms(vtkPointSplatProgram& program, const vtkPointSplatItem& item,
    const vtkPointSplatView& view, unsigned int tagMask);

  /**
   * Draws all splats that are in view: with these ids, or their own.
   */
  static void Draw(const vtkPointSplatItem& item, vtkPointSplatCloud::Buffers& buffers,
    const vtkPointSplatBuffer* ids);
  /// Draws a run of splats as quads.
  static void DrawRun(const vtkPointSplatItem& item, vtkPointSplatCloud::Buffers& buffers,
    vtkIdType first, vtkIdType count);

private:
  static void Bind(const vtkPointSplatItem& item, vtkPointSplatCloud::Buffers& buffers,
    const vtkPointSplatBuffer* ids, vtkIdType first);
};

#endif
