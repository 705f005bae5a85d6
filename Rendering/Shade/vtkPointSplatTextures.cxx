// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatTextures.h"

#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkMatrix4x4.h"
#include "vtkPointSplattingConfigure.h"
#include "vtkProperty.h"
#include "vtkTexture.h"
#include "vtkTransform.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

namespace
{
vtkInformationDoubleVectorKey* TransformKey()
{
#if PointSplatting_HAVE_GENERAL_TEXTURE_TRANSFORM
  return vtkProp::GENERAL_TEXTURE_TRANSFORM();
#else
  return vtkProp::GeneralTextureTransform();
#endif
}

glm::mat4 TransformOf(vtkActor* actor)
{
  vtkInformation* keys = actor->GetPropertyKeys();
  vtkTexture* texture = actor->GetTexture();
  const double* elements = nullptr; // row by row
  if (texture && texture->GetTransform())
  {
    elements = &texture->GetTransform()->GetMatrix()->Element[0][0];
  }
  else if (keys && keys->Has(TransformKey()) && keys->Length(TransformKey()) == 16)
  {
    elements = keys->Get(TransformKey());
  }
  glm::mat4 transform(1.0f);
  for (int i = 0; elements && i < 16; ++i)
  {
    transform[i % 4][i / 4] = static_cast<float>(elements[i]);
  }
  return transform;
}
}

//------------------------------------------------------------------------------
vtkPointSplatTextures vtkPointSplatTextures::Of(vtkActor* actor, bool tangents)
{
  vtkPointSplatTextures all;
  vtkProperty* property = actor->GetProperty();
  all.IsPhysical = property->GetInterpolation() == VTK_PBR && property->GetLighting();
  all.IsAnisotropic = tangents && all.IsPhysical && property->GetAnisotropy() != 0.0;
  all.Transform = TransformOf(actor);
  const std::pair<const char*, vtkTexture**> named[] = { { "albedoTex", &all.Albedo },
    { "materialTex", &all.Material }, { "emissiveTex", &all.Emissive },
    { "anisotropyTex", &all.Anisotropy }, { "normalTex", &all.Normal },
    { "coatNormalTex", &all.CoatNormal }, { "brdfTex", nullptr } };
  auto add = [&all](vtkTexture* texture) {
    if (texture && !texture->GetCubeMap() && all.Colours.size() < MostColours)
    {
      all.Colours.push_back(texture);
    }
  };
  add(actor->GetTexture());
  for (const auto& entry : property->GetAllTextures())
  {
    const auto found = std::find_if(std::begin(named), std::end(named),
      [&entry](const auto& one) { return entry.first == one.first; });
    if (found == std::end(named))
    {
      add(entry.second);
    }
    else if (found->second && entry.second && !entry.second->GetCubeMap())
    {
      *found->second = entry.second;
    }
  }
  if (all.IsPhysical)
  {
    all.Colours.clear();
  }
  else
  {
    all.Albedo = all.Material = all.Emissive = nullptr;
  }
  all.Anisotropy = all.IsAnisotropic ? all.Anisotropy : nullptr;
  all.Normal = tangents ? all.Normal : nullptr;
  all.CoatNormal =
    tangents && all.IsPhysical && property->GetCoatStrength() > 0.0 ? all.CoatNormal : nullptr;
  return all;
}

//------------------------------------------------------------------------------
std::vector<vtkTexture*> vtkPointSplatTextures::GetAll() const
{
  std::vector<vtkTexture*> all = this->Colours;
  for (vtkTexture* texture : { this->Albedo, this->Material, this->Emissive, this->Anisotropy,
         this->Normal, this->CoatNormal })
  {
    if (texture)
    {
      all.push_back(texture);
    }
  }
  return all;
}

//------------------------------------------------------------------------------
bool vtkPointSplatTextures::HasMore() const
{
  return this->Albedo || this->Material || this->Emissive || this->NeedTangents();
}

//------------------------------------------------------------------------------
bool vtkPointSplatTextures::Repeat() const
{
  const std::vector<vtkTexture*> all = this->GetAll();
  return !all.empty() &&
    std::all_of(all.begin(), all.end(), [](vtkTexture* texture) { return texture->GetRepeat(); });
}

//------------------------------------------------------------------------------
bool vtkPointSplatTextures::AreTranslucent() const
{
  auto test = [](vtkTexture* texture) { return texture->IsTranslucent() != 0; };
  return std::any_of(this->Colours.begin(), this->Colours.end(), test) ||
    (this->Albedo && test(this->Albedo));
}

//------------------------------------------------------------------------------
vtkMTimeType vtkPointSplatTextures::GetMTime() const
{
  vtkMTimeType time = 0;
  for (vtkTexture* texture : this->GetAll())
  {
    time = std::max(time, texture->GetMTime());
    if (texture->GetTransform())
    {
      time = std::max(time, texture->GetTransform()->GetMTime());
    }
    if (texture->GetNumberOfInputConnections(0) > 0)
    {
      texture->GetInputAlgorithm()->Update();
      vtkDataObject* data = texture->GetInputDataObject(0, 0);
      time = data ? std::max(time, data->GetMTime()) : time;
    }
  }
  return time;
}
