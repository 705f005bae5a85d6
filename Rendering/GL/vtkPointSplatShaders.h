// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The embedded text of Shaders/*.glsl.
#ifndef vtkPointSplatShaders_h
#define vtkPointSplatShaders_h

#include <string>

/**
 * A shader's text by its file's name without ".glsl"; nullptr where there is none.
 */
const char* vtkPointSplatShaderText(const std::string& name);

#endif
