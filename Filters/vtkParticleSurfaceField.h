// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkParticleSurfaceField
 * @brief   the sum of kernels in one leaf of a vtkParticleSurfaceTree
 *
 * Internal to vtkParticleSurface. One object a thread: memory is kept from leaf to leaf.
 */
#ifndef vtkParticleSurfaceField_h
#define vtkParticleSurfaceField_h

#include "vtkParticleSurfaceTree.h"

#include <array>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkParticleSurfaceField
{
public:
  using Kernel = vtkParticleSurfaceKernels::Kernel;
  using Leaf = vtkParticleSurfaceTree::Leaf;

  static constexpr int NodesPerSide = vtkParticleSurfaceTree::CellsPerSide + 1;

  struct Value
  {
    double Sum;
    double Gradient[3];
    double Hessian[6]; // XX, YY, ZZ, XY, YZ, XZ
  };
  /// A kernel's part of the sum.
  struct Share
  {
    vtkIdType Id;
    double Weight;
  };

  void SetLeaf(const Leaf& leaf, const std::vector<Kernel>& kernels);

  /// The sums at the nodes, x fastest, of cells that IsNear(). They live until the next leaf's.
  void EvaluateNodes();
  const std::vector<float>& GetNodes() const { return this->Nodes; }
  /// Whether a kernel that is not deep inside the fluid reaches a row of cells.
  bool IsNear(int j, int k) const { return this->NearRows[j / PartSide][k / PartSide]; }

  /// At a position relative to the leaf's origin, which may lie outside by up to a cell.
  void Evaluate(const double x[3], Value& value);
  /// The same with second derivatives.
  void EvaluateSecond(const double x[3], Value& value);
  /// The kernels that reach a position; their weights have the sum 1.
  void GetShares(const double x[3], std::vector<Share>& shares);

private:
  /// Kernels relative to the leaf's origin.
  struct Local
  {
    float Center[3];
    float Metric[6];
    float Amplitude;
    float Extent[3];
    bool Deep;
    vtkIdType Id;
  };
  /// Parts of the leaf have lists of their own, made when they are needed.
  static constexpr int PartsPerSide = 4;
  static constexpr int PartSide = vtkParticleSurfaceTree::CellsPerSide / PartsPerSide; // in cells
  struct Part
  {
    bool Listed;
    std::vector<Local> Kernels;
  };

  const std::vector<Local>& GetKernelsAt(const double x[3]);
  void MarkRows();
  void AddToNodes(const Local& kernel);

  double Cell = 1;
  std::vector<Local> Kernels;
  std::array<Part, PartsPerSide * PartsPerSide * PartsPerSide> Parts;
  std::vector<float> Nodes;
  bool NearRows[PartsPerSide][PartsPerSide];                    // of parts' cells
  std::array<std::array<bool, NodesPerSide>, NodesPerSide> Rows; // of nodes
};

VTK_ABI_NAMESPACE_END
#endif
