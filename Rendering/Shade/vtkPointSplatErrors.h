// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Measures how much a frame would differ if less work had been done for it.
//
// 1. What is behind all layers is copied from a framebuffer, if it is there.
// 2. Pixels on a grid, no more than some ten thousand, are shaded and blended
//    (vtkPointSplatErrorsFS.glsl): with all of their layers and with those before each of some shares of the
//    light; or with all of them, to be compared with those of other splats.
// 3. They are read back, and squares of differences averaged over those that have layers.
#ifndef vtkPointSplatErrors_h
#define vtkPointSplatErrors_h

#include "vtkPointSplatFramebuffer.h"
#include "vtkPointSplatLayers.h"
#include "vtkPointSplatProgram.h"
#include "vtkPointSplatScreen.h"
#include "vtkPointSplatShading.h"

#include <map>
#include <string>
#include <vector>

class vtkPointSplatErrors
{
public:
  static constexpr size_t Shares = 16; // as in the shader

  /// Copies what is behind the layers that are measured next, from a rectangle of a framebuffer.
  void TakeBehind(GLuint framebuffer, const glm::ivec2& origin, const glm::ivec2& size);
  void ForgetBehind();

  /**
   * Rms differences of colour, of 1, of peeling that ends where less than each of Shares lights is left;
   * none where no pixel has layers, or, with GetError(), where the shader does not build. window: of the
   * image, where the grid lies.
   */
  std::vector<double> MeasureEnds(const vtkPointSplatShading& shading,
    const vtkPointSplatLayers& layers, const glm::ivec4& window, const std::vector<float>& lights);

  /// The grid's pixels: colours, and whether there are layers; none, with GetError(), as above.
  std::vector<float> Blend(const vtkPointSplatShading& shading, const vtkPointSplatLayers& layers,
    const glm::ivec4& window);
  /// The rms difference of colour, of 1, between what Blend() gave.
  static double Difference(const std::vector<float>& a, const std::vector<float>& b);

  const std::string& GetError() const { return this->Error; }
  void Release();

private:
  bool Draw(const vtkPointSplatShading& shading, const vtkPointSplatLayers& layers,
    const glm::ivec4& window, const std::vector<float>& lights);
  std::vector<float> Download(int image) const;

  std::map<std::string, vtkPointSplatProgram> Programs; // by defines
  vtkPointSplatImage Pixels{ GL_RGBA32F };
  vtkPointSplatImage Behind{ GL_RGBA16F };
  bool HasBehind = false;
  vtkPointSplatFramebuffer Framebuffer;
  vtkPointSplatScreen Screen;
  std::string Error;
};

#endif
