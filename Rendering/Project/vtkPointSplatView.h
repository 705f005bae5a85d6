// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Where a renderer looks from and draws to, as the stages take it.
#ifndef vtkPointSplatView_h
#define vtkPointSplatView_h

#include <glm/glm.hpp>

#include "vtkType.h"

#include "vtkPointSplattingABI.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkMatrix4x4;
class vtkRenderer;
VTK_ABI_NAMESPACE_END

class vtkPointSplatProgram;

struct vtkPointSplatView
{
  glm::ivec2 Origin{ 0, 0 }; // of the viewport in the framebuffer, pixels
  glm::ivec2 Size{ 0, 0 };
  glm::dmat4 WCVC{ 1.0 }; // world to view coordinates
  // View coordinates to x w and y w in pixels of the viewport, w, and z w.
  glm::vec4 PixelX{ 0.0f };
  glm::vec4 PixelY{ 0.0f };
  glm::vec4 PixelW{ 0.0f };
  glm::vec4 PixelZ{ 0.0f };
  double Near = 0.0;
  double Far = 1.0;
  bool Parallel = false;

  /**
   * Of the renderer's camera and the viewport that OpenGL has now: render passes
   * draw to viewports of their own.
   */
  static vtkPointSplatView Current(vtkRenderer* renderer);

  /// A part of the viewport, pixels, as a view of its own.
  vtkPointSplatView Part(const glm::ivec2& first, const glm::ivec2& size) const;

  bool operator==(const vtkPointSplatView& other) const;
  bool operator!=(const vtkPointSplatView& other) const { return !(*this == other); }

  /**
   * The pixels that a box in world coordinates covers, grown by a margin in
   * world units: first x, y, last x, y; the whole viewport where the box
   * reaches behind the eye.
   */
  glm::ivec4 Cover(const glm::dmat4& MCWC, const double bounds[6], double margin) const;

  /**
   * World units to a pixel, where a box in world coordinates is nearest to the eye, and where
   * it is farthest.
   */
  glm::dvec2 PixelSizes(const glm::dmat4& MCWC, const double bounds[6]) const;

  /// A pixel's width in world units: at depth 0, and its growth with the depth.
  glm::vec2 GetPixelSize() const;
  /// Sets how directions follow from pixels: RayOffset and RayScale.
  void SetPixelRays(vtkPointSplatProgram& program) const;

  static glm::dmat4 Matrix(vtkMatrix4x4* matrix);
};

#endif
