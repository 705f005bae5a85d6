// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatTriangles.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointSplatCells.h"
#include "vtkPoints.h"
#include "vtkPointSplatThreads.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

namespace
{
constexpr uint32_t None = 0xffffffffu;
constexpr float LongestShare = 1.0f / 3.0f; // of the longest edge

std::array<float, 3> PositionOf(const vtkPointSplatTriangles::Splats& splats, uint32_t splat)
{
  std::array<float, 3> p;
  std::memcpy(p.data(), splats.Words.data() + splats.WordsPerSplat * splat, sizeof(p));
  return p;
}

/// The triangles of a polygon, as places in its list of points.
void CutUp(vtkPolyData* data, const vtkIdType* ids, vtkIdType count, std::vector<vtkIdType>& triangles)
{
  triangles.clear();
  if (count > 4)
  {
    vtkNew<vtkPolygon> polygon;
    polygon->PointIds->SetNumberOfIds(count);
    polygon->Points->SetNumberOfPoints(count);
    for (vtkIdType i = 0; i < count; ++i)
    {
      double p[3];
      data->GetPoint(ids[i], p);
      polygon->PointIds->SetId(i, i);
      polygon->Points->SetPoint(i, p);
    }
    vtkNew<vtkIdList> cut;
    vtkNew<vtkPoints> points;
    if (static_cast<vtkCell*>(polygon)->Triangulate(0, cut, points) &&
      cut->GetNumberOfIds() == 3 * (count - 2))
    {
      triangles.assign(cut->begin(), cut->end());
      return;
    }
  }
  for (vtkIdType i = 2; i < count; ++i)
  {
    triangles.insert(triangles.end(), { 0, i - 1, i });
  }
}

void Grow(vtkPointSplatTriangles::Extent& extent, const std::array<float, 3>& p)
{
  for (size_t k = 0; k < 3; ++k)
  {
    extent.Low[k] = std::min(extent.Low[k], p[k]);
    extent.High[k] = std::max(extent.High[k], p[k]);
  }
}

vtkPointSplatTriangles::Extent NoExtent()
{
  return { { { VTK_FLOAT_MAX, VTK_FLOAT_MAX, VTK_FLOAT_MAX } },
    { { -VTK_FLOAT_MAX, -VTK_FLOAT_MAX, -VTK_FLOAT_MAX } }, 0.0f };
}
}

//------------------------------------------------------------------------------
void vtkPointSplatTriangles::Make(const std::vector<Mesh>& meshes, const Splats& splats)
{
  this->Corners.clear();
  this->Patches.clear();
  this->Crossings.clear();
  this->Loose.clear();
  this->Extents.clear();
  this->PatchOfBlock.clear();
  this->LongestEdge = 0.0f;
  std::vector<bool> used(static_cast<size_t>(splats.Count), false);
  for (const Mesh& mesh : meshes)
  {
    if (mesh.Data && vtkPointSplatCells::CanBeRead(mesh.Data))
    {
      this->Collect(mesh, splats, used);
    }
  }
  // Entries of lists have 31 bits for a triangle.
  if (this->Corners.size() / 4 >= 0x80000000u)
  {
    this->Corners.clear();
  }
  if (this->Corners.empty())
  {
    return;
  }
  const std::vector<uint32_t> patchOf = this->DividePatches(splats);
  this->Order(patchOf);
  this->Measure(splats);
  this->FindLoose(used, patchOf);
}

//------------------------------------------------------------------------------
void vtkPointSplatTriangles::Collect(
  const Mesh& mesh, const Splats& splats, std::vector<bool>& used)
{
  const vtkIdType points = mesh.Data->GetNumberOfPoints();
  std::vector<uint32_t> splatOf(static_cast<size_t>(points), None);
  for (vtkIdType i = mesh.First; i < mesh.First + mesh.Count; ++i)
  {
    // Folded splats are several of one point, at one place.
    const uint32_t point = splats.Words[splats.WordsPerSplat * static_cast<size_t>(i) + 7];
    splatOf[point] = splatOf[point] == None ? static_cast<uint32_t>(i) : splatOf[point];
  }
  static const std::vector<vtkPointSplatCopies::Copy> none;
  const std::vector<vtkPointSplatCopies::Copy>& copies = mesh.Copies ? mesh.Copies->Get() : none;
  for (const vtkPointSplatCopies::Copy& copy : copies)
  {
    splatOf[copy.Point] = splatOf[copy.Of];
  }
  vtkUnsignedCharArray* ghosts = vtkPointSplatCells::GetGhosts(mesh.Data);
  std::vector<bool> isCorner(static_cast<size_t>(points), false);
  auto add = [&](const vtkIdType* ids, vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType cell) {
    const vtkIdType three[3] = { ids[a], ids[b], ids[c] };
    if (!std::all_of(three, three + 3,
          [&](vtkIdType id) { return splatOf[static_cast<size_t>(id)] != None; }))
    {
      return;
    }
    for (const vtkIdType id : three)
    {
      this->Corners.push_back(splatOf[static_cast<size_t>(id)]);
      isCorner[static_cast<size_t>(id)] = true;
    }
    this->Corners.push_back(static_cast<uint32_t>(cell));
  };
  vtkIdType cell = mesh.Data->GetNumberOfVerts() + mesh.Data->GetNumberOfLines();
  std::vector<vtkIdType> cut;
  for (vtkCellArray* cells : { mesh.Data->GetPolys(), mesh.Data->GetStrips() })
  {
    if (!cells || cells->GetNumberOfCells() == 0)
    {
      continue;
    }
    const bool strips = cells == mesh.Data->GetStrips();
    auto it = vtk::TakeSmartPointer(cells->NewIterator());
    for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell(), ++cell)
    {
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      it->GetCurrentCell(count, ids);
      if (vtkPointSplatCells::IsGhost(ghosts, cell) || count < 3 ||
        !vtkPointSplatCells::ArePoints(ids, count, points))
      {
        continue;
      }
      if (strips)
      {
        for (vtkIdType i = 2; i < count; ++i)
        {
          add(ids, i - 2, i - 1, i, cell);
        }
      }
      else if (count == 3)
      {
        add(ids, 0, 1, 2, cell);
      }
      else
      {
        CutUp(mesh.Data, ids, count, cut);
        for (size_t i = 0; i < cut.size(); i += 3)
        {
          add(ids, cut[i], cut[i + 1], cut[i + 2], cell);
        }
      }
    }
  }
  for (const vtkPointSplatCopies::Copy& copy : copies)
  {
    isCorner[copy.Of] = isCorner[copy.Of] || isCorner[copy.Point];
  }
  for (vtkIdType i = mesh.First; i < mesh.First + mesh.Count; ++i)
  {
    const uint32_t point = splats.Words[splats.WordsPerSplat * static_cast<size_t>(i) + 7];
    used[static_cast<size_t>(i)] = isCorner[point];
  }
}

//------------------------------------------------------------------------------
std::vector<uint32_t> vtkPointSplatTriangles::DividePatches(const Splats& splats)
{
  std::vector<uint32_t> patchOf(static_cast<size_t>(splats.Count), None);
  uint32_t patches = 0;
  const std::vector<vtkPointSplatLevels::Block>& blocks = splats.Levels.GetBlocks();
  if (blocks.empty())
  {
    for (size_t i = 0; i < patchOf.size(); ++i)
    {
      patchOf[i] = static_cast<uint32_t>(i >> vtkPointSplatBlocks::Shift);
      patches = patchOf[i] + 1;
    }
  }
  this->PatchOfBlock.assign(blocks.size(), None);
  for (size_t b = 0; b < blocks.size(); ++b)
  {
    if (blocks[b].Level == 0)
    {
      std::fill_n(patchOf.begin() + blocks[b].First, blocks[b].Count, patches);
      this->PatchOfBlock[b] = patches++;
    }
  }
  // What has no level is never selected as a patch of its own.
  if (std::find(patchOf.begin(), patchOf.end(), None) != patchOf.end())
  {
    std::replace(patchOf.begin(), patchOf.end(), None, patches);
    ++patches;
  }
  this->Patches.assign(patches + size_t(1), { NoExtent(), 0, 0, 0, 0, 0 });
  return patchOf;
}

//------------------------------------------------------------------------------
void vtkPointSplatTriangles::Order(const std::vector<uint32_t>& patchOf)
{
  const size_t count = this->Corners.size() / 4;
  auto patchesOf = [&](size_t triangle) {
    std::array<uint32_t, 3> p;
    for (size_t k = 0; k < 3; ++k)
    {
      p[k] = patchOf[this->Corners[4 * triangle + k]];
    }
    std::sort(p.begin(), p.end());
    return p;
  };
  // Within a patch: two keys a patch, the second one of what crosses.
  std::vector<uint32_t> places(2 * this->Patches.size() + 1, 0);
  std::vector<uint32_t> keys(count);
  for (size_t t = 0; t < count; ++t)
  {
    const std::array<uint32_t, 3> p = patchesOf(t);
    const bool crosses = p[0] != p[2];
    keys[t] = 2 * p[0] + (crosses ? 1 : 0);
    ++places[keys[t] + size_t(1)];
  }
  std::partial_sum(places.begin(), places.end(), places.begin());
  for (size_t patch = 0; patch < this->Patches.size(); ++patch)
  {
    this->Patches[patch].First = places[2 * patch];
    this->Patches[patch].Crossing = places[2 * patch + 1];
    this->Patches[patch].End = places[std::min(2 * patch + 2, places.size() - 1)];
  }
  std::vector<uint32_t> ordered(this->Corners.size());
  for (size_t t = 0; t < count; ++t)
  {
    std::copy_n(this->Corners.data() + 4 * t, 4, ordered.data() + 4 * size_t(places[keys[t]]++));
  }
  this->Corners.swap(ordered);

  // To each patch what crosses there.
  std::vector<uint32_t> shares(this->Patches.size() + 1, 0);
  auto forEachCrossing = [&](auto function) {
    for (const Patch& patch : this->Patches)
    {
      for (uint32_t t = patch.Crossing; t < patch.End; ++t)
      {
        const std::array<uint32_t, 3> p = patchesOf(t);
        for (size_t k = 0; k < 3; ++k)
        {
          if (k == 0 || p[k] != p[k - 1])
          {
            function(t, p, p[k]);
          }
        }
      }
    }
  };
  forEachCrossing([&](uint32_t, const std::array<uint32_t, 3>&, uint32_t patch) {
    ++shares[patch + size_t(1)];
  });
  std::partial_sum(shares.begin(), shares.end(), shares.begin());
  for (size_t patch = 0; patch < this->Patches.size(); ++patch)
  {
    this->Patches[patch].FirstShared = shares[patch];
  }
  this->Crossings.resize(shares.back());
  forEachCrossing([&](uint32_t t, const std::array<uint32_t, 3>& p, uint32_t patch) {
    this->Crossings[shares[patch]++] = { t, p };
  });
}

//------------------------------------------------------------------------------
void vtkPointSplatTriangles::Measure(const Splats& splats)
{
  struct Edges
  {
    double Squares = 0.0;
    double Longest = 0.0;
    size_t Count = 0;
  };
  auto add = [&](uint32_t triangle, Extent& extent, Edges& edges) {
    std::array<float, 3> p[3];
    for (size_t k = 0; k < 3; ++k)
    {
      p[k] = PositionOf(splats, this->Corners[4 * size_t(triangle) + k]);
      Grow(extent, p[k]);
    }
    for (size_t k = 0; k < 3; ++k)
    {
      const std::array<float, 3>& a = p[k];
      const std::array<float, 3>& b = p[(k + 1) % 3];
      const double square = std::pow(a[0] - b[0], 2) + std::pow(a[1] - b[1], 2) +
        std::pow(a[2] - b[2], 2);
      edges.Squares += square;
      edges.Longest = std::max(edges.Longest, square);
      ++edges.Count;
    }
  };
  std::vector<float> longest(this->GetNumberOfPatches(), 0.0f);
  auto measure = [&](size_t i) {
    Patch& patch = this->Patches[i];
    Edges edges;
    for (uint32_t t = patch.First; t < patch.Crossing; ++t)
    {
      add(t, patch.Size, edges);
    }
    for (uint32_t s = patch.FirstShared; s < this->Patches[i + 1].FirstShared; ++s)
    {
      add(this->Crossings[s].Triangle, patch.Size, edges);
    }
    if (edges.Count > 0)
    {
      longest[i] = static_cast<float>(std::sqrt(edges.Longest));
      patch.Size.Edge =
        std::max(static_cast<float>(std::sqrt(edges.Squares / static_cast<double>(edges.Count))),
          LongestShare * longest[i]);
    }
  };
  vtkPointSplatThreads::For(
    0, static_cast<vtkIdType>(longest.size()), 256, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType i = begin; i < end; ++i)
      {
        measure(static_cast<size_t>(i));
      }
    });
  this->LongestEdge = *std::max_element(longest.begin(), longest.end());
  const std::vector<vtkPointSplatLevels::Block>& blocks = splats.Levels.GetBlocks();
  this->Extents.assign(blocks.size(), NoExtent());
  const auto join = [](Extent& extent, const Extent& other) {
    Grow(extent, other.Low);
    Grow(extent, other.High);
    extent.Edge = std::max(extent.Edge, other.Edge);
  };
  for (size_t b = 0; b < blocks.size(); ++b)
  {
    Extent& extent = this->Extents[b];
    Grow(extent, { { blocks[b].Low[0], blocks[b].Low[1], blocks[b].Low[2] } });
    Grow(extent, { { blocks[b].High[0], blocks[b].High[1], blocks[b].High[2] } });
    if (blocks[b].Level == 0 && this->Patches[this->PatchOfBlock[b]].Size.Edge > 0.0f)
    {
      join(extent, this->Patches[this->PatchOfBlock[b]].Size);
    }
  }
  vtkPointSplatHierarchy::JoinUpward(blocks, [this, &join](size_t block, size_t child) {
    join(this->Extents[block], this->Extents[child]);
  });
}

//------------------------------------------------------------------------------
void vtkPointSplatTriangles::FindLoose(
  const std::vector<bool>& used, const std::vector<uint32_t>& patchOf)
{
  constexpr uint32_t most = 1u << vtkPointSplatBlocks::PieceShift;
  std::vector<std::pair<uint32_t, vtkPointSplatRuns::Run>> runs; // patch, run
  for (size_t i = 0; i < used.size(); ++i)
  {
    if (used[i])
    {
      continue;
    }
    const bool goesOn = !runs.empty() && runs.back().first == patchOf[i] &&
      runs.back().second.First + runs.back().second.Count == i && runs.back().second.Count < most;
    if (goesOn)
    {
      ++runs.back().second.Count;
    }
    else
    {
      runs.push_back({ patchOf[i], { static_cast<uint32_t>(i), 1 } });
    }
  }
  std::stable_sort(runs.begin(), runs.end(),
    [](const auto& a, const auto& b) { return a.first < b.first; });
  size_t at = 0;
  for (size_t patch = 0; patch < this->Patches.size(); ++patch)
  {
    while (at < runs.size() && runs[at].first < patch)
    {
      ++at;
    }
    this->Patches[patch].FirstLoose = static_cast<uint32_t>(at);
  }
  for (const auto& run : runs)
  {
    this->Loose.push_back(run.second);
  }
}
