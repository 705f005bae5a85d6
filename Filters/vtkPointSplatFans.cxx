// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatFans.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointSplatCrease.h"
#include "vtkPointSplatInput.h"
#include "vtkPoints.h"
#include "vtkPointSplatThreads.h"
#include "vtkPolyData.h"
#include "vtkSMPThreadLocal.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <numeric>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// Of a surface that is there once for each side one in so many triangles at least is the same as one before.
constexpr vtkIdType SidesShare = 3;
}

void vtkPointSplatFans::Add(
  vtkIdType a, vtkIdType b, vtkIdType c, const unsigned char* used)
{
  if (a != b && b != c && c != a && used[a] && used[b] && used[c])
  {
    this->Corners.insert(this->Corners.end(), { a, b, c });
  }
}

vtkIdType vtkPointSplatFans::Read(vtkPolyData* mesh, const unsigned char* used)
{
  this->Clear();
  const vtkIdType numberOfPoints = mesh->GetNumberOfPoints();
  vtkIdType bad = 0;
  for (vtkCellArray* cells : { mesh->GetPolys(), mesh->GetStrips() })
  {
    if (!cells || cells->GetNumberOfCells() == 0)
    {
      continue;
    }
    if (!cells->IsValid())
    {
      bad += cells->GetNumberOfCells();
      continue;
    }
    const bool strips = cells == mesh->GetStrips();
    for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
    {
      vtkIdType size;
      const vtkIdType* ids;
      cells->GetCellAtId(cell, size, ids);
      if (!std::all_of(
            ids, ids + size, [&](vtkIdType id) { return id >= 0 && id < numberOfPoints; }))
      {
        ++bad;
        continue;
      }
      for (vtkIdType i = 2; i < size; ++i)
      {
        // Of strips every second triangle has its corners the other way round.
        const vtkIdType first = strips ? ids[i - 2] : ids[0], second = ids[i - 1];
        const bool turned = strips && i % 2 == 1;
        this->Add(turned ? second : first, turned ? first : second, ids[i], used);
      }
    }
  }
  if (!this->IsEmpty())
  {
    this->Positions = vtkPointSplatInput::ReadPositions(mesh->GetPoints()->GetData());
    this->Sort();
    this->LeaveOutDoubles();
  }
  return bad;
}

/// If about each triangle is there once for each side.
void vtkPointSplatFans::LeaveOutDoubles()
{
  const vtkIdType count = static_cast<vtkIdType>(this->Corners.size() / 3);
  std::vector<unsigned char> doubled(count, 0);
  vtkPointSplatThreads::For(0, count, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType t = begin; t < end; ++t)
    {
      const vtkIdType* own = this->Corners.data() + 3 * t;
      // Fans of thousands meet in a point.
      const vtkIdType* few = std::min_element(own, own + 3,
        [this](vtkIdType a, vtkIdType b) { return this->GetNumberOfTriangles(a) < this->GetNumberOfTriangles(b); });
      this->VisitTriangles(*few, [&](const vtkIdType other[3]) {
        doubled[t] |= other < own && std::is_permutation(own, own + 3, other);
      });
    }
  });
  // Of scans some are doubled where the surface was folded flat; that does not end there.
  if (SidesShare * std::count(doubled.begin(), doubled.end(), 1) < count)
  {
    return;
  }
  std::size_t kept = 0;
  for (vtkIdType t = 0; t < count; ++t)
  {
    if (!doubled[t])
    {
      std::copy_n(this->Corners.begin() + 3 * t, 3, this->Corners.begin() + kept);
      kept += 3;
    }
  }
  this->Corners.resize(kept);
  this->Sort();
}

void vtkPointSplatFans::Take(
  std::vector<double> positions, std::vector<vtkIdType> corners, std::vector<vtkIdType> same)
{
  this->Clear();
  this->Corners = std::move(corners);
  this->Same = std::move(same);
  this->Positions = std::move(positions);
  this->Sort();
  this->FindBorder();
}

vtkSmartPointer<vtkPolyData> vtkPointSplatFans::MakeMesh() const
{
  vtkNew<vtkDoubleArray> positions;
  positions->SetNumberOfComponents(3);
  positions->SetNumberOfTuples(this->GetNumberOfPoints());
  std::copy(this->Positions.begin(), this->Positions.end(), positions->GetPointer(0));
  vtkNew<vtkPoints> points;
  points->SetData(positions);
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetNumberOfValues(static_cast<vtkIdType>(this->Corners.size()));
  std::copy(this->Corners.begin(), this->Corners.end(), ids->GetPointer(0));
  vtkNew<vtkCellArray> polygons;
  polygons->SetData(3, ids);
  mesh->SetPolys(polygons);
  return mesh;
}

void vtkPointSplatFans::Split(const std::vector<vtkIdType>& sources, std::vector<vtkIdType> corners)
{
  for (const vtkIdType source : sources)
  {
    for (int c = 0; c < 3; ++c)
    {
      this->Positions.push_back(this->Positions[3 * source + c]);
    }
    if (!this->Same.empty())
    {
      this->Same.push_back(static_cast<vtkIdType>(this->Same.size()));
    }
  }
  this->Corners = std::move(corners);
  this->WasSplit = true;
  this->Sort();
  this->FindBorder();
}

/// Makes one of two points, if they share their place, and their normal or have none, as is returned. At edges as sharp
/// as a wing's trailing one normals are nearly opposite.
bool vtkPointSplatFans::Unite(vtkIdType a, vtkIdType b, const float* normals)
{
  const float *n = normals + 3 * a, *m = normals + 3 * b;
  const bool both = !vtkPointSplatInput::IsZero(n) && !vtkPointSplatInput::IsZero(m);
  if (!this->IsSamePlace(a, b) ||
    (both && (vtkMath::Dot(n, m) < 0 || vtkPointSplatCrease::Parts(n, m))))
  {
    return false;
  }
  if (this->Same.empty())
  {
    this->Same.resize(this->GetNumberOfPoints());
    std::iota(this->Same.begin(), this->Same.end(), vtkIdType(0));
  }
  const auto getFirst = [this](vtkIdType id) {
    while (this->Same[id] != id)
    {
      id = this->Same[id] = this->Same[this->Same[id]];
    }
    return id;
  };
  const auto [first, second] = std::minmax({ getFirst(a), getFirst(b) });
  this->Same[second] = first;
  return true;
}

bool vtkPointSplatFans::Join(const float* normals)
{
  bool any = false, anyOfSeams = false;
  for (std::size_t i = 0; i < this->Corners.size(); ++i)
  {
    any = this->Unite(this->Corners[i], this->Corners[i % 3 < 2 ? i + 1 : i - 2], normals) || any;
  }
  if (any)
  {
    this->Merge();
  }
  this->FindBorder();
  // Not all of the border's: where it comes by a place twice it stays two borders.
  std::vector<vtkIdType> apart; // of one place, those that no other one was united with before
  for (const vtkIdType id : this->FindSeams())
  {
    if (!apart.empty() && !this->IsSamePlace(apart.front(), id))
    {
      apart.clear();
    }
    if (std::any_of(apart.begin(), apart.end(),
          [&](vtkIdType other) { return this->Unite(other, id, normals); }))
    {
      anyOfSeams = true;
    }
    else
    {
      apart.push_back(id);
    }
  }
  if (anyOfSeams)
  {
    this->Merge();
    this->FindBorder();
  }
  return any || anyOfSeams;
}

bool vtkPointSplatFans::HasEdgesWithoutLength() const
{
  std::atomic<bool> any{ false };
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(this->Corners.size()), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end && !any; ++i)
    {
      if (this->IsSamePlace(this->Corners[i], this->Corners[i % 3 < 2 ? i + 1 : i - 2]))
      {
        any = true;
      }
    }
  });
  return any;
}

bool vtkPointSplatFans::AreApart() const
{
  return std::adjacent_find(this->First.begin(), this->First.end(), [](vtkIdType first, vtkIdType next) {
    return next - first > 1;
  }) == this->First.end();
}

/// Takes for corners what takes part for them, and leaves out triangles that have no area by that.
void vtkPointSplatFans::Merge()
{
  for (vtkIdType& same : this->Same)
  {
    same = this->Same[same]; // the first ones come first
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < this->Corners.size(); i += 3)
  {
    vtkIdType read[3], corners[3];
    std::copy_n(this->Corners.begin() + i, 3, read);
    std::transform(read, read + 3, corners, [this](vtkIdType id) { return this->Same[id]; });
    if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
    {
      std::copy_n(corners, 3, this->Corners.begin() + kept);
      kept += 3;
    }
    else
    {
      this->Collapsed.insert(this->Collapsed.end(), read, read + 3);
    }
  }
  this->Corners.resize(kept);
  this->Sort();
}

void vtkPointSplatFans::LeaveOutCollapsed(std::vector<unsigned char>& used) const
{
  for (const vtkIdType id : this->Collapsed)
  {
    used[id] = used[id] && this->Has(id);
  }
}

/// Lists each point's triangles, in the order in which they were read.
void vtkPointSplatFans::Sort()
{
  const vtkIdType numberOfPoints = this->GetNumberOfPoints();
  this->First.assign(numberOfPoints + 1, 0);
  for (const vtkIdType id : this->Corners)
  {
    ++this->First[id + 1];
  }
  for (vtkIdType id = 0; id < numberOfPoints; ++id)
  {
    this->First[id + 1] += this->First[id];
  }
  std::vector<vtkIdType> next(this->First.begin(), this->First.end() - 1);
  this->Triangles.resize(this->Corners.size());
  for (std::size_t i = 0; i < this->Corners.size(); ++i)
  {
    this->Triangles[next[this->Corners[i]]++] = static_cast<vtkIdType>(i / 3);
  }
}

/// The edges at a point that belong to one triangle alone.
void vtkPointSplatFans::GetSingleEdges(vtkIdType id, std::vector<BorderEdge>& edges) const
{
  edges.clear();
  for (vtkIdType t = this->First[id]; t < this->First[id + 1]; ++t)
  {
    const vtkIdType* corner = this->Corners.data() + 3 * this->Triangles[t];
    const std::array<vtkIdType, 2> others = GetOthers(corner, id);
    const bool second = corner[1] == id;
    edges.push_back({ others[0], others[1], !second });
    edges.push_back({ others[1], others[0], second });
  }
  std::sort(edges.begin(), edges.end(), [](const BorderEdge& a, const BorderEdge& b) {
    return a.Next != b.Next ? a.Next < b.Next : a.Inner < b.Inner;
  });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < edges.size();)
  {
    std::size_t next = i + 1;
    while (next < edges.size() && edges[next].Next == edges[i].Next)
    {
      ++next;
    }
    if (next == i + 1)
    {
      edges[kept++] = edges[i];
    }
    i = next;
  }
  edges.resize(kept);
}

void vtkPointSplatFans::FindBorder()
{
  const vtkIdType numberOfPoints = this->GetNumberOfPoints();
  this->InBorder.assign(numberOfPoints, Inside);
  vtkSMPThreadLocal<std::vector<BorderEdge>> scratch;
  vtkPointSplatThreads::For(0, numberOfPoints, [&](vtkIdType begin, vtkIdType end) {
    std::vector<BorderEdge>& edges = scratch.Local();
    for (vtkIdType id = begin; id < end; ++id)
    {
      this->GetSingleEdges(id, edges);
      this->InBorder[id] = edges.empty() ? Inside : 0;
    }
  });
  this->Border.clear();
  this->FirstOfBorder.assign(1, 0);
  this->EdgesOfBorder.clear();
  std::vector<BorderEdge> edges;
  for (vtkIdType id = 0; id < numberOfPoints; ++id)
  {
    if (this->InBorder[id] != Inside)
    {
      this->GetSingleEdges(id, edges);
      this->InBorder[id] = this->Border.size();
      this->Border.push_back(id);
      this->EdgesOfBorder.insert(this->EdgesOfBorder.end(), edges.begin(), edges.end());
      this->FirstOfBorder.push_back(this->EdgesOfBorder.size());
    }
  }
}

vtkPointSplatFans::BorderEdges vtkPointSplatFans::GetBorderEdges(vtkIdType id) const
{
  const std::size_t i = this->Border.empty() ? Inside : this->InBorder[id];
  return i == Inside ? BorderEdges{ nullptr, 0 }
                     : BorderEdges{ this->EdgesOfBorder.data() + this->FirstOfBorder[i],
                         this->FirstOfBorder[i + 1] - this->FirstOfBorder[i] };
}

/// In the order of positions.
bool vtkPointSplatFans::IsBefore(vtkIdType a, vtkIdType b) const
{
  const double *x = this->GetPosition(a), *y = this->GetPosition(b);
  return std::lexicographical_compare(x, x + 3, y, y + 3);
}

void vtkPointSplatFans::SortByPlace(std::vector<vtkIdType>& ids) const
{
  std::sort(ids.begin(), ids.end(), [this](vtkIdType a, vtkIdType b) { return this->IsBefore(a, b); });
}

std::vector<vtkIdType> vtkPointSplatFans::FindSplit() const
{
  std::vector<vtkIdType> placed = this->Border, split;
  this->SortByPlace(placed);
  for (std::size_t i = 0; i < placed.size(); ++i)
  {
    if ((i > 0 && this->IsSamePlace(placed[i - 1], placed[i])) ||
      (i + 1 < placed.size() && this->IsSamePlace(placed[i], placed[i + 1])))
    {
      split.push_back(placed[i]);
    }
  }
  return split;
}

/// The ends of those of the border's edges that have both ends where another one has its, in the order of positions.
std::vector<vtkIdType> vtkPointSplatFans::FindSeams() const
{
  // Points in one place have the first one's number in the order of positions.
  std::vector<vtkIdType> placed = this->Border;
  this->SortByPlace(placed);
  const auto getPlace = [&](vtkIdType id) -> std::ptrdiff_t {
    return std::lower_bound(placed.begin(), placed.end(), id,
             [this](vtkIdType a, vtkIdType b) { return this->IsBefore(a, b); }) -
      placed.begin();
  };
  using Places = std::pair<std::ptrdiff_t, std::ptrdiff_t>;
  std::vector<Places> places; // of both ends of each edge, the lesser one first
  places.reserve(this->EdgesOfBorder.size());
  for (std::size_t i = 0; i < this->Border.size(); ++i)
  {
    const std::ptrdiff_t place = getPlace(this->Border[i]);
    for (std::size_t k = this->FirstOfBorder[i]; k < this->FirstOfBorder[i + 1]; ++k)
    {
      places.push_back(std::minmax({ place, getPlace(this->EdgesOfBorder[k].Next) }));
    }
  }
  // Each edge is there twice, once for each of its ends.
  std::vector<Places> sorted = places;
  std::sort(sorted.begin(), sorted.end());
  std::vector<vtkIdType> seams;
  std::size_t k = 0;
  for (std::size_t i = 0; i < this->Border.size(); ++i)
  {
    bool seam = false;
    for (; k < this->FirstOfBorder[i + 1]; ++k)
    {
      const auto same = std::equal_range(sorted.begin(), sorted.end(), places[k]);
      seam = seam || same.second - same.first > 2;
    }
    if (seam)
    {
      seams.push_back(this->Border[i]);
    }
  }
  this->SortByPlace(seams);
  return seams;
}

bool vtkPointSplatFans::AreAll(
  const std::vector<unsigned char>& used, const float* normals) const
{
  bool all = !this->IsEmpty();
  for (std::size_t id = 0; id < used.size() && all; ++id)
  {
    all = !used[id] ||
      (this->Has(static_cast<vtkIdType>(id)) && !vtkPointSplatInput::IsZero(normals + 3 * id));
  }
  return all;
}

VTK_ABI_NAMESPACE_END
