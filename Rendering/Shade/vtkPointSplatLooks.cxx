// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatLooks.h"

#include "vtkActor.h"
#include "vtkOpenGLTexture.h"
#include "vtkPointSplatContext.h"
#include "vtkPointSplatShading.h"
#include "vtkPointSplatUnits.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <deque>

namespace
{

/// A texture, the uniform that it is for, and the line that says that there is one.
struct Map
{
  vtkTexture* Texture;
  const char* Sampler;
  const char* Define;
};

std::vector<Map> MapsOf(const vtkPointSplatTextures& textures)
{
  static const char* const colours[vtkPointSplatTextures::MostColours] = { "ColourTextures[0]",
    "ColourTextures[1]", "ColourTextures[2]", "ColourTextures[3]" };
  std::vector<Map> all;
  for (size_t i = 0; i < textures.Colours.size(); ++i)
  {
    all.push_back({ textures.Colours[i], colours[i], "" });
  }
  const Map named[] = { { textures.Albedo, "AlbedoTexture", "#define ALBEDO\n" },
    { textures.Material, "MaterialTexture", "#define MATERIAL\n" },
    { textures.Emissive, "EmissiveTexture", "#define EMISSIVE\n" },
    { textures.Normal, "NormalTexture", "#define NORMAL_MAP\n" },
    { textures.CoatNormal, "CoatNormalTexture", "#define COAT_NORMAL_MAP\n" },
    { textures.Anisotropy, "AnisotropyTexture", "#define ANISOTROPY_MAP\n" } };
  std::copy_if(std::begin(named), std::end(named), std::back_inserter(all),
    [](const Map& map) { return map.Texture != nullptr; });
  return all;
}

/// Brings a texture up to date, with its filters as they are to be, and leaves it unbound; null
/// where it has no picture.
vtkTextureObject* Load(vtkTexture* texture, vtkRenderer* renderer)
{
  auto own = vtkOpenGLTexture::SafeDownCast(texture);
  if (!own)
  {
    return nullptr;
  }
  own->Render(renderer);
  vtkTextureObject* object = own->GetTextureObject();
  const bool good = object && object->GetHandle() != 0;
  own->PostRender(renderer);
  return good ? object : nullptr;
}

/**
 * While it lives, Mesa's software rasterizer filters a texture without anisotropy, which the shader
 * does in its place: its filter takes the changes of coordinates not from the shader but from the
 * invocations beside it, which may be of another chart or of nothing at all.
 */
class Isotropic
{
public:
  Isotropic(vtkTextureObject* texture)
    : Texture(texture)
    , Kept(texture->GetMaximumAnisotropicFiltering())
  {
    if (vtkPointSplatContext::IsSoftware())
    {
      this->Set(1.0f);
    }
  }
  ~Isotropic() { this->Set(this->Kept); }
  /// How often the shader must look up.
  float GetMostSamples() const
  {
    return this->Kept / std::max(this->Texture->GetMaximumAnisotropicFiltering(), 1.0f);
  }
  Isotropic(const Isotropic&) = delete;
  void operator=(const Isotropic&) = delete;

private:
  void Set(float anisotropy)
  {
    if (this->Texture->GetMaximumAnisotropicFiltering() != anisotropy)
    {
      this->Texture->SetMaximumAnisotropicFiltering(anisotropy);
      this->Texture->Activate();
      this->Texture->SendParameters();
      this->Texture->Deactivate();
    }
  }

  vtkTextureObject* Texture;
  float Kept;
};
}

//------------------------------------------------------------------------------
bool vtkPointSplatLooks::Apply(vtkRenderer* renderer, const vtkPointSplatView& view,
  const std::vector<Entry>& entries, const vtkPointSplatLayers& layers)
{
  bool good = true;
  for (const Entry& entry : entries)
  {
    good = this->ApplyOne(renderer, view, entry, layers) && good;
  }
  return good;
}

//------------------------------------------------------------------------------
bool vtkPointSplatLooks::ApplyOne(vtkRenderer* renderer, const vtkPointSplatView& view,
  const Entry& entry, const vtkPointSplatLayers& layers)
{
  const vtkPointSplatTextures textures = vtkPointSplatTextures::Of(entry.Actor, entry.Tangents);
  std::vector<std::pair<Map, vtkTextureObject*>> maps;
  std::vector<glm::vec4> kinds;
  std::string defines = layers.GetDefines();
  for (const Map& map : MapsOf(textures))
  {
    vtkTextureObject* object = Load(map.Texture, renderer);
    if (!object)
    {
      continue;
    }
    defines += map.Define;
    if (map.Define[0] == 0)
    {
      kinds.emplace_back(object->GetComponents(), map.Texture->GetBlendingMode(), 0.0f, 0.0f);
    }
    maps.emplace_back(map, object);
  }
  defines += (kinds.empty() ? "" : "#define COLOURS " + std::to_string(kinds.size()) + "\n") +
    std::string(textures.NeedTangents() ? "#define TANGENTS\n" : "");
  vtkPointSplatProgram& program = this->Programs[defines];
  if (!program.Build({ { GL_COMPUTE_SHADER, "vtkPointSplatLookCS" } }, defines))
  {
    this->Error = program.GetLog();
    return false;
  }
  std::deque<Isotropic> isotropic;
  float samples = 1.0f;
  for (const auto& map : maps)
  {
    isotropic.emplace_back(map.second);
    samples = std::max(samples, isotropic.back().GetMostSamples());
  }
  program.Use();
  {
    vtkPointSplatUnits units(vtkPointSplatContext::Entered().GetWindow());
    for (const auto& map : maps)
    {
      units.Bind(program, map.first.Sampler, GL_TEXTURE_2D, map.second->GetHandle());
    }
    vtkProperty* property = entry.Actor->GetProperty();
    const glm::ivec2& size = layers.GetSize();
    vtkPointSplatShading::SetRay(view, program);
    program.Set("MostSamples", samples);
    program.Set("ColourKinds", kinds);
    program.Set("CoordinateTransform", textures.Transform);
    program.Set("OnBackFaces", property->GetShowTexturesOnBackface());
    program.Set("NormalScales",
      glm::vec2(property->GetNormalScale(), property->GetCoatNormalScale()));
    program.Set("AnisotropyRotation",
      static_cast<float>(textures.IsAnisotropic ? property->GetAnisotropyRotation() : 0.0));
    program.Set("OnlySlot", entry.Slot);
    program.Set("LookSize", size);
    program.Set("LookCapacity", layers.GetCapacity());
    program.Set("LookCount", layers.GetNumberOfLayers());
    for (int row = 0; row < size.y; row += layers.GetRowsPerBand())
    {
      const int rows = std::min(layers.GetRowsPerBand(), size.y - row);
      layers.BindRows(row);
      program.Set("FirstRow", row);
      program.Set("RowCount", rows);
      vtkPointSplatProgram::Dispatch(
        static_cast<vtkIdType>(rows) * size.x * layers.GetNumberOfLayers());
    }
  }
  glUseProgram(0);
  return true;
}
