// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatFans.h"

#include "vtkCellArray.h"
#include "vtkMath.h"
#include "vtkPointSplatCrease.h"
#include "vtkPointSplatCurvature.h"
#include "vtkPointSplatDisk.h"
#include "vtkPointSplatInput.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// The radius, of the mean distance of the neighbours: below 0.6 holes open, and from 0.7 on
/// disks stand out at edges (this and the next are from Testing/Accuracy/fit_constants.py).
constexpr float LengthPerEdge = 0.62f;
/// ... and of what the triangles ask for, which kernels need not in full.
constexpr float LengthPerReach = 0.9f;

/// How many neighbours tell the curvature: as many as are searched for without a mesh.
constexpr int CurvatureNeighbors = 12;

// The next two are from fit_constants.py, too.
/// Where triangles are long, what is beside them tells the curvature across: no spacing is more than so many times as far
/// as the third neighbour.
constexpr float ThirdsPerSpacing = 4;
/// From which sine on a triangle at a vertex falls off so steeply from its disk that this is none of the surface: a tip.
constexpr float SteepSine = 0.75f;

constexpr int MaximumNumberOfNeighbors = vtkPointSplatNeighbors::MaximumNumberOfNeighbors;

/// How many of a neighbour's triangles are looked at.
constexpr vtkIdType MostTriangles = 64;

/// A vertex' neighbours, nearest first.
struct Ring
{
  vtkPointSplatNeighbors::Slot Slots[MaximumNumberOfNeighbors];
  float X[MaximumNumberOfNeighbors], Y[MaximumNumberOfNeighbors], Z[MaximumNumberOfNeighbors];
  float Squared[MaximumNumberOfNeighbors];
  int Count = 0;

  /// Adds a neighbour, if it is one of so many nearest ones.
  void Add(vtkPointSplatNeighbors::Slot slot, const float d[3], int most)
  {
    const float squared = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    if (!(squared > 0) || (this->Count >= most && squared >= this->Squared[most - 1]) ||
      std::find(this->Slots, this->Slots + this->Count, slot) != this->Slots + this->Count)
    {
      return;
    }
    int at = this->Count < most ? this->Count++ : most - 1;
    for (; at > 0 && this->Squared[at - 1] > squared; --at)
    {
      this->Put(at, this->Slots[at - 1], this->X[at - 1], this->Y[at - 1], this->Z[at - 1]);
      this->Squared[at] = this->Squared[at - 1];
    }
    this->Put(at, slot, d[0], d[1], d[2]);
    this->Squared[at] = squared;
  }

private:
  void Put(int at, vtkPointSplatNeighbors::Slot slot, float x, float y, float z)
  {
    this->Slots[at] = slot;
    this->X[at] = x;
    this->Y[at] = y;
    this->Z[at] = z;
  }
};
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
        this->Add(strips ? ids[i - 2] : ids[0], ids[i - 1], ids[i], used);
      }
    }
  }
  if (!this->IsEmpty())
  {
    this->Positions = vtkPointSplatInput::ReadPositions(mesh->GetPoints()->GetData());
    this->Sort();
  }
  return bad;
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
    const vtkIdType others[2] = { corner[0] == id ? corner[1] : corner[0],
      corner[2] == id ? corner[1] : corner[2] };
    edges.push_back({ others[0], others[1] });
    edges.push_back({ others[1], others[0] });
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
  std::vector<unsigned char> atBorder(numberOfPoints, 0);
  vtkSMPThreadLocal<std::vector<BorderEdge>> scratch;
  vtkSMPTools::For(0, numberOfPoints, [&](vtkIdType begin, vtkIdType end) {
    std::vector<BorderEdge>& edges = scratch.Local();
    for (vtkIdType id = begin; id < end; ++id)
    {
      this->GetSingleEdges(id, edges);
      atBorder[id] = !edges.empty();
    }
  });
  this->Border.clear();
  this->FirstOfBorder.assign(1, 0);
  this->EdgesOfBorder.clear();
  std::vector<BorderEdge> edges;
  for (vtkIdType id = 0; id < numberOfPoints; ++id)
  {
    if (atBorder[id])
    {
      this->GetSingleEdges(id, edges);
      this->Border.push_back(id);
      this->EdgesOfBorder.insert(this->EdgesOfBorder.end(), edges.begin(), edges.end());
      this->FirstOfBorder.push_back(this->EdgesOfBorder.size());
    }
  }
}

vtkPointSplatFans::BorderEdges vtkPointSplatFans::GetBorderEdges(vtkIdType id) const
{
  const auto at = std::lower_bound(this->Border.begin(), this->Border.end(), id);
  if (at == this->Border.end() || *at != id)
  {
    return { nullptr, 0 };
  }
  const std::size_t i = at - this->Border.begin();
  return { this->EdgesOfBorder.data() + this->FirstOfBorder[i],
    this->FirstOfBorder[i + 1] - this->FirstOfBorder[i] };
}

/// In the order of positions.
bool vtkPointSplatFans::IsBefore(vtkIdType a, vtkIdType b) const
{
  const double *x = this->GetPosition(a), *y = this->GetPosition(b);
  return std::lexicographical_compare(x, x + 3, y, y + 3);
}

/// The ends of those of the border's edges that have both ends where another one has its, in the order of positions.
std::vector<vtkIdType> vtkPointSplatFans::FindSeams() const
{
  // Points in one place have the first one's number in the order of positions.
  std::vector<vtkIdType> placed = this->Border;
  std::sort(placed.begin(), placed.end(),
    [this](vtkIdType a, vtkIdType b) { return this->IsBefore(a, b); });
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
  std::sort(seams.begin(), seams.end(),
    [this](vtkIdType a, vtkIdType b) { return this->IsBefore(a, b); });
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

vtkPointSplatFans::Disk vtkPointSplatFans::GetDisk(vtkIdType id, const float* normals) const
{
  using Slot = vtkPointSplatNeighbors::Slot;
  Ring ring;
  const double* centre = this->Positions.data() + 3 * id;
  float reach2 = 0;
  for (vtkIdType t = this->First[id]; t < this->First[id + 1]; ++t)
  {
    const vtkIdType* corner = this->Corners.data() + 3 * this->Triangles[t];
    const vtkIdType others[2] = { corner[0] == id ? corner[1] : corner[0],
      corner[2] == id ? corner[1] : corner[2] };
    float d[2][3];
    for (int k = 0; k < 2; ++k)
    {
      for (int c = 0; c < 3; ++c)
      {
        d[k][c] = static_cast<float>(this->Positions[3 * others[k] + c] - centre[c]);
      }
      ring.Add(static_cast<Slot>(others[k]), d[k], MaximumNumberOfNeighbors);
    }
    const float aa = vtkMath::Dot(d[0], d[0]), bb = vtkMath::Dot(d[1], d[1]),
                ab = vtkMath::Dot(d[0], d[1]);
    if (!(aa > 0) || !(bb > 0))
    {
      continue;
    }
    const float cross2 = aa * bb - ab * ab;
    const float circumscribed2 =
      cross2 > 0 ? aa * bb * (aa + bb - 2 * ab) / (4 * cross2) : 0.25f * std::max(aa, bb);
    reach2 = std::max(reach2, vtkPointSplatDisk::GetSquaredReach(aa, bb, ab, circumscribed2));
  }

  Disk found;
  const float* n = normals + 3 * id;
  std::copy(n, n + 3, found.Plane);
  if (ring.Count == 0)
  {
    return found;
  }
  float sum = 0;
  for (int i = 0; i < ring.Count; ++i)
  {
    sum += std::sqrt(ring.Squared[i]);
  }
  found.Radius = std::max(LengthPerEdge * sum / ring.Count, LengthPerReach * std::sqrt(reach2));

  found.Distance = vtkPointSplatDisk::GetDistance(ring.Squared, ring.Count, 0.0f);
  found.Width = std::sqrt(ring.Squared[std::min(ring.Count - 1, 1)]);
  found.Farthest = std::sqrt(ring.Squared[ring.Count - 1]);
  const float grain = vtkPointSplatSheet::Grain * found.Farthest;
  float lowest = 1, highest = -1; // neighbours, as sines
  for (int i = 0; i < ring.Count; ++i)
  {
    const float place[3] = { ring.X[i], ring.Y[i], ring.Z[i] };
    found.Turn = std::max(found.Turn, vtkPointSplatSheet::GetSquaredTurn(n, place, grain));
    const float height = vtkMath::Dot(n, place) / vtkMath::Norm(place);
    lowest = std::min(lowest, height);
    highest = std::max(highest, height);
  }
  found.Turn = std::sqrt(found.Turn);
  found.Tip = highest < -SteepSine || lowest > SteepSine;

  // How the surface bends the corners beyond tell, too: few normals are too noisy.
  const int next = ring.Count, most = std::max(next, CurvatureNeighbors);
  Slot beside[MaximumNumberOfNeighbors];
  std::copy(ring.Slots, ring.Slots + next, beside);
  for (int i = 0; i < next; ++i)
  {
    // A point in the middle of a fan of thousands would be walked around by each of its neighbours.
    const vtkIdType first = this->First[beside[i]],
                    last = std::min(this->First[beside[i] + 1], first + MostTriangles);
    for (vtkIdType t = first; t < last; ++t)
    {
      for (int k = 0; k < 3; ++k)
      {
        const vtkIdType other = this->Corners[3 * this->Triangles[t] + k];
        if (other == id || other == static_cast<vtkIdType>(beside[i]))
        {
          continue;
        }
        const double* x = this->Positions.data() + 3 * other;
        const float d[3] = { static_cast<float>(x[0] - centre[0]),
          static_cast<float>(x[1] - centre[1]), static_cast<float>(x[2] - centre[2]) };
        ring.Add(static_cast<Slot>(other), d, most);
      }
    }
  }
  const vtkPointSplatNeighbors::Neighborhood around{ static_cast<Slot>(id), ring.Count, ring.Slots,
    ring.X, ring.Y, ring.Z, ring.Squared };
  vtkPointSplatDisk disk;
  disk.SelectSheet(around, ring.Count, normals, vtkPointSplatSheet::GetSpacing(around));
  std::copy(disk.Normal, disk.Normal + 3, found.Plane);
  found.Creased = disk.Sheet.Uneven &&
    vtkPointSplatCrease::IsLikely(around, normals, n, disk.Sheet.Spacing);
  // Normals that are not the surface's say nothing of its curvature.
  if (std::equal(disk.Normal, disk.Normal + 3, n))
  {
    vtkPointSplatCurvature curvature;
    const float most = ThirdsPerSpacing * std::sqrt(ring.Squared[std::min(ring.Count - 1, 2)]);
    disk.Sheet.Spacing = std::min(disk.Sheet.Spacing, most);
    curvature.Estimate(around, normals, n, disk.Sheet, std::min(found.Radius, most));
    std::copy(curvature.Tensor, curvature.Tensor + 6, found.Curvature);
  }
  return found;
}

VTK_ABI_NAMESPACE_END
