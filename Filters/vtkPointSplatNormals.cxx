// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatNormals.h"

#include "vtkPointSplatRows.h"
#include "vtkPointSplatThreads.h"
#include "vtkSMPThreadLocal.h"

#include <algorithm>
#include <cmath>
#include <iterator>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// The unit eigenvector of the least eigenvalue of a symmetric matrix (xx, xy, xz, yy, yz, zz).
void GetLeastAxis(const double m[6], float axis[3])
{
  axis[0] = axis[1] = 0;
  axis[2] = 1;
  const double scale =
    std::max({ std::abs(m[0]), std::abs(m[3]), std::abs(m[5]), std::abs(m[1]), std::abs(m[2]),
      std::abs(m[4]) });
  if (!(scale > 0) || !std::isfinite(scale))
  {
    return;
  }
  double a[6];
  for (int i = 0; i < 6; ++i)
  {
    a[i] = m[i] / scale;
  }
  // Eigenvalues by the trigonometric solution of the characteristic polynomial.
  const double mean = (a[0] + a[3] + a[5]) / 3;
  const double xx = a[0] - mean, yy = a[3] - mean, zz = a[5] - mean;
  const double off = a[1] * a[1] + a[2] * a[2] + a[4] * a[4];
  const double p = std::sqrt((xx * xx + yy * yy + zz * zz + 2 * off) / 6);
  if (!(p > 1e-12))
  {
    return; // a ball: any direction is as good
  }
  const double det = xx * (yy * zz - a[4] * a[4]) - a[1] * (a[1] * zz - a[4] * a[2]) +
    a[2] * (a[1] * a[4] - yy * a[2]);
  const double angle = std::acos(std::clamp(det / (2 * p * p * p), -1.0, 1.0)) / 3;
  const double least = mean + 2 * p * std::cos(angle + 2 * 3.14159265358979323846 / 3);
  // The rows of A - lambda I span the plane across the eigenvector.
  const double r[3][3] = { { a[0] - least, a[1], a[2] }, { a[1], a[3] - least, a[4] },
    { a[2], a[4], a[5] - least } };
  double best[3] = { 0, 0, 0 }, longest = 0;
  for (int i = 0; i < 3; ++i)
  {
    const double* u = r[i];
    const double* v = r[(i + 1) % 3];
    const double c[3] = { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
      u[0] * v[1] - u[1] * v[0] };
    const double length = c[0] * c[0] + c[1] * c[1] + c[2] * c[2];
    if (length > longest)
    {
      longest = length;
      std::copy(c, c + 3, best);
    }
  }
  if (longest < 1e-20)
  {
    // Points in a row: something across the longest row, which is their direction.
    int row = 0;
    for (int i = 1; i < 3; ++i)
    {
      row = std::abs(r[i][i]) > std::abs(r[row][row]) ? i : row;
    }
    const double* u = r[row];
    const int smallest = std::abs(u[0]) < std::abs(u[1])
      ? (std::abs(u[0]) < std::abs(u[2]) ? 0 : 2)
      : (std::abs(u[1]) < std::abs(u[2]) ? 1 : 2);
    const int one = (smallest + 1) % 3, two = (smallest + 2) % 3;
    best[smallest] = 0;
    best[one] = u[two];
    best[two] = -u[one];
    longest = best[one] * best[one] + best[two] * best[two];
    if (!(longest > 0))
    {
      return;
    }
  }
  const double inverse = 1 / std::sqrt(longest);
  for (int i = 0; i < 3; ++i)
  {
    axis[i] = static_cast<float>(best[i] * inverse);
  }
}
}

vtkPointSplatNormals::vtkPointSplatNormals(const vtkPointSplatNeighbors& neighbors,
  float* normals, const std::vector<unsigned char>& known)
  : Neighbors(neighbors)
  , Normals(normals)
  , Known(known)
{
}

void vtkPointSplatNormals::FitPlane(
  const vtkPointSplatNeighbors::Neighborhood& around, float normal[3])
{
  // The centre, the origin of the offsets, is one of the points.
  double sum[3] = { 0, 0, 0 }, m[6] = { 0, 0, 0, 0, 0, 0 };
  for (int i = 0; i < around.Count; ++i)
  {
    const double x = around.X[i], y = around.Y[i], z = around.Z[i];
    sum[0] += x;
    sum[1] += y;
    sum[2] += z;
    m[0] += x * x;
    m[1] += x * y;
    m[2] += x * z;
    m[3] += y * y;
    m[4] += y * z;
    m[5] += z * z;
  }
  const double n = around.Count + 1;
  m[0] -= sum[0] * sum[0] / n;
  m[1] -= sum[0] * sum[1] / n;
  m[2] -= sum[0] * sum[2] / n;
  m[3] -= sum[1] * sum[1] / n;
  m[4] -= sum[1] * sum[2] / n;
  m[5] -= sum[2] * sum[2] / n;
  GetLeastAxis(m, normal);
}

bool vtkPointSplatNormals::Fit(vtkAlgorithm* self, double from, double to, int k, bool keepGraph)
{
  using Neighborhood = vtkPointSplatNeighbors::Neighborhood;
  const Slot slots = this->Neighbors.GetNumberOfSlots();
  if (keepGraph)
  {
    this->Graph.assign(std::size_t(NumberOfEdges) * slots, vtkPointSplatNeighbors::None);
  }
  std::vector<unsigned char> inRow(slots, 0);
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
    float variances[3];
    vtkPointSplatRows::GetVariances(around, around.Count, variances);
    inRow[s] = inRow[s] || vtkPointSplatRows::IsCurve(around, around.Count, variances);
    if (round == 0)
    {
      vtkPointSplatNormals::FitPlane(around, normal);
      return !inRow[s] && !vtkPointSplatRows::IsLong(variances);
    }
    vtkPointSplatRows::FitThick(around, variances, normal);
    return !inRow[s];
  };
  if (!this->Neighbors.VisitWidely(self, from, to, k, fit, [](Slot) { return true; }))
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

float vtkPointSplatNormals::GetSign(Slot i, Slot j, int& cost) const
{
  double p[3], q[3];
  this->Neighbors.GetPosition(i, p);
  this->Neighbors.GetPosition(j, q);
  const float* n = this->Normals + std::size_t(3) * i;
  const float* m = this->Normals + std::size_t(3) * j;
  const float e[3] = { float(q[0] - p[0]), float(q[1] - p[1]), float(q[2] - p[2]) };
  const float squared = e[0] * e[0] + e[1] * e[1] + e[2] * e[2];
  const float en = e[0] * n[0] + e[1] * n[1] + e[2] * n[2];
  const float em = e[0] * m[0] + e[1] * m[1] + e[2] * m[2];
  const float nm = n[0] * m[0] + n[1] * m[1] + n[2] * m[2];
  // i's normal mirrored in the plane half way between the points is, on a circle's arc, j's.
  const float cosine = squared > 0 ? nm - 2 * en * em / squared : nm;
  const float length = std::sqrt(squared);
  const float elevation = length > 0 ? 0.5f * (std::abs(en) + std::abs(em)) / length : 0.0f;
  const float part = 0.5f * (1 - std::abs(cosine) + elevation);
  cost = std::clamp(static_cast<int>(part * NumberOfCosts), 0, NumberOfCosts - 1);
  return cosine < 0 ? -1.0f : 1.0f;
}

void vtkPointSplatNormals::Enqueue(Slot slot)
{
  for (vtkIdType e = this->Offsets[slot]; e < this->Offsets[slot + std::size_t(1)]; ++e)
  {
    if (!this->Done[this->Edges[e]])
    {
      int cost;
      this->GetSign(slot, this->Edges[e], cost);
      this->Queue[cost].push_back({ slot, this->Edges[e] });
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
    int unused;
    if (this->GetSign(next.From, next.To, unused) < 0)
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
