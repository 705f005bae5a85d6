// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// What processes that share a cloud need of one another: a region of space for each, and the points
// of others that matter there. vtkDistributedPointCloudFilter::GetPointsInsideBounds() exchanges
// points, too, but by a box alone: here each point has a reach of its own, its vertex' data go with
// it, and a process' own points stay the first, so that what is estimated is theirs by number.
#ifndef vtkPVPointSplatBorders_h
#define vtkPVPointSplatBorders_h

#include "vtkBoundingBox.h"
#include "vtkSmartPointer.h"

#include "vtkPointSplattingABI.h"

#include <functional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObjectTree;
class vtkMultiProcessController;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

class vtkPVPointSplatBorders
{
public:
  /// How far off a point matters, world units; less than 0: nowhere.
  using Reach = std::function<double(vtkIdType point)>;

  /// The processes that share the data, or null: one has them all.
  static vtkMultiProcessController* GetProcesses();

  /// By flat index, whether any process has data at that place of a tree. All processes must call.
  static std::vector<unsigned char> FindLeaves(
    vtkMultiProcessController* controller, vtkDataObjectTree* tree);

  /// The boxes of all processes, by rank; a process without points has one that is not valid.
  static std::vector<vtkBoundingBox> Gather(
    vtkMultiProcessController* controller, const vtkBoundingBox& own);

  /**
   * A partition of space, one box a rank, open to the outside (+-VTK_DOUBLE_MAX): planes across
   * the axes divide ranks into halves, again and again, where their boxes overlap least. Ranks
   * without points have a box that is not valid. The same on all ranks.
   */
  static std::vector<vtkBoundingBox> Partition(const std::vector<vtkBoundingBox>& boxes);

  /**
   * The points of this process with those of all others that are within their reach of its box;
   * points of its own that are not are left out if asked for. All processes must call. Points
   * come with their point data, and their vertices, which are all cells that they may have, with
   * their cell data. The first GetNumberOfPoints() of those that stay are its own.
   */
  static vtkSmartPointer<vtkPolyData> Exchange(vtkMultiProcessController* controller,
    vtkPolyData* own, const std::vector<vtkBoundingBox>& boxes, const Reach& reach);

  /// The box of points, without those that are nowhere.
  static vtkBoundingBox FindBox(vtkPolyData* points);

  /**
   * How far off points say how a surface runs, to exchange them by: four times the distance of the
   * k-th neighbour, the same on all processes, which must all call. Hidden points and copies
   * of others' (vtkGhostType) are of no use anywhere else.
   */
  static Reach FindReach(vtkMultiProcessController* controller, vtkPolyData* own, int k);

  /// The points of a data set of vertices that are within reach of a box.
  static vtkSmartPointer<vtkPolyData> Within(
    vtkPolyData* points, const vtkBoundingBox& box, const Reach& reach);
};

#endif
