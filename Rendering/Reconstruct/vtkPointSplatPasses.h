// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Reconstructs surface layers by passes over all splats, one layer after the other: points that are
// projected as single pixels, and all splats where there are no compute shaders.
//
// 1. A layer is summed up: points alone by compute shaders (vtkPointSplatPointSums), splats, and
//    points with them or without compute shaders, by the rasteriser (vtkPointSplatRaster). What
//    belongs to the layers before is left out, by their coded depths.
// 2. Sums become texels: points' holes are filled (vtkPointSplatFill), splats leave none.
// This goes on until nothing is left, or nothing that could change a pixel by the target.
//
// Images: the coded depths (R32UI) of four layers, in turn.
#ifndef vtkPointSplatPasses_h
#define vtkPointSplatPasses_h

#include "vtkPointSplatFill.h"
#include "vtkPointSplatItemTable.h"
#include "vtkPointSplatLayers.h"
#include "vtkPointSplatPointSums.h"
#include "vtkPointSplatRaster.h"
#include "vtkPointSplatRequest.h"

#include <array>
#include <map>
#include <string>

class vtkPointSplatPasses
{
public:
  /// As many items as coded depths tell apart and still are depths.
  static constexpr size_t MostItems = 512;

  /// Makes the layers. False, with GetError(), where shaders do not build.
  bool Reconstruct(const vtkPointSplatRequest& given, vtkPointSplatLayers& layers);

  /// Steps of filling that the last call made.
  int GetNumberOfFillSteps() const { return this->FillSteps; }
  const std::string& GetError() const { return this->Error; }
  vtkIdType GetMemorySize() const; // bytes
  void Release();

private:
  bool MakeLayer(const vtkPointSplatRequest& request, int layer, vtkPointSplatLayers& layers,
    bool& empty);
  bool Normalise(const vtkPointSplatRequest& request, int layer, vtkPointSplatLayers& layers);

  vtkPointSplatItemTable Items;
  vtkPointSplatSums Sums;
  std::array<vtkPointSplatImage, 4> Codes{ { vtkPointSplatImage(GL_R32UI),
    vtkPointSplatImage(GL_R32UI), vtkPointSplatImage(GL_R32UI), vtkPointSplatImage(GL_R32UI) } };
  vtkPointSplatRaster Raster;
  vtkPointSplatPointSums PointSums;
  vtkPointSplatFill Fill;
  std::map<std::string, vtkPointSplatProgram> Normalising; // by defines
  vtkPointSplatFramebuffer Framebuffer;
  vtkPointSplatScreen Screen;
  bool ByCompute = false;
  bool Fills = false;
  int FillSteps = 0;
  std::string Error;
};

#endif
