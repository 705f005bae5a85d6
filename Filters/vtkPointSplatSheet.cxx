// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatSheet.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN

// Those that are fitted by hand are from Testing/Accuracy/fit_constants.py.
namespace
{
/// The sixth neighbour's distance, of the third one's, for points at random in a plane (1.43) and a little.
constexpr float SixthPerThird = 1.5f;
/// Neighbours are near within this many spacings, their own or the cloud's; hardly any edge of a
/// Delaunay triangulation of points at random is longer.
constexpr float NearReach = 2.0f;
/// How far apart, in spacings, the surfaces through two points may pass for them to be of one sheet:
/// near ones, since points have noise ...
constexpr float NearOffset = 0.6f;
/// ... and the sine of half the angle by which the arc between them may turn (106 degrees), the mean of both
/// normals'.
constexpr float NearTurn = 0.8f;
/// The same for those across a gap (60 degrees), where nothing but the normals tells of a sheet: so far the next row's
/// turn where slices of a volume are some voxels apart.
constexpr float FarOffset = 0.1f; // of their distance
constexpr float FarTurn = 0.5f;
/// Normals that part by more than this cosine (87 degrees) are those of two faces at an edge, unless
/// the sheet has too few others: on a body of a few points all part so.
constexpr float EdgeCosine = 0.05f;
/// ... and so are those that part by more than a right angle where the arc turns by more than this (35 degrees).
constexpr float EdgeTurn = 0.3f;
/// A point lies in another's tangent plane if it is off that by less than this part of their distance, and
/// may be one on an edge, a rim or a tip if its normal parts from the other's by less than this cosine.
constexpr float InPlane = 0.25f;
constexpr float LeastTipCosine = -0.1f;
/// Normals tell of a crease if they part by more than this cosine (13 degrees; at an edge of 30
/// degrees, averaged ones part by 15 from those of its faces) and the surfaces through the two
/// points pass each other by more than this part of their distance (at that edge it is 0.13 to
/// 0.25).
constexpr float UnevenCosine = 0.974f;
constexpr float UnevenOffset = 0.11f;
/// What is farther counts only where this part of it is of the sheet: some always is, by chance.
constexpr float LeastFarShare = 0.34f;
/// ... or this part has normals that part by less than this cosine (14 degrees), ...
constexpr float LeastAlikeShare = 0.1f;
constexpr float FlatCosine = 0.97f;
/// ... or by no more than near ones' do, but for rounding, if the surfaces pass each other by less than this part of their
/// distance.
constexpr float TurnRounding = 1e-3f;
constexpr float AlikeOffset = 0.03f;
}

float vtkPointSplatSheet::GetSpacing(const vtkPointSplatNeighbors::Neighborhood& around)
{
  return around.Count > 0
    ? std::sqrt(around.SquaredDistance[std::min(SpacingRank, around.Count) - 1])
    : 0.0f;
}

float vtkPointSplatSheet::GetBodySpacing(const vtkPointSplatNeighbors::Neighborhood& around)
{
  const int third = std::min(3, around.Count) - 1;
  return third < 0
    ? 0.0f
    : std::min(GetSpacing(around), SixthPerThird * std::sqrt(around.SquaredDistance[third]));
}

float vtkPointSplatSheet::GetSquaredTurn(
  const float n[3], const float place[3], float grain)
{
  const float height = n[0] * place[0] + n[1] * place[1] + n[2] * place[2];
  const float squared = place[0] * place[0] + place[1] * place[1] + place[2] * place[2];
  const float turn = 2 * height / std::max(squared, grain * grain);
  return turn * turn;
}

float vtkPointSplatSheet::GetSquaredTurn(
  const float n[3], const float m[3], const float place[3], float grain)
{
  const float cosine = n[0] * m[0] + n[1] * m[1] + n[2] * m[2];
  const float squared = place[0] * place[0] + place[1] * place[1] + place[2] * place[2];
  return std::max(2 - 2 * cosine, 0.0f) / std::max(squared, grain * grain);
}

int vtkPointSplatSheet::CountNear(
  const vtkPointSplatNeighbors::Neighborhood& around, float spacing)
{
  const float reach = NearReach * spacing;
  const float* squared = around.SquaredDistance;
  return static_cast<int>(
    std::upper_bound(squared, squared + around.Count, reach * reach) - squared);
}

void vtkPointSplatSheet::Compare(const vtkPointSplatNeighbors::Neighborhood& around,
  const float* normals, const float n[3])
{
  for (int i = 0; i < around.Count; ++i)
  {
    const float* m = normals + std::size_t(3) * around.Slots[i];
    const float x = around.X[i], y = around.Y[i], z = around.Z[i];
    Arc& arc = this->Arcs[i];
    arc.Height = n[0] * x + n[1] * y + n[2] * z;
    arc.OtherHeight = m[0] * x + m[1] * y + m[2] * z;
    arc.Cosine = n[0] * m[0] + n[1] * m[1] + n[2] * m[2];
    // Which side of the neighbour's normal n's mirror image lies on.
    const bool turned =
      arc.Cosine * around.SquaredDistance[i] < 2 * arc.Height * arc.OtherHeight;
    arc.Offset = 0.5f * (turned ? arc.Height - arc.OtherHeight : arc.Height + arc.OtherHeight);
  }
}

float vtkPointSplatSheet::GetResidual(
  const vtkPointSplatNeighbors::Neighborhood& around, int count) const
{
  float across = 0, all = 0;
  for (int i = 0; i < count; ++i)
  {
    across += 4 * this->Arcs[i].Offset * this->Arcs[i].Offset;
    all += around.SquaredDistance[i];
  }
  return all > 0 ? across / all : 0;
}

/// Whether one of two points lies in the other's tangent plane, and its own normal leans over by less than
/// a right angle: at an edge whose normal is an average, at a rim or a tip, the surface between the two is flat.
bool vtkPointSplatSheet::MeetsEdge(const Arc& arc, float squared)
{
  const float least = std::min(std::abs(arc.Height), std::abs(arc.OtherHeight));
  return arc.Cosine > LeastTipCosine && least * least < InPlane * InPlane * squared;
}

/// Whether normals part as those of two faces at an edge do. turn: how far they lean.
bool vtkPointSplatSheet::IsEdge(const Arc& arc, float turn, float squared)
{
  return std::abs(arc.Cosine) < EdgeCosine ||
    (arc.Cosine < 0 && turn * turn > EdgeTurn * EdgeTurn * squared);
}

bool vtkPointSplatSheet::IsAcross(const vtkPointSplatNeighbors::Neighborhood& around, int i) const
{
  const Arc& arc = this->Arcs[i];
  const float squared = around.SquaredDistance[i];
  const float turn = std::max(std::abs(arc.Height), std::abs(arc.OtherHeight));
  return turn * turn <= FarTurn * FarTurn * squared &&
    arc.Offset * arc.Offset <= FarOffset * FarOffset * squared && !IsEdge(arc, turn, squared);
}

/**
 * Leaves of the members that are far those that are not there by chance, if there are enough: with the centre's normal, as on a
 * sparse flat face beside a dense edge, or on an arc that turns no more than near ones do, as of the next ring of a tube, about
 * which all others are of the tube's far side and of other tubes.
 */
void vtkPointSplatSheet::KeepAlike(const vtkPointSplatNeighbors::Neighborhood& around, int countFar)
{
  float turned = FlatCosine;
  for (int k = 0; k < this->Near; ++k)
  {
    turned = std::min(turned, this->Arcs[this->Members[k]].Cosine);
  }
  int kept = this->Near;
  for (int k = this->Near; k < this->Count; ++k)
  {
    const int i = this->Members[k];
    const Arc& arc = this->Arcs[i];
    if (arc.Cosine > FlatCosine ||
      (arc.Cosine > turned - TurnRounding &&
        arc.Offset * arc.Offset < AlikeOffset * AlikeOffset * around.SquaredDistance[i]))
    {
      this->Members[kept++] = i;
    }
  }
  const int alike = kept - this->Near;
  this->Count = alike >= FewMembers && alike >= LeastAlikeShare * countFar ? kept : this->Near;
}

void vtkPointSplatSheet::Select(
  const vtkPointSplatNeighbors::Neighborhood& around, int countNear, float spacing)
{
  this->Count = this->Near = 0;
  this->Spacing = spacing;
  this->Uneven = false;
  const float near2 = NearOffset * NearOffset * spacing * spacing;
  int edge[vtkPointSplatNeighbors::MaximumNumberOfNeighbors];
  int edges = 0;
  for (int i = 0; i < around.Count; ++i)
  {
    const float squared = around.SquaredDistance[i];
    const Arc& arc = this->Arcs[i];
    const bool isNear = i < countNear;
    this->Uneven = this->Uneven ||
      (isNear && std::abs(arc.Cosine) < UnevenCosine &&
        arc.Offset * arc.Offset > UnevenOffset * UnevenOffset * squared);
    if (isNear && this->MeetsEdge(arc, squared))
    {
      ++this->Near;
      this->Members[this->Count++] = i;
      continue;
    }
    if (!isNear)
    {
      if (this->IsAcross(around, i))
      {
        this->Members[this->Count++] = i;
      }
      continue;
    }
    // The mean of how far both normals lean tells, as where a disk ends at a rim.
    const float turn = 0.5f * (std::abs(arc.Height) + std::abs(arc.OtherHeight));
    if (turn * turn > NearTurn * NearTurn * squared || arc.Offset * arc.Offset > near2)
    {
      continue;
    }
    if (IsEdge(arc, turn, squared))
    {
      edge[edges++] = i;
      continue;
    }
    ++this->Near;
    this->Members[this->Count++] = i;
  }
  this->Whole = this->Count == around.Count;
  const int countFar = around.Count - countNear;
  this->IsFewAfar = false;
  if (this->Count - this->Near < LeastFarShare * countFar)
  {
    this->KeepAlike(around, countFar);
    this->IsFewAfar = this->Count > this->Near;
  }
  this->IsFlatAfar =
    std::all_of(this->Members + this->Near, this->Members + this->Count,
      [this](int i) { return this->Arcs[i].Cosine > FlatCosine; });
  if (this->Near < FewMembers && edges > 0)
  {
    // All are near ones, and so come before those that are not.
    int merged[vtkPointSplatNeighbors::MaximumNumberOfNeighbors];
    const int count = static_cast<int>(std::merge(this->Members, this->Members + this->Count, edge,
                                         edge + edges, merged) - merged);
    std::copy(merged, merged + count, this->Members);
    this->Near += edges;
    this->Count = count;
  }
}

VTK_ABI_NAMESPACE_END
