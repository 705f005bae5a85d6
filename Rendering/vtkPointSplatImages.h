// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The images between the stages of a frame. Both kinds hold the same:
//   depths  the nearest disk's coded depth, a uint a pixel (vtkPointSplatProjection.glsl)
//   sums    of weights, and of weighted normals, depths, colours and factors of lights
//   ids     the splat of the greatest weight, made for hardware selection only
// Compute shaders write buffers (uint; 4 ints, or 8 with colours or more than two factors; 2 uints
// a pixel), which the resolve stage reads as buffer textures. Quads write textures (R32UI; two
// RGBA32F and one R32F, and one more RGBA32F with factors; R32UI) through a framebuffer object.
#ifndef vtkPointSplatImages_h
#define vtkPointSplatImages_h

#include "vtkPointSplattingOpenGL.h"

#include <glm/glm.hpp>

#include "vtkType.h"

#include "vtkPointSplattingABI.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
VTK_ABI_NAMESPACE_END

class vtkPointSplatImages
{
public:
  vtkPointSplatImages() = default;
  ~vtkPointSplatImages() = default;
  vtkPointSplatImages(const vtkPointSplatImages&) = delete;
  void operator=(const vtkPointSplatImages&) = delete;

  /**
   * Whether buffers of this size are within what the driver allows.
   */
  static bool FitCompute(const glm::ivec2& size);

  /**
   * Makes the images of this size and kind, or keeps them if they are. factors: of how many
   * lights.
   */
  void Allocate(bool compute, const glm::ivec2& size, bool colours, int factors = 0);

  /**
   * Empties the rows of a rectangle (first x, y, last x, y).
   */
  void ClearBuffers(const glm::ivec4& window);
  void ClearIdBuffer(const glm::ivec4& window);

  bool IsCompute() const { return this->Compute; }
  const glm::ivec2& GetSize() const { return this->Size; }
  int GetSumStride() const // ints a pixel, compute
  {
    return this->Colours || this->GetFactorWords() > 1 ? 8 : 4;
  }
  int GetFactorCount() const { return this->Factors; }
  int GetFactorWords() const { return (this->Factors + 1) / 2; }       // compute
  int GetFactorWord() const { return this->Colours ? 5 : 3; } // the first of them
  vtkIdType GetMemorySize() const; // bytes

  ///@{
  /**
   * OpenGL names: of buffers, or of textures.
   */
  GLuint GetDepths() const { return this->Depths; }
  GLuint GetDepthTexture() const { return this->BufferTextures[0]; } // of the buffer
  GLuint GetSums(int i = 0) const { return this->Sums[i]; } // quads: 2 is the opacity
  GLuint GetIds() const { return this->Ids; }
  GLuint GetDepthAttachment() const { return this->DepthAttachment; }
  GLuint GetFramebuffer() const { return this->Framebuffer; }
  ///@}

  /**
   * Binds what the resolve stage reads to texture units of the window, and says
   * so to its program. Unbind() gives the units back.
   */
  void Bind(vtkOpenGLRenderWindow* window, vtkShaderProgram* program, bool withIds);
  void Unbind(vtkOpenGLRenderWindow* window);

  void Release();

private:
  bool Compute = false;
  bool Colours = false;
  int Factors = 0;
  glm::ivec2 Size{ 0, 0 };
  GLuint Depths = 0;
  GLuint Sums[4] = { 0, 0, 0, 0 };
  GLuint Ids = 0;
  GLuint DepthAttachment = 0;
  GLuint Framebuffer = 0;
  GLuint BufferTextures[3] = { 0, 0, 0 }; // of depths, sums, ids
  int Units[6] = { -1, -1, -1, -1, -1, -1 };
};

#endif
