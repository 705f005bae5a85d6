// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Points are as large as shaders say, until the end of the scope; vtkOpenGLState does not know of
// this.
#ifndef vtkPointSplatPointSizes_h
#define vtkPointSplatPointSizes_h

#include "vtkPointSplattingOpenGL.h"

class vtkPointSplatPointSizes
{
public:
  vtkPointSplatPointSizes()
    : Was(glIsEnabled(GL_PROGRAM_POINT_SIZE))
  {
    glEnable(GL_PROGRAM_POINT_SIZE);
  }
  ~vtkPointSplatPointSizes()
  {
    if (!this->Was)
    {
      glDisable(GL_PROGRAM_POINT_SIZE);
    }
  }
  vtkPointSplatPointSizes(const vtkPointSplatPointSizes&) = delete;
  void operator=(const vtkPointSplatPointSizes&) = delete;

private:
  GLboolean Was;
};

#endif
