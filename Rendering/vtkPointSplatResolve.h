// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The stages shade and present: one cloud's part of a reconstructed layer goes
// to the renderer's framebuffer as a full-screen triangle with colour, opacity
// and depth, through VTK's shader cache and the hooks of its render passes.
#ifndef vtkPointSplatResolve_h
#define vtkPointSplatResolve_h

#include "vtkPointSplatStages.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkPointSplatMapper;
class vtkRenderer;
class vtkShaderProgram;
VTK_ABI_NAMESPACE_END

class vtkPointSplatResolve
{
public:
  /**
   * What is written as colour.
   */
  enum Output
  {
    Shaded,
    SelectionColour,
    SelectionIds
  };

  /**
   * Presents the item of this actor. selectionShift: bits by which ids are
   * shifted, for the passes that carry their high bits.
   */
  bool Present(vtkRenderer* renderer, vtkActor* actor, vtkPointSplatMapper* mapper,
    const vtkPointSplatView& view, const vtkPointSplatItem& item, vtkPointSplatImages& images,
    float depthUnit, Output output, int selectionShift);

  void Release();

private:
  void SetLights(vtkRenderer* renderer, const vtkPointSplatView& view, vtkShaderProgram* program,
    int level, int count);
  static void SetMaterial(
    vtkActor* actor, bool colours, vtkShaderProgram* program);

  GLuint VertexArray = 0;
};

#endif
