// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The images between the stages of a frame. Both kinds hold the same:
//   depths  the nearest disk's coded depth, a uint a pixel (vtkPointSplatProjection.glsl)
//   sums    of weights, and of weighted normals, depths, colours and factors of lights
//   ids     the splat of the greatest weight, made for hardware selection only
// Compute shaders write buffers (uint; 4 ints, or 8 with colours or more than two factors; 2 uints
// a pixel), which the resolve stage reads as buffer textures. Quads write textures (R32UI; two
// RGBA32F and one R32F, and one more RGBA32F with factors; R32UI) through a framebuffer object. A
// layer that was filled in image space is one buffer or texture (RGBA32UI), and one more with
// factors (R32UI; see vtkPointSplatTexel.glsl), and names its points by the images that it came
// from.
#ifndef vtkPointSplatImages_h
#define vtkPointSplatImages_h

#include "vtkPointSplattingOpenGL.h"

#include <glm/glm.hpp>

#include "vtkType.h"

#include <string>

#include "vtkPointSplattingABI.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
VTK_ABI_NAMESPACE_END
class vtkPointSplatProgram;
class vtkPointSplatUnits;

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
   * Makes the image of a filled layer, and with factors the second one, in place of the others.
   */
  void AllocateFilled(bool compute, const glm::ivec2& size, int factors);
  bool IsFilled() const { return this->Texels != 0; }
  /// What tells vtkPointSplatFetch.glsl of which kind the images are.
  std::string GetDefines() const;
  GLuint GetTexels() const { return this->Texels; }
  GLuint GetFactorTexels() const { return this->FactorTexels; } // 0 without factors
  /// Where a filled layer's ids are: in the images that were projected, at the pixel that
  /// the image filled (RG32UI: a texture, of a buffer or not) tells.
  void SetIdSource(const vtkPointSplatImages* projected, GLuint filled)
  {
    this->Projected = projected;
    this->Filled = filled;
  }

  static GLuint MakeTexture(
    const glm::ivec2& size, GLenum internal, GLenum format, GLenum type);
  static void MakeBuffer(GLuint& buffer, GLuint& texture, GLsizeiptr bytes, GLenum format);

  /**
   * Empties the rows of a rectangle (first x, y, last x, y).
   */
  void ClearBuffers(const glm::ivec4& window);
  void ClearIdBuffer(const glm::ivec4& window);

  bool IsCompute() const { return this->Compute; }
  const glm::ivec2& GetSize() const { return this->Size; }
  bool HasColours() const { return this->Colours || !this->Compute; }
  int GetSumStride() const // ints a pixel, compute
  {
    return this->Colours || this->Factors > 2 ? 8 : 4;
  }
  int GetFactorCount() const { return this->Factors; }
  /// Of the words of factors the first, compute.
  int GetFactorWord() const { return this->Colours ? 5 : 3; }
  vtkIdType GetMemorySize() const; // bytes

  ///@{
  /**
   * OpenGL names: of buffers, or of textures.
   */
  GLuint GetDepths() const { return this->Depths; }
  /// What stages read coded depths from, the first component: of a buffer or not.
  GLuint GetDepthTexture() const
  {
    return this->Compute ? this->BufferTextures[0] : this->Texels ? this->Texels : this->Depths;
  }
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
  /// The same for a program of this module's own.
  void Bind(vtkPointSplatUnits& units, vtkPointSplatProgram& program);

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
  GLuint BufferTextures[3] = { 0, 0, 0 }; // of depths, sums, ids; or of texels, factors
  GLuint Texels = 0;
  GLuint FactorTexels = 0;
  const vtkPointSplatImages* Projected = nullptr;
  GLuint Filled = 0;
  int Units[6] = { -1, -1, -1, -1, -1, -1 };
  GLenum Targets[6] = { 0, 0, 0, 0, 0, 0 };
};

#endif
