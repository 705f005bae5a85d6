// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// Makes the surface layers that a request asks for: by tiles (vtkPointSplatTiles), by deferred
// blending where that is asked for (vtkPointSplatDeferred), and by passes over all splats where
// there are points without an extent, or no compute shaders (vtkPointSplatPasses).
#ifndef vtkPointSplatReconstruction_h
#define vtkPointSplatReconstruction_h

#include "vtkPointSplatDeferred.h"
#include "vtkPointSplatLayers.h"
#include "vtkPointSplatPasses.h"
#include "vtkPointSplatRequest.h"
#include "vtkPointSplatTiles.h"

#include <string>

class vtkPointSplatReconstruction
{
public:
  /// Whether a request's layers are made by tiles.
  static bool UsesTiles(const vtkPointSplatRequest& request);

  /**
   * parts: the request's items in parts of its window, with the blocks that these show; more than
   * one only for tiles.
   */
  vtkPointSplatTiles::Result Build(const vtkPointSplatRequest& request,
    const std::vector<vtkPointSplatPart>& parts, vtkPointSplatLayers& layers,
    vtkPointSplatOutlines& outlines);

  /// Steps of filling that the last call made.
  int GetNumberOfFillSteps() const { return this->FillSteps; }
  vtkIdType GetMemorySize() const
  {
    return this->Tiles.GetMemorySize() + this->Passes.GetMemorySize() +
      this->Deferred.GetMemorySize();
  }
  const std::string& GetError() const { return this->Error; }
  void Release();

private:
  vtkPointSplatTiles Tiles;
  vtkPointSplatPasses Passes;
  vtkPointSplatDeferred Deferred;
  int FillSteps = 0;
  std::string Error;
};

#endif
