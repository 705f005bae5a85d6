// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// One triangle over the viewport, for passes over an image; its vertex shader is
// vtkPointSplatScreenVS.glsl. Or what a vertex shader finds places for.
#ifndef vtkPointSplatScreen_h
#define vtkPointSplatScreen_h

#include "vtkPointSplatHandle.h"
#include "vtkPointSplatPointSizes.h"

class vtkPointSplatScreen
{
public:
  void Draw() { this->Draw(GL_TRIANGLES, 3); }
  /// Or so many rectangles, of two triangles each.
  void DrawRectangles(int count) { this->Draw(GL_TRIANGLES, 6 * count); }
  /// Or so many points.
  void DrawPoints(int count)
  {
    const vtkPointSplatPointSizes sizes;
    this->Draw(GL_POINTS, count);
  }
  void Release() { this->VertexArray.Release(); }

private:
  void Draw(GLenum mode, int count)
  {
    this->VertexArray.Make();
    glBindVertexArray(this->VertexArray.Get());
    glDrawArrays(mode, 0, count);
    glBindVertexArray(0);
  }

  vtkPointSplatHandle VertexArray{ vtkPointSplatHandle::VertexArray };
};

#endif
