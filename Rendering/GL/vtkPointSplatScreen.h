// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// One triangle over the viewport, for passes over an image; its vertex shader is
// vtkPointSplatScreenVS.glsl.
#ifndef vtkPointSplatScreen_h
#define vtkPointSplatScreen_h

#include "vtkPointSplatHandle.h"

class vtkPointSplatScreen
{
public:
  void Draw()
  {
    this->VertexArray.Make();
    glBindVertexArray(this->VertexArray.Get());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
  }
  void Release() { this->VertexArray.Release(); }

private:
  vtkPointSplatHandle VertexArray{ vtkPointSplatHandle::VertexArray };
};

#endif
