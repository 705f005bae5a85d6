// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkParticleSurfacePoints
 * @brief   oriented points on the surface of a fluid that is given as particles
 *
 * After Yu, Turk 2013, Reconstructing Surfaces of Particle-Based Fluids Using Anisotropic Kernels:
 * each particle is smeared over an ellipsoid that lies along the surface near it, and the fluid's
 * surface is where the sum of these has a certain value. Points on it, with normals, sizes and
 * curvature, go to a vtkPointSplatMapper as they are; no mesh and no volume is made.
 *
 * Input: the points of any vtkPointSet, of any type; cells do not matter. Point arrays with one
 * component may tell the particles' sizes. They are chosen by SetInputArrayToProcess with the index
 * given, otherwise taken by name, upper case or not:
 * - 0, smoothing length (world units): "SmoothingLength", "smoothing_length", "hsml" or "h";
 * - 1, mass: "Mass" or "m";
 * - 2, density (mass by cubic world unit): "Density" or "rho".
 *
 * Output: a vtkPolyData without cells, with
 * - points: float, or double where floats would not resolve a thousandth of a particle's spacing;
 * - active normals (3 floats, unit length), which point out of the fluid;
 * - `SplatRadius` (1 float, world units) and `SplatCurvature` (6 floats, 1 / world units) as
 *   vtkPointSplatEstimation has them, so that no estimation is needed;
 * - the particles' numeric point data: real ones by their mean with the kernels at the point as
 *   weights, whole ones (as ids or phases) from the particle with the largest share. Ghosts,
 *   global and pedigree ids and what has the name of a splat's array are not carried, and no array
 *   is made the active scalars.
 *
 * Stages:
 * 1. *Sizes.* The particles' usual spacing d is measured: around a sample of particles, how the
 *    number of neighbours grows with distance tells whether they fill a body, a sheet or a
 *    line, and how densely; the lower quartile counts, since particles at the surface lack
 *    neighbours. A particle's volume is its mass by its density, but the density is at least the
 *    median one (a liquid's at rest): sums over neighbours are too low at a surface. Where one
 *    of both is missing, volumes go by the other, by the cube of the smoothing length, or
 *    are equal. So may the units be any: the median is put to d^3, unless masses and densities make
 *    it smaller (spray is farther apart than it is large) or ParticleSpacing is set. The same for
 *    smoothing lengths, which no two programs define alike.
 * 2. *Kernels.* Of the particles within the reach r = KernelReach times the particle's spacing (as
 *    many at most as such a ball has inside the fluid, 66), the weighted covariance C is taken
 *    (section 4; weights 1 - (distance / r)^3 times their volume). The half
 *    axes of its kernel's ellipsoid are r times C's eigenvalues over those of a full ball, 0.15
 *    r^2, but no eigenvalue counts less than the largest by LargestStretch.
 *    Less than ten neighbours stretch a kernel less, down to a ball for one. No ellipsoid is
 *    smaller than the ball that a lone particle has, of 1.07 spacings' radius, and where the sum
 *    at its centre would be less than twice the surface's value it shrinks towards that, so that
 *    ligaments do not vanish. A kernel is (1 - q)^3 (q: the square of the scaled distance), and
 *    its integral is the particle's volume.
 *    Particles so deep in the fluid that their kernel does not reach the surface (the cubes of
 *    side r around are nearly as full as at the usual spacing) get balls without a look at their
 *    neighbours, and where only such reach no surface is looked for: bubbles of less than about
 *    two spacings there are not seen.
 * 3. *Centres* move to the weighted mean of the particles within their kernel, by Smoothing
 *    (section 4). There the mean is over a ball, which draws the surface inward; in the flattened
 *    kernel it is along the surface.
 * 4. *Blocks.* An octree over the kernels, not over space: blocks of 16^3 cells, whose
 *    side is about half of the spacing of the smallest particle that reaches them. What no kernel
 *    reaches has no block.
 * 5. *Candidates.* In each block the sum is taken at the cells' corners; cells on both sides of
 *    the value 35 / (54 sqrt(3)) = 0.374 give candidates as in vtkIsosurfacePoints. At this value a
 *    lone particle's ball has the particle's volume. A block's samples are forgotten at once.
 * 6. *Placing and thinning.* In random but always equal order, candidates are moved by Newton
 *    steps onto the surface of the exact sum, and stay if no other of the same side is nearer than
 *    0.8 PointSpacing. Blocks go in turns of such as are not next to each other, in parallel.
 *    Without PointSpacing, points are added at half the spacing in cells where the surface bends
 *    so that splats would turn by more than 0.6 radians from their centre to their rim.
 * 7. *Writing.* From the sum's gradient g and Hessian H at the point: the normal n = -g / |g|, the
 *    curvature -P H P / |g| with P = 1 - n n^T, and the radius 0.8 PointSpacing, as
 *    no place on the surface is farther from a point; down to a half of that where the surface
 *    turns by more than 0.6 radians on this way.
 *
 * Memory: about 200 bytes a particle and 100 a point of the output, besides input and output, and
 * the samples of one block a thread.
 *
 * Bad input: particles with coordinates that are not finite (beyond 1e37, or so large that double
 * precision does not resolve a thousandth of their spacing), hidden ones (vtkGhostType has
 * HIDDENPOINT), and all but the first at one position take no part. Sizes that are not positive
 * and finite are replaced by the usual one, and are within a factor of 1000 of it. All these are
 * counted in one warning. Duplicate ghosts (DUPLICATEPOINT, another process' particles) belong to
 * the fluid, but points where they have the largest share are left out. A lone particle of unknown
 * size has the spacing 0.1. No particles give an empty output; an array that was asked for and is
 * not there, or has not one number a particle, is an error, and the output empty.
 *
 * Results do not depend on the number of threads. The filter reports progress and can be
 * aborted, with an empty output then.
 */
#ifndef vtkParticleSurfacePoints_h
#define vtkParticleSurfacePoints_h

#include "vtkFiltersPointSplattingModule.h" // For export macro
#include "vtkPointSplatSetMacros.h"
#include "vtkPointSplattingABI.h"
#include "vtkPolyDataAlgorithm.h"

VTK_ABI_NAMESPACE_BEGIN

class vtkDataArray;
class vtkPointSet;

class VTKFILTERSPOINTSPLATTING_EXPORT vtkParticleSurfacePoints : public vtkPolyDataAlgorithm
{
public:
  static vtkParticleSurfacePoints* New();
  vtkTypeMacro(vtkParticleSurfacePoints, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The indices for SetInputArrayToProcess.
  enum ArrayIndex
  {
    SmoothingLengths = 0,
    Masses = 1,
    Densities = 2
  };

  ///@{
  /**
   * The wanted distance between neighbouring points in world units; 0, the default, is 0.4 of the
   * particles' spacing, finer where particles are smaller, and half of it where the surface
   * bends strongly. It is kept between a fiftieth of
   * their spacing and eight times it.
   */
  vtkPointSplatSetClampMacro(PointSpacing, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(PointSpacing, double);
  ///@}

  ///@{
  /**
   * The edge of the cube of fluid that is one particle of median size, in world units; 0, the
   * default, is measured (stage 1). Twice the radius with which particles were put on a lattice.
   */
  vtkPointSplatSetClampMacro(ParticleSpacing, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(ParticleSpacing, double);
  ///@}

  ///@{
  /**
   * How far a particle's kernel reaches inside the fluid, in its spacings; 1.5 to 3, 2.5 by
   * default. A longer reach makes smoother surfaces that keep fewer details.
   */
  vtkPointSplatSetClampMacro(KernelReach, 1.5, 3.0);
  vtkGetMacro(KernelReach, double);
  ///@}

  ///@{
  /**
   * How far kernels' centres are moved to the mean of the particles around: 0, not at all, to 1;
   * 0.9 by default.
   */
  vtkPointSplatSetClampMacro(Smoothing, 0.0, 1.0);
  vtkGetMacro(Smoothing, double);
  ///@}

  ///@{
  /**
   * The largest ratio of a kernel's axes; 1, which makes them all balls, to 16. By default
   * 3: a sheet of one layer of particles is then about as thick as its particles are apart.
   */
  vtkPointSplatSetClampMacro(LargestStretch, 1.0, 16.0);
  vtkGetMacro(LargestStretch, double);
  ///@}

  /**
   * The particles' usual spacing, in world units, of the last execution; 0 if there were none.
   */
  vtkGetMacro(MeasuredSpacing, double);

protected:
  vtkParticleSurfacePoints();
  ~vtkParticleSurfacePoints() override;

  int FillInputPortInformation(int, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkParticleSurfacePoints(const vtkParticleSurfacePoints&) = delete;
  void operator=(const vtkParticleSurfacePoints&) = delete;

  /// False after an error. The array may be null.
  bool FindSizes(ArrayIndex index, vtkPointSet* input, vtkDataArray*& array);

  double PointSpacing = 0;
  double ParticleSpacing = 0;
  double KernelReach = 2.5;
  double Smoothing = 0.9;
  double LargestStretch = 3;
  double MeasuredSpacing = 0;
};

VTK_ABI_NAMESPACE_END
#endif
