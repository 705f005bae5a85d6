// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatCrease.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// Averages of normals are no farther than this cosine (37 degrees) from the mean of the faces' own, of which one may have
/// more weight; the normal of a strip between the two sides of a plate is across theirs (Testing/Accuracy/fit_constants.py).
constexpr float BetweenCosine = 0.8f;
/// On a strip's edge an average of normals is that near to its own: of faces that part by 120 degrees.
constexpr float StripCosine = 0.5f;
/// What is off a face's plane by this slope is not on it.
constexpr float OwnSideSlope = 0.1f;
}

/// Whether n is about the mean of the normals of faces that meet.
bool vtkPointSplatCrease::IsBetween(const float n[3]) const
{
  float sum[3] = { 0, 0, 0 };
  for (int f = 0; f < this->NumberOfMeeting; ++f)
  {
    for (int c = 0; c < 3; ++c)
    {
      sum[c] += this->Meeting[f][c];
    }
  }
  return vtkMath::Normalize(sum) > 0 && vtkMath::Dot(sum, n) > BetweenCosine;
}

bool vtkPointSplatCrease::GoesOn(
  int meeting, const float n[3], const float direction[3]) const
{
  // What turns n to the face's normal turns the direction to the one in which the face goes on.
  const float* m = this->Meeting[meeting];
  const float cosine = vtkMath::Dot(m, n), sine = vtkMath::Dot(m, direction);
  const float* way = this->Ways[meeting];
  return cosine * vtkMath::Dot(way, direction) > sine * vtkMath::Dot(way, n);
}

bool vtkPointSplatCrease::FindMeeting(const vtkPointSplatNeighbors::Neighborhood& around,
  const float n[3], float spacing, const vtkPointSplatFaces& faces)
{
  const float reach = LargestReach * spacing;
  int members[MaximumNumberOfMeeting];
  float sums[MaximumNumberOfMeeting][3], ways[MaximumNumberOfMeeting][3];
  this->NumberOfMeeting = 0;
  bool others = false;
  for (int i = 0; i < around.Count && around.SquaredDistance[i] <= reach * reach; ++i)
  {
    const vtkPointSplatFaces::Slot j = around.Slots[i];
    float C[6], turned[3], normal[3];
    const float* m = faces.GetFace(j, C);
    if (!m)
    {
      continue;
    }
    const float q[3] = { around.X[i], around.Y[i], around.Z[i] };
    vtkPointSplatFace::Multiply(C, q, turned);
    const float height = 0.5f * vtkMath::Dot(q, turned) - vtkMath::Dot(m, q);
    if (std::abs(height) > OnLine * spacing)
    {
      others = true;
      continue;
    }
    // The centre is on the face: the height that is left says by how much more that bends on the way there.
    for (int c = 0; c < 3; ++c)
    {
      normal[c] = m[c] - turned[c] + 2 * height / around.SquaredDistance[i] * q[c];
    }
    const float length =
      std::sqrt(vtkMath::Dot(normal, normal)) * (vtkMath::Dot(normal, n) < 0 ? -1 : 1);
    int f = 0;
    for (float& component : normal)
    {
      component /= length;
    }
    while (f < this->NumberOfMeeting && vtkMath::Dot(normal, this->Meeting[f]) < SameDirection)
    {
      ++f;
    }
    if (f == MaximumNumberOfMeeting)
    {
      continue;
    }
    if (f == this->NumberOfMeeting)
    {
      std::copy(normal, normal + 3, this->Meeting[f]);
      std::fill_n(sums[f], 3, 0.0f);
      std::fill_n(ways[f], 3, 0.0f);
      members[this->NumberOfMeeting++] = 0;
    }
    ++members[f];
    for (int c = 0; c < 3; ++c)
    {
      sums[f][c] += normal[c];
      ways[f][c] += q[c];
    }
  }
  int count = 0;
  for (int f = 0; f < this->NumberOfMeeting; ++f)
  {
    if (members[f] >= FewestVotes)
    {
      // A single neighbour's normal may be an average of faces', too.
      vtkMath::Normalize(sums[f]);
      std::copy_n(sums[f], 3, this->Meeting[count]);
      std::copy_n(ways[f], 3, this->Ways[count++]);
    }
  }
  this->NumberOfMeeting = count;
  this->Hides = !others && count == 1;
  return count > 1 && this->IsBetween(n);
}

int vtkPointSplatCrease::FindStrip(const vtkPointSplatNeighbors::Neighborhood& around,
  const float n[3], float spacing, const vtkPointSplatFaces& faces)
{
  const float reach = LargestReach * spacing;
  // The nearest point on the face tells the edge's direction; others make planes with it, so far off it.
  int others[vtkPointSplatNeighbors::MaximumNumberOfNeighbors];
  int count = 0;
  float along[3] = { 0, 0, 0 };
  for (int i = 0; i < around.Count && around.SquaredDistance[i] <= reach * reach; ++i)
  {
    if (faces.IsSound(around.Slots[i]))
    {
      continue;
    }
    const float q[3] = { around.X[i], around.Y[i], around.Z[i] };
    const float height = vtkMath::Dot(this->Meeting[0], q);
    if (height * height >= OwnSideSlope * OwnSideSlope * around.SquaredDistance[i])
    {
      others[count++] = i;
    }
    else if (vtkMath::Dot(along, along) == 0)
    {
      std::copy(q, q + 3, along);
      vtkMath::Normalize(along);
    }
  }
  float planes[vtkPointSplatNeighbors::MaximumNumberOfNeighbors][3];
  float ways[vtkPointSplatNeighbors::MaximumNumberOfNeighbors];
  const int asked = std::exchange(count, 0);
  for (int k = 0; k < asked; ++k)
  {
    const int i = others[k];
    const float q[3] = { around.X[i], around.Y[i], around.Z[i] };
    float* plane = planes[count];
    vtkMath::Cross(along, q, plane);
    ways[count] = static_cast<float>(vtkMath::Normalize(plane));
    const float part = vtkMath::Dot(plane, n);
    vtkMath::MultiplyScalar(plane, part < 0 ? -1.0f : 1.0f);
    const float* m = faces.Normals + std::size_t(3) * around.Slots[i];
    if (ways[count] > 0 && std::abs(part) >= StripCosine && vtkMath::Dot(plane, m) >= StripCosine)
    {
      ++count;
    }
  }
  if (count == 0)
  {
    return 0;
  }
  const float* nearest = planes[std::min_element(ways, ways + count) - ways];
  const auto votes = std::count_if(planes, planes + count,
    [nearest](const float* plane) { return vtkMath::Dot(plane, nearest) > SameDirection; });
  std::copy_n(nearest, 3, this->Meeting[this->NumberOfMeeting++]);
  return votes >= FewestVotes && this->IsBetween(n) ? static_cast<int>(votes) : 0;
}

VTK_ABI_NAMESPACE_END
