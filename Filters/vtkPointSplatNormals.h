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

#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatNormals
{
public:
  /// Normals, 3 floats a slot, are read and written; known[slot] says which are given.
  vtkPointSplatNormals(const vtkPointSplatNeighbors& neighbors, float* normals,
    const std::vector<unsigned char>& known);

  /// The neighbours of a slot that tell its normal.
  struct Samples
  {
    int Nearest; // whether so many lie in a row is asked
    int All;     // through so many of them the surface goes
    bool Curved; // whether it is of second order (vtkPointSplatQuadric.h), or a plane
  };

  /**
   * How many times k neighbours, up to three, tell a normal where points are noise: there a surface of second order is no
   * farther from these, the more there are. Else 1. Looks at some of the slots without normal.
   */
  int GetTimes(vtkAlgorithm* self, int k) const;
  /**
   * Fits surfaces to the nearest neighbours of each slot without normal, and keeps the
   * graph of the neighbours if it is to be oriented. Where these lie in a row, a surface of rows side by side tells the
   * normal, if there is one (vtkPointSplatRows.h). Returns false if aborted.
   */
  bool Fit(vtkAlgorithm* self, double from, double to, const Samples& samples, bool keepGraph);
  /// Marks the slots whose normals were fitted to rows side by side.
  void MarkRows(std::vector<unsigned char>& marks) const;
  /// Tells of each slot whether its normal was fitted to neighbours on all sides that are on the surface but for noise.
  std::vector<unsigned char> TakeOnSurface() { return std::move(this->OnSurface); }

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
  /// The normal of the slot's plane, on the side of its normal, which it is where there is no plane.
  void GetPlane(Slot slot, float plane[3]) const;
  /// Whether j's normal goes on with i's the other way, and what it costs to rely on that. Across an edge planes tell more clearly,
  /// since those of points near to it turn on the way, and elsewhere surfaces. The tip of a wedge has the plane of a sheet that
  /// goes on in its middle, where both faces seem to be one: to go round another edge costs less.
  bool IsTurned(Slot i, Slot j, int& cost) const;

  const vtkPointSplatNeighbors& Neighbors;
  float* Normals;
  const std::vector<unsigned char>& Known;
  /// What was fitted before the surface of second order, where the normal is that one's; else 0.
  struct Plane
  {
    float Normal[3] = { 0, 0, 0 };
    float Tip = 0; // how far neighbours are off the surface, in spacings, times how far the point is off their centre
  };
  std::vector<Plane> Planes;         // for each slot
  std::vector<Slot> InRows;          // whose normals were fitted to rows
  std::vector<unsigned char> OnSurface; // for each slot
  std::vector<Slot> Graph;           // NumberOfEdges for each slot, then None
  std::vector<vtkIdType> Offsets;    // into Edges, for each slot, both directions
  std::vector<Slot> Edges;
  std::vector<unsigned char> Turned; // for each slot, or empty: to a sensor
  std::vector<unsigned char> Done;
  struct Candidate
  {
    Slot To;
    bool Turned; // whether its normal, which is as it was until it is done, goes on the other way
  };
  static constexpr int NumberOfCosts = 256;
  std::vector<std::vector<Candidate>> Queue; // by cost
};

VTK_ABI_NAMESPACE_END
#endif
