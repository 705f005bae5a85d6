// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Deferred blending: the nearest surface layer from one pass over the geometry
// (Zhang, Pajarola 2006, section 3.2 and Algorithm 1).
//
// 1. Geometry pass: each group's splats, by quads and the depth test, to that
//    group's layer of two array textures: texels (RGBA32UI, see
//    vtkPointSplatGroupTexel.glsl) and depths (DEPTH_COMPONENT32F). Splats lie grouped in their
//    buffer, in Morton order within a group: a group is one draw.
// 2. Compositing pass: figure 5's epsilon test over the groups at each pixel.
//    Its result are the images of two-pass splatting, so that what
//    follows (shading, presentation, hardware selection) is the same.
//
// Where lights cast shadows, a third array (R32UI) has the factors of up to four of them.
// 20 bytes a pixel and group, 24 with factors. Needs OpenGL 3.3, no gl_Layer.
#ifndef vtkPointSplatDeferred_h
#define vtkPointSplatDeferred_h

#include "vtkPointSplatStages.h"

class vtkPointSplatDeferred
{
public:
  vtkPointSplatDeferred() = default;
  ~vtkPointSplatDeferred() = default;
  vtkPointSplatDeferred(const vtkPointSplatDeferred&) = delete;
  void operator=(const vtkPointSplatDeferred&) = delete;

  /**
   * Whether the context has so many array layers of this size, and bytes is within
   * the bound. 0 bytes: no bound.
   */
  static bool Fits(const glm::ivec2& size, int groups, vtkIdType bytes);

  /**
   * As vtkPointSplatStages::Reconstruct, for images of the quads' kind. depthUnit: of depths
   * in the sums and of layer distances, world units; voronoiScale: what a
   * splat's rim lies behind its centre in the Voronoi depth, world units, or 0 for plain depth.
   */
  bool Reconstruct(vtkOpenGLRenderWindow* window, const vtkPointSplatView& view,
    const std::vector<vtkPointSplatItem>& items, vtkPointSplatImages& images, float depthUnit,
    float voronoiScale);

  const std::string& GetError() const { return this->Error; }
  vtkIdType GetMemorySize() const; // bytes
  void Release();

private:
  void Allocate(const glm::ivec2& size, int groups, bool factors);
  bool BuildPrograms(bool factors);
  void ReleaseImages();

  vtkPointSplatProgram Geometry[2]; // the latter with factors of lights
  vtkPointSplatProgram Compositing[2];
  std::string Error;
  glm::ivec2 Size{ 0, 0 };
  int Groups = 0;
  GLuint Texels = 0;
  GLuint Depths = 0;
  GLuint Factors = 0;
  GLuint Framebuffer = 0;
  GLuint VertexArray = 0;
};

#endif
