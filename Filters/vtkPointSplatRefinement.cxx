// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatRefinement.h"

#include "vtkMath.h"
#include "vtkPointSplatThreads.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN

// Those that are fitted by hand are from Testing/Accuracy/fit_constants.py.
namespace
{
/// How many sizes long edges are divided from: kernels reach half a size past disks, and blend there.
constexpr double LongEdge = 1.7;
/// What part of an edge's length the point in its middle may be large.
constexpr float ShareOfEdge = 0.55f;
/// In how many parts a triangle's sides are divided by the places that have to be covered.
constexpr int CoveredParts = 6;
/// How many times as large as grading lets it a fill point may be.
constexpr float MostGraded = 1.5f;
/// How often fill points are graded, and what is long then divided: each time fewer are.
constexpr int MostRounds = 3;
/// How many triangles are divided at once, by all threads.
constexpr std::size_t PartsAtOnce = 4096;
/// Each division halves an edge: more are those of sizes that next to nothing is left of.
constexpr int MostHalvings = 24;
}

vtkPointSplatRefinement::vtkPointSplatRefinement(
  const vtkPointSplatStars& stars, const float* normals, const float* curvatures)
  : Covers(stars.Sizes.size(), 1.0f)
  , Stars(stars)
  , Normals(normals)
  , Curvatures(curvatures)
{
}

vtkPointSplatRefinement::Point vtkPointSplatRefinement::Get(Index index) const
{
  if (index >= FirstIndex)
  {
    return this->Points[index - FirstIndex];
  }
  const Site site = static_cast<Site>(index);
  Point point{};
  this->Stars.GetPosition(site, point.X);
  std::copy_n(this->Normals + std::size_t(3) * site, 3, point.Normal);
  std::copy_n(this->Curvatures + std::size_t(6) * site, 6, point.Curvature);
  point.Size = this->Stars.Sizes[site];
  point.Tip = std::binary_search(this->Stars.Tips.begin(), this->Stars.Tips.end(), site);
  point.Cover = this->Covers[site];
  point.Count = 1;
  point.Ends[0] = site;
  point.Weights[0] = 1;
  return point;
}

float vtkPointSplatRefinement::GetSize(Index index) const
{
  return index >= FirstIndex ? this->Points[index - FirstIndex].Size : this->Stars.Sizes[index];
}

bool vtkPointSplatRefinement::IsLong(const Corner& a, const Corner& b, double& length) const
{
  length = std::sqrt(vtkMath::Distance2BetweenPoints(a.At.data(), b.At.data()));
  const double sizeA = this->GetSize(a.Of), sizeB = this->GetSize(b.Of);
  return sizeA > 0 && sizeB > 0 && std::isfinite(length) && length > LongEdge * 0.5 * (sizeA + sizeB);
}

/// Adds half of a point's ends to a middle's.
void vtkPointSplatRefinement::AddEnds(const Point& of, Point& to) const
{
  for (int k = 0; k < of.Count; ++k)
  {
    int at = 0;
    while (at < to.Count && to.Ends[at] != of.Ends[k])
    {
      ++at;
    }
    if (at == to.Count && to.Count < 3)
    {
      to.Ends[to.Count++] = of.Ends[k];
    }
    to.Weights[std::min(at, 2)] += 0.5f * of.Weights[k];
  }
}

/// Adds the point that was made in the middle between two, unless there is one near to it.
vtkPointSplatRefinement::Middle vtkPointSplatRefinement::AddMiddle(Index a, Index b, const Point& made)
{
  double x[3], y[3];
  this->GetPlace(a, x);
  this->GetPlace(b, y);
  Middle middle{ a, { { 0, 0, 0 } } };
  if (std::equal(x, x + 3, y))
  {
    return middle; // one point stands for both ends
  }
  middle.Of = FirstIndex + this->Points.size();
  if (!this->FindNear(made, middle.Of))
  {
    this->Points.push_back(made);
    this->Insert(middle.Of, made.X, made.Size);
  }
  for (int c = 0; c < 3; ++c)
  {
    middle.Rise[c] = made.X[c] - 0.5 * (x[c] + y[c]);
  }
  return middle;
}

/// Divides the edges at which some triangles are to be divided. What is made of an edge depends on its ends alone, but not what
/// stands for it.
void vtkPointSplatRefinement::DivideEdges(const Part* first, const Part* last)
{
  std::vector<std::pair<const std::pair<Index, Index>, Middle>*> edges;
  for (const Part* part = first; part != last; ++part)
  {
    const auto [known, isNew] = this->Middles.try_emplace(std::minmax(part->Of[0].Of, part->Of[1].Of));
    if (isNew)
    {
      edges.push_back(&*known);
    }
  }
  std::vector<Point> made(edges.size());
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(edges.size()), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      const Point p = this->Get(edges[i]->first.first), q = this->Get(edges[i]->first.second);
      if (!std::equal(p.X, p.X + 3, q.X))
      {
        made[i] = this->MakeMiddle(p, q);
      }
    }
  });
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    edges[i]->second = this->AddMiddle(edges[i]->first.first, edges[i]->first.second, made[i]);
  }
}

/// Gives the corner in the middle of an edge that was divided.
vtkPointSplatRefinement::Corner vtkPointSplatRefinement::Divide(const Corner& a, const Corner& b)
{
  const Middle& middle = this->Middles.at(std::minmax(a.Of, b.Of));
  Corner corner{ middle.Of, middle.Rise };
  if (!this->GetRoom)
  {
    // A cloud's triangles overlap, and cover what lies between.
    this->GetPlace(middle.Of, corner.At.data());
    return corner;
  }
  for (int c = 0; c < 3; ++c)
  {
    corner.At[c] += 0.5 * (a.At[c] + b.At[c]);
  }
  return corner;
}

namespace
{
/// Gives a middle its curvature, which along the edge is along.
void Bend(const vtkPointSplatRefinement::Point& p, const vtkPointSplatRefinement::Point& q,
  const double way[3], double along, vtkPointSplatRefinement::Point& middle)
{
  double across[3];
  const double plane[3] = { middle.Plane[0], middle.Plane[1], middle.Plane[2] };
  vtkMath::Cross(plane, way, across);
  const double share = double(p.Size) * p.Size / (double(p.Size) * p.Size + double(q.Size) * q.Size);
  const int rows[6] = { 0, 1, 2, 0, 1, 0 }, columns[6] = { 0, 1, 2, 1, 2, 2 };
  // Half way to a tip, as a cone's, the surface is half as wide, and bends twice as much.
  const double ofP = p.Tip ? 0 : (q.Tip ? 2 : share), ofQ = q.Tip ? 0 : (p.Tip ? 2 : 1 - share);
  double beside = 0;
  for (int c = 0; c < 6; ++c)
  {
    const double sum = ofP * p.Curvature[c] + ofQ * q.Curvature[c];
    beside += (c < 3 ? 1 : 2) * sum * across[rows[c]] * across[columns[c]];
  }
  for (int c = 0; c < 6; ++c)
  {
    middle.Curvature[c] = static_cast<float>(along * way[rows[c]] * way[columns[c]] +
      beside * across[rows[c]] * across[columns[c]]);
  }
}
}

vtkPointSplatRefinement::Point vtkPointSplatRefinement::MakeMiddle(
  const Point& p, const Point& q) const
{
  Point middle{};
  middle.Cover = 1;
  double way[3];
  vtkMath::Subtract(q.X, p.X, way);
  const double length = vtkMath::Normalize(way);
  double n[3] = { p.Normal[0], p.Normal[1], p.Normal[2] };
  double m[3] = { q.Normal[0], q.Normal[1], q.Normal[2] };
  const double lean = vtkMath::Dot(n, way);
  double otherLean = vtkMath::Dot(m, way);
  // What is less than this product points, across the edge, against the other; what is less than twice that, against
  // its mirror image.
  const double leans = lean * otherLean;
  if (vtkMath::Dot(n, m) < std::min(leans, 2 * leans))
  {
    vtkMath::MultiplyScalar(m, -1);
    otherLean = -otherLean;
  }
  double normal[3];
  vtkMath::Add(n, m, normal);
  if (vtkMath::Normalize(normal) < LeastMean)
  {
    std::copy_n(n, 3, normal);
  }
  double plane[3];
  const double along = vtkMath::Dot(normal, way);
  for (int c = 0; c < 3; ++c)
  {
    plane[c] = normal[c] - along * way[c];
  }
  if (vtkMath::Normalize(plane) < LeastMean)
  {
    std::copy_n(normal, 3, plane);
  }
  // Of a ball it falls behind the first end, and rises before the second.
  const double rise = lean * otherLean < 0
    ? std::copysign(std::min(std::abs(lean), std::abs(otherLean)), otherLean)
    : 0;
  for (int c = 0; c < 3; ++c)
  {
    middle.X[c] = 0.5 * (p.X[c] + q.X[c]) + 0.25 * length * rise * normal[c];
    middle.Normal[c] = static_cast<float>(normal[c]);
    middle.Plane[c] = static_cast<float>(plane[c]);
  }
  Bend(p, q, way, (otherLean - lean) / length, middle);
  const float half = static_cast<float>(0.5 * length);
  const float graded = vtkPointSplatStars::GetGraded(std::min(p.Size, q.Size), half);
  middle.Size = std::min(graded, std::max(2 * ShareOfEdge * half, std::min(p.Size, q.Size)));
  this->AddEnds(p, middle);
  this->AddEnds(q, middle);
  if (this->GetRoom)
  {
    middle.Size = std::min(middle.Size, vtkPointSplatStars::GetSize(this->GetRoom(middle)));
  }
  return middle;
}

/// By how much the splats of a triangle's corners must be larger to cover it.
float vtkPointSplatRefinement::GetCover(const Corners& corners) const
{
  double inverse[3]; // of squared radii
  Place centres[3];
  for (int k = 0; k < 3; ++k)
  {
    const float size = this->GetSize(corners[k].Of);
    if (!(size > 0))
    {
      return 1; // what is beside such a one is not the surface's
    }
    const double radius = vtkPointSplatStars::GetRadius(size);
    inverse[k] = 1 / (radius * radius);
    this->GetPlace(corners[k].Of, centres[k].data());
  }
  double needed = 1; // squared, in radii
  for (int i = 0; i <= CoveredParts; ++i)
  {
    for (int j = 0; j <= CoveredParts - i; ++j)
    {
      const double shares[3] = { double(i) / CoveredParts, double(j) / CoveredParts,
        double(CoveredParts - i - j) / CoveredParts };
      double place[3] = { 0, 0, 0 }, nearest = std::numeric_limits<double>::max();
      for (int k = 0; k < 3; ++k)
      {
        for (int c = 0; c < 3; ++c)
        {
          place[c] += shares[k] * corners[k].At[c];
        }
      }
      for (int k = 0; k < 3; ++k)
      {
        nearest =
          std::min(nearest, vtkMath::Distance2BetweenPoints(place, centres[k].data()) * inverse[k]);
      }
      needed = std::max(needed, nearest);
    }
  }
  return static_cast<float>(std::sqrt(needed));
}

/// Covers the triangles that are left.
void vtkPointSplatRefinement::Cover()
{
  vtkPointSplatLargeArray<float> covers(this->Undivided.size());
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(this->Undivided.size()), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType t = begin; t < end; ++t)
    {
      covers[t] = this->GetCover(this->Undivided[t]);
    }
  });
  for (std::size_t t = 0; t < this->Undivided.size(); ++t)
  {
    for (const Corner& corner : this->Undivided[t])
    {
      float& cover = corner.Of < FirstIndex ? this->Covers[corner.Of] : this->Points[corner.Of - FirstIndex].Cover;
      cover = std::max(cover, covers[t]);
    }
  }
}

/// Adds a triangle to those that are to be divided, or to those that are not.
void vtkPointSplatRefinement::Add(const Corners& corners, int divisions)
{
  int longest = -1;
  double length, largest = 0;
  for (int k = 0; k < 3; ++k)
  {
    if (this->IsLong(corners[k], corners[(k + 1) % 3], length) && length > largest)
    {
      largest = length;
      longest = k;
    }
  }
  if (longest < 0)
  {
    this->Undivided.push_back(corners);
    return;
  }
  if (divisions == MostHalvings)
  {
    return;
  }
  Part part{ 0, largest, {}, {}, divisions };
  for (int k = 0; k < 3; ++k)
  {
    part.Of[k] = corners[(longest + k) % 3];
    part.Middle[k] = corners[longest].At[k] + corners[(longest + 1) % 3].At[k];
  }
  const int octave = std::ilogb(largest);
  part.Where = GetKey(FindCell(part.Middle.data(), octave));
  this->Parts[octave].push_back(part);
}

/// About how many points will divide these triangles: their first edges are halved until they are short, and each is
/// that of another triangle, too. Where points stand for others it is fewer, else more.
double vtkPointSplatRefinement::CountExpected() const
{
  double divisions = 0;
  for (const auto& parts : this->Parts)
  {
    for (const Part& part : parts.second)
    {
      const double sizes = double(this->GetSize(part.Of[0].Of)) + this->GetSize(part.Of[1].Of);
      divisions += std::ceil(std::log2(part.Length / (LongEdge * 0.5 * sizes)));
    }
  }
  return 0.5 * divisions;
}

/// Enters the corners of triangles, which may stand for fill points.
void vtkPointSplatRefinement::InsertSites()
{
  std::vector<unsigned char> isCorner(this->Stars.Sizes.size(), 0);
  for (const vtkPointSplatStars::Triangle& triangle : this->Stars.Triangles)
  {
    for (const Site corner : triangle)
    {
      isCorner[corner] = 1;
    }
  }
  for (Site site = 0; site < isCorner.size(); ++site)
  {
    if (isCorner[site] && this->Stars.Sizes[site] > 0)
    {
      double x[3];
      this->Stars.GetPosition(site, x);
      this->Insert(site, x, this->Stars.Sizes[site]);
    }
  }
}

/// Makes fill points no larger than what is next to them in the triangles that are left lets them. Returns whether any had to be
/// smaller.
bool vtkPointSplatRefinement::Grade()
{
  std::vector<float> sizes(this->Points.size());
  std::transform(
    this->Points.begin(), this->Points.end(), sizes.begin(), [](const Point& point) { return point.Size; });
  const auto bound = [&](Index index, float most) {
    if (index >= FirstIndex)
    {
      float& size = sizes[index - FirstIndex];
      size = std::min(size, most);
    }
  };
  for (const Corners& corners : this->Undivided)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Corner &a = corners[k], &b = corners[(k + 1) % 3];
      const float length = static_cast<float>(std::sqrt(vtkMath::Distance2BetweenPoints(a.At.data(), b.At.data())));
      bound(a.Of, vtkPointSplatStars::GetGraded(this->GetSize(b.Of), length));
      bound(b.Of, vtkPointSplatStars::GetGraded(this->GetSize(a.Of), length));
    }
  }
  bool any = false;
  for (std::size_t i = 0; i < sizes.size(); ++i)
  {
    if (MostGraded * sizes[i] < this->Points[i].Size)
    {
      this->Points[i].Size = sizes[i];
      any = true;
    }
  }
  return any;
}

/// Divides triangles until none has long edges. Returns false if that takes more than most points.
bool vtkPointSplatRefinement::DivideAll(std::size_t most)
{
  while (!this->Parts.empty())
  {
    const auto longest = std::prev(this->Parts.end());
    std::vector<Part> parts = std::move(longest->second);
    this->Parts.erase(longest);
    vtkSMPTools::Sort(parts.begin(), parts.end());
    for (std::size_t begin = 0, end; begin < parts.size(); begin = end)
    {
      end = std::min(parts.size(), begin + PartsAtOnce);
      this->DivideEdges(parts.data() + begin, parts.data() + end);
      if (this->Points.size() > most)
      {
        return false;
      }
      for (std::size_t i = begin; i < end; ++i)
      {
        const Corners& c = parts[i].Of;
        const Corner middle = this->Divide(c[0], c[1]);
        this->Add({ { c[0], middle, c[2] } }, parts[i].Divisions + 1);
        this->Add({ { middle, c[1], c[2] } }, parts[i].Divisions + 1);
      }
    }
  }
  return true;
}

bool vtkPointSplatRefinement::Make(std::size_t most)
{
  for (const vtkPointSplatStars::Triangle& triangle : this->Stars.Triangles)
  {
    Corners corners;
    for (int k = 0; k < 3; ++k)
    {
      corners[k].Of = triangle[k];
      this->GetPlace(triangle[k], corners[k].At.data());
    }
    this->Add(corners, 0);
  }
  // Of points all over a volume it takes long to see that there are too many by making them.
  if (this->CountExpected() > static_cast<double>(most))
  {
    return false;
  }
  this->InsertSites();
  for (int round = 0; this->DivideAll(most); ++round)
  {
    if (round == MostRounds || !this->Grade())
    {
      this->Cover();
      return true;
    }
    for (const Corners& left : std::exchange(this->Undivided, {}))
    {
      this->Add(left, 0);
    }
  }
  return false;
}

VTK_ABI_NAMESPACE_END
