// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkIsosurfaceScatterField
 * @brief   scattered samples, which of them are next to each other, and a field fitted to them
 *
 * Internal to vtkIsosurfaceScatter.
 *
 * 1. *Slots.* Samples that are not hidden, at finite coordinates and with a finite value go into
 *    vtkPointSplatNeighbors; of samples at the same position the first counts.
 * 2. *Nodes.* A sample becomes a node where an isovalue lies between the values around it; all
 *    others are left alone, most of them by whole leaves of the tree.
 * 3. *Links.* Of a node's neighbours j those are its links that no other sample k hides, that is,
 *    the angle at k between the node and j is less than a right one (the Gabriel graph, a part of
 *    the natural neighbours' graph). A grid's links are its edges. Where the nearest neighbours
 *    leave directions open, as at a step of the density, more of them are asked for. The pairs of
 *    Rosenthal, Linsen 2006 are chosen by an angle criterion, too.
 * 4. *Fits.* A polynomial of second degree is fitted to the node's neighbours by least squares
 *    with weights falling with distance; a slight penalty on its second degree leaves the linear
 *    fit where the neighbours tell no more, as those on a plane.
 * 5. *Field.* At any position it is the mean of the fits of the nodes around with smooth weights
 *    of compact support (a partition of unity), so that it and its gradient are continuous.
 */
#ifndef vtkIsosurfaceScatterField_h
#define vtkIsosurfaceScatterField_h

#include "vtkPointSplatNeighbors.h"

#include <vector>

class vtkAlgorithm;
class vtkDataArray;

VTK_ABI_NAMESPACE_BEGIN

class vtkIsosurfaceScatterField
{
public:
  using Slot = vtkPointSplatNeighbors::Slot;
  using Node = std::uint32_t;
  static constexpr Node None = vtkPointSplatNeighbors::None;

  /// How many samples do not take part, and why.
  struct Skipped
  {
    vtkIdType Points = 0;     // coordinates that are not finite
    vtkIdType Values = 0;     // values that are not finite
    vtkIdType Hidden = 0;     // HIDDENPOINT
    vtkIdType Duplicates = 0; // at the position of an earlier one
  };

  /// Two linked samples; the first is a node.
  struct Pair
  {
    Node From;
    Slot To;
  };

  struct Value
  {
    double Difference; // to the isovalue
    double Gradient[3];
    double Hessian[6]; // the mean of the fits': XX, YY, ZZ, XY, YZ, XZ
    bool Straddled; // there are samples around on either side of the isovalue
  };

  /// Takes one component of an array of standard memory layout; ghosts may be null, and must live
  /// as long as this.
  Skipped SetSamples(
    vtkDataArray* points, vtkDataArray* scalars, int component, const unsigned char* ghosts);
  vtkIdType GetNumberOfSamples() const { return this->NumberOfSamples; }

  /**
   * Makes nodes, links and fits for the isovalues, sorted ascending, with k neighbours, or if
   * radius is not 0, with those within. Returns false if aborted.
   */
  bool Connect(vtkAlgorithm* self, double from, double to, const std::vector<double>& isovalues,
    int k, double radius);

  Node GetNumberOfNodes() const { return static_cast<Node>(this->Nodes.size()); }
  /// Calls visit(pair) for each of a node's pairs that the isovalue separates; each pair is one
  /// node's only.
  template <typename Visitor>
  void VisitPairs(Node node, double isovalue, const Visitor& visit) const;

  void GetPosition(Slot slot, double x[3]) const { this->Neighbors.GetPosition(slot, x); }
  double GetValue(Slot slot) const { return this->Values[slot]; }
  Slot GetSlot(Node node) const { return this->Nodes[node].Center; }
  /// The node at a slot, or None.
  Node GetNode(Slot slot) const { return this->NodeOf[slot]; }
  /// The edge of the cube that is one sample's share of space.
  double GetSpacing(Node node) const { return this->Nodes[node].Spacing; }
  /// The fit's gradient at the sample itself.
  const double* GetGradient(Node node) const { return this->Nodes[node].Fit + 1; }
  /// Whether the node's sample is this process' own.
  bool IsOwn(Node node) const;

  /// Moves `node` on to the one nearest to x, as far as each step leads nearer.
  void Approach(const double x[3], Node& node) const;
  /// The field at a position with `node` near; false where there is none.
  bool Evaluate(double isovalue, const double x[3], Node node, Value& value) const;
  /// Whether the samples around `node` lie in all directions as seen from x.
  bool Surrounds(Node node, const double x[3]) const;

private:
  using Neighborhood = vtkPointSplatNeighbors::Neighborhood;
  static constexpr int Terms = 10; // 1, x, y, z, xx, yy, zz, xy, xz, yz

  struct NodeData
  {
    Slot Center = None;
    bool Usable = false; // has a fit
    bool Surrounded = false;
    float Reach = 0; // of the fit's weight in the field
    float Spacing = 0;
    double Position[3];
    double Fit[Terms]; // less the sample's value
    std::vector<Slot> Near; // nearest first
    std::vector<Slot> Links;
  };

  template <typename Classifier>
  void MarkLeaves(const Classifier& getClass, double diagonals, double least,
    std::vector<unsigned char>& marks) const;
  bool MakeNode(const Neighborhood& around, int round, float limit, NodeData& node) const;
  static void Link(const Neighborhood& around, int count, std::vector<Slot>& links);
  void MakeFit(const Neighborhood& around, int count, NodeData& node) const;

  vtkPointSplatNeighbors Neighbors;
  vtkIdType NumberOfSamples = 0;
  const unsigned char* Ghosts = nullptr;
  std::vector<double> Values; // of slots
  std::vector<Node> NodeOf;   // of slots
  std::vector<NodeData> Nodes;
};

template <typename Visitor>
void vtkIsosurfaceScatterField::VisitPairs(
  Node node, double isovalue, const Visitor& visit) const
{
  const NodeData& data = this->Nodes[node];
  const bool above = this->Values[data.Center] >= isovalue;
  for (const Slot slot : data.Links)
  {
    if ((this->Values[slot] >= isovalue) == above)
    {
      continue;
    }
    // Two nodes both have the link.
    if (this->NodeOf[slot] == None || node < this->NodeOf[slot])
    {
      visit(Pair{ node, slot });
    }
  }
}

VTK_ABI_NAMESPACE_END
#endif
