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

#include "vtkPointSplatFramebuffer.h"

#include <glm/glm.hpp>

#include "vtkPointSplattingABI.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
VTK_ABI_NAMESPACE_END

class vtkPointSplatSceneDepth
{
public:
  /**
   * Copies a rectangle of the framebuffer; false where it has no depth that could be copied.
   */
  bool Capture(vtkOpenGLRenderWindow* window, const glm::ivec2& origin, const glm::ivec2& size);

  GLuint GetTexture() const { return this->Depth.Get(); }
  void Release()
  {
    this->Depth.Release();
    this->Framebuffer.Release();
  }

private:
  vtkPointSplatImage Depth{ GL_DEPTH_COMPONENT24 };
  vtkPointSplatFramebuffer Framebuffer;
};

#endif
