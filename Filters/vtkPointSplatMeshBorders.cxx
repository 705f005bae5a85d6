// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatMeshBorders.h"

#include "vtkFloatArray.h"
#include "vtkLine.h"
#include "vtkMath.h"
#include "vtkPointSplatBorderPlane.h"
#include "vtkPointSplatBorders.h"
#include "vtkPointSplatInput.h"
#include "vtkPointSplatThreads.h"
#include "vtkSMPThreadLocal.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>
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
constexpr vtkIdType MostSeen = 1024;
/// Of how many points near to the vertices around a fill point it is asked whether that reaches them: of a face's middle
/// with a fine outline they are thousands.
constexpr std::size_t MostListed = 64;
// From Testing/Accuracy/fit_constants.py.
/// How far the border is followed, in a point's radii, to tell where it goes, and over how many edges at most: vertices of
/// isosurfaces lie as near to one another as they like, and an edge between two that nearly coincide goes anywhere.
constexpr float LeastEdge = 0.002f;
constexpr int MostSteps = 16;
/// Where triangles are narrower than a radius it is followed for that share of their width, and as if they were no narrower
/// than that of the radius: slivers beside such an edge are.
constexpr float NarrowShare = 0.05f;
/// How far a triangle's normal may be from a disk's whose plane it is in, as a cosine (60 degrees).
constexpr float AlikePlane = 0.5f;
// The next two are from there, too.
/// Lines do not go through the points themselves, but so many lengths of the edge off, or distances of the next one if that is
/// nearer: their vectors are finite.
constexpr float LeastOff = 0.0005f;
/// How far past an edge that has no line a kernel may reach, of its reach: where an outline bends it does. And how far past a
/// reflex corner one line across that may be, of the radius.
constexpr float MostPast = 0.03f;
/// What is left of a disk where faces meet in its point alone, which two lines cannot end.
constexpr float PinchShare = 0.05f;
/// Products with lines up to which a place is kept, and not just on them.
constexpr float StillKept = 0.999f;

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
}

void vtkPointSplatMeshBorders::GetOffset(const double from[3], vtkIdType to, float d[3]) const
{
  for (int c = 0; c < 3; ++c)
  {
    d[c] = static_cast<float>(this->Fans.GetPosition(to)[c] - from[c]);
  }
}

/// Sets how a triangle at an edge of a side faces.
void vtkPointSplatMeshBorders::Face(
  vtkIdType from, const vtkPointSplatFans::BorderEdge& edge, const float normal[3], Side& side) const
{
  float along[3], inward[3], across[3];
  this->GetOffset(this->Fans.GetPosition(from), edge.Next, along);
  this->GetOffset(this->Fans.GetPosition(from), edge.Inner, inward);
  vtkMath::Cross(along, inward, across);
  vtkMath::Normalize(across);
  side.Facing = vtkMath::Dot(across, normal);
  side.Alike = !this->Fans.IsSplit() ? std::abs(side.Facing) : edge.Forward ? side.Facing : -side.Facing;
}

/// Follows the border from a point along one of its edges until that is so far off, or as far as it goes on.
vtkPointSplatMeshBorders::Side vtkPointSplatMeshBorders::Walk(
  vtkIdType id, const vtkPointSplatFans::BorderEdge& edge, const float normal[3], float least) const
{
  Side side;
  vtkIdType from = id;
  vtkPointSplatFans::BorderEdge step = edge;
  for (int k = 1;; ++k)
  {
    side.End = step.Next;
    this->GetOffset(this->Fans.GetPosition(id), side.End, side.Way);
    const vtkPointSplatFans::BorderEdges next = this->Fans.GetBorderEdges(side.End);
    if (vtkMath::Norm(side.Way) >= least || next.Count != 2 || k == MostSteps)
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
  this->Face(from, step, normal, side);
  return side;
}

/// Returns whether the point is of those that have lines.
bool vtkPointSplatMeshBorders::FindOwnLines(vtkIdType id, float least, bool two, End& end) const
{
  std::vector<vtkPointSplatFans::BorderEdge> edges;
  for (const vtkPointSplatFans::BorderEdge& edge : this->Fans.GetBorderEdges(id))
  {
    const auto other = std::find_if(edges.begin(), edges.end(),
      [&](const auto& before) { return this->Fans.IsSamePlace(before.Next, edge.Next); });
    if (other == edges.end())
    {
      edges.push_back(edge);
    }
    else
    {
      edges.erase(other); // a slit ends here
    }
  }
  if (edges.size() > 2)
  {
    end.Room = PinchShare * this->Radii->GetValue(id);
    return false;
  }
  if (edges.empty())
  {
    return true; // it is in the midst
  }
  const float* normal = this->Planes->GetPointer(3 * id);
  const vtkPointSplatBorderPlane plane(normal);
  Side sides[2];
  float nearest = std::numeric_limits<float>::max();
  for (std::size_t k = 0; k < edges.size(); ++k)
  {
    sides[k] = this->Walk(id, edges[k], normal, least);
    nearest = std::min(nearest, vtkMath::Norm(sides[k].Way));
  }
  if (!(nearest > 0))
  {
    return false;
  }
  // Where the sector begins in which there is no surface, counterclockwise: at one edge or the other.
  const double first = plane.GetAngle(sides[0].Way);
  nearest = std::max(nearest, LeastOff * least);
  if (edges.size() == 1)
  {
    const double from = sides[0].IsLeft() ? first + vtkMath::Pi() : first;
    plane.SetLines(from, vtkMath::Pi(), LeastOff * nearest, nearest, end.Clip);
  }
  else
  {
    const double turn = vtkPointSplatBorderPlane::Turn(first, plane.GetAngle(sides[1].Way));
    const double open = sides[0].IsLeft() ? 2 * vtkMath::Pi() - turn : turn;
    const double from = sides[0].IsLeft() ? first + turn : first;
    plane.SetLines(from, open, LeastOff * nearest, nearest, end.Clip);
    if (two && open < vtkMath::Pi() && MostPast * this->Radii->GetValue(id) * vtkMath::Norm(end.Clip) < 1)
    {
      float both[6];
      plane.SetSides(from, open, LeastOff * nearest, both);
      std::copy_n(both, 3, end.Clip);
      std::copy_n(both + 3, 3, end.Other);
    }
  }
  return true;
}

/// How far off a point tells where a disk's border goes: where its triangles are narrow, at a strip's end, the edge across does.
float vtkPointSplatMeshBorders::GetLeast(vtkIdType id) const
{
  double widest = 0;
  this->Fans.VisitTriangles(
    id, [&](const vtkIdType own[3]) { widest = std::max(widest, this->Fans.GetShape(own).Height); });
  const float radius = this->Radii->GetValue(id);
  return LeastEdge * std::clamp(static_cast<float>(widest), NarrowShare * radius, radius);
}

float vtkPointSplatMeshBorders::GetReach(vtkIdType id) const
{
  return KernelReach * this->Radii->GetValue(id);
}

/// How far a point is off another one on the border, or off the edges there whose ends its kernel may reach between.
float vtkPointSplatMeshBorders::GetDistance(vtkIdType border, vtkIdType id) const
{
  const double *x = this->Fans.GetPosition(id), *y = this->Fans.GetPosition(border);
  const double reach2 = std::pow(this->GetReach(id), 2);
  double squared = vtkMath::Distance2BetweenPoints(x, y);
  for (const vtkPointSplatFans::BorderEdge& edge : this->Fans.GetBorderEdges(border))
  {
    const double* z = this->Fans.GetPosition(edge.Next);
    if (vtkMath::Distance2BetweenPoints(y, z) > reach2)
    {
      squared = std::min(squared, vtkLine::DistanceToLine(x, y, z));
    }
  }
  return static_cast<float>(std::sqrt(squared));
}

vtkPointSplatMeshBorders::Near vtkPointSplatMeshBorders::FindNear() const
{
  using Pair = std::pair<vtkIdType, vtkIdType>; // a point, and one on the border
  vtkSMPThreadLocal<std::vector<Pair>> found;
  const std::vector<vtkIdType>& border = this->Fans.GetBorder();
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(border.size()), [&](vtkIdType begin, vtkIdType end) {
    std::vector<Pair>& near = found.Local();
    std::vector<vtkIdType> around; // in the order in which they were met
    std::set<vtkIdType> seen;
    for (vtkIdType i = begin; i < end; ++i)
    {
      const vtkIdType at = border[i];
      around.assign(1, at);
      seen = { at };
      near.emplace_back(at, at);
      for (std::size_t k = 0; k < around.size() && static_cast<vtkIdType>(seen.size()) < MostSeen; ++k)
      {
        const vtkIdType from = around[k];
        this->Fans.VisitNeighbors(from, [&](vtkIdType other) {
          if (!seen.insert(other).second)
          {
            return;
          }
          const float distance = this->GetDistance(at, other);
          const bool reaches = distance < this->GetReach(other);
          if (reaches || from == at)
          {
            near.emplace_back(other, at);
          }
          // Beyond points with small disks there may be one with a large one.
          if ((reaches || distance < this->GetReach(at)) && this->Fans.GetNumberOfTriangles(other) < MostSeen)
          {
            around.push_back(other);
          }
        });
      }
    }
  });
  std::vector<Pair> all;
  for (const std::vector<Pair>& near : found)
  {
    all.insert(all.end(), near.begin(), near.end());
  }
  std::sort(all.begin(), all.end());
  Near near;
  for (const auto& [id, at] : all)
  {
    near.First.resize(std::max<std::size_t>(near.First.size(), id + 1), near.Border.size());
    near.Border.push_back(at);
  }
  near.First.resize(this->Fans.GetNumberOfPoints() + 1, near.Border.size());
  return near;
}

/// An edge of the border in the disk's plane, if it is near, and not at the disk's own place.
void vtkPointSplatMeshBorders::AddEdge(
  const Disk& disk, vtkIdType from, const Side& side, std::vector<Edge>& edges) const
{
  float end[3];
  Edge found;
  this->GetOffset(disk.X, from, found.Start);
  this->GetOffset(disk.X, side.End, end);
  if (side.Alike < AlikePlane || vtkPointSplatInput::IsZero(found.Start) ||
    vtkPointSplatInput::IsZero(end))
  {
    return;
  }
  ProjectOnto(disk.Normal, found.Start);
  std::copy_n(side.Way, 3, found.Way);
  ProjectOnto(disk.Normal, found.Way);
  vtkMath::Cross(found.Way, disk.Normal, found.Out);
  found.Length = vtkMath::Normalize(found.Out);
  if (!side.IsLeft())
  {
    vtkMath::MultiplyScalar(found.Out, -1.0f);
  }
  found.Distance = vtkMath::Dot(found.Start, found.Out);
  found.Alike = side.Alike;
  found.Own = side.Own;
  if (found.Length > 0 && found.Distance >= -Edge::Rounding * found.Length && found.Distance < KernelReach * disk.Radius)
  {
    edges.push_back(found);
  }
}

/// Where a mesh was split, but not all along, edges of both sides are one body's: of those through the disk's centre the
/// ones are left out whose surface is on the other side. Of the others the nearest are the first.
void vtkPointSplatMeshBorders::PutInOrder(std::vector<Edge>& edges)
{
  const Edge* own = nullptr; // that between whose ends it is, or whose triangle is most like it
  for (const Edge& edge : edges)
  {
    if (edge.IsOn() && (!own || std::make_pair(edge.Own, edge.Alike) > std::make_pair(own->Own, own->Alike)))
    {
      own = &edge;
    }
  }
  if (own)
  {
    const float out[3] = { own->Out[0], own->Out[1], own->Out[2] };
    edges.erase(std::remove_if(edges.begin(), edges.end(),
                  [&](const Edge& edge) { return edge.IsThrough() && vtkMath::Dot(edge.Out, out) < 0; }),
      edges.end());
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.Distance < b.Distance; });
}

/// Gives an end, which may have lines, those along edges that it is beside, the nearest first.
void vtkPointSplatMeshBorders::TakeLines(float least, const std::vector<Edge>& edges, float clip[6])
{
  float nearest = std::numeric_limits<float>::max(); // of the edges that are not its own
  for (const Edge& edge : edges)
  {
    nearest = edge.IsThrough() ? nearest : std::min(nearest, edge.Distance);
  }
  for (const Edge& edge : edges)
  {
    if (!edge.IsBeside())
    {
      continue;
    }
    float line[3];
    const float off = std::max(edge.Distance, LeastOff * std::min(nearest, std::max(edge.Length, least)));
    for (int c = 0; c < 3; ++c)
    {
      line[c] = edge.Out[c] / off;
    }
    if (!IsLine(clip))
    {
      std::copy_n(line, 3, clip);
    }
    else if (!IsOne(clip, line) && !IsLine(clip + 3))
    {
      std::copy_n(line, 3, clip + 3);
    }
    else if (IsLine(clip + 3) && IsOne(clip, clip + 3) && !IsOne(clip, line))
    {
      for (int c = 0; c < 3; ++c)
      {
        clip[c] = 0.5f * (clip[c] + clip[3 + c]);
      }
      std::copy_n(line, 3, clip + 3);
    }
  }
}

/// The places of an edge through which a kernel reaches farthest past it: the nearest one, its ends, and where behind it lines
/// leave the kernel or cross each other; some of them twice.
std::array<float, 8> vtkPointSplatMeshBorders::FindPassed(
  const Edge& edge, const float clip[6], float reach, const float part[2])
{
  std::array<float, 8> places{ { part[0], part[1], edge.GetPlace(), part[0], part[0], part[0], part[0], part[0] } };
  const double squared = std::pow(reach, 2);
  double at[2], slope[2];
  for (int k = 0; k < 2; ++k)
  {
    at[k] = vtkMath::Dot(clip + 3 * k, edge.Start);
    slope[k] = vtkMath::Dot(clip + 3 * k, edge.Way);
    // A ray is cut by the line where it leaves the kernel.
    const double a = slope[k] * slope[k] * squared - std::pow(edge.Length, 2);
    const double b = at[k] * slope[k] * squared - vtkMath::Dot(edge.Start, edge.Way);
    const double c = at[k] * at[k] * squared - vtkMath::Dot(edge.Start, edge.Start);
    const double root = std::sqrt(std::max(b * b - a * c, 0.0));
    for (int sign = 0; sign < 2 && a != 0; ++sign)
    {
      places[3 + 2 * k + sign] = static_cast<float>((sign == 0 ? -b - root : root - b) / a);
    }
  }
  if (slope[0] != slope[1])
  {
    places[7] = static_cast<float>((at[1] - at[0]) / (slope[0] - slope[1]));
  }
  for (float& place : places)
  {
    place = std::clamp(place, part[0], part[1]);
  }
  return places;
}

/// The largest radius with which a disk's kernel, where lines keep it, goes past an edge by no more than MostPast of its
/// reach; none where it does not with its own.
float vtkPointSplatMeshBorders::GetRoom(const Edge& edge, const float clip[6], float radius)
{
  // The part of the edge that lines keep.
  float part[2] = { 0, 1 };
  for (int k = 0; k < 2; ++k)
  {
    const float at = vtkMath::Dot(clip + 3 * k, edge.Start) - StillKept, slope = vtkMath::Dot(clip + 3 * k, edge.Way);
    if (slope > 0)
    {
      part[1] = std::min(part[1], -at / slope);
    }
    else if (slope < 0)
    {
      part[0] = std::max(part[0], -at / slope);
    }
    else if (at > 0)
    {
      part[1] = -1;
    }
  }
  if (part[0] > part[1] || edge.Distance <= Edge::Rounding * std::min(edge.Length, radius))
  {
    return std::numeric_limits<float>::max();
  }
  float reach = KernelReach * radius;
  for (const float at : FindPassed(edge, clip, reach, part))
  {
    float place[3];
    for (int c = 0; c < 3; ++c)
    {
      place[c] = edge.Start[c] + at * edge.Way[c];
    }
    // The ray through a place of the edge leaves the kernel, or is cut by a line.
    const float way = vtkMath::Norm(place), sine = edge.Distance / way;
    const float product = std::max(vtkMath::Dot(clip, place), vtkMath::Dot(clip + 3, place));
    const float past = product > 0 ? std::min(reach / way, 1 / product) : reach / way;
    if (edge.Distance * (past - 1) > MostPast * reach)
    {
      reach = edge.Distance / (sine - MostPast);
    }
  }
  return reach < KernelReach * radius ? reach / KernelReach : std::numeric_limits<float>::max();
}

/// Lines along the edges, the nearest first, and the room that they leave.
void vtkPointSplatMeshBorders::Take(const Disk& disk, const std::vector<Edge>& edges, float clip[6], float& room)
{
  TakeLines(LeastEdge * disk.Radius, edges, clip);
  for (const Edge& edge : edges)
  {
    room = std::min(room, GetRoom(edge, clip, disk.Radius));
  }
}

void vtkPointSplatMeshBorders::AddNearLines(const Near& near, float least, End& end) const
{
  const Disk disk{ this->Fans.GetPosition(end.Id), this->Planes->GetPointer(3 * end.Id), this->Radii->GetValue(end.Id) };
  std::vector<Edge> edges;
  for (std::size_t k = near.First[end.Id]; k < near.First[end.Id + 1]; ++k)
  {
    const vtkPointSplatFans::BorderEdges from = this->Fans.GetBorderEdges(near.Border[k]);
    if (from.Count > 2)
    {
      continue;
    }
    for (const vtkPointSplatFans::BorderEdge& edge : from)
    {
      this->AddEdge(disk, near.Border[k], this->Walk(near.Border[k], edge, disk.Normal, least), edges);
    }
  }
  PutInOrder(edges);
  Take(disk, edges, end.Clip, end.Room);
  if (end.IsTwo())
  {
    Take(disk, edges, end.Other, end.Room);
  }
}

/// Adds an edge near to a fill point's disk, or what goes on from there. own: whether the point lies between its ends.
void vtkPointSplatMeshBorders::AddPiece(const Disk& disk, const vtkPointSplatMeshOutline::Piece& piece, bool own,
  std::vector<Edge>& edges) const
{
  Side side;
  side.End = piece.To;
  this->Face(piece.From, piece.First, disk.Normal, side);
  this->GetOffset(this->Fans.GetPosition(piece.From), piece.To, side.Way);
  side.Own = own;
  this->AddEdge(disk, piece.From, side, edges);
}

/// Gives the points on the border that are near to a place's vertices, each once; false if they are many.
bool vtkPointSplatMeshBorders::FindBorders(const Place& place, std::vector<vtkIdType>& borders)
{
  for (const vtkIdType vertex : place.Vertices)
  {
    const auto first = place.Known.Border.begin() + place.Known.First[vertex];
    const auto last = place.Known.Border.begin() + place.Known.First[vertex + 1];
    if (borders.size() + (last - first) > MostListed)
    {
      return false;
    }
    borders.insert(borders.end(), first, last);
  }
  std::sort(borders.begin(), borders.end());
  borders.erase(std::unique(borders.begin(), borders.end()), borders.end());
  return true;
}

vtkPointSplatMeshBorders::End vtkPointSplatMeshBorders::FindEnd(const Disk& disk, const Place& place) const
{
  std::vector<Edge> edges;
  std::vector<vtkIdType> borders;
  if (FindBorders(place, borders))
  {
    for (const vtkIdType border : borders)
    {
      for (const vtkPointSplatFans::BorderEdge& edge : this->Fans.GetBorderEdges(border))
      {
        // Once, if both of its ends are near.
        if (edge.Next > border || !std::binary_search(borders.begin(), borders.end(), edge.Next))
        {
          const auto isOf = [&](vtkIdType id) {
            return std::find(place.Vertices.begin(), place.Vertices.end(), id) != place.Vertices.end();
          };
          this->AddPiece(disk, { border, edge, edge.Next }, isOf(border) && isOf(edge.Next), edges);
        }
      }
    }
  }
  else
  {
    std::vector<vtkPointSplatMeshOutline::Piece> pieces;
    place.Outline.Find(place.Vertices.front(), disk.X, KernelReach * disk.Radius, pieces);
    for (const vtkPointSplatMeshOutline::Piece& piece : pieces)
    {
      this->AddPiece(disk, piece, false, edges);
    }
  }
  End end;
  PutInOrder(edges);
  Take(disk, edges, end.Clip, end.Room);
  return end;
}

std::vector<vtkPointSplatMeshBorders::End> vtkPointSplatMeshBorders::FindEnds(const Near& near, bool two) const
{
  std::vector<End> ends;
  for (vtkIdType id = 0; id < this->Fans.GetNumberOfPoints(); ++id)
  {
    if (near.First[id] < near.First[id + 1])
    {
      ends.emplace_back().Id = id;
    }
  }
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(ends.size()), [&](vtkIdType begin, vtkIdType last) {
    for (vtkIdType i = begin; i < last; ++i)
    {
      if (!(this->Radii->GetValue(ends[i].Id) > 0))
      {
        continue;
      }
      const float least = this->GetLeast(ends[i].Id);
      if (this->FindOwnLines(ends[i].Id, least, two, ends[i]))
      {
        this->AddNearLines(near, least, ends[i]);
      }
    }
  });
  return ends;
}

void vtkPointSplatMeshBorders::Write(const std::vector<End>& ends, vtkFloatArray* clips) const
{
  for (const End& end : ends)
  {
    if (!IsLine(end.Clip))
    {
      continue;
    }
    vtkPointSplatBorders::MakeLines(clips, this->Radii->GetNumberOfTuples());
    float* clip = clips->GetPointer(6 * end.Id);
    if (!IsLine(clip) && !IsLine(clip + 3))
    {
      std::copy_n(end.Clip, 6, clip);
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
