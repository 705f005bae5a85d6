// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatRequest.h"

#include "vtkPointSplatLayers.h"

#include <algorithm>
#include <utility>

//------------------------------------------------------------------------------
bool vtkPointSplatRequest::operator==(const vtkPointSplatRequest& other) const
{
  return this->View == other.View && this->Items == other.Items &&
    this->CloudTimes == other.CloudTimes && this->Compute == other.Compute &&
    this->OnDevice == other.OnDevice && this->Deferred == other.Deferred &&
    this->Voronoi == other.Voronoi && this->FillSteps == other.FillSteps &&
    this->MaximumLayers == other.MaximumLayers &&
    this->LeastContribution == other.LeastContribution && this->Gather == other.Gather &&
    this->ShowsEach == other.ShowsEach && this->SceneDepth == other.SceneDepth &&
    (this->SceneDepth == 0 || this->SceneFrame == other.SceneFrame) &&
    this->MaximumMemory == other.MaximumMemory && this->Outlines == other.Outlines &&
    this->HasIds == other.HasIds &&
    (!this->HasIds || this->Ids == other.Ids);
}

//------------------------------------------------------------------------------
bool vtkPointSplatRequest::HasColours() const
{
  return std::any_of(this->Items.begin(), this->Items.end(),
    [](const vtkPointSplatItem& item) { return item.Cloud->HasColours(); });
}

//------------------------------------------------------------------------------
bool vtkPointSplatRequest::HasValues() const
{
  return std::any_of(this->Items.begin(), this->Items.end(),
    [](const vtkPointSplatItem& item) { return item.Cloud->HasValues(); });
}

//------------------------------------------------------------------------------
bool vtkPointSplatRequest::HasCellColours() const
{
  return !this->HasIds &&
    std::any_of(this->Items.begin(), this->Items.end(),
      [](const vtkPointSplatItem& item) { return item.Cloud->HasCellColours(); });
}

//------------------------------------------------------------------------------
std::string vtkPointSplatRequest::GetAppearanceDefines(bool gathered) const
{
  // What is gathered has mean colours and normals.
  return std::string(this->HasValues() && !gathered ? "#define VALUES\n" : "") +
    (this->HasCellColours() && !gathered ? "#define CELL_COLOURS\n" : "") +
    (this->HasFacets() && !gathered ? "#define FACETS\n" : "");
}

//------------------------------------------------------------------------------
bool vtkPointSplatRequest::HasFacets() const
{
  return !this->HasIds &&
    std::any_of(this->Items.begin(), this->Items.end(),
      [](const vtkPointSplatItem& item) { return item.IsFlat; });
}

//------------------------------------------------------------------------------
bool vtkPointSplatRequest::HasClipLines() const
{
  return std::any_of(this->Items.begin(), this->Items.end(),
    [](const vtkPointSplatItem& item) { return item.Cloud->HasClipLines(); });
}

//------------------------------------------------------------------------------
bool vtkPointSplatRequest::HasLook(bool (*test)(const vtkPointSplatItemLook&)) const
{
  return !this->HasIds &&
    std::any_of(this->Items.begin(), this->Items.end(),
      [test](const vtkPointSplatItem& item) { return test(item.Look); });
}

//------------------------------------------------------------------------------
int vtkPointSplatRequest::GetLookTexels() const
{
  int most = 0;
  for (const vtkPointSplatItem& item : this->Items)
  {
    most = std::max(most, this->HasIds ? 0 : item.Look.GetTexels());
  }
  return most;
}

//------------------------------------------------------------------------------
std::string vtkPointSplatRequest::GetLookDefines() const
{
  using Look = vtkPointSplatItemLook;
  const std::pair<const char*, bool (*)(const Look&)> parts[] = {
    { "#define COORDINATES\n", [](const Look& look) { return look.Coordinates; } },
    { "#define TANGENTS\n", [](const Look& look) { return look.Tangents; } },
    { "#define EDGES\n", [](const Look& look) { return look.EdgeWidth > 0.0f; } },
  };
  std::string defines;
  for (const auto& part : parts)
  {
    defines += this->HasLook(part.second) ? part.first : "";
  }
  return defines;
}

//------------------------------------------------------------------------------
int vtkPointSplatRequest::GetFactorCount() const
{
  int count = 0;
  for (const vtkPointSplatItem& item : this->Items)
  {
    count = std::max(count, item.FactorCount);
  }
  return count;
}

//------------------------------------------------------------------------------
unsigned int vtkPointSplatRequest::GetTagMask() const
{
  unsigned int mask = 127; // 64 slots, so that depths are as fine in small scenes
  while (mask < 2 * this->Items.size())
  {
    mask = 2 * mask + 1;
  }
  return mask;
}

//------------------------------------------------------------------------------
int vtkPointSplatRequest::GetMostLayers(vtkIdType room) const
{
  if (this->MaximumMemory > 0)
  {
    room = std::min(room,
      this->MaximumMemory /
        vtkPointSplatLayers::BytesPerLayer(
          this->View.Size, this->GetFactorCount(), this->GetLookTexels()));
  }
  return static_cast<int>(
    std::min<vtkIdType>(this->MaximumLayers, std::max<vtkIdType>(room, 1)));
}

//------------------------------------------------------------------------------
int vtkPointSplatRequest::GetLayersThatCount() const
{
  double through = 0.0; // of the light behind a layer, at most
  for (const vtkPointSplatItem& item : this->Items)
  {
    const double least =
      item.Cloud->HasColours() ? 0.0 : std::min(item.Opacities.x, item.Opacities.y);
    through = std::max(through, 1.0 - least);
  }
  int count = 1;
  for (double light = through; light >= this->LeastContribution && count < this->MaximumLayers; ++count)
  {
    light *= through;
  }
  return count;
}

//------------------------------------------------------------------------------
double vtkPointSplatRequest::GetVoronoiScale() const
{
  double layer = 0.0;
  for (const vtkPointSplatItem& item : this->Items)
  {
    layer = std::max(layer, item.LargestLayer);
  }
  return this->Voronoi ? std::min(layer, this->View.Far - this->View.Near) : 0.0;
}

//------------------------------------------------------------------------------
double vtkPointSplatRequest::GetDepthUnit() const
{
  double layer = 0.0;
  for (const vtkPointSplatItem& item : this->Items)
  {
    layer = std::max(layer, item.LargestLayer);
  }
  // Splats seen edge-on may lie 5 layer distances off along the ray (LeastFacing in
  // vtkPointSplatProjection.glsl). Nothing lies farther off than the clipping planes.
  const double range = this->View.Far - this->View.Near;
  return layer > 0.0 && 5.0 * layer < range ? 5.0 * layer : range;
}

//------------------------------------------------------------------------------
glm::ivec4 vtkPointSplatRequest::GetWindow() const
{
  const glm::ivec2& size = this->View.Size;
  glm::ivec4 window(size.x, size.y, -1, -1);
  for (const vtkPointSplatItem& item : this->Items)
  {
    if (item.IsInView())
    {
      // And one row more: in multisampled framebuffers Mesa lets samples of the next one through.
      window = glm::ivec4(std::min(window.x, item.Window.x),
        std::min(window.y, std::max(item.Window.y - 1, 0)), std::max(window.z, item.Window.z),
        std::max(window.w, std::min(item.Window.w + 1, size.y - 1)));
    }
  }
  return window;
}
