// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The lights of a renderer that are switched on, as the stages take them.
#ifndef vtkPointSplatLights_h
#define vtkPointSplatLights_h

#include "vtkPointSplatView.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkLight;
VTK_ABI_NAMESPACE_END
class vtkPointSplatProgram;

class vtkPointSplatLights
{
public:
  /// The most lights that cast shadows: factors have four components.
  static constexpr int MostCasting = 4;

  vtkPointSplatLights(vtkRenderer* renderer, const vtkPointSplatView& view);

  /**
   * Whether a light casts shadows at all: headlights do not, nor lights that are off or at no
   * finite place.
   */
  static bool Casts(vtkLight* light);
  /// Lights that are on, or only those that cast.
  static std::vector<vtkLight*> Of(vtkRenderer* renderer, bool casting);

  /// Lines for programs that include vtkPointSplatLighting.glsl.
  std::string GetDefines() const;
  /// factors: of how many lights, the first that cast, points have factors.
  void SetUniforms(vtkPointSplatProgram& program, int factors) const;

private:
  int Level = 0; // as VTK's mappers have it: 1 one headlight, 2 directional lights, 3 positional ones
  std::vector<bool> Casting;
  // Four components each, as the shader has them.
  std::vector<glm::vec4> Colours;
  std::vector<glm::vec4> Directions;
  std::vector<glm::vec4> Positions;
  std::vector<glm::vec4> Attenuations;
};

#endif
