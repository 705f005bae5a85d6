// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatCrease.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// The sine of the angle (20 degrees) that two faces must be apart at a crease: two thirds of the
/// least that is promised, 30, for what forms are wrong by.
constexpr float LeastAngle = 0.342f;
/// And by how much more where normals deviate from their face: what random points of a surface with
/// sharp folds gain by less, the vertices of its mesh, which is rounded there, lose
/// (Testing/Accuracy/fit_constants.py).
constexpr float AnglePerDeviation = 4.0f;
/// A face may turn by this much, in radians, on the way to the line: farther on a form of second
/// order is no guess any more.
constexpr float LargestFaceBend = 0.7f;
/// A neighbour's normal has turned if it parts by more than this cosine (13 degrees; at an edge of
/// 30 degrees averaged ones part by 15 from those of its faces) ...
constexpr float TurnedCosine = 0.974f;
/// ... and of those that have, unit vectors, the mean is at least that long where they agree.
constexpr float Agreement = 0.85f;
/// The fewest neighbours that have turned alike beside a flat face: thin walls have many neighbours on their other side. Alike
/// are normals within this cosine (25 degrees): averages go by how many triangles are on which face.
constexpr int FewestAlike = 2;
constexpr float AlikeTurned = 0.9f;
/// The fewest neighbours whose normals have not turned.
constexpr int FewestLevel = 2;
/// Votes for the same line: their distances, in spacings.
constexpr float SameDistance = 0.25f;
/// Votes against a line have directions of at least this cosine (45 degrees).
constexpr float AgainstDirection = 0.7f;
/// How many times as many votes as are against.
constexpr int VotesPerAgainst = 3;
/// Points at the same position whose normals part by more than this cosine (15 degrees) are of two
/// faces.
constexpr float SplitCosine = 0.966f;
/// What is farther may be off the line by this part of its distance: an edge of a radius of 20
/// spacings is that far off its tangent at the farthest neighbours.
constexpr float EdgeBend = 0.1f;
/// The distance, in spacings, of a line that the point is on.
constexpr float OnLineDistance = 0.02f;
/// Where a mesh was split a face's points are those near to its plane, by their slope, and nearer than to the other face's by
/// this share; they are to one side of the line if their slope to it is that, and all but this part of them are.
constexpr float FaceSlope = 0.3f;
constexpr float FaceShare = 0.5f;
constexpr float BesideSlope = 0.1f;
constexpr float MostBeyond = 0.34f;
/// Of these the nearest are kept.
constexpr int MaximumNumberOfFound = 4;
/// How far, in spacings, a line may begin past the foot of a point where the face goes on behind
/// it.
constexpr float FootReach = 0.3f;
/// Keeps weights of neighbours on the line finite, in spacings.
constexpr float LineSoftening = 0.3f;

}

const float* vtkPointSplatFaces::GetFace(Slot s, float tensor[6]) const
{
  const Slot number = this->Numbers[s];
  const float* normal = this->Normals + std::size_t(3) * s;
  std::fill_n(tensor, 6, 0.0f);
  if (number == vtkPointSplatNeighbors::None)
  {
    if (this->Tensors)
    {
      std::copy_n(this->Tensors + std::size_t(6) * s, 6, tensor);
    }
    return normal;
  }
  if (this->Sound[number])
  {
    std::copy_n(this->Fitted.data() + std::size_t(6) * number, 6, tensor);
    return normal;
  }
  const float* strip = this->Strips.data() + std::size_t(3) * number;
  return vtkMath::Dot(strip, strip) > 0 ? strip : nullptr;
}

bool vtkPointSplatCrease::IsSame(const Line& a, const Line& b, float spacing)
{
  return vtkMath::Dot(a.Direction, b.Direction) >= SameDirection &&
    std::abs(a.Distance - b.Distance) <= SameDistance * spacing;
}

bool vtkPointSplatCrease::IsOn(const Line& line, const float x[3], float spacing)
{
  const float off = vtkMath::Dot(line.Direction, x) - line.Distance;
  return std::abs(off) <= OnLine * spacing + EdgeBend * std::sqrt(vtkMath::Dot(x, x));
}

bool vtkPointSplatCrease::Parts(const float n[3], const float m[3])
{
  return std::abs(vtkMath::Dot(n, m)) < SplitCosine;
}

bool vtkPointSplatCrease::IsLikely(const vtkPointSplatNeighbors::Neighborhood& around,
  const float* normals, const float n[3], float spacing)
{
  const int count = vtkPointSplatSheet::CountNear(around, spacing);
  float mean[3] = { 0, 0, 0 }, residual = 0;
  int level = 0, turned = 0;
  for (int i = 0; i < count; ++i)
  {
    const float* m = normals + std::size_t(3) * around.Slots[i];
    const float cosine = vtkMath::Dot(n, m);
    if (std::abs(cosine) >= TurnedCosine)
    {
      ++level;
      residual += 1 - cosine * cosine;
      continue;
    }
    ++turned;
    // Whichever side the neighbour's normal points to.
    const float side = vtkMath::Dot(mean, m) < 0 ? -1.0f : 1.0f;
    for (int c = 0; c < 3; ++c)
    {
      mean[c] += side * m[c];
    }
  }
  if (level < FewestLevel || turned < FewestAlike)
  {
    return false;
  }
  const float length2 = vtkMath::Dot(mean, mean), part = vtkMath::Dot(mean, n);
  const float deviation = std::sqrt(std::max(residual, 0.0f) / level);
  const float least = std::sqrt(1 - TurnedCosine * TurnedCosine) + AnglePerDeviation * deviation;
  if (turned >= FewestVotes && length2 >= Agreement * Agreement * turned * turned)
  {
    return length2 - part * part >= least * least * length2;
  }
  // Flat and narrow faces have others at both of their edges: those count that have turned as the nearest has.
  int alike = 0;
  const float* nearest = nullptr;
  for (int i = 0; i < count && deviation < vtkPointSplatFace::FlatDeviation; ++i)
  {
    const float* m = normals + std::size_t(3) * around.Slots[i];
    if (std::abs(vtkMath::Dot(n, m)) < TurnedCosine)
    {
      nearest = nearest ? nearest : m;
      alike += std::abs(vtkMath::Dot(nearest, m)) >= AlikeTurned ? 1 : 0;
    }
  }
  return alike >= FewestAlike;
}

/// Whether the face's points are behind a line through the centre. The nearest ones tell, which beside a reflex corner are
/// where the face goes on, and not those along the line.
bool vtkPointSplatCrease::IsBehind(const Line& line, const vtkPointSplatFace& face) const
{
  float side = 0;
  for (int k = 0; k < face.Members.Count; ++k)
  {
    const int i = face.Members.Members[k];
    const float x[3] = { this->Around->X[i], this->Around->Y[i], this->Around->Z[i] };
    const float across = vtkMath::Dot(line.Direction, x) - line.Distance;
    const float squared = this->Around->SquaredDistance[i];
    side += std::copysign(across * across / squared, across) / squared;
  }
  return side > 0;
}

/// What a neighbour at q says; false if nothing.
bool vtkPointSplatCrease::GetVote(const float q[3], const float m[3], const float C[6],
  const float n[3], const vtkPointSplatFace& face, Vote& vote) const
{
  const float spacing = face.Members.Spacing;
  const float cosine = vtkMath::Dot(n, m);
  const float sine = std::sqrt(std::max(0.0f, 1 - cosine * cosine));
  if (sine < 0.5f * LeastAngle)
  {
    return false;
  }
  float g[3];
  for (int c = 0; c < 3; ++c)
  {
    g[c] = (m[c] - cosine * n[c]) / sine;
  }
  float d = vtkMath::Dot(m, q) / sine;
  float x[3], own[3], other[3], normal[3], otherNormal[3];
  for (int step = 0; step < 3; ++step)
  {
    if (!(std::abs(d) < LargestReach * spacing))
    {
      return false;
    }
    for (int c = 0; c < 3; ++c)
    {
      x[c] = d * g[c];
    }
    vtkPointSplatFace::Multiply(face.Tensor, x, own);
    const float height = -0.5f * vtkMath::Dot(x, own);
    float e[3];
    for (int c = 0; c < 3; ++c)
    {
      x[c] += height * n[c];
      e[c] = x[c] - q[c];
      vote.Along[c] = -e[c];
    }
    vtkPointSplatFace::Multiply(C, e, other);
    const float off = vtkMath::Dot(m, e) + 0.5f * vtkMath::Dot(e, other);
    for (int c = 0; c < 3; ++c)
    {
      normal[c] = n[c] + own[c];
      otherNormal[c] = m[c] + other[c];
    }
    if (step < 2)
    {
      const float slope =
        vtkMath::Dot(otherNormal, g) - vtkMath::Dot(otherNormal, n) * vtkMath::Dot(own, g);
      d -= off / slope;
    }
  }
  float cross[3];
  vtkMath::Cross(normal, otherNormal, cross);
  const float least = LeastAngle + AnglePerDeviation * face.Deviation;
  const float left2 = vtkMath::Dot(cross, cross);
  vote.Open = vote.For = vtkMath::Dot(own, own) < LargestFaceBend * LargestFaceBend &&
    vtkMath::Dot(other, other) < LargestFaceBend * LargestFaceBend &&
    left2 >= least * least * vtkMath::Dot(normal, normal) * vtkMath::Dot(otherNormal, otherNormal);

  // The line across the plane of n.
  const float part = vtkMath::Dot(otherNormal, n);
  float length2 = 0;
  for (int c = 0; c < 3; ++c)
  {
    vote.At.Direction[c] = otherNormal[c] - part * n[c];
    length2 += vote.At.Direction[c] * vote.At.Direction[c];
  }
  if (!(length2 > 0))
  {
    return false;
  }
  const float length = std::sqrt(length2);
  for (float& component : vote.At.Direction)
  {
    component /= length;
  }
  vote.At.Distance = vtkMath::Dot(vote.At.Direction, x);
  // Away from the centre, or if that is on the line, from its face's points.
  const bool on = std::abs(vote.At.Distance) < OnLine * spacing;
  if (on ? this->IsBehind(vote.At, face) : vote.At.Distance < 0)
  {
    for (float& component : vote.At.Direction)
    {
      component = -component;
    }
    vote.At.Distance = -vote.At.Distance;
  }
  const float soft = LineSoftening * spacing;
  vote.Weight = 1 / (vtkMath::Dot(vote.Along, vote.Along) + soft * soft);
  for (int c = 0; c < 3; ++c)
  {
    vote.Along[c] = q[c];
    vote.Normal[c] = m[c];
  }
  return true;
}

/// The mean of the open votes that say about the same line as this one.
vtkPointSplatCrease::Candidate vtkPointSplatCrease::GetMean(const Vote& best) const
{
  Candidate mean{ { { 0, 0, 0 }, 0 }, 0 };
  float weights = 0;
  for (int v = 0; v < this->NumberOfVotes; ++v)
  {
    const Vote& vote = this->Votes[v];
    if (!vote.For || !vote.Open || !IsSame(vote.At, best.At, this->Spacing))
    {
      continue;
    }
    ++mean.Votes;
    weights += vote.Weight;
    for (int c = 0; c < 3; ++c)
    {
      mean.At.Direction[c] += vote.Weight * vote.At.Direction[c];
    }
    mean.At.Distance += vote.Weight * vote.At.Distance;
  }
  const float length = std::sqrt(vtkMath::Dot(mean.At.Direction, mean.At.Direction));
  for (float& component : mean.At.Direction)
  {
    component /= length;
  }
  mean.At.Distance = std::max(mean.At.Distance / weights, OnLineDistance * this->Spacing);
  return mean;
}

/// Whether few enough are against a line, and it runs past the point. unsound: neighbours without a
/// face of their own that are on no candidate.
bool vtkPointSplatCrease::IsLine(const Candidate& candidate,
  const vtkPointSplatNeighbors::Neighborhood& around, const vtkPointSplatFace& face,
  const float n[3], int unsound) const
{
  const float spacing = this->Spacing;
  const Line& line = candidate.At;
  int against = unsound;
  for (int v = 0; v < this->NumberOfVotes; ++v)
  {
    const Vote& vote = this->Votes[v];
    against +=
      !vote.For && vtkMath::Dot(vote.At.Direction, line.Direction) > AgainstDirection ? 1 : 0;
  }
  if (candidate.Votes < FewestVotes || candidate.Votes < VotesPerAgainst * against)
  {
    return false;
  }

  // Where the face goes on behind the line, the line must run past the point.
  bool behind = false;
  for (int k = 0; k < face.Members.Count && !behind; ++k)
  {
    const int i = face.Members.Members[k];
    const float x[3] = { around.X[i], around.Y[i], around.Z[i] };
    behind = vtkMath::Dot(line.Direction, x) > line.Distance + OnLine * spacing;
  }
  if (behind)
  {
    float along[3];
    vtkMath::Cross(n, line.Direction, along);
    float first = std::numeric_limits<float>::max(), last = -first;
    for (int v = 0; v < this->NumberOfVotes; ++v)
    {
      const Vote& vote = this->Votes[v];
      if (vote.For && vtkMath::Dot(vote.At.Direction, line.Direction) >= SameDirection)
      {
        const float t = vtkMath::Dot(along, vote.Along);
        first = std::min(first, t);
        last = std::max(last, t);
      }
    }
    if (first > FootReach * spacing || last < -FootReach * spacing)
    {
      return false;
    }
  }
  return true;
}

void vtkPointSplatCrease::Find(const vtkPointSplatNeighbors::Neighborhood& around,
  const vtkPointSplatFace& face, const float n[3], const vtkPointSplatFaces& faces)
{
  const float spacing = this->Spacing = face.Members.Spacing;
  this->Count = this->NumberOfVotes = this->NumberOfUnsound = 0;
  const float reach = LargestReach * spacing;
  this->Around = &around;
  int member = 0;
  int others = 0;
  for (int i = 0; i < around.Count && around.SquaredDistance[i] <= reach * reach; ++i)
  {
    if (member < face.Members.Count && face.Members.Members[member] == i)
    {
      ++member;
      continue;
    }
    const vtkPointSplatFaces::Slot j = around.Slots[i];
    float C[6];
    const float* m = faces.GetFace(j, C);
    if (!m)
    {
      this->Unsound[this->NumberOfUnsound++] = i;
      continue;
    }
    ++others;
    const float q[3] = { around.X[i], around.Y[i], around.Z[i] };
    this->NumberOfVotes += this->GetVote(q, m, C, n, face, this->Votes[this->NumberOfVotes]);
  }
  this->Hides = others < FewestVotes && this->NumberOfUnsound > 0;
  Candidate candidates[MaximumNumberOfFound];
  int said = 0;
  for (int best = this->GetBest(); best >= 0 && said < MaximumNumberOfFound; best = this->GetBest())
  {
    const Vote vote = this->Votes[best];
    candidates[said++] = this->GetMean(vote);
    for (int v = 0; v < this->NumberOfVotes; ++v)
    {
      this->Votes[v].Open = this->Votes[v].Open && !IsSame(this->Votes[v].At, vote.At, spacing);
    }
  }
  // Where edges meet at a corner, a neighbour is on another of them.
  int unsound = 0;
  for (int k = 0; k < this->NumberOfUnsound; ++k)
  {
    const int i = this->Unsound[k];
    const float q[3] = { around.X[i], around.Y[i], around.Z[i] };
    // Or it is on the other edge of a narrow face that ends at one of them.
    const bool behind = std::any_of(this->Votes, this->Votes + this->NumberOfVotes, [&](const Vote& vote) {
      const float d[3] = { q[0] - vote.Along[0], q[1] - vote.Along[1], q[2] - vote.Along[2] };
      return vote.For && std::abs(vtkMath::Dot(vote.Normal, d)) <= OnLine * spacing;
    });
    unsound += !behind && std::none_of(candidates, candidates + said,
      [&q, spacing](const Candidate& candidate) { return IsOn(candidate.At, q, spacing); });
  }
  Line found[MaximumNumberOfFound];
  int count = 0;
  for (int c = 0; c < said; ++c)
  {
    if (this->IsLine(candidates[c], around, face, n, unsound))
    {
      found[count++] = candidates[c].At;
    }
  }
  std::stable_sort(found, found + count,
    [](const Line& a, const Line& b) { return a.Distance < b.Distance; });
  this->Count = std::min(count, MaximumNumberOfLines);
  std::copy_n(found, this->Count, this->Lines);
}

void vtkPointSplatCrease::AddSplit(
  const vtkPointSplatNeighbors::Neighborhood& around, const float n[3], const float m[3])
{
  Line line;
  const float part = vtkMath::Dot(n, m);
  for (int c = 0; c < 3; ++c)
  {
    line.Direction[c] = m[c] - part * n[c];
  }
  if (!Parts(n, m) || !(vtkMath::Normalize(line.Direction) > 0))
  {
    return;
  }
  line.Distance = OnLineDistance * this->Spacing;
  int sides[2] = { 0, 0 }; // how many are behind the line, and before it
  for (int i = 0; i < around.Count; ++i)
  {
    const float x[3] = { around.X[i], around.Y[i], around.Z[i] };
    const float squared = around.SquaredDistance[i];
    const float across = vtkMath::Dot(line.Direction, x);
    const float height = vtkMath::Dot(n, x), other = vtkMath::Dot(m, x);
    if (across * across > BesideSlope * BesideSlope * squared &&
      height * height < std::min(FaceSlope * FaceSlope * squared, FaceShare * FaceShare * other * other))
    {
      ++sides[across > 0 ? 0 : 1];
    }
  }
  if (sides[0] == sides[1] ||
    std::min(sides[0], sides[1]) > MostBeyond * std::max(sides[0], sides[1]))
  {
    return;
  }
  if (sides[0] > sides[1])
  {
    vtkMath::MultiplyScalar(line.Direction, -1.0f);
  }
  const bool known = std::any_of(this->Lines, this->Lines + this->Count, [&line](const Line& other) {
    return vtkMath::Dot(other.Direction, line.Direction) > SameDirection;
  });
  if (!known && this->Count < MaximumNumberOfLines)
  {
    this->Lines[this->Count++] = line;
  }
}

/// The vote for the line that most say, of those that are still open; -1 if too few say any.
int vtkPointSplatCrease::GetBest() const
{
  int best = -1, most = FewestVotes - 1;
  for (int v = 0; v < this->NumberOfVotes; ++v)
  {
    if (!this->Votes[v].Open)
    {
      continue;
    }
    int same = 0;
    for (int w = 0; w < this->NumberOfVotes; ++w)
    {
      same += this->Votes[w].Open && IsSame(this->Votes[v].At, this->Votes[w].At, this->Spacing);
    }
    if (same > most)
    {
      most = same;
      best = v;
    }
  }
  return best;
}

VTK_ABI_NAMESPACE_END
