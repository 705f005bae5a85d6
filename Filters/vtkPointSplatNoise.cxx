// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatNoise.h"

#include "vtkAlgorithm.h"
#include "vtkMath.h"
#include "vtkPointSplatPrincipal.h"
#include "vtkPointSplatRobustSurface.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// One of so many leaves is looked at: three in a hundred points, at that share of a search's time.
constexpr vtkPointSplatNeighbors::Slot Stride = 32;
/// Neighbours and bandwidths as vtkPointSplatProjection has them by default.
constexpr int ProjectionNeighbors = 24;
constexpr float Bandwidth = 0.5f;
/// Of the deviation from a plane, the square root of the least eigenvalue of the neighbours'
/// covariance, over that of the middle one, which is 1.4 spacings for 24 neighbours: positions that
/// deviate by less than a tenth of their spacing are no noise, whatever the normals say.
constexpr double LeastFlatness = 0.07;

/// From which share of points off their neighbours' surface on estimated normals tell noise: those of 12 neighbours are off
/// it, too, where the surface turns within these. Of meshes' vertices up to 0.7 are if these are 300 of a scan, of noise of 0.3 spacings 0.9.
constexpr double LeastGuessedNoise = 0.7; // Testing/Cxx/TestSplatsNoise.cxx

/// Or from which share of points with others above or below: of noise of 0.2 spacings 0.2 are, on thin tubes 0.12, and of a plate
/// that is one to one and a half spacings thick 0.37 and more.
constexpr double LeastGuessedContradiction = 0.25; // ribbed_plate, Testing/Accuracy/TestStandIns.py

/// Of meshes' vertices and points on surfaces at random fewer than 0.04 are off it, of scans with trees and bushes 0.2 and more.
constexpr double MostOfClean = 0.1;

/// Of the neighbours of a point of a surface, its noise and all, about none face the other way.
constexpr double MostAway = 0.25; // Testing/Cxx/TestSplatApart.cxx

// Of isosurfaces of volumes with noise, of few grey values as well, 0.93 of the points and more lie on the lattice, and 0.08 and
// more along the second of the axes; of quantised scans and noisy heights over a grid at most 0.03.
// (Testing/Cxx/TestSplatsNoise.cxx)
constexpr int LeastInPlane = 3; // neighbours in a plane of the lattice, of 24
constexpr double LeastOnLattice = 0.9;
constexpr double LeastAlongSecond = 0.05;

/// Whether the positions of neighbours are off any plane: normals that others than the surface's
/// geometry gave, as of waves on a flat sea, contradict it on purpose.
bool IsRough(const vtkPointSplatNeighbors::Neighborhood& around)
{
  const vtkPointSplatPrincipal principal(around, around.Count, false);
  return principal.Variances[2] > LeastFlatness * LeastFlatness * principal.Variances[1];
}

/// Which points lie on the edges of a volume's lattice, as the vertices of isosurfaces do: two coordinates of each are those of
/// neighbours beside it, in the lattice's planes that meet in the edge.
struct Lattice
{
  vtkIdType Points = 0;
  vtkIdType Along[3] = { 0, 0, 0 }; // of these, whose third coordinate, along an axis, is their own

  void Look(const vtkPointSplatNeighbors::Neighborhood& around)
  {
    int same[3] = { 0, 0, 0 };
    for (int i = 0; i < around.Count; ++i)
    {
      same[0] += around.X[i] == 0 ? 1 : 0;
      same[1] += around.Y[i] == 0 ? 1 : 0;
      same[2] += around.Z[i] == 0 ? 1 : 0;
    }
    const int axis = static_cast<int>(std::min_element(same, same + 3) - same);
    if (same[(axis + 1) % 3] >= LeastInPlane && same[(axis + 2) % 3] >= LeastInPlane)
    {
      ++this->Points;
      this->Along[axis] += same[axis] < LeastInPlane ? 1 : 0;
    }
  }

  void Add(const Lattice& other)
  {
    this->Points += other.Points;
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Along[axis] += other.Along[axis];
    }
  }

  /// all: how many points were looked at.
  bool HasIsosurface(double all) const
  {
    vtkIdType along[3];
    std::partial_sort_copy(this->Along, this->Along + 3, along, along + 3);
    return this->Points > LeastOnLattice * all && along[1] > LeastAlongSecond * all;
  }
};

/// Whether many of the neighbours face the other way: those of a body that is no larger than where they lie, as the
/// specks of an isosurface of noise are, are off any plane, and nothing is off its surface.
bool IsSmallBody(const vtkPointSplatNeighbors::Neighborhood& around, const float* normals)
{
  const float* own = normals + std::size_t(3) * around.Center;
  int away = 0;
  for (int i = 0; i < around.Count; ++i)
  {
    away += vtkMath::Dot(own, normals + std::size_t(3) * around.Slots[i]) < 0 ? 1 : 0;
  }
  return MostAway * around.Count < away;
}

/// Whether something that faces the other way lies between the point and what is that high above it, or below: as the
/// near side of the next body does, beyond which its far side faces as the point does.
bool IsSeparated(
  const vtkPointSplatNeighbors::Neighborhood& around, const float* normals, float height)
{
  const float* own = normals + std::size_t(3) * around.Center;
  for (int i = 0; i < around.Count; ++i)
  {
    const float d[3] = { around.X[i], around.Y[i], around.Z[i] };
    const float way = vtkMath::Dot(d, own);
    if (vtkMath::Dot(own, normals + std::size_t(3) * around.Slots[i]) < 0 && way * height > 0 &&
      std::abs(way) < std::abs(height))
    {
      return true;
    }
  }
  return false;
}

/// Whether a neighbour lies above or below the point, on a side that both normals agree on, with nothing between.
bool HasContradiction(
  const vtkPointSplatNeighbors::Neighborhood& around, const float* normals)
{
  const float* own = normals + std::size_t(3) * around.Center;
  for (int i = 0; i < around.Count; ++i)
  {
    const float* other = normals + std::size_t(3) * around.Slots[i];
    const float d[3] = { around.X[i], around.Y[i], around.Z[i] };
    const float cosine = vtkMath::Dot(own, other);
    // Along the sum of both normals, which is sqrt(2 + 2 cosine) long.
    const float ownHeight = vtkMath::Dot(d, own);
    const float height = ownHeight + vtkMath::Dot(d, other);
    if (cosine > 0.5f && height * height > (1 + cosine) * around.SquaredDistance[i] &&
      !IsSeparated(around, normals, ownHeight))
    {
      return true;
    }
  }
  return false;
}
}

vtkPointSplatNoise::Shares vtkPointSplatNoise::Measure(
  vtkAlgorithm* self, const vtkPointSplatNeighbors& neighbors, const float* normals, bool guessed)
{
  using Slot = vtkPointSplatNeighbors::Slot;
  struct Counts
  {
    vtkIdType All = 0;
    vtkIdType Noisy = 0;
    vtkIdType Contradicted = 0;
    Lattice OnLattice;
  };
  vtkSMPThreadLocal<Counts> counts;
  auto measure = [&](const vtkPointSplatNeighbors::Neighborhood& around, int) {
    if (around.Count < ProjectionNeighbors)
    {
      return true; // the cloud is a body that is no larger than what is looked at
    }
    vtkPointSplatRobustSurface surface(Bandwidth, Bandwidth);
    surface.Gather(around, normals);
    surface.FindNormal();
    const bool found = surface.Project();
    Counts& own = counts.Local();
    ++own.All;
    own.Noisy += found && surface.Noise > Noisy && IsRough(around) && !IsSmallBody(around, normals) ? 1 : 0;
    own.Contradicted += HasContradiction(around, normals) ? 1 : 0;
    own.OnLattice.Look(around);
    return true;
  };
  const double progress = self->GetProgress();
  neighbors.Visit(self, progress, progress, ProjectionNeighbors, measure,
    [](Slot slot) { return slot / vtkPointSplatNeighbors::LeafSize % Stride == 0; });
  Counts sum;
  for (const Counts& own : counts)
  {
    sum.All += own.All;
    sum.Noisy += own.Noisy;
    sum.Contradicted += own.Contradicted;
    sum.OnLattice.Add(own.OnLattice);
  }
  const double all = static_cast<double>(std::max<vtkIdType>(sum.All, 1));
  const bool isosurface = !guessed && sum.OnLattice.HasIsosurface(all);
  const double noisy = sum.Noisy / all;
  const Shares found{ noisy, isosurface ? 0.0 : sum.Contradicted / all, noisy < MostOfClean };
  const bool told = !guessed || found.Noisy > LeastGuessedNoise || found.Contradicted > LeastGuessedContradiction;
  return told ? found : Shares{ 0, 0, found.Clean };
}

VTK_ABI_NAMESPACE_END
