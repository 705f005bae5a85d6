// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatLevelSelection.h"

#include "vtkPointSplatThreads.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace
{
// Radians: normals are coded, and splats' sides seen, less exactly than this.
constexpr double AngleMargin = 0.01;
// Outlines show how large splats are: there those of smooth surfaces are smaller by this.
constexpr double OutlineShare = 0.5;
// Branches of the tree that threads visit: as many as keep them all busy, some at a time.
constexpr size_t EnoughBranches = 256;
constexpr vtkIdType BranchesAtOnce = 4;

/// Appends the numbers of a block's children.
void AddChildren(const vtkPointSplatLevels::Block& block, std::vector<uint32_t>& numbers)
{
  numbers.resize(numbers.size() + block.ChildCount);
  std::iota(numbers.end() - static_cast<std::ptrdiff_t>(block.ChildCount), numbers.end(), block.FirstChild);
}
}

//------------------------------------------------------------------------------
vtkPointSplatLevelSelection::vtkPointSplatLevelSelection(
  const vtkPointSplatView& view, const vtkPointSplatItem& item)
  : Item(item)
  , Halves(view, item)
  , PixelSize(view, item)
  , Patches(view, item)
{
  const glm::dmat4 MCVC = item.GetMCVC(view);
  this->Eye = glm::inverse(MCVC) *
    (view.Parallel ? glm::dvec4(0.0, 0.0, 1.0, 0.0) : glm::dvec4(0.0, 0.0, 0.0, 1.0));
}

//------------------------------------------------------------------------------
vtkPointSplatLevelSelection::Sides vtkPointSplatLevelSelection::SidesOf(const Block& block) const
{
  const glm::dvec3 low(block.Low[0], block.Low[1], block.Low[2]);
  const glm::dvec3 high(block.High[0], block.High[1], block.High[2]);
  const glm::dvec3 centre = 0.5 * (low + high);
  glm::dvec3 towards(this->Eye);
  double width = 0.0; // of the directions to the eye, radians
  if (this->Eye.w != 0.0)
  {
    towards = towards / this->Eye.w - centre;
    const double radius = 0.5 * glm::distance(low, high);
    const double distance = glm::length(towards);
    if (distance <= radius)
    {
      return { true, true };
    }
    width = std::asin(radius / distance);
  }
  const glm::dvec3 axis(block.Cone[0], block.Cone[1], block.Cone[2]);
  const double angle =
    std::acos(glm::clamp(glm::dot(axis, glm::normalize(towards)), -1.0, 1.0));
  const double spread = block.Angle + width + AngleMargin;
  const double quarter = 0.5 * std::acos(-1.0);
  return { angle - spread <= quarter, angle + spread >= quarter };
}

//------------------------------------------------------------------------------
bool vtkPointSplatLevelSelection::IsFine(const Block& block, const Sides& sides) const
{
  const double size = this->PixelSize.At(block) * this->Item.RadiusScale;
  const vtkPointSplatLevelBounds& bounds = this->Item.Levels;
  const size_t index =
    static_cast<size_t>(&block - this->Item.Cloud->GetLevels().GetBlocks().data());
  double deviation = block.Deviation;
  for (const vtkPointSplatLevels::Deviations* painted :
    { &this->Item.Cloud->GetColourDeviations(), &this->Item.FactorDeviations })
  {
    deviation = *painted ? std::max<double>(deviation, (**painted)[index]) : deviation;
  }
  const bool smooth = deviation <= bounds.Deviation;
  const bool outline = sides.Front && sides.Back;
  const double most = outline ? OutlineShare * bounds.SmoothPixels : bounds.SmoothPixels;
  const double allowed = smooth ? std::max(most, bounds.Pixels) : bounds.Pixels;
  return size * block.MeanRadius <= allowed;
}

//------------------------------------------------------------------------------
const vtkPointSplatTriangles::Extent& vtkPointSplatLevelSelection::ExtentOf(
  const Block& block) const
{
  const vtkPointSplatCloud& cloud = *this->Item.Cloud;
  return cloud.GetTriangles().GetExtent(
    static_cast<size_t>(&block - cloud.GetLevels().GetBlocks().data()));
}

//------------------------------------------------------------------------------
bool vtkPointSplatLevelSelection::IsOutside(const Block& block) const
{
  vtkPointSplatBlocks::Box box{ { { block.Low[0], block.Low[1], block.Low[2] } },
    { { block.High[0], block.High[1], block.High[2] } }, block.Radius };
  if (this->Item.TrianglePixels > 0.0)
  {
    const vtkPointSplatTriangles::Extent& extent = this->ExtentOf(block);
    box.Low = extent.Low;
    box.High = extent.High;
  }
  return this->Halves.IsOutside(box);
}

//------------------------------------------------------------------------------
vtkPointSplatLevelSelection::Decision vtkPointSplatLevelSelection::Decide(const Block& block) const
{
  if (this->IsOutside(block))
  {
    return Decision::LeaveOut;
  }
  const Sides sides = this->SidesOf(block);
  const bool front = sides.Front && (this->Item.Culling & 2) == 0;
  const bool back = sides.Back && (this->Item.Culling & 1) == 0;
  if (!front && !back)
  {
    return Decision::LeaveOut;
  }
  const bool magnified =
    this->Item.TrianglePixels > 0.0 && this->Patches.IsMagnified(this->ExtentOf(block));
  if (block.Level > 0 && (magnified || !this->IsFine(block, sides)))
  {
    return Decision::Divide;
  }
  return magnified ? Decision::TakeTriangles : Decision::TakeSplats;
}

//------------------------------------------------------------------------------
void vtkPointSplatLevelSelection::Visit(const Block& block, Chosen& chosen) const
{
  const std::vector<Block>& blocks = this->Item.Cloud->GetLevels().GetBlocks();
  constexpr uint32_t most = 1u << vtkPointSplatBlocks::PieceShift;
  switch (this->Decide(block))
  {
    case Decision::LeaveOut:
      return;
    case Decision::Divide:
      for (uint32_t child = 0; child < block.ChildCount; ++child)
      {
        this->Visit(blocks[block.FirstChild + child], chosen);
      }
      return;
    case Decision::TakeTriangles:
      chosen.Patches.push_back(
        this->Item.Cloud->GetTriangles().GetPatch(static_cast<size_t>(&block - blocks.data())));
      return;
    case Decision::TakeSplats:
      for (uint32_t i = 0; i < block.Count; i += most)
      {
        chosen.Runs.push_back({ block.First + i, std::min(most, block.Count - i) });
      }
      chosen.LargestRadius = std::max<double>(chosen.LargestRadius, block.Radius);
  }
}

//------------------------------------------------------------------------------
std::vector<uint32_t> vtkPointSplatLevelSelection::FindBranches() const
{
  const vtkPointSplatLevels& levels = this->Item.Cloud->GetLevels();
  std::vector<uint32_t> branches(levels.GetNumberOfRoots());
  std::iota(branches.begin(), branches.end(), 0u);
  for (bool divides = true; divides && branches.size() < EnoughBranches;)
  {
    divides = false;
    std::vector<uint32_t> next;
    for (const uint32_t number : branches)
    {
      const Block& block = levels.GetBlocks()[number];
      if (this->Decide(block) != Decision::Divide)
      {
        next.push_back(number);
        continue;
      }
      divides = true;
      AddChildren(block, next);
    }
    branches = std::move(next);
  }
  return branches;
}

//------------------------------------------------------------------------------
void vtkPointSplatLevelSelection::MoveVisited()
{
  const vtkPointSplatLevels& levels = this->Item.Cloud->GetLevels();
  std::vector<uint32_t> front(levels.GetNumberOfRoots());
  std::iota(front.begin(), front.end(), 0u);
  while (!front.empty())
  {
    this->Item.Cloud->MoveBlocks(front);
    std::vector<uint32_t> next;
    for (uint32_t number : front)
    {
      const Block& block = levels.GetBlocks()[number];
      if (this->Decide(block) == Decision::Divide)
      {
        AddChildren(block, next);
      }
    }
    front = std::move(next);
  }
}

//------------------------------------------------------------------------------
std::shared_ptr<const vtkPointSplatRuns> vtkPointSplatLevelSelection::Choose()
{
  auto chosen = std::make_shared<vtkPointSplatRuns>();
  const vtkPointSplatLevels& levels = this->Item.Cloud->GetLevels();
  if (this->Item.Cloud->IsFollowing())
  {
    this->MoveVisited();
  }
  const std::vector<uint32_t> branches = this->FindBranches();
  std::vector<Chosen> parts(branches.size());
  vtkPointSplatThreads::For(
    0, static_cast<vtkIdType>(branches.size()), BranchesAtOnce, [&](vtkIdType begin, vtkIdType end) {
      for (size_t i = static_cast<size_t>(begin); i < static_cast<size_t>(end); ++i)
      {
        this->Visit(levels.GetBlocks()[branches[i]], parts[i]);
      }
    });
  for (const Chosen& part : parts)
  {
    chosen->Runs.insert(chosen->Runs.end(), part.Runs.begin(), part.Runs.end());
    chosen->LargestRadius = std::max(chosen->LargestRadius, part.LargestRadius);
    for (const uint32_t patch : part.Patches)
    {
      this->Patches.Take(patch);
    }
  }
  this->Patches.AddTo(*chosen);
  return chosen;
}
