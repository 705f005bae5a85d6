// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkParticleSurfaceProbe
 * @brief   how densely particles lie around one
 *
 * Internal to vtkParticleSurfaceKernels.
 */
#ifndef vtkParticleSurfaceProbe_h
#define vtkParticleSurfaceProbe_h

#include "vtkMath.h"
#include "vtkPointSplatNeighbors.h"

#include <cmath>

VTK_ABI_NAMESPACE_BEGIN

struct vtkParticleSurfaceProbe
{
  using Neighborhood = vtkPointSplatNeighbors::Neighborhood;

  /// With less of them only the nearest counts.
  static constexpr int LeastRanks = 8;

  double Dimension = 0; // 3 in a body, 2 in a sheet, 1 in a line, or between; 0 if unknown
  double LogDistance = 0, LogRank = 0; // means over the ranks
  double Nearest = 0;

  /// The mean logarithms of distances, and of how many particles are within, the particle itself
  /// included: between those just within and just past.
  static void GetMeans(
    const Neighborhood& around, int first, int last, double& distance, double& rank)
  {
    distance = rank = 0;
    for (int k = first; k < last; ++k)
    {
      distance += 0.5 * std::log(static_cast<double>(around.SquaredDistance[k])) / (last - first);
      rank += std::log(k + 1.5) / (last - first);
    }
  }

  void Measure(const Neighborhood& around)
  {
    this->Nearest = std::sqrt(static_cast<double>(around.SquaredDistance[0]));
    if (around.Count >= LeastRanks)
    {
      // Means over many ranks, since in lattices distances come in steps.
      double distances[2], ranks[2];
      GetMeans(around, around.Count / 8, around.Count / 3, distances[0], ranks[0]);
      GetMeans(around, 2 * around.Count / 3, around.Count, distances[1], ranks[1]);
      this->Dimension = (ranks[1] - ranks[0]) / (distances[1] - distances[0]);
      GetMeans(around, around.Count / 8, around.Count, this->LogDistance, this->LogRank);
    }
  }

  double GetSpacing(int dimension) const
  {
    const double ball = dimension == 1 ? 2 : dimension == 2 ? vtkMath::Pi() : vtkMath::Pi() * 4 / 3;
    return this->LogRank > 0
      ? std::exp(this->LogDistance - (this->LogRank - std::log(ball)) / dimension)
      : this->Nearest;
  }
};

VTK_ABI_NAMESPACE_END
#endif
