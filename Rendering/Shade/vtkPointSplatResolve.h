// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The stage shade: a reconstructed layer goes to the renderer's framebuffer as a full-screen
// triangle with colour, opacity and depth, through VTK's shader cache and the hooks of its render
// passes.
#ifndef vtkPointSplatResolve_h
#define vtkPointSplatResolve_h

#include "vtkPointSplatLayers.h"
#include "vtkPointSplatProgram.h"
#include "vtkPointSplatScreen.h"
#include "vtkPointSplatShading.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkMapper;
class vtkOpenGLRenderWindow;
class vtkRenderer;
VTK_ABI_NAMESPACE_END

class vtkPointSplatResolve
{
public:
  /**
   * Where to present, and for whom: the actor whose render passes' hooks hold.
   */
  struct Target
  {
    vtkRenderer* Renderer;
    vtkActor* Actor;
    vtkMapper* Mapper;
    glm::ivec4 Window; // pixels that there may be something at: first x, y, last x, y
  };

  /// Presents a layer: of one slot, or of all (-1). False where the shaders do not build.
  bool Present(const Target& target, const vtkPointSplatShading& shading,
    const vtkPointSplatLayers& layers, int layer, int slot);

  /**
   * What hardware selection asks for.
   */
  struct Selection
  {
    bool Ids;  // or one colour
    int Shift; // bits by which ids are shifted, for the passes that carry their high bits
  };
  bool PresentSelection(const Target& target, const vtkPointSplatView& view,
    const vtkPointSplatLayers& layers, int slot, const Selection& selection);

  /// Presents an image of premultiplied colours and one of depths.
  bool PresentFlat(const Target& target, const vtkPointSplatView& view,
    const vtkPointSplatImage& colour, const vtkPointSplatImage& depth);

  /// Whether the hooks of the render passes that an actor is drawn in are the same for all actors.
  static bool AreHooksShared(vtkActor* actor);

  const std::string& GetError() const { return this->Error; }
  void Release() { this->Screen.Release(); }

private:
  struct Hooks;
  bool Use(const Target& target, const Hooks& hooks, const std::string& file,
    const std::string& defines, vtkPointSplatProgram& program);
  void Draw(const Target& target, const vtkPointSplatView& view);

  vtkPointSplatScreen Screen;
  std::string Error;
};

#endif
