// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatLightMaps.h"

#include "vtkPointSplatProgram.h"
#include "vtkPointSplatUnits.h"

//------------------------------------------------------------------------------
std::string vtkPointSplatLightMaps::GetDefines(bool depths) const
{
  return "#define LIGHT_MAPS " + std::to_string(this->Lights.size()) + "\n" +
    (depths && this->HasDepths ? "#define OPAQUE_LIGHT_MAPS\n" : "") +
    (this->HasLayers ? "#define LIGHT_MAP_LAYERS " + std::to_string(MostLayers) + "\n" : "");
}

//------------------------------------------------------------------------------
void vtkPointSplatLightMaps::Bind(
  const glm::dmat4& WCVC, vtkPointSplatUnits& units, vtkPointSplatProgram& program)
{
  const glm::dmat4 VCWC = glm::inverse(WCVC);
  std::vector<glm::vec4> texels;
  for (const vtkPointSplatLightMap& map : this->Maps)
  {
    const glm::mat4 rows(glm::transpose(map.WCLC * VCWC));
    texels.insert(
      texels.end(), { rows[0], rows[1], rows[2], map.Place, map.Size, map.Kind });
  }
  if (texels != this->Texels || !this->Table.IsMade())
  {
    // Uploading binds the texture to the active unit, which must be this one's own.
    units.Bind(program, "LightMapTable", GL_TEXTURE_BUFFER, this->Table.GetTexture());
    this->Table.Upload(texels);
    this->Texels = texels;
  }
  std::vector<glm::vec4> lights;
  for (const Light& light : this->Lights)
  {
    lights.emplace_back(light.First, light.Samples, light.Faces, 0.0f);
  }
  program.Set("LightMapsOf", lights);
  units.Bind(program, "LightMapTable", GL_TEXTURE_BUFFER, this->Table.GetTexture());
  units.Bind(program, "LightMapDepths", GL_TEXTURE_2D_ARRAY,
    this->HasDepths ? this->Depths.Get() : 0);
  units.Bind(program, "LightMapLayers", GL_TEXTURE_2D_ARRAY,
    this->HasLayers ? this->Layers.Get() : 0);
}

//------------------------------------------------------------------------------
void vtkPointSplatLightMaps::Release()
{
  this->Depths.Release();
  this->Layers.Release();
  this->Table.Release();
  this->Texels.clear();
}
