// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Of the fans: stages 2 and 3, disks.
#include "vtkPointSplatFans.h"

#include "vtkLine.h"
#include "vtkMath.h"
#include "vtkPointSplatCrease.h"
#include "vtkPointSplatCurvature.h"
#include "vtkPointSplatDisk.h"
#include "vtkTriangle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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

// The next five are from fit_constants.py, too.
/// Where triangles are long, what is beside them tells the curvature across: no spacing is more than so many times as far
/// as the third neighbour.
constexpr float ThirdsPerSpacing = 4;
/// Beyond a triangle that is narrower than so much of its radius a disk goes far, and it must not where normals turn by more
/// than that on the way, as between a flat face and a fillet, and by less than at an edge (30 degrees).
constexpr float NearShare = 0.5f;
constexpr float LeastTurn = 0.04f;
constexpr float SharpTurn = 0.52f;
/// From which sine on a triangle at a vertex falls off so steeply from its disk that this is none of the surface: a tip.
constexpr float SteepSine = 0.75f;

constexpr int MaximumNumberOfNeighbors = vtkPointSplatNeighbors::MaximumNumberOfNeighbors;

/// How many of a point's triangles are looked at, but for its neighbours.
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

/// Whether two triangles at a point lie in a plane.
bool vtkPointSplatFans::IsAtFlat(vtkIdType id) const
{
  std::array<double, 3> directions[MostTriangles];
  const vtkIdType count = std::min(this->GetNumberOfTriangles(id), MostTriangles);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const vtkIdType* corner = this->Corners.data() + 3 * this->Triangles[this->First[id] + i];
    double* own = directions[i].data();
    vtkTriangle::ComputeNormal(
      this->GetPosition(corner[0]), this->GetPosition(corner[1]), this->GetPosition(corner[2]), own);
    const bool flat = std::any_of(directions, directions + i,
      [own](const auto& other) { return vtkMath::Dot(own, other.data()) >= 1 - 0.5 * FlatSine * FlatSine; });
    if (flat)
    {
      return true;
    }
  }
  return false;
}

vtkPointSplatFans::Shape vtkPointSplatFans::GetShape(const vtkIdType corners[3]) const
{
  const double* places[3] = { this->GetPosition(corners[0]), this->GetPosition(corners[1]), this->GetPosition(corners[2]) };
  double longest2 = 0, normal[3];
  for (int k = 0; k < 3; ++k)
  {
    longest2 = std::max(longest2, vtkMath::Distance2BetweenPoints(places[k], places[(k + 1) % 3]));
  }
  vtkTriangle::ComputeNormalDirection(places[0], places[1], places[2], normal);
  const double longest = std::sqrt(longest2);
  return { longest, longest > 0 ? vtkMath::Norm(normal) / longest : 0 };
}

/// Finds which of the far sides of a point's triangles that are near to it turns away most, if the point is of a flat face.
/// Where there is none the surface is rough, and finer disks were none the better.
vtkPointSplatFans::Bend vtkPointSplatFans::FindBend(vtkIdType id, const float* normals, float radius) const
{
  const double* centre = this->GetPosition(id);
  const float* n = normals + 3 * id;
  Bend bend;
  this->VisitTriangles(id, [&](const vtkIdType corner[3]) {
    const auto [first, last] = GetOthers(corner, id);
    double at, place[3];
    const double distance =
      std::sqrt(vtkLine::DistanceToLine(centre, this->GetPosition(first), this->GetPosition(last), at, place));
    at = std::clamp(at, 0.0, 1.0);
    float m[3];
    for (int c = 0; c < 3; ++c)
    {
      m[c] = static_cast<float>((1 - at) * normals[3 * first + c] + at * normals[3 * last + c]);
    }
    vtkMath::Normalize(m);
    const double turn = std::sqrt(vtkMath::Distance2BetweenPoints(n, m));
    if (distance > 0 && distance < NearShare * radius && turn > std::max<double>(LeastTurn, bend.Amount * distance) &&
      turn < SharpTurn)
    {
      bend.Amount = static_cast<float>(turn / distance);
      bend.Within = static_cast<float>(distance);
      for (int c = 0; c < 3; ++c)
      {
        bend.Way[c] = static_cast<float>((place[c] - centre[c]) / distance);
      }
    }
  });
  return bend.Amount > 0 && this->IsAtFlat(id) ? bend : Bend();
}

vtkPointSplatFans::Disk vtkPointSplatFans::GetDisk(vtkIdType id, const float* normals) const
{
  using Slot = vtkPointSplatNeighbors::Slot;
  Ring ring;
  const double* centre = this->Positions.data() + 3 * id;
  float reach2 = 0, widest2 = 0, narrowest2 = std::numeric_limits<float>::max();
  for (vtkIdType t = this->First[id]; t < this->First[id + 1]; ++t)
  {
    const vtkIdType* corner = this->Corners.data() + 3 * this->Triangles[t];
    const std::array<vtkIdType, 2> others = GetOthers(corner, id);
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
    const float across2 = aa + bb - 2 * ab;
    widest2 = std::max(widest2, cross2 / std::max({ aa, bb, across2 }));
    narrowest2 = std::min(narrowest2, cross2 / across2);
    const float circumscribed2 =
      cross2 > 0 ? aa * bb * across2 / (4 * cross2) : 0.25f * std::max(aa, bb);
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
  const float second2 = ring.Squared[std::min(ring.Count - 1, 1)];
  found.Width = std::sqrt(widest2 > 0 ? std::min(second2, widest2) : second2);
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
  if (narrowest2 < std::pow(NearShare * found.Radius, 2))
  {
    found.Beside = this->FindBend(id, normals, found.Radius);
  }

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
