// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkParticleSurface
 * @brief   points where the sum of kernels has the surface's value
 *
 * Internal to vtkParticleSurfacePoints, which tells the stages.
 */
#ifndef vtkParticleSurface_h
#define vtkParticleSurface_h

#include "vtkIsosurfaceDivision.h"
#include "vtkParticleSurfaceField.h"

#include <array>
#include <functional>
#include <map>
#include <vector>

class vtkAlgorithm;

VTK_ABI_NAMESPACE_BEGIN

class vtkParticleSurface
{
public:
  using Kernel = vtkParticleSurfaceKernels::Kernel;
  using Leaf = vtkParticleSurfaceTree::Leaf;
  using Share = vtkParticleSurfaceField::Share;

  /// What is known of a point.
  struct Point
  {
    double Position[3];
    double Normal[3];
    double Curvature[6]; // as vtkPointSplatArrays::Curvature
    double Radius;
    const std::vector<Share>* Shares; // of kernels
  };

  using Writer = std::function<void(vtkIdType, const Point&)>;

  /// The finest spacing of points for which cells are divided far enough, in cells.
  static constexpr double FinestSpacing = 2.5 / 64;

  /// All must outlive this. spacing: of points, 0: by the particles. ghosts may be null.
  vtkParticleSurface(const std::vector<Kernel>& kernels, const vtkParticleSurfaceTree& tree,
    double spacing, const unsigned char* ghosts);

  ///@{
  /**
   * Finds the points; then calls write(id, point) for each, points in parallel. Moves self's
   * progress from `from` to `to`; returns false if aborted.
   */
  bool Find(vtkAlgorithm* self, double from, double to, vtkIdType& count);
  bool Write(vtkAlgorithm* self, double from, double to, const Writer& write) const;
  ///@}

private:
  using Sample = vtkIsosurfaceThinning::Sample;

  /// Points of which no two of the same side are nearer than the lesser of their distances, of
  /// which there are few different ones.
  class Sieve
  {
  public:
    bool HasNear(const Sample& sample, double distance) const;
    void Add(const Sample& sample, double distance);

  private:
    std::map<double, vtkIsosurfaceThinning> Thinnings; // by distance
  };
  struct Scratch
  {
    vtkParticleSurfaceField Field;
    vtkIsosurfaceDivision::Scratch Division;
    std::vector<Sample> Candidates;
    std::array<bool, vtkParticleSurfaceTree::CellsPerSide * vtkParticleSurfaceTree::CellsPerSide *
        vtkParticleSurfaceTree::CellsPerSide>
      Wanted; // cells
    std::vector<Share> Shares;
  };

  double GetSpacing(const Leaf& leaf) const;
  void FillLeaf(std::size_t l, Scratch& scratch);
  void AddPoints(std::size_t l, double spacing, Sieve& own, Scratch& scratch);
  bool MarkBent(std::size_t l, Scratch& scratch) const;
  void FindCandidates(const Leaf& leaf, double spacing, Scratch& scratch) const;
  bool Place(double cell, vtkParticleSurfaceField& field, Sample& sample) const;
  bool IsOwn(const std::vector<Share>& shares) const;
  void Describe(std::size_t l, std::size_t i, Scratch& scratch, Point& point) const;

  const std::vector<Kernel>& Kernels;
  const std::vector<Leaf>& Leaves;
  double Spacing;
  const unsigned char* Ghosts;
  Sieve Found;
  std::vector<std::vector<Sample>> Samples; // of leaves
  std::vector<std::size_t> Bent;            // of leaves: the first of the denser samples
};

VTK_ABI_NAMESPACE_END
#endif
