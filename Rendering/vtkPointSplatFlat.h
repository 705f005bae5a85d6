// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Translucent layers flattened to one image: each layer is shaded and blended over the ones
// behind it, where nothing else translucent can lie between them. VTK's translucent passes
// then have one layer to deal with, and the default order-independent pass, which weights
// layers instead of sorting them, is exact.
// Behind the last layer of a refracting body comes the environment that is seen through it.
// Images: RGBA16F, premultiplied colour; R32F, the nearest layer's depth; RG16F, the number of
// refracting layers behind the nearest where they are sorted, and of groups that have some.
#ifndef vtkPointSplatFlat_h
#define vtkPointSplatFlat_h

#include "vtkPointSplatLayers.h"
#include "vtkPointSplatRefraction.h"
#include "vtkPointSplatResolve.h"
#include "vtkPointSplatSorted.h"

class vtkPointSplatFlat
{
public:
  vtkPointSplatFlat() = default;
  ~vtkPointSplatFlat() = default;
  vtkPointSplatFlat(const vtkPointSplatFlat&) = delete;
  void operator=(const vtkPointSplatFlat&) = delete;

  /**
   * What an item of the layers belongs to.
   */
  struct Part
  {
    vtkActor* Actor;
    vtkPointSplatMapper* Mapper;
  };

  /**
   * Which layers are drawn group-sorted.
   */
  enum SortedLayers
  {
    None,
    All,
    AllButNearest
  };

  /**
   * Blends all layers, parts in the order of their items; what the opaque scene hides is left out.
   * environment: what refracting items refract, or null.
   */
  bool Blend(vtkRenderer* renderer, const std::vector<Part>& parts, vtkPointSplatLayers& layers,
    vtkPointSplatResolve& resolve, SortedLayers sorted, vtkPointSplatRefraction& refraction,
    const vtkPointSplatEnvironment* environment);

  /**
   * Presents the image in the pass that is under way, by one actor on behalf of all.
   */
  bool Present(vtkRenderer* renderer, vtkActor* actor, vtkPointSplatMapper* mapper,
    const vtkPointSplatView& view, vtkPointSplatResolve& resolve);

  void Release();

private:
  void Allocate(vtkOpenGLRenderWindow* window, const glm::ivec2& size);
  void ClearLayerCount(vtkOpenGLRenderWindow* window);

  glm::ivec2 Size{ 0, 0 };
  GLuint Colour = 0;
  GLuint Depth = 0;
  GLuint LayerCount = 0; // made at need
  GLuint Framebuffer = 0;
  vtkPointSplatSorted Sorted;
};

#endif
