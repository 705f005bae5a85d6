// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// A copy of the opaque scene's depth, as a texture with the viewport's pixels: what
// cuts the peeling of translucent layers short.
//
// It is taken from the framebuffer that is bound for reading: vtkDualDepthPeelingPass binds its
// own for drawing only, and vtkOrderIndependentTranslucentPass copies depth into its own first.
// Multisampled framebuffers are resolved.
#ifndef vtkPointSplatSceneDepth_h
#define vtkPointSplatSceneDepth_h

#include "vtkPointSplattingOpenGL.h"

#include <glm/glm.hpp>

#include "vtkPointSplattingABI.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
VTK_ABI_NAMESPACE_END

class vtkPointSplatSceneDepth
{
public:
  vtkPointSplatSceneDepth() = default;
  ~vtkPointSplatSceneDepth() = default;
  vtkPointSplatSceneDepth(const vtkPointSplatSceneDepth&) = delete;
  void operator=(const vtkPointSplatSceneDepth&) = delete;

  /**
   * Copies a rectangle of the framebuffer; false where it has no depth that could be copied.
   */
  bool Capture(vtkOpenGLRenderWindow* window, const glm::ivec2& origin, const glm::ivec2& size);

  GLuint GetTexture() const { return this->Texture; }
  void Release();

private:
  glm::ivec2 Size{ 0, 0 };
  GLenum Format = 0;
  GLuint Texture = 0;
  GLuint Framebuffer = 0;
};

#endif
