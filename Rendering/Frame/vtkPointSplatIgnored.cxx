// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatIgnored.h"

#include "vtkActor.h"
#include "vtkPointSplatFrame.h"
#include "vtkPointSplatTextures.h"
#include "vtkProperty.h"
#include "vtkRenderer.h" // For the frame's weak pointer
#include "vtkShaderProperty.h"

#include <utility>
#include <vector>

namespace
{
using Names = std::vector<std::pair<bool, std::string>>;

/// How the splats are drawn, where that is not the one way that shows all looks.
std::string WayWithoutLooks(const vtkPointSplatReport& report)
{
  const std::string method = report.Method;
  const std::string transparency = report.Transparency;
  const bool sorted = transparency == "sorted" || transparency == "nearest-exact";
  const bool quads = std::string(report.Projection) == "quads";
  return method == "image-space" ? " with Method ImageSpace"
    : method == "deferred"       ? " with Method Deferred"
    : quads                      ? " where splats are drawn by quads"
    : sorted                     ? " of sorted layers"
                                 : "";
}

/// What of textures, tangents and edges is not shown.
void AddLooks(vtkActor* actor, const vtkPointSplatCloud& cloud, const std::string& way, Names& all)
{
  vtkProperty* property = actor->GetProperty();
  const vtkPointSplatTextures textures = vtkPointSplatTextures::Of(actor, true);
  const bool some = !textures.GetAll().empty();
  const bool hasWay = way.empty();
  const size_t many = property->GetAllTextures().size() + (actor->GetTexture() ? 1 : 0);
  all.emplace_back(some && !hasWay, "textures" + way);
  all.emplace_back(some && hasWay && !cloud.HasCoordinates(),
    "textures, since the points have no texture coordinates (TCoords)");
  all.emplace_back(hasWay && many > textures.GetAll().size() &&
      textures.Colours.size() == vtkPointSplatTextures::MostColours,
    "textures of colours but for the first four");
  all.emplace_back(textures.IsAnisotropic && !hasWay, "Anisotropy" + way);
  all.emplace_back(textures.IsAnisotropic && hasWay && !cloud.HasTangents(),
    "Anisotropy, since the points have no tangents");
  all.emplace_back(
    (textures.Normal || textures.CoatNormal) && hasWay && !cloud.HasTangents(),
    "maps of normals, since the points have no tangents");
  all.emplace_back(property->GetEdgeVisibility() && !hasWay, "EdgeVisibility" + way);
}

/// The names, or nothing where all is shown.
std::string NamesOf(
  vtkActor* actor, const vtkPointSplatCloud& cloud, const vtkPointSplatReport& report)
{
  vtkProperty* property = actor->GetProperty();
  vtkShaderProperty* shaders = actor->GetShaderProperty();
  Names all;
  AddLooks(actor, cloud, WayWithoutLooks(report), all);
  all.emplace_back(property->GetInterpolation() == VTK_FLAT &&
      report.Settings.Method == vtkPointSplatSettings::ImageSpace,
    "flat interpolation");
  all.emplace_back(property->GetVertexVisibility() != 0, "VertexVisibility");
  all.emplace_back(shaders->GetNumberOfShaderReplacements() > 0 ||
      shaders->HasVertexShaderCode() || shaders->HasFragmentShaderCode(),
    "shader code of the actor's own");
  std::string names;
  for (const auto& one : all)
  {
    names += one.first ? (names.empty() ? "" : "; ") + one.second : "";
  }
  return names;
}
}

//------------------------------------------------------------------------------
void vtkPointSplatIgnored::Warn(vtkObject* mapper, vtkActor* actor, const vtkPointSplatCloud& cloud,
  const vtkPointSplatReport& report, std::set<std::string>& warned)
{
  const std::string names = NamesOf(actor, cloud, report);
  if (!names.empty() && warned.insert(names).second)
  {
    vtkWarningWithObjectMacro(mapper,
      << "Splats do not show these properties of the actor, which have no effect: " << names << ".");
  }
}
