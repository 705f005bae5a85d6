// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatNormals
 * @brief   normals from neighbours, with one orientation for each surface
 *
 * An internal helper of vtkPointSplatEstimation; see the stages there.
 */
#ifndef vtkPointSplatNormals_h
#define vtkPointSplatNormals_h

#include "vtkPointSplatNeighbors.h"
#include "vtkPointSplatSensors.h"

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatNormals
{
public:
  /// Normals, 3 floats a slot, are read and written; known[slot] says which are given.
  vtkPointSplatNormals(const vtkPointSplatNeighbors& neighbors, float* normals,
    const std::vector<unsigned char>& known);

  /**
   * The normal of the plane that fits the centre and its neighbours best.
   */
  static void FitPlane(const vtkPointSplatNeighbors::Neighborhood& around, float normal[3]);

  /**
   * Fits planes to the k nearest neighbours of each slot without normal, and keeps the
   * graph of the neighbours if it is to be oriented. Where these lie in a row, a surface of rows side by side tells the
   * normal, if there is one (vtkPointSplatRows.h). Returns false if aborted.
   */
  bool Fit(vtkAlgorithm* self, double from, double to, int k, bool keepGraph);
  /// Marks the slots whose normals were fitted to rows side by side.
  void MarkRows(std::vector<unsigned char>& marks) const;

  /// Turns what was fitted the same way within a surface; given normals decide first.
  void OrientConsistently();
  /// Turns what was fitted to the given point.
  void OrientToViewpoint(const double viewpoint[3]);
  /// Turns what was fitted to the sensors that saw the points, and the others consistently with
  /// these. What is known keeps its sign, as always.
  void OrientToSensors(const vtkPointSplatSensors& sensors);

private:
  using Slot = vtkPointSplatNeighbors::Slot;
  static constexpr int NumberOfEdges = 10; // of the graph, for each slot

  /// Turns what is not known to the position x that target(slot, x) gives, where it gives one, and
  /// tells so in Turned.
  template <typename Target>
  void Turn(const Target& target);
  void Symmetrize();
  void Propagate(std::vector<Slot>& surface);
  void TurnOutward(const std::vector<Slot>& surface);
  void Enqueue(Slot slot);
  /// The sign by which j's normal goes on with i's, and what it costs to rely on it.
  float GetSign(Slot i, Slot j, int& cost) const;

  const vtkPointSplatNeighbors& Neighbors;
  float* Normals;
  const std::vector<unsigned char>& Known;
  std::vector<Slot> InRows;          // whose normals were fitted to rows
  std::vector<Slot> Graph;           // NumberOfEdges for each slot, then None
  std::vector<vtkIdType> Offsets;    // into Edges, for each slot, both directions
  std::vector<Slot> Edges;
  std::vector<unsigned char> Turned; // for each slot, or empty: to a sensor
  std::vector<unsigned char> Done;
  struct Candidate
  {
    Slot From, To;
  };
  static constexpr int NumberOfCosts = 256;
  std::vector<std::vector<Candidate>> Queue; // by cost
};

VTK_ABI_NAMESPACE_END
#endif
