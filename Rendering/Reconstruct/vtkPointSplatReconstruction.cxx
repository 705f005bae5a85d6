// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatReconstruction.h"

#include <algorithm>

//------------------------------------------------------------------------------
bool vtkPointSplatReconstruction::UsesTiles(const vtkPointSplatRequest& request)
{
  return request.Compute && !request.Deferred &&
    std::none_of(request.Items.begin(), request.Items.end(),
      [](const vtkPointSplatItem& item) { return item.IsPoints; });
}

//------------------------------------------------------------------------------
vtkPointSplatTiles::Result vtkPointSplatReconstruction::Build(const vtkPointSplatRequest& request,
  const std::vector<vtkPointSplatPart>& parts, vtkPointSplatLayers& layers,
  vtkPointSplatOutlines& outlines)
{
  this->FillSteps = 0;
  outlines.Clear();
  if (vtkPointSplatReconstruction::UsesTiles(request))
  {
    const vtkPointSplatTiles::Result result =
      this->Tiles.Reconstruct(request, parts, layers, outlines);
    this->Error = this->Tiles.GetError();
    return result;
  }
  // These draw no more than what is in view, too.
  vtkPointSplatRequest seen = request;
  seen.Items = parts.front().Items;
  bool good = false;
  if (request.Deferred)
  {
    good = this->Deferred.Reconstruct(seen, layers);
    this->Error = this->Deferred.GetError();
  }
  else
  {
    good = this->Passes.Reconstruct(seen, layers);
    this->Error = this->Passes.GetError();
    this->FillSteps = this->Passes.GetNumberOfFillSteps();
  }
  return good ? vtkPointSplatTiles::Made : vtkPointSplatTiles::Failed;
}

//------------------------------------------------------------------------------
void vtkPointSplatReconstruction::Release()
{
  this->Tiles.Release();
  this->Passes.Release();
  this->Deferred.Release();
}
