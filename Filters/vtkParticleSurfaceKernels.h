// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkParticleSurfaceKernels
 * @brief   particles of a fluid as ellipsoidal kernels whose sum is the fluid's density
 *
 * Internal to vtkParticleSurfacePoints, which tells the stages. A kernel is
 *   w(x) = Amplitude (1 - q)^3, q = (x - Center)^T Metric (x - Center), where q < 1,
 * which is twice continuously differentiable, so that normals and curvature of a sum's isosurfaces
 * are continuous; a kernel's integral is its particle's volume, so that the sum is 1 in the fluid.
 */
#ifndef vtkParticleSurfaceKernels_h
#define vtkParticleSurfaceKernels_h

#include "vtkPointSplatNeighbors.h"

#include <cstdint>
#include <vector>

class vtkAlgorithm;
class vtkDataArray;

VTK_ABI_NAMESPACE_BEGIN

class vtkParticleSurfaceKernels
{
public:
  struct Kernel
  {
    double Center[3];
    float Metric[6]; // XX, YY, ZZ, XY, YZ, XZ
    float Amplitude;
    float Extent[3]; // half of the sides of the box around the ellipsoid
    float Spacing;   // the edge of a cube of the particle's volume
    vtkIdType Id;    // of the particle
    bool Deep;       // the surface is farther away than the kernel reaches
  };

  /// What the input has; arrays may be null.
  struct Particles
  {
    vtkDataArray* Points = nullptr; // contiguous
    vtkDataArray* SmoothingLengths = nullptr;
    vtkDataArray* Masses = nullptr;
    vtkDataArray* Densities = nullptr;
    const unsigned char* Ghosts = nullptr;
  };

  struct Settings
  {
    double Spacing; // of particles; 0: from the particles
    double Reach;   // of a kernel inside the fluid, in spacings
    double Smoothing;
    double LargestStretch;
  };

  /// How many particles do not take part as they are, and why.
  struct Skipped
  {
    vtkIdType Points = 0;     // coordinates that are not finite, or cannot tell neighbours apart
    vtkIdType Hidden = 0;     // HIDDENPOINT
    vtkIdType Duplicates = 0; // at the position of an earlier one
    vtkIdType Sizes = 0;      // lengths, masses or densities that are not positive: the usual size
    vtkIdType Clamped = 0;    // sizes that are too far from the usual one
  };

  /// The sum of kernels at the surface, 35 / (54 sqrt(3)): the highest at which a lone particle's
  /// ball can have the particle's volume.
  static constexpr double Isovalue = 0.37420790;

  /// Returns false if aborted.
  bool Build(vtkAlgorithm* self, double from, double to, const Particles& particles,
    const Settings& settings);

  const std::vector<Kernel>& Get() const { return this->Kernels; }
  const Skipped& GetSkipped() const { return this->Left; }
  /// The usual particle spacing, world units; 0 if there are no particles.
  double GetSpacing() const { return this->Usual; }

private:
  using Neighborhood = vtkPointSplatNeighbors::Neighborhood;
  using Slot = vtkPointSplatNeighbors::Slot;

  struct Size
  {
    float Length = 0; // scales the reach, in usual spacings
    float Spacing = 0; // the cube root of the volume, in usual spacings
  };

  bool Sort(const Particles& particles);
  bool MeasureSpacing(vtkAlgorithm* self, double from, double to);
  void SetSizes(const Particles& particles, double wanted);
  void MarkDeep(const Settings& settings);
  Kernel MakeBall(Slot slot, const Settings& settings) const;
  Kernel MakeKernel(const Neighborhood& around, const Settings& settings) const;

  vtkPointSplatNeighbors Neighbors;
  vtkIdType NumberOfParticles = 0; // that take part
  std::vector<Size> Sizes;         // of slots
  std::vector<unsigned char> Deep; // of slots
  std::vector<Kernel> Kernels;
  Skipped Left;
  double Measured = 0;
  double Usual = 0;
};

VTK_ABI_NAMESPACE_END
#endif
