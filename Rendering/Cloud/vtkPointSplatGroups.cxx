// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatGroups.h"

#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPointSplatArrays.h"
#include "vtkPointSplatCodes.h"
#include "vtkPointSplatGrouping.h"
#include "vtkPointSplatOrdered.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstring>
#include <numeric>

namespace
{
// Splats that are sorted as one.
constexpr vtkIdType LeafSize = 16;
// Degrees, by which normals of splats in one plane differ at most. TestSplatsDeferred's sheets have a
// fifth of the groups with it, and pictures as like those of two passes, within 0.1 dB.
constexpr double CoplanarAngle = 1.0;
// The share of the surface that a group must cover.
constexpr double LeastCoverage = 0.95;

bool IsCovering(vtkPointSet* data)
{
  vtkDataArray* coverage = data->GetFieldData()->GetArray(vtkPointSplatArrays::GroupCoverage);
  if (!coverage || coverage->GetNumberOfTuples() == 0)
  {
    return false;
  }
  double range[2];
  coverage->GetRange(range);
  return range[0] >= LeastCoverage;
}
}

//------------------------------------------------------------------------------
bool vtkPointSplatGroups::TakeGiven(
  const Splats& splats, bool covering, std::vector<int>& groups) const
{
  for (const Splats::Block& block : splats.Blocks)
  {
    vtkDataArray* given = block.Data->GetPointData()->GetArray(vtkPointSplatArrays::Group);
    if (!given || given->GetNumberOfComponents() != 1 ||
      given->GetNumberOfTuples() != block.Data->GetNumberOfPoints() ||
      (covering && !IsCovering(block.Data)))
    {
      return false;
    }
    for (vtkIdType i = block.First; i < block.First + block.Count; ++i)
    {
      const uint32_t id = splats.Packed[splats.Words * static_cast<size_t>(i) + 7];
      const double group = given->GetComponent(id, 0);
      groups[static_cast<size_t>(i)] =
        group >= 0.0 && group < VTK_INT_MAX ? static_cast<int>(group) : -1;
    }
  }
  // Splats that belong to no group make one of their own.
  const int most = *std::max_element(groups.begin(), groups.end());
  std::replace_if(groups.begin(), groups.end(), [](int group) { return group < 0; }, most + 1);
  if (most >= static_cast<int>(groups.size()))
  {
    // Numbers with gaps, as of ids that mean something else: there are no more groups than splats.
    std::vector<int> numbers = groups;
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    for (int& group : groups)
    {
      group = static_cast<int>(
        std::lower_bound(numbers.begin(), numbers.end(), group) - numbers.begin());
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkPointSplatGroups::Find(const Splats& splats, std::vector<int>& groups)
{
  const vtkIdType count = static_cast<vtkIdType>(groups.size());
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  vtkNew<vtkFloatArray> radii;
  points->SetNumberOfPoints(count);
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(count);
  radii->SetName(vtkPointSplatArrays::Radius);
  radii->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    float splat[4];
    const uint32_t* packed = &splats.Packed[splats.Words * static_cast<size_t>(i)];
    std::memcpy(splat, packed, sizeof(splat));
    points->SetPoint(i, splat[0], splat[1], splat[2]);
    radii->SetValue(i, splat[3]);
    double normal[3]; // of the disk's plane
    vtkPointSplatCodes::DecodeNormal(packed[4], normal);
    normals->SetTuple(i, normal);
  }
  data->SetPoints(points);
  data->GetPointData()->SetNormals(normals);
  data->GetPointData()->AddArray(radii);
  vtkNew<vtkPointSplatGrouping> grouping;
  // Who asks says what is to be said, and not at every frame.
  vtkNew<vtkCallbackCommand> silence;
  grouping->AddObserver(vtkCommand::WarningEvent, silence);
  grouping->AddObserver(vtkCommand::ErrorEvent, silence);
  grouping->SetInputData(data);
  grouping->SetOverlapFactor(this->Asked.Factor);
  grouping->SetReach(this->Asked.Reach);
  grouping->IgnoreOppositeOn();
  if (this->Asked.Number > 0)
  {
    grouping->SetColoringToWeighted();
    grouping->SetWantedNumberOfGroups(this->Asked.Number);
    grouping->SetCoverageToEnlarge();
  }
  else
  {
    grouping->SetCoplanarAngle(this->Asked.Alike ? CoplanarAngle : 0.0);
  }
  grouping->Update();
  auto found = vtkIntArray::SafeDownCast(
    grouping->GetOutput()->GetPointData()->GetAbstractArray(vtkPointSplatArrays::Group));
  if (grouping->GetNumberOfGroups() == 0 || !found)
  {
    return false;
  }
  std::copy_n(found->GetPointer(0), count, groups.begin());
  for (int group = 0; group < grouping->GetNumberOfGroups(); ++group)
  {
    this->Scales.push_back(grouping->GetGroupRadiusScale(group));
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkPointSplatGroups::Make(
  const Splats& splats, vtkMTimeType splatTime, const Request& request)
{
  // Behind them may be those of levels.
  const size_t count = std::accumulate(splats.Blocks.begin(), splats.Blocks.end(), size_t(0),
    [](size_t sum, const Splats::Block& block) { return sum + static_cast<size_t>(block.Count); });
  if (count == 0 || (this->Time > splatTime && this->Asked == request))
  {
    return !this->Order.empty();
  }
  this->Asked = request;
  this->Time.Modified();
  this->Order.clear();
  this->Starts.clear();
  this->Leaves.clear();
  this->Scales.clear();
  std::vector<int> groups(count);
  if (!this->TakeGiven(splats, request.Number > 0, groups) && !this->Find(splats, groups))
  {
    return false;
  }

  this->Order.resize(count);
  std::iota(this->Order.begin(), this->Order.end(), 0u);
  std::stable_sort(this->Order.begin(), this->Order.end(),
    [&groups](uint32_t a, uint32_t b) { return groups[a] < groups[b]; });
  const int most = *std::max_element(groups.begin(), groups.end());
  this->Starts.assign(static_cast<size_t>(most) + 2, 0);
  for (const int group : groups)
  {
    ++this->Starts[static_cast<size_t>(group) + 1];
  }
  std::partial_sum(this->Starts.begin(), this->Starts.end(), this->Starts.begin());
  this->MakeLeaves(splats);
  return true;
}

//------------------------------------------------------------------------------
void vtkPointSplatGroups::MakeLeaves(const Splats& splats)
{
  this->Leaves.assign(static_cast<size_t>(this->GetNumberOfGroups()), {});
  for (int group = 0; group < this->GetNumberOfGroups(); ++group)
  {
    const auto range = this->GetGroup(group);
    for (vtkIdType first = range.first; first < range.first + range.second; first += LeafSize)
    {
      Leaf leaf{ first, std::min(LeafSize, range.first + range.second - first), { 0, 0, 0 } };
      for (vtkIdType i = first; i < first + leaf.Count; ++i)
      {
        float splat[3];
        std::memcpy(splat, &splats.Packed[splats.Words * this->Order[static_cast<size_t>(i)]],
          sizeof(splat));
        for (int k = 0; k < 3; ++k)
        {
          leaf.Centre[k] += splat[k] / static_cast<double>(leaf.Count);
        }
      }
      for (size_t k = 0; k < 3; ++k)
      {
        leaf.Centre[k] += splats.Origin[k];
      }
      this->Leaves[static_cast<size_t>(group)].push_back(leaf);
    }
  }
}

//------------------------------------------------------------------------------
const std::vector<vtkPointSplatGroups::Leaf>& vtkPointSplatGroups::GetLeaves(int group) const
{
  static const std::vector<Leaf> none;
  return group >= 0 && group < static_cast<int>(this->Leaves.size())
    ? this->Leaves[static_cast<size_t>(group)]
    : none;
}

//------------------------------------------------------------------------------
std::pair<vtkIdType, vtkIdType> vtkPointSplatGroups::GetGroup(int group) const
{
  if (group < 0 || group >= this->GetNumberOfGroups())
  {
    return { 0, 0 };
  }
  const size_t g = static_cast<size_t>(group);
  return { this->Starts[g], this->Starts[g + 1] - this->Starts[g] };
}

//------------------------------------------------------------------------------
double vtkPointSplatGroups::GetScale(int group) const
{
  // Splats that are in no group make one more, which is not enlarged.
  return group >= 0 && group < static_cast<int>(this->Scales.size())
    ? this->Scales[static_cast<size_t>(group)]
    : 1.0;
}

//------------------------------------------------------------------------------
double vtkPointSplatGroups::GetLargestScale() const
{
  double largest = 1.0;
  for (const double scale : this->Scales)
  {
    largest = std::max(largest, scale);
  }
  return largest;
}

//------------------------------------------------------------------------------
std::vector<uint32_t> vtkPointSplatGroups::Ordered(
  const std::vector<uint32_t>& data, size_t words) const
{
  if (data.empty())
  {
    return data;
  }
  return vtkPointSplatOrdered(data, words, this->Order, data.size() / words);
}
