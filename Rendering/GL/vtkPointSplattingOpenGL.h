// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// OpenGL's entry points, by the loader that this build of VTK uses.
#ifndef vtkPointSplattingOpenGL_h
#define vtkPointSplattingOpenGL_h

#include "vtkPointSplattingConfigure.h"

#if PointSplatting_USE_GLAD
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

#endif
// VTK-HeaderTest-Exclude: vtkPointSplattingOpenGL.h
