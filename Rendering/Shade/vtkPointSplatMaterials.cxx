// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatMaterials.h"

#include "vtkActor.h"
#include "vtkPointSplatProgram.h"
#include "vtkPointSplatUnits.h"
#include "vtkProperty.h"

#include <algorithm>
#include <limits>

namespace
{
constexpr size_t AbsorptionTexel = 9;

void AddPhysical(vtkProperty* property, bool tangents, std::vector<glm::vec4>& texels)
{
  if (property->GetInterpolation() != VTK_PBR)
  {
    texels.resize(texels.size() + 5, glm::vec4(0.0f));
    return;
  }
  const double* tint = property->GetEdgeTint();
  const double* coat = property->GetCoatColor();
  texels.emplace_back(property->GetMetallic(), property->GetRoughness(),
    property->ComputeReflectanceOfBaseLayer(),
    1.0 + vtkProperty::ComputeReflectanceFromIOR(property->GetCoatIOR(), 1.0));
  texels.emplace_back(tint[0], tint[1], tint[2], property->GetCoatStrength());
  texels.emplace_back(coat[0], coat[1], coat[2], property->GetCoatRoughness());
  const double* emission = property->GetEmissiveFactor();
  texels.emplace_back(emission[0], emission[1], emission[2], property->GetOcclusionStrength());
  texels.emplace_back(property->GetAnisotropy(),
    property->GetTexture("albedoTex") ? 1.0f : 0.0f,
    tangents && property->GetAnisotropy() != 0.0 ? 1.0f : 0.0f, 0.0f);
}

glm::vec3 Multiply(const double colour[3], double intensity)
{
  return glm::vec3(glm::dvec3(colour[0], colour[1], colour[2]) * intensity);
}
}

//------------------------------------------------------------------------------
size_t vtkPointSplatMaterials::GetTexelsPerSlot() const
{
  return this->HasPhysical ? 16 : 11; // as in vtkPointSplatMaterials.glsl
}

//------------------------------------------------------------------------------
void vtkPointSplatMaterials::Upload(const std::vector<Entry>& entries)
{
  std::vector<glm::vec4> texels;
  this->HasColours = this->HasMedia = this->HasDispersion = false;
  this->HasPhysical = std::any_of(entries.begin(), entries.end(), [](const Entry& entry) {
    return entry.Actor->GetProperty()->GetInterpolation() == VTK_PBR;
  });
  const size_t perSlot = this->GetTexelsPerSlot();
  bool specular = false;
  bool unlit = false;
  bool twoSided = false;
  glm::dvec3 low(std::numeric_limits<double>::max());
  glm::dvec3 high(-low);
  for (const Entry& entry : entries)
  {
    // VTK ignores the back-face property where scalars colour the surface.
    vtkProperty* front = entry.Actor->GetProperty();
    vtkProperty* back = entry.Actor->GetBackfaceProperty() && !entry.HasColours
      ? entry.Actor->GetBackfaceProperty()
      : front;
    for (vtkProperty* p : { front, back })
    {
      texels.emplace_back(Multiply(p->GetAmbientColor(), p->GetAmbient()),
        entry.HasOwnOpacity ? 1.0 : p->GetOpacity());
      texels.emplace_back(Multiply(p->GetDiffuseColor(), p->GetDiffuse()), p->GetSpecularPower());
      texels.emplace_back(
        Multiply(p->GetSpecularColor(), p->GetSpecular()), entry.Receives ? 1.0 : 0.0);
      texels.emplace_back(p->GetAmbient(), p->GetDiffuse(), front->GetLighting() ? 1.0 : 0.0,
        entry.HasColours ? 1.0 : 0.0);
      specular = specular || p->GetSpecular() > 0.0;
    }
    unlit = unlit || !front->GetLighting();
    twoSided = twoSided || front != back;
    this->HasColours = this->HasColours || entry.HasColours;
    const vtkPointSplatMedium& m = entry.Medium;
    texels.emplace_back(m.Index, 0.5 * m.Index * m.Dispersion, glm::length(m.High - m.Low),
      m.Refracts ? 1.0 : 0.0);
    texels.emplace_back(glm::vec3(m.Absorption), 0.0f);
    texels.emplace_back(Multiply(front->GetEdgeColor(), 1.0),
      (entry.HasLook ? 1.0f : 0.0f) + (entry.HasEdges ? 2.0f : 0.0f));
    if (this->HasPhysical)
    {
      AddPhysical(front, entry.HasTangents, texels);
    }
    low = m.Refracts ? glm::min(low, m.Low) : low;
    high = m.Refracts ? glm::max(high, m.High) : high;
    this->HasMedia = this->HasMedia || m.Refracts;
    this->HasDispersion = this->HasDispersion || (m.Refracts && m.Dispersion > 0.0);
  }
  for (size_t i = AbsorptionTexel; this->HasMedia && i < texels.size(); i += perSlot)
  {
    texels[i].w = static_cast<float>(glm::length(high - low));
  }
  if (texels.size() > perSlot && (texels != this->Texels || !this->Table.IsMade()))
  {
    this->Table.Upload(texels);
  }
  this->Texels = std::move(texels);
  this->Defines =
    std::string(this->Texels.size() == perSlot ? "#define ONE_MATERIAL\n" : "") +
    (specular ? "#define SPECULAR\n" : "") + (unlit ? "#define UNLIT\n" : "") +
    (twoSided ? "#define TWO_SIDED\n" : "") + (this->HasPhysical ? "#define PHYSICAL\n" : "");
}

//------------------------------------------------------------------------------
std::string vtkPointSplatMaterials::GetDefines(bool gathered) const
{
  return this->Defines + (this->HasColours || gathered ? "#define COLOURED\n" : "");
}

//------------------------------------------------------------------------------
void vtkPointSplatMaterials::Bind(vtkPointSplatUnits& units, vtkPointSplatProgram& program) const
{
  if (this->Texels.size() == this->GetTexelsPerSlot())
  {
    program.Set("OneMaterial", this->Texels);
  }
  else
  {
    units.Bind(program, "MaterialTable", GL_TEXTURE_BUFFER, this->Table.GetTexture());
  }
}
