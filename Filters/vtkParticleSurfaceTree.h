// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkParticleSurfaceTree
 * @brief   an octree of blocks of a grid where kernels are, each as fine as its kernels need
 *
 * Internal to vtkParticleSurfacePoints. A leaf is a block of CellsPerSide^3 cubic cells and a list
 * of the kernels that reach it. Blocks without kernels are not there, so that memory grows with
 * the particles' number and not with the space between them.
 */
#ifndef vtkParticleSurfaceTree_h
#define vtkParticleSurfaceTree_h

#include "vtkParticleSurfaceKernels.h"

#include <cstdint>
#include <vector>

class vtkAlgorithm;

VTK_ABI_NAMESPACE_BEGIN

class vtkParticleSurfaceTree
{
public:
  using Kernel = vtkParticleSurfaceKernels::Kernel;

  static constexpr int CellsPerSide = 16;
  /// Cells have at most about this part of a particle's spacing as their side. A sheet of particles
  /// is thicker than that, so that a line of the grid that runs through it has a node in it.
  static constexpr double CellPerSpacing = 0.5;

  struct Leaf
  {
    double Origin[3];
    double Cell;
    int Turn; // leaves of the same turn and cell are not next to each other
    std::vector<std::uint32_t> Kernels;

    double GetSide() const { return CellsPerSide * this->Cell; }
  };

  /// spacing: of particles, for which cells have exactly CellPerSpacing of it. False if aborted.
  bool Build(vtkAlgorithm* self, double from, double to, const std::vector<Kernel>& kernels,
    double spacing);

  /// By cells, the smallest first, and by turns.
  const std::vector<Leaf>& GetLeaves() const { return this->Leaves; }

private:
  struct Node
  {
    std::int64_t Index[3];
    int Level; // the side is CellsPerSide * Cell * 2^Level
    std::vector<std::uint32_t> Kernels;
  };

  Node MakeRoot(const std::vector<Kernel>& kernels);
  bool IsFine(const Node& node, const std::vector<Kernel>& kernels) const;
  void Split(const Node& node, const std::vector<Kernel>& kernels, std::vector<Node>& parts) const;

  double Origin[3];
  double Cell = 0; // of level 0
  std::vector<Leaf> Leaves;
};

VTK_ABI_NAMESPACE_END
#endif
