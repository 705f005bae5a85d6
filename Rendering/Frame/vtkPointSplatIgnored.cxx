// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatIgnored.h"

#include "vtkActor.h"
#include "vtkObject.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"

#include <utility>

namespace
{
/// The names, or nothing where all is shown.
std::string NamesOf(vtkActor* actor, bool points)
{
  vtkProperty* property = actor->GetProperty();
  vtkShaderProperty* shaders = actor->GetShaderProperty();
  const std::pair<bool, const char*> all[] = {
    { actor->GetTexture() || property->GetNumberOfTextures() > 0, "textures" },
    { property->GetInterpolation() == VTK_PBR && property->GetAnisotropy() != 0.0, "Anisotropy" },
    { property->GetInterpolation() == VTK_FLAT && points, "flat interpolation" },
    { property->GetEdgeVisibility() != 0, "EdgeVisibility" },
    { property->GetVertexVisibility() != 0, "VertexVisibility" },
    { shaders->GetNumberOfShaderReplacements() > 0 || shaders->HasVertexShaderCode() ||
        shaders->HasFragmentShaderCode(),
      "shader code of the actor's own" },
  };
  std::string names;
  for (const auto& one : all)
  {
    if (one.first)
    {
      names += (names.empty() ? "" : ", ") + std::string(one.second);
    }
  }
  return names;
}
}

//------------------------------------------------------------------------------
void vtkPointSplatIgnored::Warn(
  vtkObject* mapper, vtkActor* actor, bool points, std::set<std::string>& warned)
{
  const std::string names = NamesOf(actor, points);
  if (!names.empty() && warned.insert(names).second)
  {
    vtkWarningWithObjectMacro(mapper,
      << "Splats do not show these properties of the actor, which have no effect: " << names << ".");
  }
}
