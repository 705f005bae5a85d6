// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVPointSplatRegion.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVPointSplatRegionDec.h"
#include "vtkPVPointSplatRegionImpl.h"
#include "vtkProp3D.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkPVPointSplatRegion);

vtkPVPointSplatRegion::vtkPVPointSplatRegion() = default;
vtkPVPointSplatRegion::~vtkPVPointSplatRegion() = default;

//------------------------------------------------------------------------------
void vtkPVPointSplatRegion::SetCamera(vtkCamera* camera)
{
  this->Camera = camera;
}

//------------------------------------------------------------------------------
bool vtkPVPointSplatRegion::PreReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  const std::string uniforms = "//VTK::CustomUniforms::Dec";
  const std::string hook = "//VTK::DepthPeeling::PreColor";
  vtkShaderProgram::Substitute(
    fragmentShader, uniforms, vtkPVPointSplatRegionDec + ("\n" + uniforms));
  vtkShaderProgram::Substitute(
    fragmentShader, hook, vtkPVPointSplatRegionImpl + ("\n  " + hook));
  return true;
}

//------------------------------------------------------------------------------
bool vtkPVPointSplatRegion::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  // A plane's row times a point of the data is the row times the inverse of what takes points from
  // the data to the eye times the point that the eye sees.
  vtkNew<vtkMatrix4x4> toData;
  auto actor = vtkProp3D::SafeDownCast(prop);
  vtkMatrix4x4::Multiply4x4(
    this->Camera->GetViewTransformMatrix(), actor->GetMatrix(), toData);
  toData->Invert();
  float planes[6][4];
  int count = 0;
  for (int side = 0; side < 6 && this->Box.IsValid(); ++side)
  {
    const double bound = this->Box.GetBound(side);
    if (std::abs(bound) >= VTK_DOUBLE_MAX)
    {
      continue;
    }
    const double sign = side % 2 == 0 ? 1.0 : -1.0;
    double row[4];
    for (int column = 0; column < 4; ++column)
    {
      row[column] = sign * toData->GetElement(side / 2, column);
    }
    row[3] -= sign * bound;
    std::copy_n(row, 4, planes[count]);
    ++count;
  }
  if (!this->Box.IsValid())
  {
    const float nothing[4] = { 0.0f, 0.0f, 0.0f, -1.0f };
    std::copy_n(nothing, 4, planes[count++]);
  }
  if (program->IsUniformUsed("RegionPlaneCount"))
  {
    program->SetUniformi("RegionPlaneCount", count);
    program->SetUniform4fv("RegionPlanes", count, planes);
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkPVPointSplatRegion::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  double bounds[6];
  this->Box.GetBounds(bounds);
  os << indent << "Box: " << bounds[0] << " " << bounds[1] << " " << bounds[2] << " " << bounds[3]
     << " " << bounds[4] << " " << bounds[5] << "\n";
  os << indent << "Camera: " << this->Camera << "\n";
}
