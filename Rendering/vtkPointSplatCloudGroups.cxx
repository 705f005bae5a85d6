// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// A cloud's groups, for deferred blending: the part of vtkPointSplatCloud that orders splats.
#include "vtkPointSplatCloud.h"

#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPointSplatArrays.h"
#include "vtkPointSplatGrouping.h"
#include "vtkPointSplatMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cstring>
#include <numeric>

namespace
{
// Splats that are sorted as one.
constexpr vtkIdType LeafSize = 16;

/// A 10-bit number's bits, two zeros between each.
uint32_t Spread(uint32_t x)
{
  x = (x | (x << 16)) & 0x030000ffu;
  x = (x | (x << 8)) & 0x0300f00fu;
  x = (x | (x << 4)) & 0x030c30c3u;
  x = (x | (x << 2)) & 0x09249249u;
  return x;
}
}

//------------------------------------------------------------------------------
bool vtkPointSplatCloud::GivenGroups(std::vector<int>& groups) const
{
  const size_t words = this->GetWordsPerSplat();
  for (const Block& block : this->Blocks)
  {
    vtkDataArray* given = block.Data->GetPointData()->GetArray(vtkPointSplatArrays::Group);
    if (!given || given->GetNumberOfComponents() != 1 ||
      given->GetNumberOfTuples() != block.Data->GetNumberOfPoints())
    {
      return false;
    }
    for (vtkIdType i = block.First; i < block.First + block.Count; ++i)
    {
      const uint32_t id = this->Splats[words * static_cast<size_t>(i) + 7];
      const double group = given->GetComponent(id, 0);
      groups[static_cast<size_t>(i)] = group >= 0.0 && group < VTK_INT_MAX
        ? static_cast<int>(group)
        : -1;
    }
  }
  // Splats that belong to no group make one of their own.
  const int most = *std::max_element(groups.begin(), groups.end());
  std::replace_if(groups.begin(), groups.end(), [](int group) { return group < 0; }, most + 1);
  if (most >= this->Count)
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
bool vtkPointSplatCloud::FindGroups(
  std::vector<int>& groups, double factor, double reach, int number) const
{
  const size_t words = this->GetWordsPerSplat();
  vtkNew<vtkPolyData> splats;
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  vtkNew<vtkFloatArray> radii;
  points->SetNumberOfPoints(this->Count);
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(this->Count);
  radii->SetName(vtkPointSplatArrays::Radius);
  radii->SetNumberOfTuples(this->Count);
  for (vtkIdType i = 0; i < this->Count; ++i)
  {
    float splat[4];
    std::memcpy(splat, &this->Splats[words * static_cast<size_t>(i)], sizeof(splat));
    points->SetPoint(i, splat[0], splat[1], splat[2]);
    radii->SetValue(i, splat[3]);
    // Colouring by distances alone does not look at them.
    normals->SetTuple3(i, 0.0, 0.0, 1.0);
  }
  splats->SetPoints(points);
  splats->GetPointData()->SetNormals(normals);
  splats->GetPointData()->AddArray(radii);
  vtkNew<vtkPointSplatGrouping> grouping;
  // The mapper says what is to be said, and not at every frame.
  vtkNew<vtkCallbackCommand> silence;
  grouping->AddObserver(vtkCommand::WarningEvent, silence);
  grouping->AddObserver(vtkCommand::ErrorEvent, silence);
  grouping->SetInputData(splats);
  grouping->SetOverlapFactor(factor);
  grouping->SetReach(reach);
  if (number > 0)
  {
    grouping->SetColoringToWeighted();
    grouping->SetWantedNumberOfGroups(number);
  }
  grouping->Update();
  auto found = vtkIntArray::SafeDownCast(
    grouping->GetOutput()->GetPointData()->GetAbstractArray(vtkPointSplatArrays::Group));
  if (grouping->GetNumberOfGroups() == 0 || !found)
  {
    return false;
  }
  std::copy_n(found->GetPointer(0), this->Count, groups.begin());
  return true;
}

//------------------------------------------------------------------------------
bool vtkPointSplatCloud::MakeGroups(double factor, double reach, int number)
{
  if (this->Count == 0 ||
    (this->GroupTime > this->SplatTime && this->GroupFactor == factor &&
      this->GroupReach == reach && this->GroupNumber == number))
  {
    return !this->Order.empty();
  }
  this->GroupFactor = factor;
  this->GroupReach = reach;
  this->GroupNumber = number;
  this->GroupTime.Modified();
  this->Order.clear();
  this->GroupStarts.clear();
  this->Leaves.clear();
  std::vector<int> groups(static_cast<size_t>(this->Count));
  this->GroupsGiven = this->GivenGroups(groups);
  if (!this->GroupsGiven && !this->FindGroups(groups, factor, reach, number))
  {
    return false;
  }

  // Within a group in Morton order: the grouping's own scatters a group's splats all over
  // the surface, and with them the pixels that are written one after the other.
  const size_t words = this->GetWordsPerSplat();
  std::vector<uint64_t> keys(static_cast<size_t>(this->Count));
  vtkSMPTools::For(0, this->Count, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      float splat[3];
      std::memcpy(splat, &this->Splats[words * static_cast<size_t>(i)], sizeof(splat));
      uint32_t morton = 0;
      for (int k = 0; k < 3; ++k)
      {
        const double extent = this->Bounds[2 * k + 1] - this->Bounds[2 * k];
        const double x = splat[k] + this->Origin[k] - this->Bounds[2 * k];
        const double cell = extent > 0.0 ? 1023.0 * std::min(std::max(x / extent, 0.0), 1.0) : 0.0;
        morton |= Spread(static_cast<uint32_t>(cell)) << k;
      }
      keys[static_cast<size_t>(i)] =
        static_cast<uint64_t>(groups[static_cast<size_t>(i)]) << 32 | morton;
    }
  });
  this->Order.resize(static_cast<size_t>(this->Count));
  std::iota(this->Order.begin(), this->Order.end(), 0u);
  vtkSMPTools::Sort(this->Order.begin(), this->Order.end(), [&keys](uint32_t a, uint32_t b) {
    return keys[a] != keys[b] ? keys[a] < keys[b] : a < b;
  });
  const int most = *std::max_element(groups.begin(), groups.end());
  this->GroupStarts.assign(static_cast<size_t>(most) + 2, 0);
  for (const int group : groups)
  {
    ++this->GroupStarts[static_cast<size_t>(group) + 1];
  }
  std::partial_sum(this->GroupStarts.begin(), this->GroupStarts.end(), this->GroupStarts.begin());
  this->MakeLeaves();
  return true;
}

//------------------------------------------------------------------------------
void vtkPointSplatCloud::MakeLeaves()
{
  const size_t words = this->GetWordsPerSplat();
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
        std::memcpy(
          splat, &this->Splats[words * this->Order[static_cast<size_t>(i)]], sizeof(splat));
        for (int k = 0; k < 3; ++k)
        {
          leaf.Centre[k] += splat[k] / static_cast<double>(leaf.Count);
        }
      }
      for (int k = 0; k < 3; ++k)
      {
        leaf.Centre[k] += this->Origin[static_cast<size_t>(k)];
      }
      this->Leaves[static_cast<size_t>(group)].push_back(leaf);
    }
  }
}

//------------------------------------------------------------------------------
const std::vector<vtkPointSplatCloud::Leaf>& vtkPointSplatCloud::GetLeaves(int group) const
{
  static const std::vector<Leaf> none;
  return group >= 0 && group < static_cast<int>(this->Leaves.size())
    ? this->Leaves[static_cast<size_t>(group)]
    : none;
}

//------------------------------------------------------------------------------
std::pair<vtkIdType, vtkIdType> vtkPointSplatCloud::GetGroup(int group) const
{
  if (group < 0 || group >= this->GetNumberOfGroups())
  {
    return { 0, 0 };
  }
  const size_t g = static_cast<size_t>(group);
  return { this->GroupStarts[g], this->GroupStarts[g + 1] - this->GroupStarts[g] };
}
