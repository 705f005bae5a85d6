// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The renderer's image-based lighting, as vtkPointSplatPhysical.glsl takes it: VTK's own textures, which
// it makes of the renderer's environment texture whenever that changes.
#ifndef vtkPointSplatRadiance_h
#define vtkPointSplatRadiance_h

#include "vtkPointSplatView.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderer;
class vtkRenderer;
VTK_ABI_NAMESPACE_END
class vtkPointSplatProgram;
class vtkPointSplatUnits;

class vtkPointSplatRadiance
{
public:
  /// False where the renderer has none.
  bool Prepare(vtkRenderer* renderer);
  std::string GetDefines() const;
  /// Of a program in use, as vtkPointSplatPhysical.glsl has them.
  void Bind(const vtkPointSplatView& view, vtkPointSplatUnits& units,
    vtkPointSplatProgram& program) const;

private:
  vtkOpenGLRenderer* Renderer = nullptr; // only of the frame that is drawn
  std::vector<glm::vec4> Harmonics;      // or none
  glm::dmat3 FromWorld{ 1.0 };
};

#endif
