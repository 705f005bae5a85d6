// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// What shading depends on beside the layers.
#ifndef vtkPointSplatShading_h
#define vtkPointSplatShading_h

#include "vtkPointSplatEnvironment.h"
#include "vtkPointSplatLightMaps.h"
#include "vtkPointSplatLights.h"
#include "vtkPointSplatMaterials.h"
#include "vtkPointSplatRadiance.h"
#include "vtkPointSplatView.h"

struct vtkPointSplatShading
{
  vtkPointSplatView View;
  const vtkPointSplatLights* Lights = nullptr;
  const vtkPointSplatMaterials* Materials = nullptr;
  const vtkPointSplatEnvironment* Environment = nullptr; // that is reflected and refracted, or null
  const vtkPointSplatRadiance* Radiance = nullptr; // of image-based lighting, or null
  vtkPointSplatLightMaps* LightMaps = nullptr; // by which translucent splats cast shadows, or null

  bool Reflects() const { return this->Environment && this->Materials->Refracts(); }
  /// As vtkPointSplatMaterials has them, and more.
  std::string GetDefines(bool gathered) const;
  /// Of a program in use. factors: of how many lights, the first that cast, points have factors.
  void Bind(vtkPointSplatUnits& units, vtkPointSplatProgram& program, int factors) const;
  /// Gives back what Bind() took beside units.
  void Unbind() const;
  /// Sets the uniforms of vtkPointSplatRay.glsl alone.
  static void SetRay(const vtkPointSplatView& view, vtkPointSplatProgram& program);
};

#endif
