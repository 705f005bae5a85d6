// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The stage shade: a reconstructed layer goes to the renderer's framebuffer as rectangles over all
// that it may cover, with colour, opacity and depth, through VTK's shader cache and the hooks of its render
// passes.
#ifndef vtkPointSplatResolve_h
#define vtkPointSplatResolve_h

#include "vtkPointSplatFlat.h"
#include "vtkPointSplatLayers.h"
#include "vtkPointSplatOutlineMeans.h"
#include "vtkPointSplatOutlines.h"
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
    bool Blends;       // outlines, with what the framebuffer has: nothing is to come behind them
    bool KeepsDepth;   // in the framebuffer, as what is opaque does
  };

  /**
   * Layers, and the outlines in them.
   */
  struct Source
  {
    const vtkPointSplatLayers& Layers;
    const vtkPointSplatOutlines& Outlines;
  };

  /// Presents a layer: of one slot, or of all (-1). False where the shaders do not build.
  bool Present(const Target& target, const vtkPointSplatShading& shading, const Source& source,
    int layer, int slot);

  /**
   * What hardware selection asks for.
   */
  struct Selection
  {
    bool Ids;  // or one colour
    int Shift; // bits by which ids are shifted, for the passes that carry their high bits
    // Pixels: so much nearer to the eye than it is. A frame that a selection draws over, whose depth
    // it keeps, may show splats that stand for others, and these are not to hide the points.
    double Nearer;
  };
  bool PresentSelection(const Target& target, const vtkPointSplatView& view,
    const vtkPointSplatLayers& layers, int slot, const Selection& selection);

  /// Presents images of premultiplied colours and of depths that layers were flattened to.
  bool PresentFlat(const Target& target, const vtkPointSplatView& view,
    const vtkPointSplatFlatImages& images, const vtkPointSplatOutlines& outlines);

  /// Whether the hooks of the render passes that an actor is drawn in are the same for all actors.
  static bool AreHooksShared(vtkActor* actor);

  /// Whether an actor's outlines may be smoothed: not where render passes shade pixels, or draw
  /// maps of depths, whose means are of no use.
  static bool AreOutlinesSmooth(vtkActor* actor);

  const std::string& GetError() const { return this->Error; }
  void Release()
  {
    this->Screen.Release();
    this->Means.Release();
  }

private:
  struct Hooks;
  bool Use(const Target& target, const char* vertexFile, const char* file,
    const std::string& defines, vtkPointSplatProgram& program);
  /// Calls what draws with the state that it needs: a viewport of the images' size.
  template <typename Function>
  void Draw(const Target& target, const vtkPointSplatView& view, const Function& draw);

  vtkPointSplatScreen Screen;
  vtkPointSplatOutlineMeans Means;
  std::string Error;
};

#endif
