// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// What the pixels show that outlines run through, in framebuffers that have no samples of their own:
// the mean of the shaded pixels that the four samples take after (vtkPointSplatOutlines.h), by a
// compute shader over these pixels alone (vtkPointSplatOutlineMeanCS.glsl).
//
// Buffer: RGBA32UI, a pixel with an outline, in their order: premultiplied red and green, and blue
// and opacity (halves); the nearest depth, a float, behind the near plane, of flattened layers in the
// window; its normal, coded.
#ifndef vtkPointSplatOutlineMeans_h
#define vtkPointSplatOutlineMeans_h

#include "vtkPointSplatBuffer.h"
#include "vtkPointSplatProgram.h"

#include <map>
#include <string>

struct vtkPointSplatFlatImages;
struct vtkPointSplatShading;
class vtkPointSplatLayers;
class vtkPointSplatOutlines;
class vtkPointSplatUnits;

class vtkPointSplatOutlineMeans
{
public:
  /**
   * Which layer.
   */
  struct Wanted
  {
    int Layer;
    int Slot;    // of the cloud, or -1: all
    bool Blends; // with what the framebuffer has; else pixels are covered or not
  };

  ///@{
  /// Of a layer, or of flattened ones. False, with GetError(), where the shader does not build.
  bool Shade(const vtkPointSplatShading& shading, const vtkPointSplatLayers& layers,
    const vtkPointSplatOutlines& outlines, const Wanted& wanted);
  bool Flatten(const vtkPointSplatFlatImages& images, const vtkPointSplatOutlines& outlines);
  ///@}

  /// Binds the means to a program in use.
  void Bind(vtkPointSplatUnits& units, vtkPointSplatProgram& program) const;

  const std::string& GetError() const { return this->Error; }
  void Release();

private:
  bool Use(const std::string& defines, vtkPointSplatUnits& units,
    const vtkPointSplatOutlines& outlines, vtkPointSplatProgram*& program);

  vtkPointSplatBuffer Means{ GL_RGBA32UI };
  std::map<std::string, vtkPointSplatProgram> Programs; // by defines
  std::string Error;
};

#endif
