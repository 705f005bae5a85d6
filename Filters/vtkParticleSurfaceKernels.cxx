// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkParticleSurfaceKernels.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkMath.h"
#include "vtkParticleSurfaceCubes.h"
#include "vtkParticleSurfaceProbe.h"
#include "vtkPointSplatInput.h"
#include "vtkPointSplatThreads.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
using Neighborhood = vtkPointSplatNeighbors::Neighborhood;

/// The spacing is measured on so many neighbours, or on this part of all particles, ...
constexpr int MostRanks = 48, RanksPerParticles = 8;
/// ... around about so many particles.
constexpr vtkIdType NumberOfProbes = 20000;
/// A lone particle without a size has this spacing, as a lone point has this radius in
/// vtkPointSplatEstimation.
constexpr double LoneSpacing = 0.1;
/// Volumes that masses and densities tell are in units of the coordinates unless the particles
/// would overlap by more than this.
constexpr double LargestOverlap = 1.5;
/// Sizes differ from the usual one by a factor of 1000 at most.
constexpr double LargestSizeRatio = 1000;
/// The variance along an axis of weights 1 - r^3 in a ball of radius 1.
constexpr double FullVariance = 0.15;
/// The radius of a lone particle's kernel, in spacings: sqrt(3) (3 / (4 pi))^(1/3). Of all radii
/// it lets the level be highest at which the ball has the particle's volume.
constexpr double LoneReach = 1.0745;
/// Of particles that are smaller or larger than the usual ones by more than this, the cubes tell
/// nothing.
constexpr double UsualRatio = 1.3;
/// One neighbour tells no direction, and from so many on they tell it in full.
constexpr double EnoughNeighbors = 10;
/// At its centre the sum of a kernel and its neighbours' alike is at least this, twice the level of
/// the surface: what is thinner than kernels are wide would vanish otherwise.
constexpr double LeastSum = 2 * vtkParticleSurfaceKernels::Isovalue;
/// In so many steps a kernel shrinks to that.
constexpr int ShrinkingSteps = 4;

/// The value below which a part of them lies; 0 of none.
double GetQuantile(std::vector<double>& values, double part)
{
  if (values.empty())
  {
    return 0;
  }
  auto at = values.begin() + static_cast<std::ptrdiff_t>(part * (values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// As many as a kernel reaches inside the fluid.
int GetNumberOfNeighbors(double reach)
{
  return static_cast<int>(std::ceil(vtkMath::Pi() * 4 / 3 * reach * reach * reach));
}

/// A symmetric matrix R diag(s) R^T; the columns of r are the axes.
void Compose(const double r[3][3], const double s[3], double m[6])
{
  static const int rows[6] = { 0, 1, 2, 0, 1, 0 };
  static const int columns[6] = { 0, 1, 2, 1, 2, 2 };
  for (int k = 0; k < 6; ++k)
  {
    m[k] = 0;
    for (int a = 0; a < 3; ++a)
    {
      m[k] += r[rows[k]][a] * s[a] * r[columns[k]][a];
    }
  }
}

double GetForm(const double m[6], double x, double y, double z)
{
  return m[0] * x * x + m[1] * y * y + m[2] * z * z +
    2 * (m[3] * x * y + m[4] * y * z + m[5] * x * z);
}
}

bool vtkParticleSurfaceKernels::Sort(const Particles& particles)
{
  const vtkIdType number = particles.Points->GetNumberOfTuples();
  std::vector<unsigned char> used(number);
  vtkPointSplatInput::MarkFinite(particles.Points, used);
  vtkIdType count = 0;
  for (vtkIdType id = 0; id < number; ++id)
  {
    if (particles.Ghosts && (particles.Ghosts[id] & vtkDataSetAttributes::HIDDENPOINT))
    {
      used[id] = 0;
      ++this->Left.Hidden;
    }
    else if (!used[id])
    {
      ++this->Left.Points;
    }
    count += used[id];
  }
  this->Neighbors.Build(particles.Points, used.data());
  this->NumberOfParticles = 0;
  for (Slot slot = 0; slot < this->Neighbors.GetNumberOfSlots(); ++slot)
  {
    this->NumberOfParticles += this->Neighbors.GetId(slot) >= 0;
  }
  this->Left.Duplicates = count - this->NumberOfParticles;
  return this->NumberOfParticles > 0;
}

bool vtkParticleSurfaceKernels::MeasureSpacing(vtkAlgorithm* self, double from, double to)
{
  const Slot slots = this->Neighbors.GetNumberOfSlots();
  const Slot step = static_cast<Slot>(std::max<vtkIdType>(slots / NumberOfProbes, 1));
  std::vector<vtkParticleSurfaceProbe> probes((slots + step - 1) / step);
  auto visit = [&](const Neighborhood& around, int) {
    if (around.Count > 0)
    {
      probes[around.Center / step].Measure(around);
    }
    return true;
  };
  auto wanted = [&](Slot slot) {
    return slot % step == 0 && this->Neighbors.GetId(slot) >= 0;
  };
  const int ranks = static_cast<int>(
    std::clamp<vtkIdType>(this->NumberOfParticles / RanksPerParticles, 1, MostRanks));
  if (!this->Neighbors.Visit(self, from, to, ranks, visit, wanted))
  {
    return false;
  }
  // Near a surface the number grows more slowly, so that it tells less than the dimension.
  std::vector<double> dimensions, spacings;
  for (const vtkParticleSurfaceProbe& probe : probes)
  {
    if (probe.Dimension > 0 && std::isfinite(probe.Dimension))
    {
      dimensions.push_back(probe.Dimension);
    }
  }
  const double typical = GetQuantile(dimensions, 0.75);
  const int dimension = typical >= 2.5 || dimensions.empty() ? 3 : typical >= 1.5 ? 2 : 1;
  for (const vtkParticleSurfaceProbe& probe : probes)
  {
    const double spacing = probe.GetSpacing(dimension);
    if (spacing > 0 && std::isfinite(spacing))
    {
      spacings.push_back(spacing);
    }
  }
  // Half of the space around particles at the surface is empty, but hardly ever do three quarters
  // of them lie there.
  this->Measured = GetQuantile(spacings, 0.25);
  return true;
}

void vtkParticleSurfaceKernels::SetSizes(const Particles& particles, double wanted)
{
  const Slot slots = this->Neighbors.GetNumberOfSlots();
  auto get = [&](vtkDataArray* array, Slot slot) {
    return array ? array->GetComponent(this->Neighbors.GetId(slot), 0) : 1.0;
  };
  auto good = [](double value) { return value > 0 && std::isfinite(value); };

  // A liquid is hardly ever thinner than at rest. Densities by summation are too low at its
  // surface, where neighbours are missing, and would blow its particles up.
  double rest = 0;
  if (particles.Densities)
  {
    std::vector<double> densities;
    for (Slot slot = 0; slot < slots; ++slot)
    {
      if (this->Neighbors.GetId(slot) >= 0 && good(get(particles.Densities, slot)))
      {
        densities.push_back(get(particles.Densities, slot));
      }
    }
    rest = GetQuantile(densities, 0.5);
  }

  this->Sizes.assign(slots, Size());
  std::vector<double> lengths, spacings;
  for (Slot slot = 0; slot < slots; ++slot)
  {
    if (this->Neighbors.GetId(slot) < 0)
    {
      continue;
    }
    const double h = get(particles.SmoothingLengths, slot);
    const double mass = get(particles.Masses, slot);
    const double density = get(particles.Densities, slot);
    const bool volume = particles.Masses || particles.Densities;
    const double spacing = volume ? std::cbrt(mass / std::max(density, rest)) : h;
    const double length = particles.SmoothingLengths ? h : spacing;
    if (!good(h) || !good(mass) || !good(density) || !good(spacing) ||
      static_cast<float>(spacing) <= 0 || static_cast<float>(length) <= 0 ||
      !std::isfinite(static_cast<float>(spacing)) || !std::isfinite(static_cast<float>(length)))
    {
      ++this->Left.Sizes;
      continue;
    }
    this->Sizes[slot] = { static_cast<float>(length), static_cast<float>(spacing) };
    lengths.push_back(length);
    spacings.push_back(spacing);
  }
  const double length = GetQuantile(lengths, 0.5), spacing = GetQuantile(spacings, 0.5);

  // Whatever the units and the convention of smoothing lengths: what is known for sure is how
  // far particles are apart. But those of spray are farther apart than they are large.
  this->Usual = this->Measured > 0 ? this->Measured : spacing > 0 ? spacing : LoneSpacing;
  if (particles.Masses && particles.Densities && spacing > 0 &&
    spacing <= LargestOverlap * this->Usual)
  {
    this->Usual = spacing;
  }
  else if (particles.SmoothingLengths && length > 0)
  {
    this->Usual = std::min(this->Usual, length);
  }
  else if (!(particles.Masses || particles.Densities) && !(this->Measured > 0))
  {
    this->Usual = LoneSpacing;
  }
  if (wanted > 0)
  {
    this->Usual = wanted;
  }

  for (Slot slot = 0; slot < slots; ++slot)
  {
    if (this->Neighbors.GetId(slot) < 0)
    {
      continue;
    }
    Size& size = this->Sizes[slot];
    const double relative[2] = { size.Length > 0 ? size.Length / length : 1,
      size.Spacing > 0 ? size.Spacing / spacing : 1 };
    size.Length = static_cast<float>(std::clamp(relative[0], 1 / LargestSizeRatio, LargestSizeRatio));
    size.Spacing = static_cast<float>(std::clamp(relative[1], 1 / LargestSizeRatio, LargestSizeRatio));
    this->Left.Clamped += std::max(relative[0], relative[1]) > LargestSizeRatio ||
      std::min(relative[0], relative[1]) * LargestSizeRatio < 1;
  }
}

/// Marks particles of the usual size that no kernel's length away from the surface.
void vtkParticleSurfaceKernels::MarkDeep(const Settings& settings)
{
  const Slot slots = this->Neighbors.GetNumberOfSlots();
  const double side = settings.Reach * this->Usual;
  this->Deep.assign(slots, 0);
  double low[3], high[3];
  std::fill_n(low, 3, VTK_DOUBLE_MAX);
  std::fill_n(high, 3, -VTK_DOUBLE_MAX);
  for (Slot slot = 0; slot < slots; ++slot)
  {
    if (this->Neighbors.GetId(slot) >= 0)
    {
      double x[3];
      this->Neighbors.GetPosition(slot, x);
      for (int c = 0; c < 3; ++c)
      {
        low[c] = std::min(low[c], x[c]);
        high[c] = std::max(high[c], x[c]);
      }
    }
  }
  const double size = std::max({ high[0] - low[0], high[1] - low[1], high[2] - low[2] });
  if (!(size / side < (1 << vtkParticleSurfaceCubes::Bits) - 3))
  {
    return;
  }
  vtkParticleSurfaceCubes cubes(low, side);
  auto get = [&](Slot slot) {
    double x[3];
    this->Neighbors.GetPosition(slot, x);
    return cubes.GetKey(x);
  };
  std::vector<std::uint64_t> keys;
  keys.reserve(this->NumberOfParticles);
  for (Slot slot = 0; slot < slots; ++slot)
  {
    if (this->Neighbors.GetId(slot) >= 0)
    {
      keys.push_back(get(slot));
    }
  }
  cubes.Count(std::move(keys));
  cubes.MarkDeep(settings.Reach * settings.Reach * settings.Reach);
  auto mark = [&](vtkIdType begin, vtkIdType end) {
    for (Slot slot = static_cast<Slot>(begin); slot < static_cast<Slot>(end); ++slot)
    {
      const Size& s = this->Sizes[slot];
      this->Deep[slot] = this->Neighbors.GetId(slot) >= 0 &&
        std::max(s.Length, s.Spacing) < UsualRatio &&
        std::min(s.Length, s.Spacing) > 1 / UsualRatio &&
        cubes.IsDeep(get(slot));
    }
  };
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(slots), mark);
}

/// A ball, as those inside the fluid nearly are.
vtkParticleSurfaceKernels::Kernel vtkParticleSurfaceKernels::MakeBall(
  Slot slot, const Settings& settings) const
{
  Kernel kernel;
  kernel.Id = this->Neighbors.GetId(slot);
  this->Neighbors.GetPosition(slot, kernel.Center);
  kernel.Deep = true;
  const double spacing = this->Usual * this->Sizes[slot].Spacing;
  const double reach = settings.Reach * this->Usual * this->Sizes[slot].Length;
  for (int c = 0; c < 3; ++c)
  {
    kernel.Metric[c] = static_cast<float>(1 / (reach * reach));
    kernel.Metric[3 + c] = 0.0f;
    kernel.Extent[c] = static_cast<float>(reach);
  }
  const double ratio = spacing / reach;
  kernel.Amplitude = static_cast<float>(315 / (64 * vtkMath::Pi()) * ratio * ratio * ratio);
  kernel.Spacing = static_cast<float>(spacing);
  return kernel;
}

vtkParticleSurfaceKernels::Kernel vtkParticleSurfaceKernels::MakeKernel(
  const Neighborhood& around, const Settings& settings) const
{
  Kernel kernel;
  kernel.Id = this->Neighbors.GetId(around.Center);
  kernel.Deep = false;
  this->Neighbors.GetPosition(around.Center, kernel.Center);
  const Size& size = this->Sizes[around.Center];

  // No kernel has more than so many particles in it, whatever its size is said to be.
  double spacing = this->Usual * size.Spacing;
  double reach = settings.Reach * this->Usual * size.Length;
  if (around.Count == GetNumberOfNeighbors(settings.Reach))
  {
    const double farthest = std::sqrt(around.SquaredDistance[around.Count - 1]);
    reach = std::min(reach, farthest);
    spacing = std::min(spacing, farthest);
  }
  kernel.Spacing = static_cast<float>(spacing);

  // Of a neighbour, relative to the particle's own: many small ones are no more than a large one.
  auto getVolume = [&](int i) {
    const double ratio = this->Sizes[around.Slots[i]].Spacing / size.Spacing;
    return ratio * ratio * ratio;
  };
  // Weighted mean and covariance, in units of the reach; the particle itself is one of them.
  double total = 1, mean[3] = { 0, 0, 0 }, second[6] = { 0, 0, 0, 0, 0, 0 };
  int count = 0;
  for (; count < around.Count; ++count)
  {
    const double x = around.X[count] / reach, y = around.Y[count] / reach,
                 z = around.Z[count] / reach;
    const double squared = x * x + y * y + z * z;
    if (!(squared < 1))
    {
      break;
    }
    const double w = (1 - squared * std::sqrt(squared)) * getVolume(count);
    const double p[6] = { x * x, y * y, z * z, x * y, y * z, x * z };
    total += w;
    mean[0] += w * x;
    mean[1] += w * y;
    mean[2] += w * z;
    for (int k = 0; k < 6; ++k)
    {
      second[k] += w * p[k];
    }
  }
  for (double& m : mean)
  {
    m /= total;
  }
  double covariance[3][3], axes[3][3], variances[3];
  covariance[0][0] = second[0] / total - mean[0] * mean[0];
  covariance[1][1] = second[1] / total - mean[1] * mean[1];
  covariance[2][2] = second[2] / total - mean[2] * mean[2];
  covariance[0][1] = covariance[1][0] = second[3] / total - mean[0] * mean[1];
  covariance[1][2] = covariance[2][1] = second[4] / total - mean[1] * mean[2];
  covariance[0][2] = covariance[2][0] = second[5] / total - mean[0] * mean[2];
  vtkMath::Diagonalize3x3(covariance, variances, axes);

  // Few neighbours stretch a kernel less.
  const double told = std::clamp((count - 1) / (EnoughNeighbors - 1), 0.0, 1.0);
  const double stretch = 1 + told * (settings.LargestStretch - 1);
  const double largest = std::max({ variances[0], variances[1], variances[2] });
  double half[3], product = 1;
  for (int a = 0; a < 3; ++a)
  {
    half[a] = reach * std::max(variances[a], largest / stretch) / FullVariance;
    product *= half[a];
  }
  const double lone = LoneReach * spacing;
  const double volume = 315 / (64 * vtkMath::Pi()) * spacing * spacing * spacing;
  double metric[6];
  for (int step = 0;; ++step)
  {
    const double least = lone * lone * lone;
    if (!(product >= least))
    {
      const double scale = std::cbrt(least / product);
      for (double& h : half)
      {
        h = std::isfinite(scale) && h > 0 ? scale * h : lone;
      }
      product = least;
    }
    double inverse[3];
    for (int a = 0; a < 3; ++a)
    {
      inverse[a] = 1 / (half[a] * half[a]);
    }
    Compose(axes, inverse, metric);
    double sum = 1;
    for (int i = 0; i < count; ++i)
    {
      const double t = std::max(1 - GetForm(metric, around.X[i], around.Y[i], around.Z[i]), 0.0);
      sum += t * t * t * getVolume(i);
    }
    sum *= volume / product;
    if (sum >= LeastSum || product <= least || step == ShrinkingSteps)
    {
      break;
    }
    for (double& h : half)
    {
      h *= std::cbrt(sum / LeastSum);
    }
    product *= sum / LeastSum;
  }

  double box[6];
  const double squares[3] = { half[0] * half[0], half[1] * half[1], half[2] * half[2] };
  Compose(axes, squares, box);
  for (int k = 0; k < 6; ++k)
  {
    kernel.Metric[k] = static_cast<float>(metric[k]);
  }
  for (int c = 0; c < 3; ++c)
  {
    // A little more, so that rounding cuts no kernel.
    kernel.Extent[c] = static_cast<float>(1.0001 * std::sqrt(box[c]));
  }
  kernel.Amplitude = static_cast<float>(volume / product);

  // The mean of those within the kernel: along the surface, and hardly across it.
  double weights = 1, shift[3] = { 0, 0, 0 };
  for (int i = 0; i < count; ++i)
  {
    const double q = GetForm(metric, around.X[i], around.Y[i], around.Z[i]);
    if (q < 1)
    {
      const double w = (1 - q * std::sqrt(q)) * getVolume(i);
      weights += w;
      shift[0] += w * around.X[i];
      shift[1] += w * around.Y[i];
      shift[2] += w * around.Z[i];
    }
  }
  for (int c = 0; c < 3; ++c)
  {
    kernel.Center[c] += settings.Smoothing * shift[c] / weights;
  }
  return kernel;
}

bool vtkParticleSurfaceKernels::Build(
  vtkAlgorithm* self, double from, double to, const Particles& particles, const Settings& settings)
{
  this->Kernels.clear();
  this->Left = Skipped();
  if (!this->Sort(particles))
  {
    return true;
  }
  const double measured = from + 0.2 * (to - from);
  if (!this->MeasureSpacing(self, from, measured))
  {
    return false;
  }
  this->SetSizes(particles, settings.Spacing);

  this->MarkDeep(settings);

  const Slot slots = this->Neighbors.GetNumberOfSlots();
  std::vector<Kernel> kernels(slots);
  auto visit = [&](const Neighborhood& around, int) {
    kernels[around.Center] = this->MakeKernel(around, settings);
    return true;
  };
  auto wanted = [&](Slot slot) {
    if (this->Deep[slot])
    {
      kernels[slot] = this->MakeBall(slot, settings);
    }
    return this->Neighbors.GetId(slot) >= 0 && !this->Deep[slot];
  };
  if (!this->Neighbors.Visit(
        self, measured, to, GetNumberOfNeighbors(settings.Reach), visit, wanted))
  {
    return false;
  }
  // Where doubles cannot tell places on a particle apart there is no surface to find.
  Slot kept = 0;
  for (Slot slot = 0; slot < slots; ++slot)
  {
    if (this->Neighbors.GetId(slot) < 0)
    {
      continue;
    }
    const Kernel& kernel = kernels[slot];
    const double largest = std::max({ std::abs(kernel.Center[0]), std::abs(kernel.Center[1]),
      std::abs(kernel.Center[2]) });
    if (largest * std::numeric_limits<double>::epsilon() < vtkPointSplatInput::Resolution * kernel.Spacing &&
      std::isfinite(kernel.Amplitude) && kernel.Amplitude > 0)
    {
      kernels[kept++] = kernel;
    }
    else
    {
      ++this->Left.Points;
    }
  }
  kernels.resize(kept);
  this->Kernels = std::move(kernels);
  return true;
}

VTK_ABI_NAMESPACE_END
