// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Translucent surfaces flattened to one image, where nothing else translucent can lie between
// them. VTK's translucent passes then have one layer to deal with, and the default
// order-independent pass, which weights layers instead of sorting them, is exact.
//
// 1. Splats that are drawn sorted, if any (vtkPointSplatSorted.h).
// 2. Over them the layers, each shaded and blended over the ones behind it.
// 3. Under all of it what is seen through refracting bodies (vtkPointSplatRefraction.h).
#ifndef vtkPointSplatFlat_h
#define vtkPointSplatFlat_h

#include "vtkPointSplatFramebuffer.h"
#include "vtkPointSplatRefraction.h"
#include "vtkPointSplatSorted.h"

class vtkPointSplatSavedState;

/**
 * What is flattened: premultiplied colour, and the nearest layer's depth.
 */
struct vtkPointSplatFlatImages
{
  vtkPointSplatImage Colour{ GL_RGBA16F };
  vtkPointSplatImage Depth{ GL_R32F };
  void Release()
  {
    this->Colour.Release();
    this->Depth.Release();
  }
};

class vtkPointSplatFlat
{
public:
  /**
   * Which layers are drawn sorted.
   */
  enum SortedLayers
  {
    None,
    All,
    AllButNearest
  };

  /// Blends all. False, with GetError(), where shaders do not build.
  bool Blend(const vtkPointSplatShading& shading, const vtkPointSplatRequest& request,
    const vtkPointSplatLayers& layers, SortedLayers sorted, vtkPointSplatFlatImages& to);

  /// Only what is seen through refracting bodies, at a depth just behind the last layer.
  bool Refract(const vtkPointSplatShading& shading, const vtkPointSplatRequest& request,
    const vtkPointSplatLayers& layers, vtkPointSplatFlatImages& to);

  const std::string& GetError() const { return this->Error; }
  void Release();

private:
  void Begin(const vtkPointSplatRequest& request, const vtkPointSplatSavedState& saved,
    vtkPointSplatFlatImages& to);
  bool DrawSorted(const vtkPointSplatSorted::Scene& scene, const vtkPointSplatFlatImages& to);
  bool DrawLayers(const vtkPointSplatShading& shading, const vtkPointSplatLayers& layers,
    bool reflectionAlone);
  bool DrawRefracted(const vtkPointSplatShading& shading, const vtkPointSplatRequest& request,
    const vtkPointSplatLayers& layers, const vtkPointSplatImage* layerCounts);

  vtkPointSplatSorted Sorted;
  vtkPointSplatRefraction Refraction;
  std::map<std::string, vtkPointSplatProgram> Programs; // by defines
  vtkPointSplatScreen Screen;
  vtkPointSplatFramebuffer Framebuffer;
  std::string Error;
};

#endif
