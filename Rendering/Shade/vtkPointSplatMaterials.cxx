// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatMaterials.h"

#include "vtkActor.h"
#include "vtkPointSplatProgram.h"
#include "vtkPointSplatUnits.h"
#include "vtkProperty.h"

#include <limits>

namespace
{
constexpr size_t TexelsPerSlot = 10; // as in vtkPointSplatMaterials.glsl

glm::vec3 Multiply(const double colour[3], double intensity)
{
  return glm::vec3(glm::dvec3(colour[0], colour[1], colour[2]) * intensity);
}
}

//------------------------------------------------------------------------------
void vtkPointSplatMaterials::Upload(const std::vector<Entry>& entries)
{
  std::vector<glm::vec4> texels;
  this->HasColours = this->HasMedia = this->HasDispersion = false;
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
      texels.emplace_back(Multiply(p->GetSpecularColor(), p->GetSpecular()), 0.0f);
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
    low = m.Refracts ? glm::min(low, m.Low) : low;
    high = m.Refracts ? glm::max(high, m.High) : high;
    this->HasMedia = this->HasMedia || m.Refracts;
    this->HasDispersion = this->HasDispersion || (m.Refracts && m.Dispersion > 0.0);
  }
  for (size_t i = TexelsPerSlot - 1; this->HasMedia && i < texels.size(); i += TexelsPerSlot)
  {
    texels[i].w = static_cast<float>(glm::length(high - low));
  }
  if (texels.size() > TexelsPerSlot && (texels != this->Texels || !this->Table.IsMade()))
  {
    this->Table.Upload(texels);
  }
  this->Texels = std::move(texels);
  this->Defines =
    std::string(this->Texels.size() == TexelsPerSlot ? "#define ONE_MATERIAL\n" : "") +
    (specular ? "#define SPECULAR\n" : "") + (unlit ? "#define UNLIT\n" : "") +
    (twoSided ? "#define TWO_SIDED\n" : "");
}

//------------------------------------------------------------------------------
std::string vtkPointSplatMaterials::GetDefines(bool gathered) const
{
  return this->Defines + (this->HasColours || gathered ? "#define COLOURED\n" : "");
}

//------------------------------------------------------------------------------
void vtkPointSplatMaterials::Bind(vtkPointSplatUnits& units, vtkPointSplatProgram& program) const
{
  if (this->Texels.size() == TexelsPerSlot)
  {
    program.Set("OneMaterial", this->Texels);
  }
  else
  {
    units.Bind(program, "MaterialTable", GL_TEXTURE_BUFFER, this->Table.GetTexture());
  }
}
