// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatPatches.h"

#include <numeric>

namespace
{
constexpr uint32_t BesideSplats = 0x80000000u; // as in vtkPointSplatTrianglesCS.glsl
}

//------------------------------------------------------------------------------
vtkPointSplatPatches::vtkPointSplatPatches(
  const vtkPointSplatView& view, const vtkPointSplatItem& item)
  : Triangles(item.Cloud->GetTriangles())
  , PixelSize(view, item)
  , Pixels(item.TrianglePixels)
  , IsTaken(this->Triangles.GetNumberOfPatches(), false)
{
}

//------------------------------------------------------------------------------
bool vtkPointSplatPatches::IsMagnified(const vtkPointSplatTriangles::Extent& extent) const
{
  return this->Pixels > 0.0 && extent.Edge > 0.0f &&
    extent.Edge * this->PixelSize.At(extent) >= this->Pixels;
}

//------------------------------------------------------------------------------
void vtkPointSplatPatches::Take(uint32_t patch)
{
  this->Taken.push_back(patch);
  this->IsTaken[patch] = true;
}

//------------------------------------------------------------------------------
void vtkPointSplatPatches::AddTo(vtkPointSplatRuns& chosen) const
{
  const std::vector<vtkPointSplatTriangles::Patch>& patches = this->Triangles.GetPatches();
  const std::vector<vtkPointSplatTriangles::Shared>& shared = this->Triangles.GetShared();
  const std::vector<vtkPointSplatRuns::Run>& loose = this->Triangles.GetLoose();
  for (const uint32_t taken : this->Taken)
  {
    const vtkPointSplatTriangles::Patch& patch = patches[taken];
    const vtkPointSplatTriangles::Patch& next = patches[size_t(taken) + 1];
    const size_t inside = chosen.Triangles.size();
    chosen.Triangles.resize(inside + patch.Crossing - patch.First);
    const bool mixed = next.FirstLoose > patch.FirstLoose;
    std::iota(chosen.Triangles.begin() + static_cast<std::ptrdiff_t>(inside),
      chosen.Triangles.end(), patch.First | (mixed ? BesideSplats : 0u));
    for (uint32_t s = patch.FirstShared; s < next.FirstShared; ++s)
    {
      bool mine = true;
      bool beside = mixed;
      for (const uint32_t other : shared[s].Patches)
      {
        mine = mine && (other >= taken || !this->IsTaken[other]);
        beside = beside || !this->IsTaken[other];
      }
      if (mine)
      {
        chosen.Triangles.push_back(shared[s].Triangle | (beside ? BesideSplats : 0u));
      }
    }
    chosen.Runs.insert(
      chosen.Runs.end(), loose.begin() + patch.FirstLoose, loose.begin() + next.FirstLoose);
  }
}
