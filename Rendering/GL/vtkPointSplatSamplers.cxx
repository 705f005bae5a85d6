// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatSamplers.h"

#include "vtkPointSplatProgram.h"
#include "vtkPointSplatUnits.h"

#include <string>
#include <vector>

namespace
{
// No compute program has more textures.
constexpr size_t Places = 16;

/// The context whose places have all the same sampler.
vtkPointSplatContext& Prepared()
{
  static thread_local vtkPointSplatContext context;
  return context;
}
}

//------------------------------------------------------------------------------
void vtkPointSplatSamplers::Prepare()
{
  const vtkPointSplatContext& entered = vtkPointSplatContext::Entered();
  if (Prepared() == entered)
  {
    return;
  }
  vtkPointSplatProgram program;
  if (vtkPointSplatContext::IsSoftware() &&
    program.Build({ { GL_COMPUTE_SHADER, "vtkPointSplatSamplersCS" } },
      "#define PLACES " + std::to_string(Places) + "\n"))
  {
    GLint before = 0;
    glGetIntegerv(GL_CURRENT_PROGRAM, &before);
    program.Use();
    vtkPointSplatUnits units(entered.GetWindow());
    // No texture has the driver's own in its place, at all places by the same unit.
    program.Set("Textures", std::vector<int>(Places, units.Bind(program, "Textures", GL_TEXTURE_2D, 0)));
    glDispatchCompute(1, 1, 1);
    glUseProgram(static_cast<GLuint>(before));
  }
  Prepared() = entered;
}

//------------------------------------------------------------------------------
void vtkPointSplatSamplers::Forget()
{
  Prepared() = vtkPointSplatContext();
}
