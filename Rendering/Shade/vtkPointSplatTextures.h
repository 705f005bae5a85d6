// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Which of an actor's textures show, as vtkOpenGLPolyDataMapper has it: where interpolation is
// physically based, on lit surfaces, those that the property names for it; else the actor's and
// the property's others, blended as each says; and maps of normals where points have tangents.
#ifndef vtkPointSplatTextures_h
#define vtkPointSplatTextures_h

#include <glm/glm.hpp>

#include "vtkType.h"

#include "vtkPointSplattingABI.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkRenderer;
class vtkTexture;
VTK_ABI_NAMESPACE_END

struct vtkPointSplatTextures
{
  /// Colours, that multiply what is lit, are blended of no more than so many textures.
  static constexpr size_t MostColours = 4;

  std::vector<vtkTexture*> Colours;
  vtkTexture* Albedo = nullptr;
  vtkTexture* Material = nullptr; // occlusion, roughness and metallic
  vtkTexture* Emissive = nullptr;
  vtkTexture* Anisotropy = nullptr;
  vtkTexture* Normal = nullptr;
  vtkTexture* CoatNormal = nullptr;
  bool IsPhysical = false;
  bool IsAnisotropic = false; // by the property, where there are tangents
  glm::mat4 Transform{ 1.0f }; // of coordinates

  /// Of an actor as it is now; tangents: whether its points have some.
  static vtkPointSplatTextures Of(vtkActor* actor, bool tangents);

  std::vector<vtkTexture*> GetAll() const;
  bool NeedTangents() const { return this->IsAnisotropic || this->Normal || this->CoatNormal; }
  /// Whether there is more than colours that multiply what is lit.
  bool HasMore() const;
  /// Whether coordinates that differ by one mean the same, along each of both.
  bool Repeat() const;
  /// Whether colours may be translucent.
  bool AreTranslucent() const;
  /// Of textures, with pictures that are brought up to date, and of how they are taken.
  vtkMTimeType GetMTime() const;
};

#endif
