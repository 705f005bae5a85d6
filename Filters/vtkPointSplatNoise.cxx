// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatNoise.h"

#include "vtkPointSplatRobustSurface.h"

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// One of so many leaves is looked at: three in a hundred points, at that share of a search's time.
constexpr vtkPointSplatNeighbors::Slot Stride = 32;
/// Neighbours and bandwidths as vtkPointSplatProjection has them by default.
constexpr int NumberOfNeighbors = 24;
constexpr float Bandwidth = 0.5f;
}

double vtkPointSplatNoise::Measure(
  vtkAlgorithm* self, const vtkPointSplatNeighbors& neighbors, const float* normals)
{
  using Slot = vtkPointSplatNeighbors::Slot;
  struct Counts
  {
    vtkIdType All = 0;
    vtkIdType Noisy = 0;
  };
  vtkSMPThreadLocal<Counts> counts;
  auto measure = [&](const vtkPointSplatNeighbors::Neighborhood& around, int) {
    vtkPointSplatRobustSurface surface(Bandwidth, Bandwidth);
    surface.Gather(around, normals);
    surface.FindNormal();
    const bool found = surface.Project();
    Counts& own = counts.Local();
    ++own.All;
    own.Noisy += found && surface.Noise > Noisy ? 1 : 0;
    return true;
  };
  const double progress = self->GetProgress();
  neighbors.Visit(self, progress, progress, NumberOfNeighbors, measure,
    [](Slot slot) { return slot / vtkPointSplatNeighbors::LeafSize % Stride == 0; });
  Counts sum;
  for (const Counts& own : counts)
  {
    sum.All += own.All;
    sum.Noisy += own.Noisy;
  }
  return sum.All > 0 ? static_cast<double>(sum.Noisy) / sum.All : 0;
}

VTK_ABI_NAMESPACE_END
