// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// A framebuffer object that draws to images of this module. OpenGL keeps draw buffers with each
// framebuffer: they are set when their number changes, which is once, and so past vtkOpenGLState,
// whose copy is of the framebuffers that VTK itself binds.
#ifndef vtkPointSplatFramebuffer_h
#define vtkPointSplatFramebuffer_h

#include "vtkPointSplatHandle.h"
#include "vtkPointSplatImage.h"

#include "vtkPointSplattingABI.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLState;
VTK_ABI_NAMESPACE_END

class vtkPointSplatFramebuffer
{
public:
  /// A layer of an image, or the image.
  struct Target
  {
    Target(const vtkPointSplatImage& image, int layer = 0)
      : Image(&image)
      , Layer(layer)
    {
    }
    const vtkPointSplatImage* Image;
    int Layer;
  };

  /// Binds it, with these colour attachments and no depth.
  void Bind(vtkOpenGLState* state, const std::vector<Target>& colours);
  /// With a depth, or depth and stencil (GL_DEPTH_STENCIL_ATTACHMENT).
  void Bind(vtkOpenGLState* state, const std::vector<Target>& colours, const Target& depth,
    GLenum attachment = GL_DEPTH_ATTACHMENT);
  GLuint Get() const { return this->Name.Get(); }
  /**
   * The internal format of the depth that is bound for reading, 0 for none: blits between
   * depth buffers ask for equal formats.
   */
  static GLenum GetReadDepthFormat();
  void Release() { this->Name.Release(); }

private:
  void BindColours(vtkOpenGLState* state, const std::vector<Target>& colours);

  vtkPointSplatHandle Name{ vtkPointSplatHandle::Framebuffer };
  GLsizei Count = 0;    // of colour attachments, and of draw buffers
  GLsizei Attached = 0; // the most colour attachments that were ever set
};

#endif
