// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatSurfaces.h"

#include "vtkPointSplatSelection.h"

#include <algorithm>
#include <sstream>

namespace
{
// Parts of fewer splats than this are not divided further.
constexpr vtkIdType LeastAtOnce = 1 << 12;

/// Splats of the item's blocks, every 2^StrideShift-th of each.
vtkIdType ProjectedOf(const vtkPointSplatItem& item)
{
  const vtkIdType last = (vtkIdType(1) << item.StrideShift) - 1;
  if (!item.Runs)
  {
    // Blocks but for the last one are multiples of strides.
    return (item.Cloud->GetNumberOfSplats() + last) >> item.StrideShift;
  }
  vtkIdType count = 0;
  for (const vtkPointSplatRuns::Run& run : item.Runs->Runs)
  {
    count += (run.Count + last) >> item.StrideShift;
  }
  return count;
}
}

//------------------------------------------------------------------------------
bool vtkPointSplatSurfaces::Build(
  vtkPointSplatRequest request, vtkPointSplatReconstruction& reconstruction)
{
  const vtkPointSplatContext& context = vtkPointSplatContext::Entered();
  if (this->Built && this->Context == context && this->Request == request)
  {
    this->Request.View.Origin = request.View.Origin;
    return true;
  }
  this->Built = false;
  this->Request = std::move(request);
  this->Context = context;
  ++this->Generation;
  this->Projected.assign(this->Request.Items.size(), {});
  const glm::ivec4 window = this->Request.GetWindow();
  if (this->Request.MaximumLayers == 0 || window.x > window.z || window.y > window.w)
  {
    this->Layers.SetNumberOfLayers(0);
    this->Outlines.Clear();
    this->Built = true;
    return true;
  }
  vtkPointSplatTiles::Result result = vtkPointSplatTiles::TooMany;
  for (vtkIdType splats = this->SplatsAtOnce;
       result == vtkPointSplatTiles::TooMany && splats >= LeastAtOnce; splats /= 2)
  {
    // What was too much once is not tried in each frame.
    this->SplatsAtOnce = splats;
    const std::vector<vtkPointSplatPart> parts = vtkPointSplatSelection::Divide(this->Request.View,
      this->Request.Items, window,
      vtkPointSplatReconstruction::UsesTiles(this->Request) ? splats : VTK_ID_MAX);
    this->Count(parts);
    result = reconstruction.Build(this->Request, parts, this->Layers, this->Outlines);
  }
  this->Error = result == vtkPointSplatTiles::TooMany
    ? "so many splats are so large that the lists of tiles do not fit; lower RadiusScale."
    : reconstruction.GetError();
  this->FillSteps = reconstruction.GetNumberOfFillSteps();
  this->Built = result == vtkPointSplatTiles::Made;
  return this->Built;
}

//------------------------------------------------------------------------------
void vtkPointSplatSurfaces::Count(const std::vector<vtkPointSplatPart>& parts)
{
  for (size_t slot = 0; slot < this->Projected.size(); ++slot)
  {
    this->Projected[slot] = {};
    for (const vtkPointSplatPart& part : parts)
    {
      const vtkPointSplatItem& item = part.Items[slot];
      if (item.IsInView())
      {
        this->Projected[slot].Splats += ProjectedOf(item);
        this->Projected[slot].Triangles += item.GetNumberOfTriangles();
      }
    }
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatSurfaces::Release()
{
  this->Layers.Release();
  this->Outlines.Release();
  this->Flat.Release();
  this->Built = false;
  this->SplatsAtOnce = vtkPointSplatTiles::Capacity;
}
