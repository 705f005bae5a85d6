// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Of the cloud: its levels.
#include "vtkPointSplatCloud.h"

#include "vtkPointSplatCodes.h"
#include "vtkPointSplatOrdered.h"
#include "vtkPointSplatPieces.h"

#include <cstddef>
#include <limits>

namespace
{
// Fewer splats are drawn in a time that is not worth the memory.
constexpr vtkIdType LeastSplats = vtkIdType(1) << 19;
// Disks of random points that are so many spacings large leave few gaps.
constexpr double CoveringSpacings = 1.5;
constexpr double MostBodies = 0.01; // a share of the splats
}

//------------------------------------------------------------------------------
bool vtkPointSplatCloud::CanHaveLevels()
{
  if (this->Count < LeastSplats || this->GetUsualRadius() <= 0.0 ||
    this->Count >= std::numeric_limits<int32_t>::max())
  {
    return false;
  }
  // Bodies alone are on no surface; a scan's outliers keep theirs.
  const size_t words = this->GetWordsPerSplat();
  const std::vector<uint32_t>& splats = this->GetRestingSplats();
  vtkIdType bodies = 0;
  for (size_t i = 0; i < static_cast<size_t>(this->Count); ++i)
  {
    bodies += (splats[words * i + 6] & vtkPointSplatCodes::BodyBit) != 0u ? 1 : 0;
  }
  return static_cast<double>(bodies) <= MostBodies * static_cast<double>(this->Count);
}

//------------------------------------------------------------------------------
double vtkPointSplatCloud::GetUsualRadius()
{
  return this->MedianRadius > 0.0 ? this->MedianRadius : CoveringSpacings * this->GetSpacing();
}

//------------------------------------------------------------------------------
void vtkPointSplatCloud::WantLevels()
{
  if (this->Levels.AreMade() || this->LevelsTriedFor == this->OrderTime.GetMTime())
  {
    return;
  }
  if (this->LevelsAskedFor != this->OrderTime.GetMTime())
  {
    this->LevelsAskedFor = this->OrderTime.GetMTime();
    return;
  }
  this->BeginLevels();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkPointSplatCloud::GetLevelsPending() const
{
  const bool pending = !this->Whole && !this->Levels.AreMade() &&
    this->LevelsTriedFor != this->LevelsAskedFor &&
    this->LevelsAskedFor == this->OrderTime.GetMTime();
  return pending ? this->LevelsAskedFor : 0;
}

//------------------------------------------------------------------------------
bool vtkPointSplatCloud::BeginLevels()
{
  if (this->GetLevelsPending() == 0)
  {
    return false;
  }
  this->LevelsTriedFor = this->LevelsAskedFor;
  if (!this->CanHaveLevels())
  {
    return false;
  }
  std::vector<uint32_t> ends;
  for (const Block& block : this->Blocks)
  {
    ends.push_back(static_cast<uint32_t>(block.First + block.Count));
  }
  // Points that move are found block by block, and blocks that lie side by side are sharper where they meet.
  this->Mixes = !this->Motion.HasBegun() &&
    vtkPointSplatPieces::AreMixed(this->Splats, this->GetWordsPerSplat(), ends, this->GetSpacing());
  for (size_t b = ends.size() - 1; this->Mixes && b > 0; --b)
  {
    if (vtkPointSplatPieces::MayMix(this->Blocks[b - 1].Data) &&
      vtkPointSplatPieces::MayMix(this->Blocks[b].Data))
    {
      ends.erase(ends.begin() + static_cast<std::ptrdiff_t>(b) - 1);
    }
  }
  // As they rest.
  const double stretch = this->Motion.HasBegun() ? this->Stretch : 1.0;
  this->Levels.Begin(this->GetRestingSplats(), this->GetWordsPerSplat(), std::move(ends),
    static_cast<float>(this->GetUsualRadius() / stretch));
  return true;
}

//------------------------------------------------------------------------------
void vtkPointSplatCloud::MakeLevels()
{
  this->LevelsAskedFor = this->OrderTime.GetMTime();
  if (this->BeginLevels())
  {
    this->TakeLevels(true);
  }
}

//------------------------------------------------------------------------------
bool vtkPointSplatCloud::TakeLevels(bool wait)
{
  if (!wait && !this->Levels.IsReady())
  {
    return false;
  }
  const bool moves = this->Motion.HasBegun();
  if (moves && this->Mixes)
  {
    // They were begun when points did not move yet.
    this->Levels.Clear();
    this->LevelsTriedFor = 0;
    return false;
  }
  vtkPointSplatMotion::Splats splats = moves
    ? this->Motion.Take()
    : vtkPointSplatMotion::Splats{ std::move(this->Splats), std::move(this->ClipLines) };
  const std::vector<uint32_t> order =
    this->Levels.Take(splats.Words, splats.Lines, this->GetWordsPerSplat());
  if (moves)
  {
    this->BeginMotion(std::move(splats));
  }
  else
  {
    this->Splats = std::move(splats.Words);
    this->ClipLines = std::move(splats.Lines);
  }
  if (!order.empty())
  {
    this->Mixed.resize(this->Mixes ? order.size() : 0);
    for (size_t i = 0; i < this->Mixed.size(); ++i)
    {
      this->Mixed[order[i]] = static_cast<uint32_t>(i);
    }
    this->SplatTime.Modified();
    this->OrderTime.Modified();
    this->LevelsTriedFor = this->OrderTime.GetMTime();
  }
  return !order.empty();
}

//------------------------------------------------------------------------------
void vtkPointSplatCloud::Unmix()
{
  if (this->Mixed.empty())
  {
    return;
  }
  const size_t count = this->Mixed.size();
  this->Splats = vtkPointSplatOrdered(this->Splats, this->GetWordsPerSplat(), this->Mixed, count);
  if (!this->ClipLines.empty())
  {
    this->ClipLines = vtkPointSplatOrdered(this->ClipLines, 4, this->Mixed, count);
  }
  this->Mixed.clear();
  this->Levels.Clear();
  this->SplatTime.Modified();
  this->OrderTime.Modified();
}
