// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatRadiance.h"

#include "vtkFloatArray.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPBRIrradianceTexture.h"
#include "vtkPBRLUTTexture.h"
#include "vtkPBRPrefilterTexture.h"
#include "vtkPointSplatEnvironment.h"
#include "vtkPointSplatProgram.h"
#include "vtkPointSplatUnits.h"
#include "vtkPointSplattingConfigure.h"
#include "vtkTextureObject.h"

namespace
{
/// From an environment's coefficients to those of the light that a diffuse surface reflects: the real
/// spherical harmonics' constants, times 1, 2/3 and 1/4 by their order (Ramamoorthi, Hanrahan 2001, An
/// efficient representation for irradiance environment maps, equations 3 and 8); those of odd degree
/// have the sign that VTK's coefficients have.
constexpr float HarmonicScales[9] = { 0.282095f, -0.488603f * 2.0f / 3.0f,
  0.488603f * 2.0f / 3.0f, -0.488603f * 2.0f / 3.0f, 1.092548f / 4.0f, -1.092548f / 4.0f,
  0.315392f / 4.0f, -1.092548f / 4.0f, 0.546274f / 4.0f };

/// Loads a texture as its filters are to be, and leaves it unbound.
bool Load(vtkOpenGLTexture* texture, vtkRenderer* renderer)
{
  texture->Load(renderer);
  vtkTextureObject* object = texture->GetTextureObject();
  if (object && object->GetHandle() != 0)
  {
    object->Activate();
    object->Deactivate();
  }
  return object && object->GetHandle() != 0;
}
}

//------------------------------------------------------------------------------
bool vtkPointSplatRadiance::Prepare(vtkRenderer* renderer)
{
  this->Renderer = vtkOpenGLRenderer::SafeDownCast(renderer);
  if (!this->Renderer || !renderer->GetUseImageBasedLighting() ||
    !renderer->GetEnvironmentTexture() ||
    !Load(this->Renderer->GetEnvMapLookupTable(), renderer) ||
    !Load(this->Renderer->GetEnvMapPrefiltered(), renderer))
  {
    return false;
  }
  this->Harmonics.clear();
  vtkFloatArray* harmonics =
    this->Renderer->GetUseSphericalHarmonics() ? this->Renderer->GetSphericalHarmonics() : nullptr;
  if (harmonics && harmonics->GetNumberOfTuples() == 3 && harmonics->GetNumberOfComponents() == 9)
  {
    for (int k = 0; k < 9; ++k)
    {
      this->Harmonics.push_back(HarmonicScales[k] *
        glm::vec4(harmonics->GetTypedComponent(0, k), harmonics->GetTypedComponent(1, k),
          harmonics->GetTypedComponent(2, k), 0.0f));
    }
  }
  else if (!Load(this->Renderer->GetEnvMapIrradiance(), renderer))
  {
    return false;
  }
  this->FromWorld = vtkPointSplatEnvironment::FromWorldOf(renderer);
  return true;
}

//------------------------------------------------------------------------------
std::string vtkPointSplatRadiance::GetDefines() const
{
  return std::string("#define RADIANCE\n") +
    (PointSplatting_HAVE_MULTIPLE_SCATTERING ? "#define MULTIPLE_SCATTERING\n" : "") +
    (this->Harmonics.empty() ? "" : "#define SH_RADIANCE\n");
}

//------------------------------------------------------------------------------
void vtkPointSplatRadiance::Bind(const vtkPointSplatView& view, vtkPointSplatUnits& units,
  vtkPointSplatProgram& program) const
{
  auto handle = [](vtkOpenGLTexture* texture) { return texture->GetTextureObject()->GetHandle(); };
  vtkPBRPrefilterTexture* prefiltered = this->Renderer->GetEnvMapPrefiltered();
  units.Bind(program, "RadianceTable", GL_TEXTURE_2D,
    handle(this->Renderer->GetEnvMapLookupTable()));
  units.Bind(program, "Prefiltered", GL_TEXTURE_CUBE_MAP, handle(prefiltered));
  program.Set("PrefilteredLevels", static_cast<float>(prefiltered->GetPrefilterLevels() - 1));
  if (this->Harmonics.empty())
  {
    units.Bind(program, "Irradiance", GL_TEXTURE_CUBE_MAP,
      handle(this->Renderer->GetEnvMapIrradiance()));
  }
  else
  {
    program.Set("Harmonics", this->Harmonics);
  }
  program.Set("RadianceFromView",
    glm::mat3(this->FromWorld * glm::transpose(glm::dmat3(view.WCVC))));
}
