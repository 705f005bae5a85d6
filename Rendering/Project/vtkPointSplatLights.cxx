// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatLights.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkPointSplatProgram.h"
#include "vtkPointSplattingConfigure.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace
{
glm::dvec3 Vector(const double values[3])
{
  return { values[0], values[1], values[2] };
}

bool IsFinite(const glm::dvec3& v)
{
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
}

//------------------------------------------------------------------------------
bool vtkPointSplatLights::Casts(vtkLight* light)
{
  return light->GetSwitch() && !light->LightTypeIsHeadlight() &&
    IsFinite(Vector(light->GetTransformedPosition())) &&
    IsFinite(Vector(light->GetTransformedFocalPoint()));
}

//------------------------------------------------------------------------------
std::vector<vtkLight*> vtkPointSplatLights::Of(vtkRenderer* renderer, bool casting)
{
  std::vector<vtkLight*> lights;
  vtkCollectionSimpleIterator it;
  renderer->GetLights()->InitTraversal(it);
  while (vtkLight* light = renderer->GetLights()->GetNextLight(it))
  {
    if (light->GetSwitch() && (!casting || vtkPointSplatLights::Casts(light)))
    {
      lights.push_back(light);
    }
  }
  return lights;
}

//------------------------------------------------------------------------------
vtkPointSplatLights::vtkPointSplatLights(vtkRenderer* renderer, const vtkPointSplatView& view)
{
  const std::vector<vtkLight*> lights = vtkPointSplatLights::Of(renderer, false);
  for (vtkLight* light : lights)
  {
    const glm::dvec3 position = Vector(light->GetTransformedPosition());
    const glm::dvec3 ray = Vector(light->GetTransformedFocalPoint()) - position;
    const bool positional = light->GetPositional() != 0;
    this->Level = std::max(this->Level, positional    ? 3
        : light->LightTypeIsHeadlight() && lights.size() == 1 ? 1
                                                              : 2);
    this->Casting.push_back(vtkPointSplatLights::Casts(light));
    this->Colours.emplace_back(
      Vector(light->GetDiffuseColor()) * light->GetIntensity(), positional ? 1.0 : 0.0);
    this->Directions.emplace_back(glm::normalize(glm::dmat3(view.WCVC) * ray), -1.0);
    this->Positions.emplace_back(
      glm::dvec3(view.WCVC * glm::dvec4(position, 1.0)), light->GetConeAngle());
    this->Attenuations.emplace_back(Vector(light->GetAttenuationValues()), light->GetExponent());
  }
}

//------------------------------------------------------------------------------
std::string vtkPointSplatLights::GetDefines() const
{
  return "#define LIGHT_LEVEL " + std::to_string(this->Level) + "\n#define LIGHT_COUNT " +
    std::to_string(this->Colours.size()) +
    (PointSplatting_HAVE_PHYSICAL_DIRECTIONS ? "\n#define PHYSICAL_DIRECTIONS\n" : "\n");
}

//------------------------------------------------------------------------------
void vtkPointSplatLights::SetUniforms(vtkPointSplatProgram& program, int factors) const
{
  std::vector<glm::vec4> directions = this->Directions;
  int casting = 0;
  for (size_t i = 0; i < directions.size(); ++i)
  {
    if (this->Casting[i] && casting < factors)
    {
      directions[i].w = static_cast<float>(casting++);
    }
  }
  program.Set("LightColour", this->Colours);
  program.Set("LightDirection", directions);
  program.Set("LightPosition", this->Positions);
  program.Set("LightAttenuation", this->Attenuations);
}
