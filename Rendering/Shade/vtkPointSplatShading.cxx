// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatShading.h"

#include "vtkPointSplatProgram.h"
#include "vtkPointSplatUnits.h"

//------------------------------------------------------------------------------
std::string vtkPointSplatShading::GetDefines(bool gathered) const
{
  return this->Lights->GetDefines() + this->Materials->GetDefines(gathered) +
    (this->Radiance ? this->Radiance->GetDefines() : std::string()) +
    (this->LightMaps ? this->LightMaps->GetDefines(false) : std::string()) +
    (this->Reflects() ? "#define REFLECTION\n" + this->Environment->GetDefines() : std::string());
}

//------------------------------------------------------------------------------
void vtkPointSplatShading::Bind(
  vtkPointSplatUnits& units, vtkPointSplatProgram& program, int factors) const
{
  vtkPointSplatShading::SetRay(this->View, program);
  this->Lights->SetUniforms(program, factors);
  this->Materials->Bind(units, program);
  if (this->Radiance)
  {
    this->Radiance->Bind(this->View, units, program);
  }
  if (this->LightMaps)
  {
    this->LightMaps->Bind(this->View.WCVC, units, program);
  }
  if (this->Reflects())
  {
    this->Environment->Bind(this->View, program);
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatShading::Unbind() const
{
  if (this->Reflects())
  {
    this->Environment->Unbind();
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatShading::SetRay(const vtkPointSplatView& view, vtkPointSplatProgram& program)
{
  program.Set("NearDistance", static_cast<float>(view.Near));
  program.Set("PixelInverse",
    glm::inverse(glm::mat2(view.PixelX.x, view.PixelY.x, view.PixelX.y, view.PixelY.y)));
  program.Set("PixelOffset",
    glm::vec4(view.PixelX.z, view.PixelY.z, view.PixelX.w, view.PixelY.w));
  program.Set("PixelX", view.PixelX);
  program.Set("PixelY", view.PixelY);
  program.Set("PixelW", view.PixelW);
  program.Set("PixelZ", view.PixelZ);
  program.Set("Parallel", view.Parallel);
}
