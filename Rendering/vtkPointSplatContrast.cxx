// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatContrast.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkPointSplatCloud.h"
#include "vtkPointSplatMapper.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <vector>

namespace
{
/// Of all lights together; less than one counts as one.
double Intensity(vtkRenderer* renderer)
{
  double sum = 0.0;
  vtkCollectionSimpleIterator it;
  renderer->GetLights()->InitTraversal(it);
  while (vtkLight* light = renderer->GetLights()->GetNextLight(it))
  {
    sum += light->GetSwitch() ? std::max(light->GetIntensity(), 0.0) : 0.0;
  }
  return std::max(sum, 1.0);
}

glm::dvec3 Vector(const double* colour)
{
  return { colour[0], colour[1], colour[2] };
}

double Rms(const glm::dvec3& colour)
{
  return glm::length(colour) / std::sqrt(3.0);
}
}

//------------------------------------------------------------------------------
double vtkPointSplatContrast::Of(vtkRenderer* renderer)
{
  if (renderer->GetTexturedBackground() || renderer->GetLayer() > 0 ||
    renderer->GetPreserveColorBuffer())
  {
    return 1.0;
  }
  std::vector<glm::dvec3> colours = { Vector(renderer->GetBackground()) };
  if (renderer->GetGradientBackground())
  {
    colours.push_back(Vector(renderer->GetBackground2()));
  }
  const double intensity = Intensity(renderer);
  vtkCollectionSimpleIterator it;
  renderer->GetViewProps()->InitTraversal(it);
  while (vtkProp* prop = renderer->GetViewProps()->GetNextProp(it))
  {
    if (!prop->GetVisibility() || vtkActor2D::SafeDownCast(prop))
    {
      continue;
    }
    vtkActor* actor = vtkActor::SafeDownCast(prop);
    auto mapper = actor ? vtkPointSplatMapper::SafeDownCast(actor->GetMapper()) : nullptr;
    if (!mapper || (mapper->UpdateCloud() && mapper->GetCloud()->HasColours()))
    {
      return 1.0;
    }
    for (vtkProperty* property : { actor->GetProperty(), actor->GetBackfaceProperty() })
    {
      if (property)
      {
        const glm::dvec3 dark = property->GetAmbient() * Vector(property->GetAmbientColor());
        colours.push_back(glm::min(dark, 1.0));
        colours.push_back(glm::min(
          dark + intensity * property->GetDiffuse() * Vector(property->GetDiffuseColor()), 1.0));
      }
    }
  }
  double contrast = 0.0;
  for (const glm::dvec3& a : colours)
  {
    for (const glm::dvec3& b : colours)
    {
      contrast = std::max(contrast, Rms(a - b));
    }
  }
  return contrast;
}

//------------------------------------------------------------------------------
double vtkPointSplatContrast::OfLight(vtkActor* actor, vtkPointSplatMapper* mapper)
{
  vtkProperty* property = actor->GetProperty();
  return property->GetDiffuse() *
    (mapper->GetCloud()->HasColours() ? 1.0 : Rms(Vector(property->GetDiffuseColor())));
}
