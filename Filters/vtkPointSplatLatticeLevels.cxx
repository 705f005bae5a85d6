// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatLatticeLevels.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <queue>
#include <tuple>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
constexpr vtkIdType None = -1;

using LatticeCases = vtkPointSplatLatticeCases;

/// What a region's depth may be by those beside it.
struct Candidate
{
  int Depth;
  int Edges;  // so many say it
  float Vote; // of their normals
  bool operator<(const Candidate& other) const
  {
    return this->Edges != other.Edges ? this->Edges < other.Edges : this->Vote < other.Vote;
  }
};

void Add(std::vector<Candidate>& all, const Candidate& more)
{
  const auto same =
    std::find_if(all.begin(), all.end(), [&](const Candidate& other) { return other.Depth == more.Depth; });
  if (same == all.end())
  {
    all.push_back(more);
    return;
  }
  same->Edges += more.Edges;
  same->Vote += more.Vote;
}

/// The best one of these, and how sure that is: first those that more edges say than any other one, then by votes.
struct Guess
{
  bool Sure;
  float Margin;
  std::size_t Region;
  int Depth;
  bool IsSame(const Guess& other) const
  {
    return this->Sure == other.Sure && this->Margin == other.Margin && this->Depth == other.Depth;
  }
  bool operator<(const Guess& other) const
  {
    return std::tie(this->Sure, this->Margin, other.Region) < std::tie(other.Sure, other.Margin, this->Region);
  }
};

Guess GetGuess(std::size_t region, std::vector<Candidate>& candidates)
{
  std::partial_sort(candidates.begin(), candidates.begin() + 2, candidates.end(),
    [](const Candidate& a, const Candidate& b) { return b < a; });
  const Candidate &best = candidates[0], &next = candidates[1];
  return { best.Edges > next.Edges, best.Vote - next.Vote, region, best.Depth };
}
}

vtkPointSplatLatticeLevels::vtkPointSplatLatticeLevels(
  const std::vector<Crossing>& crossings, const std::int64_t size[3], const float* normals)
  : Crossings(crossings)
  , Regions(crossings, size)
  , Normals(normals)
{
}

void vtkPointSplatLatticeLevels::AddLink(std::size_t a, std::size_t b, int step, float vote)
{
  this->Links.push_back(a < b ? Link{ a, b, step, vote, 1 } : Link{ b, a, step, -vote, 1 });
}

/// Those by edges with points, and by edges without whose one end is a point's sample.
void vtkPointSplatLatticeLevels::FindLinks()
{
  this->Regions.VisitEdges([this](const Range& on, int axis, std::size_t a, std::size_t b) {
    float vote = 0;
    for (const Crossing* crossing = on.First; crossing != on.Last; ++crossing)
    {
      vote += this->Normals[3 * crossing->Id + axis];
    }
    const int atSamples = (this->Regions.IsAtSample(a) ? 1 : 0) + (this->Regions.IsAtSample(b) ? 1 : 0);
    this->AddLink(a, b, 2 * static_cast<int>(on.GetCount()) + atSamples, vote);
    return true;
  });
  for (const Crossing& crossing : this->Crossings)
  {
    const std::int64_t sample = crossing.Key / 4;
    for (int axis = 0; axis < 3 && crossing.Key % 4 == LatticeCases::AtSample; ++axis)
    {
      for (const int way : { -1, 1 })
      {
        const std::int64_t other = sample + way * this->Regions.GetStrides()[axis];
        const std::size_t a = this->Regions.GetRegion(sample), b = this->Regions.GetRegion(other);
        const bool within = a != this->Regions.GetCount() && b != this->Regions.GetCount();
        if (within && !this->Regions.IsAtSample(b) && this->Regions.Get(std::min(sample, other), axis).GetCount() == 0)
        {
          this->AddLink(a, b, 1, way * this->Normals[3 * crossing.Id + axis]);
        }
      }
    }
  }
}

/// Makes one of those between the same two regions that have the same step.
void vtkPointSplatLatticeLevels::JoinLinks()
{
  std::sort(this->Links.begin(), this->Links.end(), [](const Link& x, const Link& y) {
    return x.A != y.A ? x.A < y.A : x.B != y.B ? x.B < y.B : x.Step < y.Step;
  });
  std::vector<Link> joined;
  for (const Link& link : this->Links)
  {
    if (joined.empty() || joined.back().A != link.A || joined.back().B != link.B || joined.back().Step != link.Step)
    {
      joined.push_back(link);
      continue;
    }
    joined.back().Vote += link.Vote;
    joined.back().Edges += link.Edges;
  }
  this->Links = std::move(joined);
}

/// From region to region, the surest first; returns whether all links agree then. Depths are even, and odd at samples.
bool vtkPointSplatLatticeLevels::FindDepths()
{
  const std::size_t count = this->Regions.GetCount();
  std::vector<std::vector<const Link*>> linksOf(count);
  std::vector<int> edges(count, 0);
  for (const Link& link : this->Links)
  {
    for (const std::size_t region : { link.A, link.B })
    {
      linksOf[region].push_back(&link);
      edges[region] += link.Edges;
    }
  }
  std::vector<std::vector<Candidate>> candidates(count);
  std::vector<unsigned char> known(count, 0);
  std::priority_queue<Guess> guesses;
  this->Depths.assign(count, 0);
  const auto setDepth = [&](std::size_t region, int depth) {
    this->Depths[region] = depth;
    known[region] = 1;
    for (const Link* link : linksOf[region])
    {
      const std::size_t other = link->A == region ? link->B : link->A;
      if (!known[other])
      {
        const float deeper = link->A == other ? link->Vote : -link->Vote;
        Add(candidates[other], { depth + link->Step, link->Edges, deeper });
        Add(candidates[other], { depth - link->Step, link->Edges, -deeper });
        guesses.push(GetGuess(other, candidates[other]));
      }
    }
  };
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return edges[a] > edges[b]; });
  for (const std::size_t start : order)
  {
    if (!known[start])
    {
      setDepth(start, this->Regions.IsAtSample(start) ? 1 : 0);
    }
    while (!guesses.empty())
    {
      const Guess guess = guesses.top();
      guesses.pop();
      // Where more has become known since, there is another guess.
      if (!known[guess.Region] && guess.IsSame(GetGuess(guess.Region, candidates[guess.Region])))
      {
        setDepth(guess.Region, guess.Depth);
      }
    }
  }
  return std::all_of(this->Links.begin(), this->Links.end(), [this](const Link& link) {
    return std::abs(this->Depths[link.A] - this->Depths[link.B]) == link.Step;
  });
}

/// An edge's point that is of a surface, which is inside of so many others.
vtkIdType vtkPointSplatLatticeLevels::GetPoint(
  std::int64_t voxel, int edge, const int depths[8], int surface) const
{
  const int lower = LatticeCases::EdgeEnds[edge], axis = LatticeCases::EdgeAxes[edge], upper = lower | (1 << axis);
  const int a = depths[lower], b = depths[upper];
  for (const int corner : { lower, upper })
  {
    if (depths[corner] == 2 * surface + 1)
    {
      return this->Regions.Get(this->Regions.GetCorner(voxel, corner), LatticeCases::AtSample).First->Id;
    }
  }
  const Range on = this->Regions.Get(this->Regions.GetCorner(voxel, lower), axis);
  const int before = surface - (std::min(a, b) + 1) / 2;
  if (before >= static_cast<int>(on.GetCount()))
  {
    return None; // between two samples that points lie at
  }
  return (a < b ? on.First[before] : on.Last[-1 - before]).Id;
}

void vtkPointSplatLatticeLevels::AddTriangles(std::int64_t voxel, std::vector<vtkIdType>& corners) const
{
  int depths[8];
  for (int corner = 0; corner < 8; ++corner)
  {
    depths[corner] = this->Depths[this->Regions.GetRegion(this->Regions.GetCorner(voxel, corner))];
  }
  const auto [least, most] = std::minmax_element(depths, depths + 8);
  for (int surface = (*least + 1) / 2; 2 * surface < *most; ++surface)
  {
    int inside = 0;
    for (int corner = 0; corner < 8; ++corner)
    {
      inside |= depths[corner] > 2 * surface ? 1 << corner : 0;
    }
    LatticeCases::VisitTriangles(inside, [&](const int edges[3]) {
      vtkIdType points[3];
      for (int k = 0; k < 3; ++k)
      {
        points[k] = this->GetPoint(voxel, edges[k], depths, surface);
      }
      const bool whole = std::find(points, points + 3, None) == points + 3;
      if (whole && points[0] != points[1] && points[1] != points[2] && points[2] != points[0])
      {
        corners.insert(corners.end(), points, points + 3);
      }
    });
  }
}

bool vtkPointSplatLatticeLevels::Find()
{
  if (!this->Regions.Find())
  {
    return false;
  }
  this->FindLinks();
  this->JoinLinks();
  if (!this->FindDepths())
  {
    return false;
  }
  // No less than 0, so that they are divided alike.
  const int least = *std::min_element(this->Depths.begin(), this->Depths.end());
  for (int& depth : this->Depths)
  {
    depth += 2 * ((1 - least) / 2);
  }
  this->Corners = this->Regions.GetTriangles(
    [this](std::int64_t voxel, std::vector<vtkIdType>& corners) { this->AddTriangles(voxel, corners); });
  return true;
}

VTK_ABI_NAMESPACE_END
