// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// From sums to texels where points are projected as single pixels (Dobrev, Rosenthal,
// Linsen 2010, section 3):
// 1. Background and occluded pixels that are holes in a surface take the nearest neighbour's
//    attributes, by the eight masks, as often as the projected point spacing needs it.
// 2. Where points are farther apart than pixels, this is done in coarser levels, from which the
//    finer ones are filled then (pull and push).
// 3. Normals, depths, colours and the factors of lights that cast shadows are smoothed by the
//    alleviated Gaussian.
// On the way: two images of two uints a pixel (RG32UI), the coded depth and the pixel whose
// attributes are meant, so that a step of filling moves 8 bytes a pixel whatever the attributes are.
#ifndef vtkPointSplatFill_h
#define vtkPointSplatFill_h

#include "vtkPointSplatFramebuffer.h"
#include "vtkPointSplatItemTable.h"
#include "vtkPointSplatLayers.h"
#include "vtkPointSplatProgram.h"
#include "vtkPointSplatRequest.h"
#include "vtkPointSplatScreen.h"
#include "vtkPointSplatSums.h"

#include <map>
#include <string>
#include <vector>

class vtkPointSplatFill
{
public:
  /**
   * Writes a layer's texels and the coded depths (R32UI) by which the next ones are peeled. False,
   * with GetError(), where a shader does not compile.
   */
  bool Reconstruct(const vtkPointSplatRequest& request, const vtkPointSplatItemTable& items,
    const vtkPointSplatSums& sums, vtkPointSplatLayers& layers, int layer,
    const vtkPointSplatImage& codes);

  /// Steps of filling that the last call made.
  int GetNumberOfSteps() const { return this->Steps; }
  const std::string& GetError() const { return this->Error; }
  vtkIdType GetMemorySize() const; // bytes
  void Release();

private:
  /// Of half the pixels a side of the level before.
  struct Level
  {
    vtkPointSplatImage Images[2]{ vtkPointSplatImage(GL_RG32UI), vtkPointSplatImage(GL_RG32UI) };
    glm::ivec4 Window{ 0 }; // pixels that can hold something
    int Now = 0;            // which holds the level
  };

  static int LevelsFor(double spacing);
  vtkPointSplatProgram* Use(const char* file, const std::string& defines);
  /// Sets what all stages take of the level that they read.
  void SetLevel(vtkPointSplatProgram& program, vtkPointSplatUnits& units, size_t index) const;
  /// Sets the part of the framebuffer bound that a stage writes, and draws.
  void Draw(const glm::ivec2& size, const glm::ivec4& window);
  bool Step(const vtkPointSplatSums& sums, size_t index, bool first);
  bool Pull(size_t index);
  bool Push(size_t index);

  std::map<std::string, vtkPointSplatProgram> Programs; // by file and defines
  std::vector<Level> Levels;
  vtkPointSplatFramebuffer Framebuffer;
  vtkPointSplatFramebuffer Result;
  vtkPointSplatScreen Screen;
  const vtkPointSplatItemTable* Items = nullptr; // while it reconstructs
  unsigned int TagMask = 0;
  glm::vec2 PixelSize{ 0.0f };
  int Steps = 0;
  std::string Error;
};

#endif
