// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The surface layers of splat actors that are drawn together, kept as long as they are right: for
// the passes of a hardware selection and of depth peeling, and for frames in which only other
// things changed.
#ifndef vtkPointSplatSurfaces_h
#define vtkPointSplatSurfaces_h

#include "vtkPointSplatBudget.h"
#include "vtkPointSplatFlat.h"
#include "vtkPointSplatMeasuredErrors.h"
#include "vtkPointSplatLayers.h"
#include "vtkPointSplatReconstruction.h"
#include "vtkPointSplatRequest.h"

/**
 * What was projected of an item: of the blocks in view, in each part of the window.
 */
struct vtkPointSplatProjected
{
  vtkIdType Splats = 0;
  vtkIdType Triangles = 0;
};

class vtkPointSplatSurfaces
{
public:
  /// Makes the layers, unless they are there. False, with GetError(), where OpenGL refuses.
  bool Build(vtkPointSplatRequest request, vtkPointSplatReconstruction& reconstruction);

  const vtkPointSplatRequest& GetRequest() const { return this->Request; }
  vtkPointSplatLayers& GetLayers() { return this->Layers; }
  /// Of the layers; none where they are not smoothed.
  const vtkPointSplatOutlines& GetOutlines() const { return this->Outlines; }
  /// Counts the times that layers were made.
  unsigned long GetGeneration() const { return this->Generation; }
  int GetNumberOfFillSteps() const { return this->FillSteps; }
  vtkPointSplatProjected GetProjected(size_t slot) const
  {
    // None before the first Build(), as where a frame failed before.
    return slot < this->Projected.size() ? this->Projected[slot] : vtkPointSplatProjected();
  }

  vtkPointSplatBudget Budget;
  vtkPointSplatMeasuredErrors Errors;
  vtkPointSplatFlatImages Flat;
  unsigned long FlatFrame = 0; // whose layers Flat shows
  unsigned long FlatGeneration = 0;
  unsigned long LookGeneration = 0; // whose layers' textures were looked up

  vtkIdType GetMemorySize() const { return this->Layers.GetMemorySize() + this->Outlines.GetMemorySize(); }
  const std::string& GetError() const { return this->Error; }
  void Release();

private:
  void Count(const std::vector<vtkPointSplatPart>& parts);

  vtkPointSplatRequest Request;
  vtkPointSplatLayers Layers;
  vtkPointSplatOutlines Outlines;
  vtkPointSplatContext Context; // that they were made in
  bool Built = false;
  unsigned long Generation = 0;
  int FillSteps = 0;
  std::vector<vtkPointSplatProjected> Projected; // a slot
  vtkIdType SplatsAtOnce = vtkPointSplatTiles::Capacity;
  std::string Error;
};

#endif
