// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVPointSplatBorders.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataSetAttributes.h"
#include "vtkMath.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticPointLocator.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace
{
constexpr int MessageTag = 78651;

/// Four times the distance of the k-th neighbour: of a sample of points, at the upper decile.
double HowFarNeighboursAre(vtkPolyData* points, int k)
{
  const vtkIdType count = points->GetNumberOfPoints();
  if (count <= k)
  {
    return 0.0;
  }
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(points);
  locator->BuildLocator();
  std::vector<double> distances;
  vtkNew<vtkIdList> found;
  for (vtkIdType i = 0; i < count; i += 1 + count / 1000)
  {
    double position[3];
    points->GetPoint(i, position);
    if (!std::isfinite(position[0] + position[1] + position[2]))
    {
      continue;
    }
    locator->FindClosestNPoints(k + 1, position, found);
    double farthest = 0.0;
    for (vtkIdType n = 0; n < found->GetNumberOfIds(); ++n)
    {
      double other[3];
      points->GetPoint(found->GetId(n), other);
      farthest = std::max(farthest, vtkMath::Distance2BetweenPoints(position, other));
    }
    distances.push_back(std::sqrt(farthest));
  }
  if (distances.empty())
  {
    return 0.0;
  }
  const auto decile = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() * 9 / 10);
  std::nth_element(distances.begin(), decile, distances.end());
  return 4.0 * *decile;
}

/// Where ranks are divided: those of the order's first part lie below the plane.
struct Cut
{
  double Overlap = VTK_DOUBLE_MAX; // of the parts, as a share of what is divided
  double Imbalance = VTK_DOUBLE_MAX;
  double Length = 0.0;
  double Position = 0.0;
  int Axis = 0;
  size_t Below = 0;
  std::vector<size_t> Order;

  bool IsBetterThan(const Cut& other) const
  {
    constexpr double little = 1e-6;
    if (std::abs(this->Overlap - other.Overlap) > little)
    {
      return this->Overlap < other.Overlap;
    }
    return this->Imbalance != other.Imbalance ? this->Imbalance < other.Imbalance
                                              : this->Length > other.Length;
  }
};

Cut FindCut(const std::vector<vtkBoundingBox>& boxes, const std::vector<size_t>& ranks)
{
  Cut best;
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<size_t> order = ranks;
    std::stable_sort(order.begin(), order.end(), [&boxes, axis](size_t a, size_t b) {
      return boxes[a].GetBound(2 * axis) + boxes[a].GetBound(2 * axis + 1) <
        boxes[b].GetBound(2 * axis) + boxes[b].GetBound(2 * axis + 1);
    });
    double low = VTK_DOUBLE_MAX;
    double high = -VTK_DOUBLE_MAX;
    for (size_t rank : ranks)
    {
      low = std::min(low, boxes[rank].GetBound(2 * axis));
      high = std::max(high, boxes[rank].GetBound(2 * axis + 1));
    }
    for (size_t below = 1; below < order.size(); ++below)
    {
      double end = -VTK_DOUBLE_MAX;
      double start = VTK_DOUBLE_MAX;
      for (size_t i = 0; i < order.size(); ++i)
      {
        i < below ? end = std::max(end, boxes[order[i]].GetBound(2 * axis + 1))
                  : start = std::min(start, boxes[order[i]].GetBound(2 * axis));
      }
      Cut cut;
      cut.Length = high - low;
      cut.Overlap = cut.Length > 0.0 ? std::max((end - start) / cut.Length, 0.0) : 1.0;
      cut.Imbalance =
        std::abs(0.5 * static_cast<double>(order.size()) - static_cast<double>(below));
      cut.Position = 0.5 * (start + end);
      cut.Axis = axis;
      cut.Below = below;
      if (cut.IsBetterThan(best))
      {
        cut.Order = order;
        best = std::move(cut);
      }
    }
  }
  return best;
}

void Divide(const std::vector<vtkBoundingBox>& boxes, const std::vector<size_t>& ranks,
  const std::array<double, 6>& region, std::vector<vtkBoundingBox>& regions)
{
  if (ranks.size() == 1)
  {
    regions[ranks[0]].SetBounds(region.data());
    return;
  }
  const Cut cut = FindCut(boxes, ranks);
  std::array<double, 6> below = region;
  std::array<double, 6> above = region;
  below[2 * cut.Axis + 1] = cut.Position;
  above[2 * cut.Axis] = cut.Position;
  // What lies beyond the plane is no more of concern.
  std::vector<vtkBoundingBox> inside = boxes;
  for (size_t i = 0; i < cut.Order.size(); ++i)
  {
    vtkBoundingBox& box = inside[cut.Order[i]];
    double bounds[6];
    box.GetBounds(bounds);
    double& bound = bounds[2 * cut.Axis + (i < cut.Below ? 1 : 0)];
    bound = i < cut.Below ? std::min(bound, cut.Position) : std::max(bound, cut.Position);
    if (bounds[2 * cut.Axis] <= bounds[2 * cut.Axis + 1])
    {
      box.SetBounds(bounds);
    }
  }
  const auto middle = cut.Order.begin() + static_cast<std::ptrdiff_t>(cut.Below);
  Divide(inside, { cut.Order.begin(), middle }, below, regions);
  Divide(inside, { middle, cut.Order.end() }, above, regions);
}

double DistanceTo(const vtkBoundingBox& box, const double point[3])
{
  double squared = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double off = std::max({ box.GetBound(2 * axis) - point[axis],
      point[axis] - box.GetBound(2 * axis + 1), 0.0 });
    squared += off * off;
  }
  return std::sqrt(squared);
}

void Send(vtkMultiProcessController* controller, vtkPolyData* points, int partner)
{
  vtkIdType count = points->GetNumberOfPoints();
  controller->Send(&count, 1, partner, MessageTag);
  if (count > 0)
  {
    controller->Send(points, partner, MessageTag + 1);
  }
}

vtkSmartPointer<vtkPolyData> Receive(vtkMultiProcessController* controller, int partner)
{
  auto points = vtkSmartPointer<vtkPolyData>::New();
  vtkIdType count = 0;
  controller->Receive(&count, 1, partner, MessageTag);
  if (count > 0)
  {
    controller->Receive(points, partner, MessageTag + 1);
  }
  return points;
}
}

//------------------------------------------------------------------------------
vtkMultiProcessController* vtkPVPointSplatBorders::GetProcesses()
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  return controller && controller->GetNumberOfProcesses() > 1 ? controller : nullptr;
}

//------------------------------------------------------------------------------
std::vector<unsigned char> vtkPVPointSplatBorders::FindLeaves(
  vtkMultiProcessController* controller, vtkDataObjectTree* tree)
{
  std::vector<unsigned char> own;
  vtkSmartPointer<vtkDataObjectTreeIterator> it;
  it.TakeReference(tree->NewTreeIterator());
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    own.resize(std::max<size_t>(own.size(), it->GetCurrentFlatIndex() + 1));
    own[it->GetCurrentFlatIndex()] = 1;
  }
  if (!controller)
  {
    return own;
  }
  int count = static_cast<int>(own.size());
  int most = 0;
  controller->AllReduce(&count, &most, 1, vtkCommunicator::MAX_OP);
  own.resize(static_cast<size_t>(most));
  std::vector<unsigned char> any(own.size());
  if (most > 0)
  {
    controller->AllReduce(own.data(), any.data(), most, vtkCommunicator::MAX_OP);
  }
  return any;
}

//------------------------------------------------------------------------------
std::vector<vtkBoundingBox> vtkPVPointSplatBorders::Gather(
  vtkMultiProcessController* controller, const vtkBoundingBox& own)
{
  double bounds[6];
  own.GetBounds(bounds); // uninitialised ones where there are no points
  const size_t ranks = static_cast<size_t>(controller->GetNumberOfProcesses());
  std::vector<double> all(6 * ranks);
  controller->AllGather(bounds, all.data(), 6);
  std::vector<vtkBoundingBox> boxes(ranks);
  for (size_t rank = 0; rank < ranks; ++rank)
  {
    if (vtkMath::AreBoundsInitialized(&all[6 * rank]))
    {
      boxes[rank].SetBounds(&all[6 * rank]);
    }
  }
  return boxes;
}

//------------------------------------------------------------------------------
std::vector<vtkBoundingBox> vtkPVPointSplatBorders::Partition(
  const std::vector<vtkBoundingBox>& boxes)
{
  std::vector<size_t> ranks;
  for (size_t rank = 0; rank < boxes.size(); ++rank)
  {
    if (boxes[rank].IsValid())
    {
      ranks.push_back(rank);
    }
  }
  std::vector<vtkBoundingBox> regions(boxes.size());
  if (!ranks.empty())
  {
    constexpr double all = VTK_DOUBLE_MAX;
    Divide(boxes, ranks, { { -all, all, -all, all, -all, all } }, regions);
  }
  return regions;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> vtkPVPointSplatBorders::Within(
  vtkPolyData* points, const vtkBoundingBox& box, const Reach& reach)
{
  auto within = vtkSmartPointer<vtkPolyData>::New();
  if (!box.IsValid() || points->GetNumberOfPoints() == 0)
  {
    return within;
  }
  vtkCellArray* vertices = points->GetVerts();
  vtkNew<vtkIdList> ids;
  vtkNew<vtkIdList> cells;
  for (vtkIdType cell = 0; cell < vertices->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* at = nullptr;
    vertices->GetCellAtId(cell, size, at);
    double position[3];
    points->GetPoint(at[0], position);
    const double far = reach(at[0]);
    if (far >= 0.0 && DistanceTo(box, position) <= far)
    {
      ids->InsertNextId(at[0]);
      cells->InsertNextId(cell);
    }
  }
  const vtkIdType count = ids->GetNumberOfIds();
  vtkNew<vtkPoints> positions;
  positions->SetDataType(points->GetPoints()->GetDataType());
  positions->SetNumberOfPoints(count);
  points->GetPoints()->GetPoints(ids, positions);
  within->SetPoints(positions);
  vtkNew<vtkCellArray> own;
  for (vtkIdType i = 0; i < count; ++i)
  {
    own->InsertNextCell(1, &i);
  }
  within->SetVerts(own);
  within->GetPointData()->CopyAllOn();
  within->GetPointData()->CopyAllocate(points->GetPointData(), count);
  within->GetPointData()->CopyData(points->GetPointData(), ids);
  within->GetCellData()->CopyAllOn();
  within->GetCellData()->CopyAllocate(points->GetCellData(), count);
  within->GetCellData()->CopyData(points->GetCellData(), cells);
  within->GetFieldData()->ShallowCopy(points->GetFieldData());
  return within;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> vtkPVPointSplatBorders::Exchange(
  vtkMultiProcessController* controller, vtkPolyData* own,
  const std::vector<vtkBoundingBox>& boxes, const Reach& reach)
{
  const int rank = controller->GetLocalProcessId();
  vtkNew<vtkAppendPolyData> append;
  append->AddInputData(own);
  // In round i each process meets the one whose number differs from its own by the bits of i, and
  // the lower one sends first: no process waits for one that waits.
  int rounds = 1;
  while (rounds < controller->GetNumberOfProcesses())
  {
    rounds *= 2;
  }
  for (int round = 1; round < rounds; ++round)
  {
    const int partner = rank ^ round;
    if (partner >= controller->GetNumberOfProcesses())
    {
      continue;
    }
    const vtkSmartPointer<vtkPolyData> wanted =
      vtkPVPointSplatBorders::Within(own, boxes[static_cast<size_t>(partner)], reach);
    vtkSmartPointer<vtkPolyData> received;
    if (rank < partner)
    {
      Send(controller, wanted, partner);
      received = Receive(controller, partner);
    }
    else
    {
      received = Receive(controller, partner);
      Send(controller, wanted, partner);
    }
    if (received->GetNumberOfPoints() > 0)
    {
      append->AddInputData(received);
    }
  }
  append->Update();
  vtkSmartPointer<vtkPolyData> all = append->GetOutput();
  all->GetFieldData()->ShallowCopy(own->GetFieldData());
  return all;
}

//------------------------------------------------------------------------------
vtkBoundingBox vtkPVPointSplatBorders::FindBox(vtkPolyData* points)
{
  vtkBoundingBox box;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double position[3];
    points->GetPoint(i, position);
    if (std::isfinite(position[0] + position[1] + position[2]))
    {
      box.AddPoint(position);
    }
  }
  return box;
}

//------------------------------------------------------------------------------
vtkPVPointSplatBorders::Reach vtkPVPointSplatBorders::FindReach(
  vtkMultiProcessController* controller, vtkPolyData* own, int k)
{
  const double ownReach = HowFarNeighboursAre(own, k);
  double reach = 0.0;
  controller->AllReduce(&ownReach, &reach, 1, vtkCommunicator::MAX_OP);
  if (reach <= 0.0)
  {
    reach = VTK_DOUBLE_MAX; // so few points everywhere that each is of concern
  }
  const vtkSmartPointer<vtkUnsignedCharArray> ghosts = vtkUnsignedCharArray::SafeDownCast(
    own->GetPointData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  return [ghosts, reach](vtkIdType point) {
    constexpr int notOwn =
      vtkDataSetAttributes::DUPLICATEPOINT | vtkDataSetAttributes::HIDDENPOINT;
    return ghosts && (ghosts->GetValue(point) & notOwn) ? -1.0 : reach;
  };
}
