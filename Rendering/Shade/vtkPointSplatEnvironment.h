// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// A renderer's environment texture, as vtkPointSplatEnvironmentMap.glsl reads it: a cube map, or an
// equirectangular picture, at infinite distance, turned by the renderer's EnvironmentUp and
// EnvironmentRight as image-based lighting turns it. A vtkSkybox of the same picture shows it so
// with SetProjectionToSphere() and SetFloorRight(0, 0, 1).
//
// It is read through a sampler of its own, which repeats around the horizon and not across the
// poles, with the texture's Interpolate and Mipmap, but not its anisotropy: directions do not
// come with a footprint that would serve it.
//
// Lighting here knows no colour spaces; colours are displayed as they are. A picture of floats, and
// one with UseSRGBColorSpace, which OpenGL decodes, is linear, and is encoded by a gamma of
// 2.2 as vtkSkybox does it with GammaCorrectOn().
#ifndef vtkPointSplatEnvironment_h
#define vtkPointSplatEnvironment_h

#include "vtkPointSplatHandle.h"
#include "vtkPointSplatView.h"

#include "vtkWeakPointer.h"

#include <string>

#include "vtkPointSplattingABI.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkTextureObject;
VTK_ABI_NAMESPACE_END
class vtkPointSplatProgram;

class vtkPointSplatEnvironment
{
public:
  /**
   * Brings the texture up to date; false where the renderer has none, or one without a picture.
   */
  bool Prepare(vtkRenderer* renderer);

  /// From world coordinates to those of a renderer's environment.
  static glm::dmat3 FromWorldOf(vtkRenderer* renderer);

  /// Lines for programs that include vtkPointSplatEnvironmentMap.glsl.
  const std::string& GetDefines() const { return this->Defines; }

  /**
   * Binds the texture to a unit of the window, and says so to a program in use. Unbind() gives
   * the unit back.
   */
  void Bind(const vtkPointSplatView& view, vtkPointSplatProgram& program) const;
  void Unbind() const;

  void Release() { this->Sampler.Release(); }

private:
  vtkWeakPointer<vtkTextureObject> Texture;
  glm::dmat3 FromWorld{ 1.0 };
  std::string Defines;
  vtkPointSplatHandle Sampler{ vtkPointSplatHandle::Sampler };
};

#endif
