// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatMeshBorders.h"

#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkPointSplatBorderPlane.h"
#include "vtkPointSplatBorders.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// Lines at less than this angle are one.
const float CosineOfOne = static_cast<float>(std::cos(vtkMath::RadiansFromDegrees(10.0)));
/// How far kernels reach, in radii.
constexpr float KernelReach = 2.0f;
/// Of about how many points near to one on the border it is asked whether they reach it. Where triangles
/// are long along the border rows of tens do; disks that reach farther than that are no mesh's.
constexpr vtkIdType MostSeen = 256;
/// How far the border is followed, in a point's radii, to tell where it goes, and over how many edges at most: vertices of
/// isosurfaces lie as near to one another as they like, and an edge between two that nearly coincide goes anywhere.
constexpr float LeastEdge = 0.1f;
constexpr int MostSteps = 16;
/// How far past the ends of an edge a point may lie that is beside it, of its length.
constexpr float PastEnds = 0.25f;

bool IsLine(const float line[3])
{
  return line[0] != 0 || line[1] != 0 || line[2] != 0;
}

bool IsOne(const float a[3], const float b[3])
{
  return vtkMath::Dot(a, b) >= CosineOfOne * vtkMath::Norm(a) * vtkMath::Norm(b);
}

/// Makes of a way its part in a plane.
void ProjectOnto(const float normal[3], float way[3])
{
  const float height = vtkMath::Dot(way, normal);
  for (int c = 0; c < 3; ++c)
  {
    way[c] -= height * normal[c];
  }
}

/// A line along an edge of the border beside a point.
struct NearLine
{
  float Distance;
  float Line[3];
};
}

void vtkPointSplatMeshBorders::GetOffset(vtkIdType from, vtkIdType to, float d[3]) const
{
  for (int c = 0; c < 3; ++c)
  {
    d[c] = static_cast<float>(this->Fans.GetPosition(to)[c] - this->Fans.GetPosition(from)[c]);
  }
}

/// Follows the border from a point along one of its edges until that is so far off, or as far as it goes on.
vtkPointSplatMeshBorders::Side vtkPointSplatMeshBorders::Walk(
  vtkIdType id, const vtkPointSplatFans::BorderEdge& edge, const float normal[3], float least) const
{
  Side side;
  vtkIdType from = id;
  vtkPointSplatFans::BorderEdge step = edge;
  for (int k = 0; k < MostSteps; ++k)
  {
    float along[3], inward[3], across[3];
    this->GetOffset(from, step.Next, along);
    this->GetOffset(from, step.Inner, inward);
    vtkMath::Cross(along, inward, across);
    side.Left = vtkMath::Dot(across, normal) > 0;
    side.End = step.Next;
    this->GetOffset(id, side.End, side.Way);
    const vtkPointSplatFans::BorderEdges next = this->Fans.GetBorderEdges(side.End);
    if (vtkMath::Norm(side.Way) >= least || next.Count != 2)
    {
      break;
    }
    const vtkPointSplatFans::BorderEdge& on = next.First[next.First[0].Next == from ? 1 : 0];
    if (on.Next == id)
    {
      break; // all around a hole
    }
    from = side.End;
    step = on;
  }
  return side;
}

/// Returns whether the point is of those that have lines.
bool vtkPointSplatMeshBorders::FindOwnLines(vtkIdType id, float clip[6]) const
{
  const vtkPointSplatFans::BorderEdges edges = this->Fans.GetBorderEdges(id);
  if (edges.Count > 2)
  {
    return false;
  }
  if (edges.Count == 0)
  {
    return true;
  }
  const float* normal = this->Planes->GetPointer(3 * id);
  const vtkPointSplatBorderPlane plane(normal);
  const float least = LeastEdge * this->Radii->GetValue(id);
  Side sides[2];
  float nearest = std::numeric_limits<float>::max();
  for (std::size_t k = 0; k < edges.Count; ++k)
  {
    sides[k] = this->Walk(id, edges.First[k], normal, least);
    nearest = std::min(nearest, vtkMath::Norm(sides[k].Way));
  }
  if (!(nearest > 0))
  {
    return false;
  }
  // Where the sector begins in which there is no surface, counterclockwise: at one edge or the other.
  const double first = plane.GetAngle(sides[0].Way);
  nearest = std::max(nearest, vtkPointSplatBorderPlane::LeastDistance * least);
  if (edges.Count == 1)
  {
    const double from = sides[0].Left ? first + vtkMath::Pi() : first;
    plane.SetLines(from, vtkMath::Pi(), nearest, nearest, clip);
  }
  else
  {
    const double turn = vtkPointSplatBorderPlane::Turn(first, plane.GetAngle(sides[1].Way));
    plane.SetLines(sides[0].Left ? first + turn : first,
      sides[0].Left ? 2 * vtkMath::Pi() - turn : turn, nearest, nearest, clip);
  }
  return true;
}

float vtkPointSplatMeshBorders::GetReach(vtkIdType id) const
{
  return KernelReach * this->Radii->GetValue(id);
}

/// In order; each point on the border is near to itself.
std::vector<vtkPointSplatMeshBorders::Near> vtkPointSplatMeshBorders::FindNear() const
{
  vtkSMPThreadLocal<std::vector<Near>> found;
  const std::vector<vtkIdType>& border = this->Fans.GetBorder();
  vtkSMPTools::For(0, static_cast<vtkIdType>(border.size()), [&](vtkIdType begin, vtkIdType end) {
    std::vector<Near>& near = found.Local();
    std::vector<vtkIdType> around; // in the order in which they were met
    std::set<vtkIdType> seen;
    for (vtkIdType i = begin; i < end; ++i)
    {
      const vtkIdType at = border[i];
      around.assign(1, at);
      seen = { at };
      near.push_back({ at, at });
      for (std::size_t k = 0; k < around.size() && static_cast<vtkIdType>(seen.size()) < MostSeen; ++k)
      {
        const vtkIdType from = around[k];
        this->Fans.VisitNeighbors(from, [&](vtkIdType other) {
          if (!seen.insert(other).second)
          {
            return;
          }
          float d[3];
          this->GetOffset(at, other, d);
          const bool reaches = vtkMath::Norm(d) < this->GetReach(other);
          if (reaches || from == at)
          {
            near.push_back({ other, at });
          }
          if (reaches && this->Fans.GetNumberOfTriangles(other) < MostSeen)
          {
            around.push_back(other);
          }
        });
      }
    }
  });
  std::vector<Near> all;
  for (const std::vector<Near>& near : found)
  {
    all.insert(all.end(), near.begin(), near.end());
  }
  std::sort(all.begin(), all.end());
  return all;
}

void vtkPointSplatMeshBorders::AddNearLines(
  const Near* first, const Near* last, float clip[6]) const
{
  const vtkIdType id = first->Id;
  const float* normal = this->Planes->GetPointer(3 * id);
  const float reach = this->GetReach(id);
  const float least = LeastEdge * this->Radii->GetValue(id);
  std::vector<NearLine> lines;
  for (const Near* near = first; near != last; ++near)
  {
    const vtkIdType neighbor = near->Border;
    const vtkPointSplatFans::BorderEdges edges = this->Fans.GetBorderEdges(neighbor);
    if (edges.Count > 2 || neighbor == id)
    {
      continue;
    }
    for (const vtkPointSplatFans::BorderEdge& edge : edges)
    {
      if (edge.Next == id)
      {
        continue;
      }
      const Side walked = this->Walk(neighbor, edge, normal, least);
      if (walked.End == id)
      {
        continue;
      }
      // In the disk's plane.
      float start[3], along[3], across[3];
      this->GetOffset(id, neighbor, start);
      ProjectOnto(normal, start);
      std::copy_n(walked.Way, 3, along);
      ProjectOnto(normal, along);
      vtkMath::Cross(along, normal, across);
      const float length = vtkMath::Normalize(across);
      if (!(length > 0))
      {
        continue;
      }
      const float side = walked.Left ? 1.0f : -1.0f;
      const float distance = side * vtkMath::Dot(start, across);
      // Where the point is opposite to on the edge. Past its ends the border may turn away.
      const float at = -vtkMath::Dot(start, along) / (length * length);
      if (distance >= 0 && distance < reach && at > -PastEnds && at < 1 + PastEnds)
      {
        NearLine line;
        line.Distance = distance;
        const float off = std::max(
          distance, vtkPointSplatBorderPlane::LeastDistance * std::max(length, least));
        for (int c = 0; c < 3; ++c)
        {
          line.Line[c] = side * across[c] / off;
        }
        lines.push_back(line);
      }
    }
  }
  std::sort(lines.begin(), lines.end(),
    [](const NearLine& a, const NearLine& b) { return a.Distance < b.Distance; });
  for (const NearLine& line : lines)
  {
    if (!IsLine(clip))
    {
      std::copy_n(line.Line, 3, clip);
    }
    else if (!IsOne(clip, line.Line) && !IsLine(clip + 3))
    {
      std::copy_n(line.Line, 3, clip + 3);
    }
    else if (IsLine(clip + 3) && IsOne(clip, clip + 3) && !IsOne(clip, line.Line))
    {
      for (int c = 0; c < 3; ++c)
      {
        clip[c] = 0.5f * (clip[c] + clip[3 + c]);
      }
      std::copy_n(line.Line, 3, clip + 3);
    }
  }
}

void vtkPointSplatMeshBorders::Write(vtkFloatArray* clips) const
{
  const std::vector<Near> near = this->FindNear();
  std::vector<std::size_t> firsts; // of each point's, and the end
  for (std::size_t k = 0; k < near.size(); ++k)
  {
    if (k == 0 || near[k].Id != near[k - 1].Id)
    {
      firsts.push_back(k);
    }
  }
  const vtkIdType count = static_cast<vtkIdType>(firsts.size());
  firsts.push_back(near.size());
  std::vector<std::array<float, 6>> found(firsts.size());
  vtkSMPTools::For(0, count, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      found[i].fill(0);
      const Near* first = near.data() + firsts[i];
      if (this->Radii->GetValue(first->Id) > 0 && this->FindOwnLines(first->Id, found[i].data()))
      {
        this->AddNearLines(first, near.data() + firsts[i + 1], found[i].data());
      }
    }
  });
  for (vtkIdType i = 0; i < count; ++i)
  {
    if (!IsLine(found[i].data()))
    {
      continue;
    }
    vtkPointSplatBorders::MakeLines(clips, this->Radii->GetNumberOfTuples());
    float* clip = clips->GetPointer(6 * near[firsts[i]].Id);
    if (!IsLine(clip) && !IsLine(clip + 3))
    {
      std::copy(found[i].begin(), found[i].end(), clip);
    }
  }
  for (vtkIdType id = 0; id < clips->GetNumberOfTuples(); ++id)
  {
    const vtkIdType same = this->Fans.GetSame(id);
    if (same != id)
    {
      std::copy_n(clips->GetPointer(6 * same), 6, clips->GetPointer(6 * id));
    }
  }
}

VTK_ABI_NAMESPACE_END
