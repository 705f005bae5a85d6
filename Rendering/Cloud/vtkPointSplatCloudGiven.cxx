// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Of the cloud: what it is told of its input before splats are made.
#include "vtkPointSplatCloud.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPointSplatThreads.h"
#include "vtkSMPThreadLocal.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
std::vector<vtkPointSplatCloud::Block> vtkPointSplatCloud::VisibleOf(
  const vtkPointSplatCloudInput& input, std::vector<Block> blocks)
{
  blocks.erase(std::remove_if(blocks.begin(), blocks.end(),
                 [&input](const Block& block) {
                   const auto look = input.Looks.find(block.FlatIndex);
                   return look != input.Looks.end() && !look->second.Visible;
                 }),
    blocks.end());
  return blocks;
}

//------------------------------------------------------------------------------
vtkPointSplatCloud::Key vtkPointSplatCloud::KeyOf(const vtkPointSplatCloudInput& input)
{
  return vtkPointSplatCloud::SplatKey(
    vtkPointSplatCloud::VisibleOf(input, vtkPointSplatCloud::Gather(input.Data)));
}

//------------------------------------------------------------------------------
vtkPointSplatCloud::Key vtkPointSplatCloud::StayingKeyOf(const vtkPointSplatCloudInput& input)
{
  return vtkPointSplatCloud::StayingKey(
    vtkPointSplatCloud::VisibleOf(input, vtkPointSplatCloud::Gather(input.Data)));
}

//------------------------------------------------------------------------------
bool vtkPointSplatCloud::IsMadeFrom(const vtkPointSplatCloudInput& input) const
{
  return this->IsMadeFrom(input, vtkPointSplatCloud::KeyOf(input));
}

//------------------------------------------------------------------------------
bool vtkPointSplatCloud::IsMadeFrom(const vtkPointSplatCloudInput& input, const Key& key) const
{
  return this->SplatTime != 0 && key == this->SplatsMadeFrom &&
    (!input.NeedSizes || this->Sized) && input.ProjectNoise == this->MayProject &&
    input.FillGaps == this->MayFill && (!input.FillGaps || input.FillMeshGaps == this->MayFillMeshes);
}

//------------------------------------------------------------------------------
vtkIdType vtkPointSplatCloud::GetNumberOfPoints() const
{
  return this->Whole ? this->Whole->GetNumberOfPoints() : this->Points;
}

//------------------------------------------------------------------------------
double vtkPointSplatCloud::GetShare() const
{
  return this->Whole
    ? static_cast<double>(this->Points) / std::max<vtkIdType>(this->Whole->GetNumberOfPoints(), 1)
    : 1.0;
}

//------------------------------------------------------------------------------
void vtkPointSplatCloud::ForgetRange()
{
  this->Low = { { VTK_DOUBLE_MAX, VTK_DOUBLE_MAX, VTK_DOUBLE_MAX } };
  this->High = { { -VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX } };
}

//------------------------------------------------------------------------------
void vtkPointSplatCloud::AddRange(vtkDataArray* points)
{
  for (size_t k = 0; k < 3; ++k)
  {
    // Of finite coordinates: vtkPointSet's own bounds swallow NaN and infinity.
    double range[2];
    points->GetFiniteRange(range, static_cast<int>(k));
    if (range[0] <= range[1])
    {
      this->Low[k] = std::min(this->Low[k], range[0]);
      this->High[k] = std::max(this->High[k], range[1]);
    }
  }
}

//------------------------------------------------------------------------------
void vtkPointSplatCloud::SetOriginToMiddle()
{
  for (size_t k = 0; k < 3; ++k)
  {
    this->Origin[k] =
      this->Low[k] <= this->High[k] ? 0.5 * this->Low[k] + 0.5 * this->High[k] : 0.0;
  }
}

//------------------------------------------------------------------------------
std::array<double, 6> vtkPointSplatCloud::BoundsOf(vtkPointSet* data)
{
  std::vector<vtkPointSplatPacking> given(1);
  given[0].Points = data->GetPoints()->GetData();
  given[0].Reach = vtkPointSplatPacking::LargestLength;
  vtkPointSplatCloud cloud;
  cloud.ForgetRange();
  cloud.AddRange(given[0].Points);
  cloud.SetOriginToMiddle();
  cloud.LeaveOutFar(given);
  const vtkSmartPointer<vtkUnsignedCharArray> ghosts = vtkPointSplatPacking::GhostsOf(data);
  constexpr unsigned char notDrawn =
    vtkDataSetAttributes::HIDDENPOINT | vtkDataSetAttributes::DUPLICATEPOINT;
  const std::array<double, 6> none{ { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 } };
  vtkSMPThreadLocal<std::array<double, 6>> parts(none);
  vtkPointSplatThreads::For(0, data->GetNumberOfPoints(), [&](vtkIdType begin, vtkIdType end) {
    std::array<double, 6>& part = parts.Local();
    for (vtkIdType i = begin; i < end; ++i)
    {
      double p[3];
      given[0].Points->GetTuple(i, p);
      bool drawn = !(ghosts && (ghosts->GetValue(i) & notDrawn) != 0);
      for (size_t k = 0; k < 3; ++k)
      {
        // NaN compares false.
        drawn = drawn && std::abs(p[k] - cloud.Origin[k]) <= given[0].Reach;
      }
      for (size_t k = 0; k < 3 && drawn; ++k)
      {
        // As splats have it.
        const double x = static_cast<float>(p[k] - cloud.Origin[k]) + cloud.Origin[k];
        const bool first = part[2 * k] > part[2 * k + 1];
        part[2 * k] = first ? x : std::min(part[2 * k], x);
        part[2 * k + 1] = first ? x : std::max(part[2 * k + 1], x);
      }
    }
  });
  std::array<double, 6> bounds = none;
  for (const std::array<double, 6>& part : parts)
  {
    for (size_t k = 0; k < 3 && part[0] <= part[1]; ++k)
    {
      const bool first = bounds[2 * k] > bounds[2 * k + 1];
      bounds[2 * k] = first ? part[2 * k] : std::min(bounds[2 * k], part[2 * k]);
      bounds[2 * k + 1] =
        first ? part[2 * k + 1] : std::max(bounds[2 * k + 1], part[2 * k + 1]);
    }
  }
  return bounds;
}
