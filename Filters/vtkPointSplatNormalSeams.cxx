// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatNormalSeams.h"

#include "vtkMath.h"
#include "vtkPointSplatBorderPlane.h"
#include "vtkPointSplatPrincipal.h"
#include "vtkPointSplatQuadric.h"
#include "vtkSMPThreadLocal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
// Limits of the stages in the header (Testing/Accuracy/fit_constants.py). Of the Stanford dragon's 100250 vertices, whose
// triangles are not wound consistently, they find 4594, and of 60 other meshes at most 139 each, where faces fold over.
constexpr float LeaningCosine = 0.7f;
constexpr int NextTo = 8;
constexpr int LeastAcrossPlane = 5;
constexpr float AcrossCosine = 0.8f;
constexpr float MostAngle = 2.2f;
constexpr int MostLikeOwn = 2;
constexpr float LikeOwnCosine = 0.9f;
constexpr float MostOffSurface = 0.1f;
constexpr float AnotherCosine = 0.985f;
constexpr int SeamRounds = 8;

/// Whether the ways to all neighbours, of which there are some, along a plane, leave no wide angle between two next to one another.
bool AreAllAround(const vtkPointSplatNeighbors::Neighborhood& around, const float normal[3])
{
  const vtkPointSplatBorderPlane plane(normal);
  std::vector<double> angles;
  for (int i = 0; i < around.Count; ++i)
  {
    const float way[3] = { around.X[i], around.Y[i], around.Z[i] };
    angles.push_back(plane.GetAngle(way));
  }
  std::sort(angles.begin(), angles.end());
  double widest = 2 * vtkMath::Pi() + angles.front() - angles.back();
  for (std::size_t i = 1; i < angles.size(); ++i)
  {
    widest = std::max(widest, angles[i] - angles[i - 1]);
  }
  return widest < MostAngle;
}
}

vtkPointSplatNormalSeams::vtkPointSplatNormalSeams(
  const vtkPointSplatNeighbors& neighbors, float* normals, const float* planes)
  : Neighbors(neighbors)
  , Normals(normals)
  , Planes(planes)
  , Beside(neighbors.GetNumberOfSlots(), 0)
{
}

bool vtkPointSplatNormalSeams::LeansOver(Slot slot) const
{
  const std::size_t at = std::size_t(3) * slot;
  return std::abs(vtkMath::Dot(this->Normals + at, this->Planes + at)) < LeaningCosine;
}

bool vtkPointSplatNormalSeams::Find(
  const vtkPointSplatNeighbors::Neighborhood& around, float mended[3]) const
{
  vtkPointSplatNeighbors::Neighborhood near = around;
  near.Count = std::min(around.Count, NextTo);
  const float* own = this->Normals + std::size_t(3) * around.Center;
  const bool leansOver = this->LeansOver(around.Center);
  float plane[3];
  if (leansOver)
  {
    std::copy_n(this->Planes + std::size_t(3) * around.Center, 3, plane);
  }
  else
  {
    vtkPointSplatPrincipal(near).GetNormal(plane);
  }
  int across = 0, alike = 0;
  float side = 0;
  for (int i = 0; i < near.Count; ++i)
  {
    const float* n = this->Normals + std::size_t(3) * near.Slots[i];
    alike += std::abs(vtkMath::Dot(n, own)) > LikeOwnCosine;
    const float cosine = vtkMath::Dot(n, plane);
    if (std::abs(cosine) > AcrossCosine)
    {
      ++across;
      side = side == 0 ? std::copysign(1.0f, cosine) : side;
    }
  }
  vtkPointSplatQuadric surface;
  if (across < LeastAcrossPlane || !AreAllAround(near, plane) ||
    !surface.Fit(around, plane) || surface.Residual > MostOffSurface)
  {
    return false;
  }
  std::copy_n(surface.Normal, 3, mended);
  vtkMath::MultiplyScalar(mended, side);
  return leansOver ? alike <= MostLikeOwn : std::abs(vtkMath::Dot(own, mended)) < AnotherCosine;
}

bool vtkPointSplatNormalSeams::IsMended(Slot slot, const float normal[3]) const
{
  const auto found = this->Given.find(slot);
  return found != this->Given.end() && std::equal(normal, normal + 3, found->second.begin());
}

bool vtkPointSplatNormalSeams::Mend(vtkAlgorithm* self, std::vector<unsigned char> slots, int count)
{
  struct Mended
  {
    Slot At;
    std::array<float, 3> Normal;
    std::vector<Slot> Beside;
  };
  std::vector<unsigned char> changed(slots.size(), 0);
  const double progress = self->GetProgress();
  bool more = true;
  for (int round = 0; round < SeamRounds && more; ++round)
  {
    vtkSMPThreadLocal<std::vector<Mended>> found;
    const auto find = [&](const vtkPointSplatNeighbors::Neighborhood& around, int) {
      std::array<float, 3> normal;
      if (this->Find(around, normal.data()))
      {
        found.Local().push_back(
          { around.Center, normal, { around.Slots, around.Slots + around.Count } });
      }
      return true;
    };
    // What a round does not change is not looked at again.
    const bool isFirst = round == 0;
    if (!this->Neighbors.Visit(self, progress, progress, std::max(count, NextTo), find, [&](Slot slot) {
          return slots[slot] && (isFirst ? this->LeansOver(slot) : changed[slot] != 0);
        }))
    {
      return false;
    }
    more = false;
    std::fill(changed.begin(), changed.end(), 0);
    for (const std::vector<Mended>& local : found)
    {
      for (const Mended& mended : local)
      {
        float* normal = this->Normals + std::size_t(3) * mended.At;
        std::copy_n(normal, 3, this->Given[mended.At].begin());
        std::copy_n(mended.Normal.begin(), 3, normal);
        slots[mended.At] = 0;
        this->Beside[mended.At] = 1;
        for (const Slot slot : mended.Beside)
        {
          this->Beside[slot] = changed[slot] = 1;
        }
        more = true;
      }
    }
  }
  return true;
}

VTK_ABI_NAMESPACE_END
