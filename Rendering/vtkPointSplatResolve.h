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
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkShaderProgram;
VTK_ABI_NAMESPACE_END

class vtkPointSplatEnvironment;

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
    SelectionIds,
    Flattened, // premultiplied, and its depth, with no pass' hooks
    Reflected  // as Flattened, but what the surface reflects of the environment alone
  };

  /**
   * Presents the item of this actor. selectionShift: bits by which ids are
   * shifted, for the passes that carry their high bits. gathered: the colours in the images
   * are those of all items.
   */
  bool Present(vtkRenderer* renderer, vtkActor* actor, vtkPointSplatMapper* mapper,
    const vtkPointSplatView& view, const vtkPointSplatItem& item, vtkPointSplatImages& images,
    float depthUnit, Output output, int selectionShift, bool gathered = false);

  /**
   * Presents an image of premultiplied colours and one of depths.
   */
  bool PresentFlat(vtkRenderer* renderer, vtkActor* actor, vtkPointSplatMapper* mapper,
    const vtkPointSplatView& view, GLuint colour, GLuint depth);

  ///@{
  /**
   * For other programs that shade: the defines of vtkPointSplatLighting.glsl, and lights and
   * material as uniforms. colours: the points have their own; factors: and those of so many
   * lights, the first ones that are switched on and no headlights.
   */
  static std::string LightDefines(vtkRenderer* renderer, vtkActor* actor);
  static void SetShading(vtkRenderer* renderer, vtkActor* actor, const vtkPointSplatView& view,
    bool colours, vtkShaderProgram* program, int factors = 0);
  ///@}

  /**
   * The uniforms of vtkPointSplatSurface.glsl. depthUnit: of the depths in the sums.
   */
  static void SetView(const vtkPointSplatView& view, float depthUnit, vtkShaderProgram* program);

  /**
   * What refracting items reflect, until another one is set; null: nothing.
   */
  void SetEnvironment(const vtkPointSplatEnvironment* environment)
  {
    this->Environment = environment;
  }
  const vtkPointSplatEnvironment* GetEnvironment() const { return this->Environment; }

  void Release();

private:
  static void SetLights(vtkRenderer* renderer, const vtkPointSplatView& view, vtkShaderProgram* program,
    int level, int count, int factors);
  static void SetMaterial(
    vtkActor* actor, bool colours, vtkShaderProgram* program);

  void DrawScreen(vtkOpenGLRenderWindow* window, const vtkPointSplatView& view,
    const glm::ivec4& rectangle);

  const vtkPointSplatEnvironment* Environment = nullptr;
  GLuint VertexArray = 0;
};

#endif
