// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Deferred blending: the nearest surface layer from one pass over the geometry
// (Zhang, Pajarola 2006, section 3.2 and Algorithm 1).
//
// 1. Geometry pass: each group's splats, by quads and the depth test, to that
//    group's layer of two array textures: texels (RGBA32UI, see
//    vtkPointSplatGroupTexel.glsl) and depths (DEPTH_COMPONENT32F). Splats lie grouped in their
//    buffer, in Morton order within a group: a group is one draw.
// 2. Compositing pass: figure 5's epsilon test over the groups at each pixel. Its result is the
//    layer's texels.
//
// Where lights cast shadows, a third array (R32UI) has the factors of up to four of them.
// 20 bytes a pixel and group, 24 with factors. Needs OpenGL 3.2, no gl_Layer.
#ifndef vtkPointSplatDeferred_h
#define vtkPointSplatDeferred_h

#include "vtkPointSplatFramebuffer.h"
#include "vtkPointSplatLayers.h"
#include "vtkPointSplatProgram.h"
#include "vtkPointSplatRequest.h"
#include "vtkPointSplatScreen.h"

#include <string>

class vtkPointSplatDeferred
{
public:
  /**
   * Whether the context has so many array layers of this size, and their bytes are within
   * the bound. 0 bytes: no bound.
   */
  static bool Fits(const glm::ivec2& size, int groups, vtkIdType bytes);

  /// Makes the layer; the clouds have groups. False, with GetError(), where shaders do not build.
  bool Reconstruct(const vtkPointSplatRequest& request, vtkPointSplatLayers& layers);

  const std::string& GetError() const { return this->Error; }
  vtkIdType GetMemorySize() const; // bytes
  void Release();

private:
  /// The geometry pass's, of the variant that a request needs, or null.
  vtkPointSplatProgram* BuildPrograms(const vtkPointSplatRequest& request);
  void DrawGroup(const vtkPointSplatRequest& request, int group, vtkPointSplatProgram& geometry);

  // The latter with factors of lights; and with clip lines.
  vtkPointSplatProgram Geometry[2][2];
  vtkPointSplatProgram Compositing[2];
  vtkPointSplatImage Texels{ GL_RGBA32UI };
  vtkPointSplatImage Depths{ GL_DEPTH_COMPONENT32F };
  vtkPointSplatImage Factors{ GL_R32UI };
  vtkPointSplatFramebuffer GroupFramebuffer;
  vtkPointSplatFramebuffer Result;
  vtkPointSplatScreen Screen;
  std::string Error;
};

#endif
