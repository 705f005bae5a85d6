// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatNormals.h"

#include "vtkMath.h"
#include "vtkPointSplatPrincipal.h"
#include "vtkPointSplatQuadric.h"
#include "vtkPointSplatRows.h"
#include "vtkPointSplatThreads.h"
#include "vtkSMPThreadLocal.h"

#include <algorithm>
#include <cmath>
#include <iterator>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// Leaves of the search tree that are asked whether points are noisy.
constexpr vtkPointSplatNeighbors::Slot NoiseLeaves = 256;
/// Noise takes no more than so many times the neighbours.
constexpr int MostTimes = 3;
/// For so many times the neighbours half of the points are off their surface by more than this share of their distance, ...
constexpr float LeastResidual[MostTimes + 1] = { 0, 0, 0.02f, 0.06f };
/// ... and not much more of the larger surface. Where it is the surface's own relief, twice the neighbours are off by 1.5 times as much.
constexpr float MostGrowth = 1.2f;
/// Neighbours are on a surface if they are off it by less than this share of their distance. Those in a volume are off by a third and more.
constexpr float OnSurfaceResidual = 0.3f;
/// And if they are all around the point: on a border Aside is 0.3, and at a curve's end more.
constexpr float OnSurfaceAside = 0.2f;
/// What a link costs more for a point whose neighbours are off its surface, and that is at their border.
constexpr float CostOfTips = 4.0f;
/// Links that cost more than that, of which up to 1 is what normals say, are not told apart.
constexpr float MostCost = 1.8f;

/// What two normals say of a surface that goes on from one point to another, by e.
struct Link
{
  bool Turned; // whether the second normal goes on with the first the other way
  float Cost; // of relying on it, from 0 to 1

  Link(const float e[3], const float n[3], const float m[3])
  {
    const float squared = vtkMath::Dot(e, e);
    const float en = vtkMath::Dot(e, n), em = vtkMath::Dot(e, m), nm = vtkMath::Dot(n, m);
    // The first normal mirrored in the plane half way between the points is, on a circle's arc, the second.
    const float cosine = squared > 0 ? nm - 2 * en * em / squared : nm;
    const float length = std::sqrt(squared);
    const float elevation = length > 0 ? 0.5f * (std::abs(en) + std::abs(em)) / length : 0.0f;
    this->Turned = cosine < 0;
    this->Cost = 0.5f * (1 - std::abs(cosine) + elevation);
  }
};
}

vtkPointSplatNormals::vtkPointSplatNormals(const vtkPointSplatNeighbors& neighbors,
  float* normals, const std::vector<unsigned char>& known)
  : Neighbors(neighbors)
  , Normals(normals)
  , Known(known)
{
}

int vtkPointSplatNormals::GetTimes(vtkAlgorithm* self, int k) const
{
  using Neighborhood = vtkPointSplatNeighbors::Neighborhood;
  struct Residuals
  {
    float Of[MostTimes + 1]; // of so many times k neighbours
  };
  vtkSMPThreadLocal<std::vector<Residuals>> found;
  const auto look = [&](const Neighborhood& around, int) {
    float plane[3];
    vtkPointSplatPrincipal(around, std::min(around.Count, k)).GetNormal(plane);
    Residuals residuals;
    for (int times = 1; times <= MostTimes; ++times)
    {
      Neighborhood near = around;
      near.Count = std::min(around.Count, times * k);
      vtkPointSplatQuadric surface;
      if (!surface.Fit(near, plane))
      {
        return true;
      }
      residuals.Of[times] = surface.Residual;
    }
    found.Local().push_back(residuals);
    return true;
  };
  const double progress = self->GetProgress();
  const auto some = this->Neighbors.WantSome(NoiseLeaves);
  this->Neighbors.Visit(self, progress, progress, MostTimes * k, look,
    [&](Slot s) { return !this->Known[s] && some(s); });
  std::vector<Residuals> all;
  for (const std::vector<Residuals>& local : found)
  {
    all.insert(all.end(), local.begin(), local.end());
  }
  const auto isNoisy = [&all](int times) {
    const auto noisy = std::count_if(all.begin(), all.end(), [times](const Residuals& residuals) {
      return residuals.Of[1] > LeastResidual[times] && residuals.Of[times] < MostGrowth * residuals.Of[1];
    });
    return 2 * static_cast<std::size_t>(noisy) > all.size();
  };
  int times = MostTimes;
  while (times > 1 && !isNoisy(times))
  {
    --times;
  }
  return times;
}

bool vtkPointSplatNormals::Fit(
  vtkAlgorithm* self, double from, double to, const Samples& samples, bool keepGraph)
{
  using Neighborhood = vtkPointSplatNeighbors::Neighborhood;
  const Slot slots = this->Neighbors.GetNumberOfSlots();
  if (keepGraph)
  {
    this->Graph.assign(std::size_t(NumberOfEdges) * slots, vtkPointSplatNeighbors::None);
    this->Planes.assign(slots, Plane());
  }
  std::vector<unsigned char> inRow(slots, 0);
  this->OnSurface.assign(slots, 0);
  vtkSMPThreadLocal<std::vector<vtkPointSplatRows::Plane>> found;
  const auto fit = [&](const Neighborhood& around, int round) {
    const Slot s = around.Center;
    float* normal = this->Normals + std::size_t(3) * s;
    if (round == 0 && keepGraph)
    {
      std::copy(around.Slots, around.Slots + std::min(around.Count, +NumberOfEdges),
        this->Graph.data() + std::size_t(NumberOfEdges) * s);
    }
    if (this->Known[s])
    {
      return true;
    }
    if (round == 2)
    {
      vtkPointSplatRows::Plane plane;
      if (vtkPointSplatRows::Fit(around, plane))
      {
        found.Local().push_back(plane);
      }
      return true;
    }
    // However many there are, the nearest tell whether they lie in a row.
    const int nearest = round == 0 ? std::min(around.Count, samples.Nearest) : around.Count;
    const vtkPointSplatPrincipal principal(around, nearest);
    inRow[s] = inRow[s] || vtkPointSplatRows::IsCurve(around, nearest, principal.Variances);
    if (round == 0)
    {
      const bool isLong = vtkPointSplatRows::IsLong(principal.Variances);
      principal.GetNormal(normal);
      vtkPointSplatQuadric surface;
      if (samples.Curved && !inRow[s] && surface.Fit(around, normal))
      {
        if (keepGraph)
        {
          this->Planes[s] = { { normal[0], normal[1], normal[2] }, surface.Residual * surface.Aside };
        }
        std::copy_n(surface.Normal, 3, normal);
        this->OnSurface[s] = surface.Residual < OnSurfaceResidual && surface.Aside < OnSurfaceAside && !isLong;
      }
      return !inRow[s] && !isLong;
    }
    if (vtkPointSplatRows::FitThick(principal, normal) && keepGraph)
    {
      this->Planes[s] = Plane();
    }
    return !inRow[s];
  };
  if (!this->Neighbors.VisitWidely(self, from, to, samples.All, fit, [](Slot) { return true; }))
  {
    return false;
  }
  std::vector<vtkPointSplatRows::Plane> planes;
  for (const std::vector<vtkPointSplatRows::Plane>& local : found)
  {
    planes.insert(planes.end(), local.begin(), local.end());
  }
  vtkPointSplatRows::KeepSurfaces(planes, inRow, this->Normals);
  this->InRows.clear();
  for (const vtkPointSplatRows::Plane& plane : planes)
  {
    this->InRows.push_back(plane.At);
    if (keepGraph)
    {
      // Else rows had nothing to do with one another.
      static_assert(vtkPointSplatRows::NumberOfBeside < NumberOfEdges);
      std::copy(plane.Beside, std::end(plane.Beside),
        this->Graph.data() + std::size_t(NumberOfEdges) * (plane.At + std::size_t(1)) -
          vtkPointSplatRows::NumberOfBeside);
    }
  }
  return true;
}

void vtkPointSplatNormals::MarkRows(std::vector<unsigned char>& marks) const
{
  for (const Slot slot : this->InRows)
  {
    marks[slot] = 1;
  }
}

/// Makes of the k nearest neighbours, which need not be mutual, edges in both directions.
void vtkPointSplatNormals::Symmetrize()
{
  const Slot slots = this->Neighbors.GetNumberOfSlots();
  this->Offsets.assign(std::size_t(slots) + 1, 0);
  for (std::size_t e = 0; e < this->Graph.size(); ++e)
  {
    if (this->Graph[e] != vtkPointSplatNeighbors::None)
    {
      ++this->Offsets[e / NumberOfEdges + 1];
      ++this->Offsets[this->Graph[e] + std::size_t(1)];
    }
  }
  for (Slot s = 0; s < slots; ++s)
  {
    this->Offsets[s + std::size_t(1)] += this->Offsets[s];
  }
  this->Edges.resize(this->Offsets[slots]);
  std::vector<vtkIdType> at(this->Offsets.begin(), this->Offsets.end() - 1);
  for (std::size_t e = 0; e < this->Graph.size(); ++e)
  {
    if (this->Graph[e] != vtkPointSplatNeighbors::None)
    {
      const Slot s = static_cast<Slot>(e / NumberOfEdges);
      this->Edges[at[s]++] = this->Graph[e];
      this->Edges[at[this->Graph[e]]++] = s;
    }
  }
  this->Graph = std::vector<Slot>();
}

void vtkPointSplatNormals::GetPlane(Slot slot, float plane[3]) const
{
  const float* n = this->Normals + std::size_t(3) * slot;
  const float* fitted = this->Planes[slot].Normal;
  const float side = vtkMath::Dot(n, fitted);
  for (int c = 0; c < 3; ++c)
  {
    plane[c] = side > 0 ? fitted[c] : side < 0 ? -fitted[c] : n[c];
  }
}

bool vtkPointSplatNormals::IsTurned(Slot i, Slot j, int& cost) const
{
  double p[3], q[3];
  this->Neighbors.GetPosition(i, p);
  this->Neighbors.GetPosition(j, q);
  const float e[3] = { float(q[0] - p[0]), float(q[1] - p[1]), float(q[2] - p[2]) };
  float n[3], m[3];
  this->GetPlane(i, n);
  this->GetPlane(j, m);
  const Link surfaces(
    e, this->Normals + std::size_t(3) * i, this->Normals + std::size_t(3) * j);
  const Link planes(e, n, m);
  const Link& link = planes.Cost < surfaces.Cost ? planes : surfaces;
  const float tip = std::max(this->Planes[i].Tip, this->Planes[j].Tip);
  const float share = (link.Cost + CostOfTips * tip) / MostCost;
  cost = std::clamp(static_cast<int>(share * NumberOfCosts), 0, NumberOfCosts - 1);
  return link.Turned;
}

void vtkPointSplatNormals::Enqueue(Slot slot)
{
  for (vtkIdType e = this->Offsets[slot]; e < this->Offsets[slot + std::size_t(1)]; ++e)
  {
    if (!this->Done[this->Edges[e]])
    {
      int cost;
      const bool turned = this->IsTurned(slot, this->Edges[e], cost);
      this->Queue[cost].push_back({ this->Edges[e], turned });
    }
  }
}

/// Prim's algorithm with costs sorted into bins, from whatever is queued.
void vtkPointSplatNormals::Propagate(std::vector<Slot>& surface)
{
  for (int cost = 0; cost < NumberOfCosts;)
  {
    if (this->Queue[cost].empty())
    {
      ++cost;
      continue;
    }
    const Candidate next = this->Queue[cost].back();
    this->Queue[cost].pop_back();
    if (this->Done[next.To])
    {
      continue;
    }
    if (next.Turned)
    {
      float* n = this->Normals + std::size_t(3) * next.To;
      n[0] = -n[0];
      n[1] = -n[1];
      n[2] = -n[2];
    }
    this->Done[next.To] = 1;
    surface.push_back(next.To);
    this->Enqueue(next.To);
    cost = 0;
  }
}

/**
 * At the point farthest out along an axis, the surface's normal points along the axis if it
 * points outward. Of the six such points the one where it does so most clearly decides.
 */
void vtkPointSplatNormals::TurnOutward(const std::vector<Slot>& surface)
{
  double extreme[6];
  Slot slots[6];
  for (std::size_t i = 0; i < surface.size(); ++i)
  {
    double x[3];
    this->Neighbors.GetPosition(surface[i], x);
    for (int side = 0; side < 6; ++side)
    {
      const double value = side < 3 ? x[side] : -x[side - 3];
      if (i == 0 || value > extreme[side])
      {
        extreme[side] = value;
        slots[side] = surface[i];
      }
    }
  }
  float clearest = 0;
  for (int side : { 2, 1, 0, 5, 4, 3 })
  {
    const float along = this->Normals[std::size_t(3) * slots[side] + side % 3];
    if (std::abs(along) > std::abs(clearest) + 1e-3f)
    {
      clearest = side < 3 ? along : -along;
    }
  }
  if (clearest < 0)
  {
    for (Slot slot : surface)
    {
      float* n = this->Normals + std::size_t(3) * slot;
      n[0] = -n[0];
      n[1] = -n[1];
      n[2] = -n[2];
    }
  }
}

void vtkPointSplatNormals::OrientConsistently()
{
  this->Symmetrize();
  const Slot slots = this->Neighbors.GetNumberOfSlots();
  this->Done.assign(slots, 0);
  this->Queue.assign(NumberOfCosts, {});
  auto isOriented = [this](Slot s) {
    return this->Known[s] || (!this->Turned.empty() && this->Turned[s]);
  };
  for (Slot s = 0; s < slots; ++s)
  {
    this->Done[s] = this->Neighbors.GetId(s) < 0 || isOriented(s);
  }
  for (Slot s = 0; s < slots; ++s)
  {
    if (this->Neighbors.GetId(s) >= 0 && isOriented(s))
    {
      this->Enqueue(s);
    }
  }
  std::vector<Slot> surface;
  this->Propagate(surface);
  for (Slot s = 0; s < slots; ++s)
  {
    if (!this->Done[s])
    {
      surface.assign(1, s);
      this->Done[s] = 1;
      this->Enqueue(s);
      this->Propagate(surface);
      this->TurnOutward(surface);
    }
  }
}

template <typename Target>
void vtkPointSplatNormals::Turn(const Target& target)
{
  this->Turned.assign(this->Neighbors.GetNumberOfSlots(), 0);
  auto turn = [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType s = begin; s < end; ++s)
    {
      const Slot slot = static_cast<Slot>(s);
      double to[3];
      if (this->Neighbors.GetId(slot) < 0 || this->Known[slot] || !target(slot, to))
      {
        continue;
      }
      double x[3];
      this->Neighbors.GetPosition(slot, x);
      float* n = this->Normals + std::size_t(3) * slot;
      if ((to[0] - x[0]) * n[0] + (to[1] - x[1]) * n[1] + (to[2] - x[2]) * n[2] < 0)
      {
        n[0] = -n[0];
        n[1] = -n[1];
        n[2] = -n[2];
      }
      this->Turned[slot] = 1;
    }
  };
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(this->Neighbors.GetNumberOfSlots()), turn);
}

void vtkPointSplatNormals::OrientToViewpoint(const double viewpoint[3])
{
  this->Turn([viewpoint](Slot, double to[3]) {
    std::copy(viewpoint, viewpoint + 3, to);
    return true;
  });
}

void vtkPointSplatNormals::OrientToSensors(const vtkPointSplatSensors& sensors)
{
  this->Turn([&](Slot slot, double to[3]) {
    return sensors.Get(this->Neighbors.GetId(slot), to);
  });
  const Slot slots = this->Neighbors.GetNumberOfSlots();
  for (Slot s = 0; s < slots; ++s)
  {
    if (this->Neighbors.GetId(s) >= 0 && !this->Known[s] && !this->Turned[s])
    {
      this->OrientConsistently();
      return;
    }
  }
}

VTK_ABI_NAMESPACE_END
