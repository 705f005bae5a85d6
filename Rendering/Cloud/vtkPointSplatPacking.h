// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// From the arrays of one block of a mapper's input to packed splats, in the form
// that vtkPointSplatCloud.h describes.
#ifndef vtkPointSplatPacking_h
#define vtkPointSplatPacking_h

#include "vtkDataArray.h"
#include "vtkPointSplatFillPoints.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include "vtkPointSplattingABI.h"

#include <array>
#include <cstdint>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPointSet;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

class vtkPointSplatFolds;

class vtkPointSplatPacking
{
public:
  vtkSmartPointer<vtkDataArray> Points;
  vtkSmartPointer<vtkDataArray> Normals;
  vtkSmartPointer<vtkDataArray> Radius;
  vtkSmartPointer<vtkDataArray> Plane;     // or none
  vtkSmartPointer<vtkDataArray> Curvature; // or none
  vtkSmartPointer<vtkDataArray> Axis1;
  vtkSmartPointer<vtkDataArray> Axis2;
  vtkSmartPointer<vtkDataArray> Clip; // or none
  vtkSmartPointer<vtkDataArray> Fold; // or none; of circles with clip lines only
  vtkSmartPointer<vtkUnsignedCharArray> Ghosts; // or none
  vtkPointSplatFillPoints::List Fill; // behind the block's own points in all of these but Ghosts
  vtkIdType Unused = 0; // points of no cell, where there are cells: they are hidden in Ghosts
  bool Projected = false; // points and normals are not the block's own, but on one surface
  bool Aborted = false;   // the estimation was, by the owner's AbortExecute
  bool HasGivenRadii = false;
  double Reach = 0.0; // points farther from the origin are not drawn; set by the caller

  /// Lengths that floats hold: vtkPointSplatEstimation goes no farther either.
  static constexpr double LargestLength = 1e37;

  /**
   * The arrays of a block, what is missing estimated; sizes only if they are needed, and points
   * whose sizes are not given projected where they are noise, and fill points made with sizes, if that is asked for.
   * owner: whose errors they are; an algorithm's progress and AbortExecute are the estimation's.
   */
  struct Wanted
  {
    bool Sizes, Projection, FillPoints, FillMeshes;
  };
  static vtkPointSplatPacking Collect(vtkObject* owner, vtkPointSet* data, const Wanted& wanted);

  /// The ghost array as it was given, or null if there is none that can be used.
  static vtkUnsignedCharArray* GivenGhostsOf(vtkPointSet* data);
  /**
   * That array, in which points that no cell uses are hidden where there are cells; or null. unused
   * gets the number of these.
   */
  static vtkSmartPointer<vtkUnsignedCharArray> GhostsOf(
    vtkPointSet* data, vtkIdType* unused = nullptr);

  /// With fill points.
  vtkIdType GetNumberOfPoints() const { return this->Points->GetNumberOfTuples(); }

  /**
   * Packs the block's splats, 8 words each if circular, otherwise 16; without sizes their
   * radius is 0. valid gets 1 for each point that can be drawn; the caller closes the gaps
   * that the others leave. Fill points' numbers go on behind the block's own points'.
   */
  void Pack(const std::array<double, 3>& origin, bool circular, uint32_t* splats,
    unsigned char* valid) const;

  /**
   * Appends to kept packed circles the other parts of those that are folded at their lines
   * (vtkPointSplatArrays.h): the same splats in the other planes. Returns how many there are now.
   */
  size_t PackFolds(std::vector<uint32_t>& splats, size_t kept) const;

  /// Whether any point has a clip line.
  bool HasClipLines() const;
  /**
   * The clip lines of packed splats, four floats each, as their bits (vtkPointSplatCloud.h).
   */
  void PackClipLines(
    const uint32_t* splats, vtkIdType count, bool circular, uint32_t* lines) const;

  /**
   * For each point the first cell that uses it, or -1. Cells may name points that are not there.
   */
  static std::vector<vtkIdType> CellsOfPoints(vtkPointSet* data);

private:
  vtkPointSplatFolds GetFolds(vtkIdType id) const;
  /// Takes what is missing from an estimation of points with what there is of normals.
  void Estimate(vtkObject* owner, vtkPolyData* bare, const Wanted& wanted);
};

#endif
