// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The stage reconstruct for points that are projected as single pixels (Dobrev, Rosenthal,
// Linsen 2010, section 3):
// 1. Background and occluded pixels that are holes in a surface take the nearest neighbour's
//    attributes, by the eight masks, as often as the projected point spacing needs it, and no
//    oftener than something changes.
// 2. Where points are farther apart than pixels, this is done in coarser levels, from which the
//    finer ones are filled then (pull and push).
// 3. Normals, depths, colours and the factors of lights that cast shadows are smoothed by the
//    alleviated Gaussian.
// It reads what the stages that project wrote (vtkPointSplatImages, of either kind), and writes
// texels: by compute shaders to buffers from buffers, by fragments to textures from textures. On
// the way: two images of two uints a pixel, the coded depth and the pixel whose attributes are
// meant, so that a step of filling moves 8 bytes a pixel whatever the attributes are.
#ifndef vtkPointSplatFill_h
#define vtkPointSplatFill_h

#include "vtkPointSplatStages.h"

#include <map>
#include <string>

class vtkPointSplatFill
{
public:
  vtkPointSplatFill() = default;
  ~vtkPointSplatFill() = default;
  vtkPointSplatFill(const vtkPointSplatFill&) = delete;
  void operator=(const vtkPointSplatFill&) = delete;

  /**
   * Fills and smooths what was projected. rectangle: the pixels that can hold something (first
   * x, y, last x, y); steps: how often holes are filled at most. False, with GetError(), where a
   * shader does not compile.
   */
  bool Reconstruct(vtkOpenGLRenderWindow* window, const vtkPointSplatView& view,
    const std::vector<vtkPointSplatItem>& items, vtkPointSplatImages& projected,
    const glm::ivec4& rectangle, int steps, float depthUnit, vtkPointSplatImages& images);

  /// Steps of filling that the last call made.
  int GetNumberOfSteps() const { return this->Steps; }
  vtkIdType GetMemorySize() const; // bytes
  const std::string& GetError() const { return this->Error; }
  void Release();

private:
  enum Stage
  {
    FirstStep,
    NextStep,
    Pull,
    Push,
    Smoothing
  };

  /**
   * Of half the pixels a side of the level before.
   */
  struct Level
  {
    glm::ivec2 Size{ 0, 0 };
    glm::ivec4 Window{ 0 };          // pixels that can hold something
    GLuint Targets[2] = { 0, 0 };    // buffers, or the textures
    GLuint Textures[2] = { 0, 0 };   // RG32UI, of the buffers or not
    int Now = 0;                     // which holds the level
  };

  /**
   * What all stages are told.
   */
  struct Parameters
  {
    std::vector<float> Layers;
    std::vector<float> LayerPixels;
    std::vector<float> Spacings;
    glm::uvec2 Silhouettes{ 0u };
    glm::vec2 PixelSize{ 0.0f };
    glm::vec2 RayOffset{ 0.0f };
    glm::vec2 RayScale{ 0.0f };
    float DepthUnit = 1.0f;
  };

  static int LevelsFor(double spacing);
  vtkPointSplatProgram* Use(Stage stage, const vtkPointSplatImages& projected);
  /// Draws a stage that reads a level of this index. factors: where smoothing writes those of
  /// the lights to, or 0.
  bool Draw(vtkOpenGLRenderWindow* window, Stage stage, size_t index,
    vtkPointSplatImages& projected, GLuint to, GLuint factors = 0);
  bool DrawStep(vtkOpenGLRenderWindow* window, size_t index, bool first,
    vtkPointSplatImages& projected, bool* changed);
  void Allocate(bool compute, const glm::ivec2& size, int levels);
  void ReleaseImages();

  std::map<std::string, vtkPointSplatProgram> Programs; // by kind, file and defines
  bool Compute = false;
  std::vector<Level> Levels;
  GLuint Changed = 0; // a buffer: whether a step filled anything
  GLuint Framebuffer = 0;
  GLuint VertexArray = 0;
  int Steps = 0;
  Parameters Given;
  std::string Error;
};

#endif
