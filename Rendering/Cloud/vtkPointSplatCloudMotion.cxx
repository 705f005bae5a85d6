// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Of the cloud: points that move.
#include "vtkPointSplatCloud.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPointSplatArrays.h"
#include "vtkPointSplatCells.h"
#include "vtkPointSplatPacking.h"
#include "vtkPoints.h"
#include "vtkPointSplatThreads.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

namespace
{
bool IsNormals(vtkDataArray* array, vtkIdType points)
{
  return array && array->GetNumberOfComponents() == 3 && array->GetNumberOfTuples() == points;
}
}

//------------------------------------------------------------------------------
vtkPointSplatCloud::Key vtkPointSplatCloud::StayingKey(const std::vector<Block>& blocks)
{
  Key key;
  for (const Block& block : blocks)
  {
    const vtkIdType points = block.Data->GetNumberOfPoints();
    vtkPointData* arrays = block.Data->GetPointData();
    key.emplace_back(nullptr, block.FlatIndex);
    key.emplace_back(nullptr, static_cast<vtkMTimeType>(points));
    key.emplace_back(nullptr, IsNormals(arrays->GetNormals(), points));
    key.emplace_back(nullptr, arrays->GetArray(vtkPointSplatArrays::Radius) != nullptr);
    vtkDataArray* ghosts = arrays->GetArray(vtkDataSetAttributes::GhostArrayName());
    key.emplace_back(ghosts, ghosts ? ghosts->GetMTime() : 0);
    const bool faces = vtkPointSplatCells::HasFaces(block.Data);
    for (vtkCellArray* cells : vtkPointSplatCells::GetLists(block.Data))
    {
      if (faces && cells && cells->GetNumberOfCells() > 0)
      {
        key.emplace_back(cells, cells->GetMTime());
      }
    }
  }
  return key;
}

//------------------------------------------------------------------------------
bool vtkPointSplatCloud::CanMove(const std::vector<Block>& blocks)
{
  return std::all_of(blocks.begin(), blocks.end(), [](const Block& block) {
    vtkPointData* arrays = block.Data->GetPointData();
    vtkIdType unused = 0;
    vtkPointSplatPacking::GhostsOf(block.Data, &unused);
    vtkDataArray* radii = arrays->GetArray(vtkPointSplatArrays::Radius);
    const bool goodRadii = !radii ||
      (radii->GetNumberOfComponents() == 1 &&
        radii->GetNumberOfTuples() == block.Data->GetNumberOfPoints());
    return unused == 0 && goodRadii && IsNormals(arrays->GetNormals(), block.Data->GetNumberOfPoints()) &&
      !arrays->GetArray(vtkPointSplatArrays::PlaneNormal) &&
      !arrays->GetArray(vtkPointSplatArrays::Curvature) &&
      !arrays->GetArray(vtkPointSplatArrays::Axis1) && !arrays->GetArray(vtkPointSplatArrays::Clip) &&
      !arrays->GetArray(vtkPointSplatArrays::Fold);
  });
}

//------------------------------------------------------------------------------
bool vtkPointSplatCloud::AreCopiesTogether(const std::vector<Block>& blocks) const
{
  return std::equal(this->Blocks.begin(), this->Blocks.end(), blocks.begin(), blocks.end(),
    [](const Block& own, const Block& block) {
      return !own.Copies || own.Copies->AreTogether(block.Data);
    });
}

//------------------------------------------------------------------------------
bool vtkPointSplatCloud::Follow(const vtkPointSplatCloudInput& input)
{
  const std::vector<Block> blocks =
    vtkPointSplatCloud::VisibleOf(input, vtkPointSplatCloud::Gather(input.Data));
  return this->Follow(input, blocks, vtkPointSplatCloud::SplatKey(blocks));
}

//------------------------------------------------------------------------------
bool vtkPointSplatCloud::Follow(
  const vtkPointSplatCloudInput& input, const std::vector<Block>& blocks, const Key& key)
{
  if (this->IsMadeFrom(input, key))
  {
    return true;
  }
  const bool drawsAll = this->Count > 0 && this->Circular && !this->Projected && this->Skipped == 0 &&
    this->Unused == 0;
  // Settings are the same, and so is all but where points are.
  if (!input.FollowMotion || !drawsAll || this->SplatsMadeFrom.empty() ||
    !this->IsMadeFrom(input, this->SplatsMadeFrom) ||
    vtkPointSplatCloud::StayingKey(blocks) != this->StaysFrom || !vtkPointSplatCloud::CanMove(blocks) ||
    !this->AreCopiesTogether(blocks))
  {
    return false;
  }
  // Those that splats were made from may be gone.
  for (size_t b = 0; b < blocks.size(); ++b)
  {
    this->Blocks[b].Data = blocks[b].Data;
  }
  if (!this->Motion.HasBegun())
  {
    this->Unmix();
    this->RestingRadius = this->MedianRadius;
    this->LargestRestingRadius = this->MaximumRadius;
    this->RestingBounds = this->GetLocalBounds();
    // Levels that are being made are of these words, which stay where they are in memory.
    this->BeginMotion({ std::move(this->Splats), std::move(this->ClipLines) });
  }
  this->TakeLevels(false);
  const bool followed = this->MoveTo(blocks);
  this->SplatsMadeFrom = followed ? key : Key();
  return followed;
}

//------------------------------------------------------------------------------
void vtkPointSplatCloud::BeginMotion(vtkPointSplatMotion::Splats splats)
{
  std::vector<uint32_t> anchors = this->FindAnchors(splats.Words);
  std::vector<vtkPointSplatMotion::Part> parts = this->MakeParts(anchors);
  this->Motion.Begin(std::move(splats), std::move(anchors), std::move(parts));
}

//------------------------------------------------------------------------------
std::vector<uint32_t> vtkPointSplatCloud::FindAnchors(const std::vector<uint32_t>& splats) const
{
  const size_t words = this->GetWordsPerSplat();
  std::vector<uint32_t> anchors(splats.size() / words);
  std::iota(anchors.begin(), anchors.end(), 0u);
  for (const Block& block : this->Blocks)
  {
    if (!block.Fill)
    {
      continue;
    }
    // The splat of each of the block's points, with which fill points go.
    std::vector<uint32_t> splatOf(static_cast<size_t>(block.Data->GetNumberOfPoints()), 0u);
    std::vector<size_t> between;
    for (size_t i = static_cast<size_t>(block.First); i < static_cast<size_t>(block.First + block.Count); ++i)
    {
      const uint32_t* splat = splats.data() + words * i;
      if (block.Fill->GetNumber(splat) == static_cast<vtkIdType>(splat[7]))
      {
        splatOf[splat[7]] = static_cast<uint32_t>(i);
      }
      else
      {
        between.push_back(i);
      }
    }
    for (size_t i : between)
    {
      anchors[i] = splatOf[splats[words * i + 7]];
    }
  }
  // Levels come one after the other.
  for (size_t i = static_cast<size_t>(this->Count); i < anchors.size(); ++i)
  {
    anchors[i] = anchors[this->Levels.GetFirst(i)];
  }
  return anchors;
}

//------------------------------------------------------------------------------
std::vector<vtkPointSplatMotion::Part> vtkPointSplatCloud::MakeParts(const std::vector<uint32_t>& anchors)
{
  std::vector<vtkPointSplatMotion::Part> parts;
  std::vector<vtkIdType> ends;
  for (const Block& block : this->Blocks)
  {
    ends.push_back(block.First + block.Count);
  }
  const auto add = [&](uint32_t first, uint32_t count) {
    const vtkIdType points = this->Count;
    for (uint32_t end = first + count; first < end;)
    {
      // A block of coarse splats may hold those of several blocks of the input.
      const auto own = std::upper_bound(ends.begin(), ends.end(), vtkIdType(anchors[first]));
      const vtkIdType last = *own;
      uint32_t next = first + 1;
      while (next < end && vtkIdType(anchors[next]) < last)
      {
        ++next;
      }
      parts.push_back({ first, next - first, static_cast<uint32_t>(own - ends.begin()), first < points });
      first = next;
    }
  };
  this->PartsOfBlocks.clear();
  for (const vtkPointSplatLevels::Block& block : this->Levels.GetBlocks())
  {
    this->PartsOfBlocks.push_back(static_cast<uint32_t>(parts.size()));
    add(block.First, block.Count);
  }
  this->PartsOfBlocks.push_back(static_cast<uint32_t>(parts.size()));
  const uint32_t all = static_cast<uint32_t>(this->Count);
  for (uint32_t first = 0; first < all && !this->Levels.AreMade(); first += vtkPointSplatBlocks::Size)
  {
    add(first, std::min<uint32_t>(vtkPointSplatBlocks::Size, all - first));
  }
  return parts;
}

//------------------------------------------------------------------------------
bool vtkPointSplatCloud::MoveTo(const std::vector<Block>& blocks)
{
  const std::array<double, 3> origin = this->Origin;
  this->ForgetRange();
  std::vector<vtkPointSplatMotion::Block> moving;
  for (size_t b = 0; b < blocks.size(); ++b)
  {
    vtkPointSet* data = blocks[b].Data;
    vtkPointData* arrays = data->GetPointData();
    const std::shared_ptr<const vtkPointSplatCopies>& copies = this->Blocks[b].Copies;
    vtkSmartPointer<vtkDataArray> normals = arrays->GetNormals();
    normals = copies ? copies->Average(normals.Get()) : normals;
    moving.push_back(
      { data->GetPoints()->GetData(), normals, arrays->GetArray(vtkPointSplatArrays::Radius) });
    this->AddRange(moving.back().Points);
  }
  // The origin stays while it is among the points.
  this->SetOriginToMiddle();
  double off = 0.0;
  double size = 0.0;
  for (size_t k = 0; k < 3; ++k)
  {
    off = std::max(off, std::abs(this->Origin[k] - origin[k]));
    size = std::max(size, this->High[k] - this->Low[k]);
  }
  this->Origin = off <= size ? origin : this->Origin;
  vtkPointSplatMotion::Splats moved{ std::move(this->Splats), std::move(this->ClipLines) };
  const vtkPointSplatMotion::Outcome outcome =
    this->Motion.MoveTo(std::move(moving), this->Origin, moved);
  this->Splats = std::move(moved.Words);
  this->ClipLines = std::move(moved.Lines);
  for (size_t k = 0; k < 3; ++k)
  {
    this->Bounds[2 * k] = this->Low[k];
    this->Bounds[2 * k + 1] = this->High[k];
  }
  this->Stretch = outcome.Stretch;
  this->MedianRadius = this->RestingRadius * outcome.Growth;
  this->MaximumRadius = this->LargestRestingRadius * outcome.LargestGrowth;
  this->SplatTime.Modified();
  this->AllMoved = false;
  if (outcome.Followed && !this->Levels.AreMade())
  {
    this->MoveAll();
  }
  return outcome.Followed;
}

//------------------------------------------------------------------------------
void vtkPointSplatCloud::MoveAll()
{
  if (!this->Motion.HasBegun() || this->AllMoved)
  {
    return;
  }
  if (this->Levels.AreMade())
  {
    std::vector<uint32_t> blocks(this->Levels.GetBlocks().size());
    std::iota(blocks.begin(), blocks.end(), 0u);
    this->MoveBlocks(blocks);
  }
  else
  {
    std::vector<uint32_t> parts(this->Motion.GetNumberOfParts());
    std::iota(parts.begin(), parts.end(), 0u);
    this->MoveParts(parts);
  }
  this->AllMoved = true;
}

//------------------------------------------------------------------------------
void vtkPointSplatCloud::MoveBlocks(const std::vector<uint32_t>& blocks)
{
  std::vector<uint32_t> missing;
  std::vector<uint32_t> parts;
  for (uint32_t block : blocks)
  {
    const uint32_t first = this->PartsOfBlocks[block];
    if (!this->Motion.IsMoved(first))
    {
      missing.push_back(block);
      parts.resize(parts.size() + this->PartsOfBlocks[block + 1] - first);
      std::iota(parts.end() - static_cast<std::ptrdiff_t>(this->PartsOfBlocks[block + 1] - first), parts.end(), first);
    }
  }
  this->MoveParts(parts);
  const float radius = static_cast<float>(missing.empty() ? 0.0 : this->GetUsualRadius());
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(missing.size()), 16, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      this->Levels.Refit(missing[static_cast<size_t>(i)], this->Splats, this->GetWordsPerSplat(), radius);
    }
  });
}

//------------------------------------------------------------------------------
void vtkPointSplatCloud::MoveParts(const std::vector<uint32_t>& parts)
{
  vtkPointSplatMotion::Splats moved{ std::move(this->Splats), std::move(this->ClipLines) };
  this->Motion.Move(parts, moved);
  this->Splats = std::move(moved.Words);
  this->ClipLines = std::move(moved.Lines);
}
