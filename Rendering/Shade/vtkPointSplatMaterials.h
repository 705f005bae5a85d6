// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The materials of a frame's splat actors, which layers name by their slots. A buffer (RGBA32F) of
// eleven or 16 texels a slot:
//   0  of front faces: ambient colour times intensity; opacity
//   1  diffuse colour times intensity; specular power
//   2  specular colour times intensity; whether shadows fall on it
//   3  ambient and diffuse intensities alone; whether it is lit; whether points have colours
//   4 to 7  the same of back faces
//   8  of a dielectric: index of refraction; its spread; the longest way through the body; whether
//      it refracts
//   9  of a dielectric: absorption; the longest way from a dielectric to another one
//   10 colour of edges; 1 if textures are looked up, or tangents turned, and 2 if there are edges
// and where some actor's interpolation is physically based, of such, else 0:
//   11 metallic; roughness; reflectance at normal incidence of what is no metal; that of the coat + 1
//   12 edge tint; strength of the coat
//   13 colour of the coat; its roughness
//   14 factor of emission; strength of occlusion
//   15 anisotropy; whether a texture has the opacity; whether there is a lobe along tangents; 0
#ifndef vtkPointSplatMaterials_h
#define vtkPointSplatMaterials_h

#include "vtkPointSplatBuffer.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

#include "vtkPointSplattingABI.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
VTK_ABI_NAMESPACE_END
class vtkPointSplatProgram;
class vtkPointSplatUnits;

/**
 * A body that bends light.
 */
struct vtkPointSplatMedium
{
  bool Refracts = false;
  double Index = 1.5;
  double Dispersion = 0.0;        // how much larger the index is for blue than for red, relatively
  glm::dvec3 Absorption{ 0.0 };   // 1 / world units
  glm::dvec3 Low{ 0.0 };          // of the box about it, world coordinates
  glm::dvec3 High{ 0.0 };
};

class vtkPointSplatMaterials
{
public:
  struct Entry
  {
    vtkActor* Actor;
    bool HasColours;
    bool HasOwnOpacity; // which the colours hold, so that the property's does not count
    bool Receives; // shadows
    vtkPointSplatMedium Medium;
    bool HasLook;  // textures are looked up, or tangents turned
    bool HasTangents;
    bool HasEdges;
  };

  /// In the order of the slots.
  void Upload(const std::vector<Entry>& entries);
  bool Refracts() const { return this->HasMedia; }
  bool Disperses() const { return this->HasDispersion; }
  bool ArePhysical() const { return this->HasPhysical; }

  /// Lines for programs that include vtkPointSplatMaterials.glsl. gathered: whether a layer holds
  /// colours of all.
  std::string GetDefines(bool gathered) const;
  void Bind(vtkPointSplatUnits& units, vtkPointSplatProgram& program) const;
  void Release() { this->Table.Release(); }

private:
  size_t GetTexelsPerSlot() const;

  std::vector<glm::vec4> Texels;
  vtkPointSplatBuffer Table{ GL_RGBA32F };
  std::string Defines; // but for COLOURED
  bool HasColours = false;
  bool HasMedia = false;
  bool HasDispersion = false;
  bool HasPhysical = false;
};

#endif
