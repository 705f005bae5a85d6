// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatStars.h"

#include "vtkAlgorithm.h"
#include "vtkMath.h"
#include "vtkPointSplatThreads.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"
#include "vtkTriangle.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN

// Those that are fitted by hand are from Testing/Accuracy/fit_constants.py.
namespace
{
/// How much normals may turn within a size, and what is left of one at least.
constexpr float MostTurn = 0.6f;
constexpr float LeastBent = 0.3f;
/// A neighbour is far from so many sizes on: in random samplings hardly any is.
constexpr float FarNeighbor = 2.4f;
/// By how much the surface may turn on the way to a disk's rim for it to be flat enough for any disk.
constexpr float FlatTurn = 0.2f;
/// How many times larger than its size asks for a disk may be where the surface bends: it would stand off that.
constexpr float LargeDisk = 1.4f;
/// By how much the surface of a mesh, where its curvature is known, may turn within a size.
constexpr float MostBend = 0.4f;
/// Of what a triangle beside a vertex is wide no size is less: a mesh is as fine across as its surface bends.
constexpr float WidthShare = 0.8f;
/// What is left of the disk at a tip.
constexpr float TipShare = 0.05f;
/// Normals of two faces part by more than this cosine (20 degrees), and where points are too few for the crease between
/// them to be found from both, by this (60 degrees): else the surface may bend from one to the other.
constexpr float CreaseCosine = 0.94f;
constexpr float EndsCosine = 0.5f;
/// A corner faces a side of a triangle from this cosine on, and is across the triangle from that on: of the triangles of
/// coarse isosurfaces that are the mesh's one in 300 is lost, of those that lead off it a fifth to a half.
constexpr double LeastFacing = 0.1;
constexpr double FacingCosine = 0.5;
/// Where a row ends at gaps on both sides, their directions part by more than 120 degrees.
constexpr double OppositeCosine = -0.5;
/// From how many times the spacing on points beside the border of a denser part say that the surface goes on there.
constexpr float Sparser = 2;

/// A triangle of a star that is too wide for what the nearest points of its corners tell.
struct WideTriangle
{
  int Others[2];    // corners: their places in the neighbourhood
  double Middle[3]; // the way to the circumcentre, of unit length

  WideTriangle(const vtkPointSplatNeighbors::Neighborhood& around, int a, int b)
    : Others{ a, b }
  {
    const double x[3] = { around.X[a], around.Y[a], around.Z[a] }, y[3] = { around.X[b], around.Y[b], around.Z[b] };
    double across[3], along[3];
    vtkMath::Cross(x, y, across);
    for (int c = 0; c < 3; ++c)
    {
      along[c] = static_cast<double>(around.SquaredDistance[a]) * y[c] - static_cast<double>(around.SquaredDistance[b]) * x[c];
    }
    vtkMath::Cross(along, across, this->Middle);
    vtkMath::Normalize(this->Middle);
  }

  /// Whether there is another one on the other side of the centre.
  bool HasOpposite(const std::vector<WideTriangle>& all) const
  {
    return std::any_of(all.begin(), all.end(), [this](const WideTriangle& other) {
      return vtkMath::Dot(this->Middle, other.Middle) < OppositeCosine;
    });
  }
};

/// Whether the surface bends on the way to a disk's rim. turn: as in vtkPointSplatDisks.
bool IsBent(float turn, float reach)
{
  return turn * reach > FlatTurn;
}
}

vtkPointSplatStars::vtkPointSplatStars(std::size_t sites, PositionGetter getPosition)
  : GetPosition(std::move(getPosition))
  , Sizes(sites, 0.0f)
  , Uneven(sites, 0)
{
}

void vtkPointSplatStars::SetSize(Site site, const Measures& measures, bool bends)
{
  float size = measures.Distance;
  if (bends && measures.Turn > 0)
  {
    size = std::min(size, std::max(MostTurn / measures.Turn, LeastBent * size));
  }
  this->Sizes[site] = size;
  this->Uneven[site] = size > 0 && measures.Farthest > FarNeighbor * size;
}

bool vtkPointSplatStars::StandsOff(Site site, float turn, float reach) const
{
  return IsBent(turn, reach) && reach > LargeDisk * this->GetRadius(site);
}

void vtkPointSplatStars::Bound(Site site, float radius)
{
  const float most = GetSize(radius);
  float& size = this->Sizes[site];
  size = size > 0 ? std::min(size, most) : most; // a corner of one triangle alone has none
  this->Uneven[site] = 1;
}

float vtkPointSplatStars::GetBent(float bend, float width)
{
  return std::max(MostBend / bend, WidthShare * width);
}

void vtkPointSplatStars::BoundBent(Site site, float size, float radius)
{
  const float most = GetRadius(size);
  if (radius > LargeDisk * most)
  {
    this->Bound(site, most);
  }
}

void vtkPointSplatStars::BoundTip(Site site, float radius)
{
  this->Bound(site, TipShare * radius);
  this->Tips.push_back(site);
}

float vtkPointSplatStars::GetMedianSize() const
{
  std::vector<float> sizes = vtkPointSplatVoronoiCells::GetSamples(
    this->Sizes.size(), [this](std::size_t site) { return this->Sizes[site]; });
  return sizes.empty() ? 0.0f : vtkPointSplatVoronoiCells::GetQuantile(sizes, 0.5);
}

void vtkPointSplatStars::RaiseSizes(float least)
{
  for (float& size : this->Sizes)
  {
    size = size > 0 ? std::max(size, least) : size;
  }
}

/// Whether a triangle connects two faces that end at lines, and do not go on behind them. Of one alone the line may be that
/// on its other side.
bool vtkPointSplatStars::IsOverCrease(const Cloud& cloud, const Triangle& triangle)
{
  for (int k = 0; k < 3; ++k)
  {
    const Site a = triangle[k], b = triangle[(k + 1) % 3];
    const vtkPointSplatCreases::Splat* splats[2] = { (*cloud.Creased)[a], (*cloud.Creased)[b] };
    const bool folded = std::any_of(splats, splats + 2,
      [](const vtkPointSplatCreases::Splat* splat) { return splat && vtkPointSplatCreases::HasFold(*splat); });
    const bool ends = cloud.Borders->IsEnd(a) || cloud.Borders->IsEnd(b);
    const float* n = cloud.Normals + std::size_t(3) * a;
    const float* m = cloud.Normals + std::size_t(3) * b;
    const float cosine = std::abs(vtkMath::Dot(n, m));
    if (!folded &&
      ((splats[0] && splats[1] && cosine < CreaseCosine) ||
        ((splats[0] || splats[1] || ends) && cosine < EndsCosine)))
    {
      return true;
    }
  }
  return false;
}

/// Whether the corners of a triangle face its two sides: then they are of different sheets that come close, as a body's
/// tip and what is next to it. Normals that are not consistently oriented, which are across the triangle all the same, do not.
bool vtkPointSplatStars::HasTwoSides(const Cloud& cloud, const Triangle& triangle) const
{
  double x[3][3], across[3];
  for (int k = 0; k < 3; ++k)
  {
    this->GetPosition(triangle[k], x[k]);
  }
  vtkTriangle::ComputeNormal(x[0], x[1], x[2], across);
  double highest = 0, lowest = 0, least = 1;
  for (const Site corner : triangle)
  {
    const float* n = cloud.Normals + std::size_t(3) * corner;
    const double facing = across[0] * n[0] + across[1] * n[1] + across[2] * n[2];
    highest = std::max(highest, facing);
    lowest = std::min(lowest, facing);
    least = std::min(least, std::abs(facing));
  }
  return std::min(highest, -lowest) > LeastFacing && least < FacingCosine;
}

/// Whether a triangle lies, as seen from that corner, past a border or in a hole.
bool vtkPointSplatStars::IsOutside(
  const vtkPointSplatBorders& borders, const Triangle& triangle, int corner) const
{
  double x[3], y[3];
  this->GetPosition(triangle[corner], x);
  float middle[3] = { 0, 0, 0 };
  for (const int other : { (corner + 1) % 3, (corner + 2) % 3 })
  {
    this->GetPosition(triangle[other], y);
    float way[3];
    for (int c = 0; c < 3; ++c)
    {
      way[c] = static_cast<float>(y[c] - x[c]);
    }
    vtkMath::Normalize(way);
    vtkMath::Add(middle, way, middle);
  }
  return borders.IsOutside(triangle[corner], middle);
}

/// Whether a corner's cell is closed, and meets those of a triangle's other corners nowhere, by which the triangle is none,
/// though points are about as dense there: just where they are sparser the surface may go on to that corner.
bool vtkPointSplatStars::IsAway(const Cloud& cloud, const Triangle& triangle, int corner) const
{
  const Site site = triangle[corner];
  const double most = 2.0 * cloud.Disks->Opening[site];
  double x[3], y[3];
  this->GetPosition(site, x);
  bool away = most > 0;
  for (const Site other : { triangle[(corner + 1) % 3], triangle[(corner + 2) % 3] })
  {
    this->GetPosition(other, y);
    away = away && vtkMath::Distance2BetweenPoints(x, y) > most * most &&
      cloud.Disks->Spacing[site] < Sparser * cloud.Disks->Spacing[other];
  }
  return away;
}

/// Whether a triangle lies past a border or in a hole: all of its corners are on that, since another one would be
/// a point of the surface there, unless it is away.
bool vtkPointSplatStars::IsOutside(const Cloud& cloud, const Triangle& triangle) const
{
  const auto corners = { 0, 1, 2 };
  return std::all_of(corners.begin(), corners.end(),
           [&](int k) { return cloud.Borders->IsEnd(triangle[k]) || this->IsAway(cloud, triangle, k); }) &&
    std::any_of(corners.begin(), corners.end(),
      [&](int k) { return this->IsOutside(*cloud.Borders, triangle, k); });
}

std::vector<vtkPointSplatStars::Site> vtkPointSplatStars::FindContinued(const Cloud& cloud) const
{
  const vtkPointSplatLargeArray<float>& spacing = cloud.Disks->Spacing;
  std::vector<Site> continued;
  for (const Triangle& triangle : this->Triangles)
  {
    const float largest =
      std::max({ spacing[triangle[0]], spacing[triangle[1]], spacing[triangle[2]] });
    for (int k = 0; k < 3; ++k)
    {
      if (cloud.Borders->IsEnd(triangle[k]) && largest > Sparser * spacing[triangle[k]] &&
        this->IsOutside(*cloud.Borders, triangle, k))
      {
        continued.push_back(triangle[k]);
      }
    }
  }
  std::sort(continued.begin(), continued.end());
  continued.erase(std::unique(continued.begin(), continued.end()), continued.end());
  return continued;
}

/// Whether all points that a site's disk was made from lie to one side, though the surface does not end there.
bool vtkPointSplatStars::IsOpen(const Cloud& cloud, Site site) const
{
  return this->Sizes[site] > 0 && cloud.Disks->Opening[site] == 0 && !(*cloud.Creased)[site] &&
    !cloud.Creases->HasTwins(site) && !cloud.Borders->IsEnd(site);
}

/// Whether some corner's disk covers none of a triangle in the midst of a face: where faces meet, points of several share
/// a place.
bool vtkPointSplatStars::IsHalfCovered(const Cloud& cloud, const Triangle& triangle) const
{
  return std::any_of(triangle.begin(), triangle.end(),
           [&](Site corner) { return this->IsOpen(cloud, corner); }) &&
    std::none_of(triangle.begin(), triangle.end(),
      [&](Site corner) { return cloud.Creases->HasTwins(corner); });
}

/// Whether a site's cell reaches into a gap that its disk does not close, and that no border surrounds.
bool vtkPointSplatStars::IsBesideGap(const Cloud& cloud, Site site)
{
  const vtkPointSplatDisks& disks = *cloud.Disks;
  return disks.MayReachHole(site) &&
    disks.Opening[site] <= cloud.Borders->GetWidestGap(site) * disks.NearSpacing[site] && !cloud.Borders->IsEnd(site);
}

/// Whether a triangle that is wide enough to reach over a hole lies in such a gap. Normals of its corners that part by
/// much are those of several sides of a small body.
bool vtkPointSplatStars::IsOverGap(const Cloud& cloud, const Triangle& triangle, float circumscribed)
{
  float densest = std::numeric_limits<float>::max();
  for (int k = 0; k < 3; ++k)
  {
    const float* n = cloud.Normals + std::size_t(3) * triangle[k];
    const float* m = cloud.Normals + std::size_t(3) * triangle[(k + 1) % 3];
    if (cloud.Borders->IsEnd(triangle[k]) || std::abs(vtkMath::Dot(n, m)) < EndsCosine)
    {
      return false;
    }
    densest = std::min(densest, cloud.Disks->NearSpacing[triangle[k]]);
  }
  return circumscribed <= cloud.Borders->GetWidestGap(triangle[0]) * densest;
}

void vtkPointSplatStars::FindUneven(const Cloud& cloud)
{
  constexpr Site leafSize = vtkPointSplatNeighbors::LeafSize;
  const vtkPointSplatDisks& disks = *cloud.Disks;
  const Site leaves = static_cast<Site>(this->Sizes.size()) / leafSize;
  std::vector<float> turns(leaves); // the largest of each leaf
  for (Site leaf = 0; leaf < leaves; ++leaf)
  {
    const Site first = leafSize * leaf;
    turns[leaf] = *std::max_element(disks.Turn.data() + first, disks.Turn.data() + first + leafSize);
    for (Site s = first; s < first + leafSize; ++s)
    {
      turns[leaf] = this->IsOpen(cloud, s) ? std::numeric_limits<float>::max() : turns[leaf];
    }
  }
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(this->Sizes.size()), [&](vtkIdType begin, vtkIdType end) {
    for (Site s = static_cast<Site>(begin); s < static_cast<Site>(end); ++s)
    {
      const float reach = disks.GetReach(s);
      const bool bends = IsBent(disks.Turn[s], reach);
      const bool gap = IsBesideGap(cloud, s);
      const bool uneven = this->Sizes[s] > 0 && !(*cloud.Creased)[s] && !disks.IsAlone(s) &&
        (this->Uneven[s] || gap || disks.HasSmallWitness(s, this->Sizes) ||
          (cloud.MayBend(s) && this->StandsOff(s, disks.Turn[s], reach)));
      // Of an open cell it is not known how far its star reaches.
      bool flat = uneven && !bends && !gap && !disks.IsTooLarge(s) && disks.Opening[s] > 0;
      if (flat)
      {
        // Two points whose cells meet are no farther apart than twice the way to where they do.
        const double most = 2.0 * std::max(disks.Opening[s], disks.Farthest[s]);
        cloud.Neighbors->VisitLeaves(s / leafSize, most, [&](Site leaf) {
          flat = !IsBent(turns[leaf], reach);
          return flat;
        });
      }
      this->Uneven[s] = uneven && !flat;
    }
  });
}

bool vtkPointSplatStars::Find(vtkAlgorithm* self, const Cloud& cloud)
{
  this->FindUneven(cloud);
  const vtkPointSplatDisks& disks = *cloud.Disks;
  vtkSMPThreadLocal<std::vector<Triangle>> found;
  vtkPointSplatLargeArray<float> longest(this->Sizes.size(), 0.0f); // of the triangles' edges at an uneven site
  auto find = [&](const vtkPointSplatNeighbors::Neighborhood& around, int round) {
    vtkPointSplatDisk disk;
    const float limit = disks.GetSampling(around.Center).HoleLimit;
    const bool closed =
      disk.Estimate(around, cloud.Normals, false, disks.GetUsual(around.Center), limit);
    // Neighbours that are not known of could lie in the triangles' circumcircles.
    float largest = 0;
    disk.VisitTriangles([&largest](int, int, float circumscribed) {
      largest = std::max(largest, circumscribed);
    });
    const bool sure = 4 * largest * largest <= around.SquaredDistance[around.Count - 1];
    if (round < 2 && !(closed && sure))
    {
      return false;
    }
    const float reach = disks.GetReach(around.Center);
    bool bends = IsBent(disks.Turn[around.Center], reach) || disks.IsTooLarge(around.Center);
    std::vector<Triangle>& local = found.Local();
    const std::size_t before = local.size();
    std::vector<Triangle> uncovered; // those that one large disk does not cover
    float longest2 = 0;
    const auto add = [&](Triangle triangle, int a, int b) {
      longest2 = std::max({ longest2, around.SquaredDistance[a], around.SquaredDistance[b] });
      std::sort(triangle.begin(), triangle.end());
      local.push_back(triangle);
    };
    const bool reachesHole = disks.MayReachHole(around.Center);
    std::vector<WideTriangle> wide; // none where they may be over a hole
    disk.VisitTriangles([&](int a, int b, float circumscribed) {
      Triangle triangle{ { around.Center, around.Slots[a], around.Slots[b] } };
      float spacing = 0;
      for (const Site corner : triangle)
      {
        spacing = std::max(spacing, disks.NearSpacing[corner]);
        bends = bends || IsBent(disks.Turn[corner], reach);
      }
      // A hole has no points, and is no larger than usual where any corner's points are so sparse.
      const bool isWide = circumscribed > limit * spacing;
      if (isWide && !IsOverGap(cloud, triangle, circumscribed))
      {
        if (!reachesHole)
        {
          wide.emplace_back(around, a, b);
        }
        return;
      }
      add(triangle, a, b);
      if (isWide || this->IsHalfCovered(cloud, triangle))
      {
        uncovered.push_back(local.back());
      }
    });
    for (const WideTriangle& triangle : wide)
    {
      if (triangle.HasOpposite(wide))
      {
        const auto [a, b] = triangle.Others;
        add({ { around.Center, around.Slots[a], around.Slots[b] } }, a, b);
      }
    }
    longest[around.Center] = longest2 > 0 ? std::sqrt(longest2) : disks.NearSpacing[around.Center];
    this->Uneven[around.Center] = bends;
    if (!bends)
    {
      local.resize(before);
      local.insert(local.end(), uncovered.begin(), uncovered.end());
    }
    return sure || (!bends && uncovered.empty());
  };
  const double progress = self->GetProgress();
  if (!cloud.Neighbors->VisitWidely(self, progress, progress, cloud.Count, find,
        [this](Site s) { return this->Uneven[s] != 0; }))
  {
    return false;
  }
  for (const std::vector<Triangle>& local : found)
  {
    std::copy_if(local.begin(), local.end(), std::back_inserter(this->Triangles),
      [&](const Triangle& triangle) {
        return !IsOverCrease(cloud, triangle) && !this->IsOutside(cloud, triangle) &&
          !(cloud.MayBend(triangle[0]) && this->HasTwoSides(cloud, triangle));
      });
  }
  // Neighbours may be those of another body in the same plane, as the soles of an animal's feet are: what no triangle
  // reaches is not the site's to cover.
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(this->Sizes.size()), [&](vtkIdType begin, vtkIdType end) {
    for (Site s = static_cast<Site>(begin); s < static_cast<Site>(end); ++s)
    {
      this->Sizes[s] = this->Uneven[s] ? std::min(this->Sizes[s], longest[s]) : this->Sizes[s];
    }
  });
  this->Grade();
  return true;
}

void vtkPointSplatStars::Find(const vtkPointSplatFans& mesh, const std::function<float(Site)>& getRadius)
{
  std::vector<Site> found;
  for (Site s = 0; s < this->Sizes.size(); ++s)
  {
    if (this->Uneven[s])
    {
      found.push_back(s);
    }
  }
  std::vector<float> before(this->Sizes.begin(), this->Sizes.end());
  while (!found.empty())
  {
    for (const Site s : found)
    {
      mesh.VisitTriangles(static_cast<vtkIdType>(s), [this](const vtkIdType corners[3]) {
        Triangle triangle;
        std::transform(corners, corners + 3, triangle.begin(),
          [](vtkIdType id) { return static_cast<Site>(id); });
        std::sort(triangle.begin(), triangle.end());
        this->Triangles.push_back(triangle);
      });
    }
    this->Grade();
    found.clear();
    // Disks beside these are too large for what bends or ends there.
    for (Site s = 0; s < this->Sizes.size(); ++s)
    {
      if (!this->Uneven[s] && LargeDisk * this->Sizes[s] < before[s] && getRadius(s) > LargeDisk * this->GetRadius(s))
      {
        this->Uneven[s] = 1;
        found.push_back(s);
      }
    }
  }
}

void vtkPointSplatStars::Grade()
{
  vtkSMPTools::Sort(this->Triangles.begin(), this->Triangles.end());
  this->Triangles.erase(
    std::unique(this->Triangles.begin(), this->Triangles.end()), this->Triangles.end());

  struct Edge
  {
    Site A, B;
    float Length;
  };
  std::vector<std::pair<Site, Site>> pairs;
  for (const Triangle& t : this->Triangles)
  {
    pairs.insert(pairs.end(), { { t[0], t[1] }, { t[0], t[2] }, { t[1], t[2] } });
  }
  vtkSMPTools::Sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  std::vector<Edge> edges;
  for (const auto& [a, b] : pairs)
  {
    if (this->Sizes[a] > 0 && this->Sizes[b] > 0)
    {
      double x[3], y[3];
      this->GetPosition(a, x);
      this->GetPosition(b, y);
      edges.push_back(
        { a, b, static_cast<float>(std::sqrt(vtkMath::Distance2BetweenPoints(x, y))) });
    }
  }
  // Each sweep carries sizes on by an edge at least, until none changes.
  for (bool changed = true; changed;)
  {
    changed = false;
    for (const Edge& edge : edges)
    {
      float &a = this->Sizes[edge.A], &b = this->Sizes[edge.B];
      const float mostA = GetGraded(b, edge.Length), mostB = GetGraded(a, edge.Length);
      changed = changed || mostA < a || mostB < b;
      a = std::min(a, mostA);
      b = std::min(b, mostB);
    }
  }
}

VTK_ABI_NAMESPACE_END
