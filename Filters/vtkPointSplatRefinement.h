// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPointSplatRefinement
 * @brief   fill points: splats between points that are farther apart than their splats are large
 *
 * An internal helper of vtkPointSplatEstimation; see the stages there.
 *
 * 1. An edge of the stars' triangles (vtkPointSplatStars.h) that is longer than LongEdge times the mean of
 *    its ends' sizes is divided: a point is put in its middle. Both triangles at an edge get the same one.
 * 2. A triangle whose longest such edge was divided makes two, until all edges are short enough. The longest
 *    edges, by powers of two, are divided first, and of these one after the other along a curve that fills space, so that
 *    what is near is near in memory, too. What is made depends on what is near, and but for ties not on the order of points.
 *    Sizes are graded to the middle from both ends, and at most ShareOfEdge of the edge.
 *    Where some point of about that size, a site or a fill point, lies within ShareOfSize of its place, that takes
 *    its: needles between a point and a dense row beside it have one row of fill points, and not each its own, and
 *    triangles that two sites see in different ways have the same. Of a mesh both share an end: what shares none may lie across
 *    a gap.
 *    Then sizes are graded across the triangles that are left, too, to within MostGraded, and what is long by that divided.
 * 3. A fill point's normal is the mean of the ends'. The second one's is turned, as normals that are not
 *    consistently oriented have to be, where it points against the first one's mirror image and its part across
 *    the edge against the first one's; the disk's plane goes through the edge. Between ends whose normals lean the same way from
 *    it, as on an arc, it is lifted by what an arc rises over its chord, a quarter of the length times the lesser of
 *    their sines; at an edge or a tip, where one end's normal is across it, it stays on the chord. Along
 *    the edge it is curved as the ends' normals say, and across it as the ends are in the mean, weighted by the
 *    squares of their sizes: a fillet's curvature says nothing of the face beside it. Half way to a tip it is twice that of
 *    the other end.
 * 4. *Cover.* The splats of the triangles that remain are larger, in the same proportion, where those of its three
 *    corners do not cover one together; sizes stay as they are. A mesh's triangle stays where it was, though other points stand for
 *    its corners: of a strip that is narrower than they are large these lie in one row, and the strip's other side is to be covered, too.
 * 5. Ends, and weights of them, tell what else a fill point has: of up to three sites.
 *
 * Numbers of fill points depend on the triangles alone, and not on what is drawn: there are none where
 * sites are even.
 */
#ifndef vtkPointSplatRefinement_h
#define vtkPointSplatRefinement_h

#include "vtkPointSplatStars.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkPointSplatRefinement
{
public:
  using Site = vtkPointSplatStars::Site;

  /// Normals whose mean is shorter nearly cancel, and have none.
  static constexpr double LeastMean = 1e-3;

  struct Point
  {
    double X[3]; // world coordinates
    float Normal[3], Plane[3]; // unit length
    float Curvature[6];        // as vtkPointSplatCurvature's
    float Clip[6];             // its lines, as in the array
    float Size;
    float Cover;               // by how much its splat is larger than its size asks for
    bool Tip;                  // whether it is a site of Stars.Tips
    int Count;                 // of ends
    Site Ends[3];
    float Weights[3];          // their sum is 1
  };

  /// normals: 3 floats a site, unit length; curvatures: 6.
  vtkPointSplatRefinement(
    const vtkPointSplatStars& stars, const float* normals, const float* curvatures);

  /// Of a mesh, gives the largest radius that the splat of a fill point has room for.
  std::function<float(const Point&)> GetRoom;

  /// Returns false if more than most points are to be made, or are expected to be.
  bool Make(std::size_t most);

  std::vector<Point> Points;
  std::vector<float> Covers; // the same of each site

private:
  using Index = std::uint64_t; // a site, or a fill point's number from FirstIndex on
  static constexpr Index FirstIndex = Index(1) << 32;
  using Place = std::array<double, 3>;
  /// Where a triangle has a corner, and the point that it is, or that stands for it.
  struct Corner
  {
    Index Of;
    Place At;
    bool operator<(const Corner& other) const
    {
      return this->Of != other.Of ? this->Of < other.Of : this->At < other.At;
    }
  };
  using Corners = std::array<Corner, 3>; // of a triangle
  /// A cell's place along a curve that fills space, and its level; two cells that share one hold points that are far from
  /// one another.
  using Key = std::uint64_t;

  /// A triangle to be divided at the first edge, its longest one.
  struct Part
  {
    Key Where; // the middle, along a curve
    double Length;
    Place Middle; // a square's diagonals have the same
    Corners Of;
    int Divisions;
    bool operator<(const Part& other) const
    {
      return std::tie(this->Where, other.Length, this->Middle, this->Of) <
        std::tie(other.Where, this->Length, other.Middle, other.Of);
    }
  };
  void Add(const Corners& corners, int divisions);
  double CountExpected() const;
  void InsertSites();

  Point Get(Index index) const;
  float GetSize(Index index) const;
  bool IsLong(const Corner& a, const Corner& b, double& length) const;
  /// The point in an edge's middle, and how far that is off the chord's.
  struct Middle
  {
    Index Of;
    Place Rise;
  };
  Middle AddMiddle(Index a, Index b, const Point& made);
  void DivideEdges(const Part* first, const Part* last);
  Corner Divide(const Corner& a, const Corner& b);
  Point MakeMiddle(const Point& p, const Point& q) const;
  void AddEnds(const Point& of, Point& to) const;
  float GetCover(const Corners& corners) const;
  void Cover();
  bool Grade();
  bool DivideAll(std::size_t most);

  const vtkPointSplatStars& Stars;
  const float* Normals;
  const float* Curvatures;
  struct Hash
  {
    std::size_t operator()(const std::pair<Index, Index>& edge) const
    {
      return std::hash<Index>()(edge.first * 0x9e3779b97f4a7c15u ^ edge.second);
    }
  };
  std::unordered_map<std::pair<Index, Index>, Middle, Hash> Middles;
  std::map<int, std::vector<Part>> Parts; // by their lengths' exponents
  std::vector<Corners> Undivided;         // triangles

  /// Points in cells of a grid about as wide as they are large, one for each power of two and the next ones.
  struct Cell
  {
    int Level;
    std::array<std::int64_t, 3> Place;
  };
  struct Entry
  {
    Key In;
    Index Of;
    std::size_t Next; // of those that share a place of the table, or None
  };
  static constexpr std::size_t None = std::numeric_limits<std::size_t>::max();
  static Cell FindCell(const double x[3], int level);
  static Key GetKey(const Cell& cell);
  std::size_t GetIndex(Key key) const;
  void Insert(Index index, const double x[3], float size);
  void Enter(std::size_t entry);
  bool IsOfOne(const Point& point, Index other) const;
  bool FindNear(const Point& point, Index& found) const;
  const float* GetPlace(Index index, double x[3]) const;
  std::vector<Entry> Entries;
  std::vector<std::size_t> Table; // of the first entries
};

VTK_ABI_NAMESPACE_END
#endif
