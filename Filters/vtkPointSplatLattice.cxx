// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatLattice.h"

#include "vtkPointSplatInput.h"
#include "vtkPointSplatLatticeLabels.h"
#include "vtkPointSplatLatticeLevels.h"
#include "vtkPointSplatThreads.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// Points at samples of the volume, at most: where all are, they fill a grid.
constexpr double MostAtSamples = 0.9;
/// Points of no triangle, at most: of an isosurface those that are its samples' alone, where it has no area.
constexpr double MostWithout = 0.02;

/// Normals that contradict the sides of one surface, at most: noise makes up to a hundredth do so, but of two surfaces in one
/// voxel all of one's do.
constexpr double MostContradicting = 0.1;
/// What is the same part of a voxel.
constexpr double SamePart = 1e-3;
/// Normals lie along the lattice's edges if their cosine is more than this (8 degrees): on boxes' faces all do, but of a mask's
/// isosurface at least this part does not, where it bends.
constexpr float AlongEdge = 0.99f;
constexpr double LeastTilted = 1e-3;

/// Voxels whose samples contradict one another though no point of a cut is in them, at most, of all points: of an isosurface
/// that a plane through its middle crops these are up to 7 hundredths.
constexpr double MostTorn = 0.1;
/// Points of such voxels that stay in no triangle, at most, counted voxel by voxel: of a surface that was cut off up to 6
/// hundredths do, but 23 of a mesh on a lattice whose triangles span several voxels where its volume was not known.
constexpr double MostTornWithout = 0.12;

constexpr int AtSample = vtkPointSplatLatticeCases::AtSample;
}

//------------------------------------------------------------------------------
vtkPointSplatLattice::Place vtkPointSplatLattice::GetPlace(vtkIdType id) const
{
  Place place;
  place.Id = id;
  for (int c = 0; c < 3; ++c)
  {
    const double x = this->Points.Positions[3 * id + c];
    place.IsPlane[c] = this->Axes[c].Has(x, place.Index[c]);
    place.Index[c] = place.IsPlane[c] ? place.Index[c] : this->Axes[c].GetFloor(x);
  }
  return place;
}

/// Of points on edges and at samples, and of those off these; returns false where too many are.
bool vtkPointSplatLattice::FindPlaces(std::vector<Place>& places, std::vector<Place>& off) const
{
  const vtkIdType count = static_cast<vtkIdType>(this->Points.Used.size());
  places.reserve(count);
  for (vtkIdType id = 0; id < count; ++id)
  {
    if (this->Points.Used[id])
    {
      const Place place = this->GetPlace(id);
      (place.IsOnEdge() ? places : off).push_back(place);
    }
  }
  return off.size() <= vtkPointSplatLatticePlanes::MostOff * (places.size() + off.size());
}

/// Returns false where a box in samples that contains all points has too many.
bool vtkPointSplatLattice::FindBox(const std::vector<Place>& places, const std::vector<Place>& off)
{
  for (int c = 0; c < 3; ++c)
  {
    std::int64_t first = std::numeric_limits<std::int64_t>::max(), last = std::numeric_limits<std::int64_t>::min();
    for (const std::vector<Place>* some : { &places, &off })
    {
      for (const Place& place : *some)
      {
        first = std::min(first, place.Index[c]);
        last = std::max(last, place.Index[c] + (place.IsPlane[c] ? 0 : 1));
      }
    }
    // Where nothing but samples are on its border, the surface may have a face between them, and it goes on beyond.
    const auto isClosed = [&](std::int64_t plane) {
      return std::none_of(places.begin(), places.end(), [&](const Place& place) {
        return place.Index[c] == plane && place.IsPlane[c] && place.GetAxis() != AtSample;
      });
    };
    this->First[c] = first - (isClosed(first) ? 1 : 0);
    this->Size[c] = last + (isClosed(last) ? 1 : 0) - this->First[c] + 3;
  }
  constexpr double most = 1e18;
  return 4.0 * this->Size[0] * this->Size[1] * this->Size[2] <= most;
}

/// The sample from which a point's edge or voxel goes on, row by row.
std::int64_t vtkPointSplatLattice::GetSample(const Place& place) const
{
  std::int64_t index[3];
  for (int c = 0; c < 3; ++c)
  {
    index[c] = place.Index[c] - this->First[c] + 1;
  }
  return (index[2] * this->Size[1] + index[1]) * this->Size[0] + index[0];
}

/// Adds a point on no edge to the voxels that it lies in: two, if it is in the face between them.
void vtkPointSplatLattice::AddOff(const Place& place)
{
  const std::int64_t voxel = this->GetSample(place);
  const std::int64_t strides[3] = { 1, this->Size[0], this->Size[0] * this->Size[1] };
  const bool* across = std::find(place.IsPlane, place.IsPlane + 3, true);
  if (across == place.IsPlane + 3)
  {
    this->Torn.Add(voxel, { place.Id, 0 });
    return;
  }
  const int axis = static_cast<int>(across - place.IsPlane);
  this->Torn.Add(voxel, { place.Id, vtkPointSplatLatticeTorn::GetFace(axis, 0) });
  this->Torn.Add(voxel - strides[axis], { place.Id, vtkPointSplatLatticeTorn::GetFace(axis, 1) });
}

/// Of all points, edge by edge along it; none where too many are on no edge.
bool vtkPointSplatLattice::FindCrossings()
{
  std::vector<Place> places, off;
  if (!this->FindPlaces(places, off) || !this->FindBox(places, off))
  {
    return false;
  }
  this->Crossings.resize(places.size());
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(places.size()), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      this->Crossings[i] = { 4 * this->GetSample(places[i]) + places[i].GetAxis(), places[i].Id };
    }
  });
  vtkSMPTools::Sort(this->Crossings.begin(), this->Crossings.end(), [&](const Crossing& a, const Crossing& b) {
    const auto getOrder = [&](const Crossing& crossing) {
      const int axis = static_cast<int>(crossing.Key % 4);
      return std::make_pair(axis == AtSample ? 0.0 : this->Points.Positions[3 * crossing.Id + axis], crossing.Id);
    };
    return a.Key != b.Key ? a.Key < b.Key : getOrder(a) < getOrder(b);
  });
  for (const Place& place : off)
  {
    this->AddOff(place);
  }
  this->Torn.Sort();
  return true;
}

/// Of points at the same sample the first one stays, and of those of a cut through a vertex. Returns false where others are at
/// the same place.
bool vtkPointSplatLattice::JoinPoints()
{
  std::size_t kept = 0;
  for (std::size_t i = 0; i < this->Crossings.size(); ++i)
  {
    const Crossing crossing = this->Crossings[i];
    const int axis = static_cast<int>(crossing.Key % 4);
    const bool another = kept == 0 || this->Crossings[kept - 1].Key != crossing.Key;
    const bool coincides = !another && axis != AtSample && this->GetBetween(i, axis) == 0;
    if (coincides && this->Torn.IsEmpty())
    {
      return false;
    }
    if (another || (axis != AtSample && !coincides))
    {
      this->Crossings[kept++] = crossing;
      this->Several = this->Several || !another;
      continue;
    }
    const vtkIdType first = this->Crossings[kept - 1].Id;
    if (this->Same.empty())
    {
      this->Same.resize(this->Points.Used.size());
      std::iota(this->Same.begin(), this->Same.end(), vtkIdType(0));
    }
    this->Same[crossing.Id] = first;
  }
  this->Crossings.resize(kept);
  const auto atSamples = std::count_if(this->Crossings.begin(), this->Crossings.end(),
    [](const Crossing& crossing) { return crossing.Key % 4 == AtSample; });
  return atSamples <= MostAtSamples * kept;
}

void vtkPointSplatLattice::FindRows()
{
  for (std::size_t i = 0; i < this->Crossings.size(); ++i)
  {
    const std::int64_t index = this->Crossings[i].Key / 4 / this->Size[0];
    if (this->Rows.empty() || this->Rows.back().Index != index)
    {
      this->Rows.push_back({ index, i, i });
    }
    this->Rows.back().Last = i + 1;
  }
}

/// A row that has points, or null.
const vtkPointSplatLattice::Row* vtkPointSplatLattice::GetRow(std::int64_t index) const
{
  const auto at = std::lower_bound(this->Rows.begin(), this->Rows.end(), index,
    [](const Row& row, std::int64_t i) { return row.Index < i; });
  return at != this->Rows.end() && at->Index == index ? &*at : nullptr;
}

/// Visits the voxels around a row that have no points in one before it.
template <typename Visitor>
bool vtkPointSplatLattice::March(const Row& row, const Visitor& visit) const
{
  const std::int64_t at = row.Index, below = at - this->Size[1];
  const bool left = this->GetRow(at - 1), under = this->GetRow(below);
  const bool before = this->GetRow(below - 1), behind = this->GetRow(below + 1);
  return this->MarchAlong(at, visit) && (left || this->MarchAlong(at - 1, visit)) &&
    (under || behind || this->MarchAlong(below, visit)) &&
    (left || under || before || this->MarchAlong(below - 1, visit));
}

/// Visits the voxels between a row and the next ones along y and z that have points, until visit(voxel) returns false, as is
/// returned.
template <typename Visitor>
bool vtkPointSplatLattice::MarchAlong(std::int64_t index, const Visitor& visit) const
{
  const std::int64_t y = index % this->Size[1], z = index / this->Size[1];
  // There is one sample more on each side than the box has.
  const bool within = y >= 1 && y < this->Size[1] - 2 && z >= 1 && z < this->Size[2] - 2;
  if (!within)
  {
    return true;
  }
  const Crossing* next[4];
  const Crossing* last[4];
  for (int r = 0; r < 4; ++r)
  {
    const Row* row = this->GetRow(index + (r & 1) + (r >> 1) * this->Size[1]);
    next[r] = this->Crossings.data() + (row ? row->First : 0);
    last[r] = this->Crossings.data() + (row ? row->Last : 0);
  }
  const auto getX = [this](const Crossing& crossing) { return crossing.Key / 4 % this->Size[0]; };
  for (std::int64_t x = 1; x < this->Size[0] - 2; ++x)
  {
    Voxel voxel;
    voxel.Index = index * this->Size[0] + x;
    std::int64_t nearest = this->Size[0];
    for (int r = 0; r < 4; ++r)
    {
      while (next[r] != last[r] && getX(*next[r]) < x)
      {
        ++next[r];
      }
      for (const Crossing* crossing = next[r]; crossing != last[r]; ++crossing)
      {
        const std::int64_t dx = getX(*crossing) - x;
        nearest = std::min(nearest, x + dx);
        if (dx > 1)
        {
          break;
        }
        const int corner = static_cast<int>(dx) + 2 * r;
        const int axis = static_cast<int>(crossing->Key % 4);
        if (axis == AtSample)
        {
          voxel.AddAt(corner, crossing->Id);
        }
        else if (!(corner & (1 << axis)))
        {
          voxel.AddCut(corner, axis, crossing->Id);
        }
      }
    }
    if (!voxel.Any)
    {
      x = std::max(x, nearest - 2); // the next voxel that has any
      continue;
    }
    if (!visit(voxel))
    {
      return false;
    }
  }
  return true;
}

/// Collects what visit(voxel, elements) adds, in the order of voxels; false where that returns false.
template <typename Element, typename Visitor>
bool vtkPointSplatLattice::VisitVoxels(std::vector<Element>& all, const Visitor& visit) const
{
  std::vector<std::vector<Element>> found(this->Rows.size());
  std::atomic<bool> whole{ true };
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(this->Rows.size()), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType r = begin; r < end && whole; ++r)
    {
      if (!this->March(this->Rows[r], [&](Voxel& voxel) { return visit(voxel, found[r]); }))
      {
        whole = false;
      }
    }
  });
  for (const std::vector<Element>& ofRow : found)
  {
    all.insert(all.end(), ofRow.begin(), ofRow.end());
  }
  return whole;
}

/// False where too many voxels within the box contradict themselves.
bool vtkPointSplatLattice::FindSides()
{
  this->FindRows();
  const float distances[3] = { static_cast<float>(this->Axes[0].Distance),
    static_cast<float>(this->Axes[1].Distance), static_cast<float>(this->Axes[2].Distance) };
  using Part = vtkPointSplatLatticeSides::Part;
  const std::size_t mostTorn = static_cast<std::size_t>(MostTorn * this->Crossings.size());
  std::atomic<std::size_t> torn{ 0 };
  if (!this->VisitVoxels(this->Sides, [&](Voxel& voxel, std::vector<Part>& parts) {
        const std::size_t before = parts.size();
        const bool found = voxel.FindParts(this->Points.Normals, distances, parts);
        if (!found)
        {
          parts.resize(before);
          if (!this->IsElsewhere(voxel))
          {
            parts.push_back(Part::MakeTorn(voxel.Index));
            return this->Torn.Has(voxel.Index) || ++torn <= mostTorn;
          }
        }
        return true;
      }))
  {
    return false;
  }
  const std::int64_t strides[3] = { 1, this->Size[0], this->Size[0] * this->Size[1] };
  vtkPointSplatLatticeSides::Settle(this->Sides, strides);
  return true;
}

/// Whether normals tell that the sides are those of one surface.
bool vtkPointSplatLattice::HasOneSurface() const
{
  double all = 0, against = 0;
  for (const vtkPointSplatLatticeSides::Part& part : this->Sides)
  {
    all += std::abs(part.Agreement);
    against += std::max(-part.Agreement, 0.0f);
  }
  return against <= MostContradicting * all;
}

bool vtkPointSplatLattice::HasTornVoxels() const
{
  return std::any_of(
    this->Sides.begin(), this->Sides.end(), [](const vtkPointSplatLatticeSides::Part& part) { return part.IsTorn(); });
}

void vtkPointSplatLattice::FindTriangles()
{
  this->VisitVoxels(this->Corners, [&](Voxel& voxel, std::vector<vtkIdType>& corners) {
    const vtkPointSplatLatticeSides::Range sides = vtkPointSplatLatticeSides::Find(this->Sides, voxel.Index);
    if (sides.First != sides.Last && sides.First->IsTorn())
    {
      this->Torn.AddTriangles(voxel, corners);
      return true;
    }
    voxel.SetSides(sides);
    voxel.AddTriangles(corners);
    return true;
  });
}

/// Whether the polygons of voxels that contradict themselves leave no more points out than those do in which a surface was cut off.
bool vtkPointSplatLattice::HasPolygons(const std::vector<unsigned char>& cornered) const
{
  if (!this->HasTornVoxels())
  {
    return true;
  }
  std::vector<vtkPointSplatLatticeTorn::Point> points;
  this->VisitVoxels(points, [&](const Voxel& voxel, std::vector<vtkPointSplatLatticeTorn::Point>& ofRow) {
    const vtkPointSplatLatticeSides::Range sides = vtkPointSplatLatticeSides::Find(this->Sides, voxel.Index);
    if (sides.First != sides.Last && sides.First->IsTorn())
    {
      const std::vector<vtkPointSplatLatticeTorn::Point> ofVoxel = this->Torn.GetPoints(voxel);
      ofRow.insert(ofRow.end(), ofVoxel.begin(), ofVoxel.end());
    }
    return true;
  });
  const auto without = std::count_if(
    points.begin(), points.end(), [&](const vtkPointSplatLatticeTorn::Point& point) { return !cornered[point.Id]; });
  return without <= MostTornWithout * points.size();
}

/// Whether all points of a voxel are another process'.
bool vtkPointSplatLattice::IsElsewhere(const Voxel& voxel) const
{
  const auto is = [this](vtkIdType id) {
    return id == Voxel::None || vtkPointSplatInput::IsDuplicate(this->Points.Ghosts, id);
  };
  return std::all_of(voxel.Cut, voxel.Cut + 12, is) && std::all_of(voxel.At, voxel.At + 8, is);
}

//------------------------------------------------------------------------------
/// Finds the planes across all axes.
bool vtkPointSplatLattice::FindPlanes()
{
  std::vector<double> samples[3];
  vtkPointSplatLatticePlanes::Sample(this->Points.Positions, this->Points.Used, samples);
  return !samples[0].empty() && vtkPointSplatLatticePlanes::Choose(samples, this->Axes) > 0;
}

/// Whether points lie equally far between planes, and normals along edges: as those of a grid on each of a box's faces do.
bool vtkPointSplatLattice::IsGrid() const
{
  std::vector<double> parts; // of a voxel, from the last plane
  std::size_t tilted = 0;
  const std::size_t count = this->Crossings.size();
  const std::size_t stride = vtkPointSplatLatticePlanes::GetStride(count);
  for (std::size_t i = 0; i < count; i += stride)
  {
    const Crossing& crossing = this->Crossings[i];
    const int axis = static_cast<int>(crossing.Key % 4);
    if (axis != AtSample)
    {
      parts.push_back(this->Axes[axis].GetPart(this->Points.Positions[3 * crossing.Id + axis]));
      const float* normal = this->Points.Normals + 3 * crossing.Id;
      const auto isAlong = [](float cosine) { return std::abs(cosine) >= AlongEdge; };
      tilted += !vtkPointSplatInput::IsZero(normal) && std::none_of(normal, normal + 3, isAlong) ? 1 : 0;
    }
  }
  if (tilted > LeastTilted * parts.size())
  {
    return false;
  }
  std::sort(parts.begin(), parts.end());
  const std::size_t most = parts.size() / 2;
  for (std::size_t i = most; i < parts.size(); ++i)
  {
    if (parts[i] - parts[i - most] < SamePart)
    {
      return true;
    }
  }
  return false;
}

/// From the point before to one, along an edge.
double vtkPointSplatLattice::GetBetween(std::size_t crossing, int axis) const
{
  const std::vector<double>& positions = this->Points.Positions;
  return positions[3 * this->Crossings[crossing].Id + axis] - positions[3 * this->Crossings[crossing - 1].Id + axis];
}

/// Whether there are edges with two points in one place, but none with points in several, and none at a sample: as where labels
/// touch.
bool vtkPointSplatLattice::HasLabels() const
{
  bool any = false;
  for (std::size_t i = 0; i < this->Crossings.size(); ++i)
  {
    const Crossing& crossing = this->Crossings[i];
    const int axis = static_cast<int>(crossing.Key % 4);
    if (axis == AtSample)
    {
      return false;
    }
    if (i > 0 && this->Crossings[i - 1].Key == crossing.Key)
    {
      if (this->GetBetween(i, axis) > SamePart * this->Axes[axis].Distance)
      {
        return false;
      }
      any = true;
    }
  }
  return any;
}

/// The triangles of one value's surface, or of several ones'.
bool vtkPointSplatLattice::FindSurface()
{
  if (!this->JoinPoints())
  {
    return false;
  }
  const bool haveSides = !this->Several && this->FindSides();
  const bool isOne = haveSides && this->HasOneSurface();
  if ((!this->Torn.IsEmpty() || this->HasTornVoxels()) && !isOne)
  {
    return false; // a surface that was cut off is one alone
  }
  if (this->Several || (haveSides && !isOne))
  {
    vtkPointSplatLatticeLevels levels(this->Crossings, this->Size, this->Points.Normals);
    if (levels.Find())
    {
      this->Corners = std::move(levels.Corners);
      return true;
    }
  }
  if (haveSides)
  {
    this->FindTriangles();
  }
  return haveSides;
}

/// The triangles of each label's.
bool vtkPointSplatLattice::FindLabels()
{
  vtkPointSplatLatticeLabels labels(this->Crossings, this->Size, this->Points.Normals);
  const bool found = labels.Find();
  this->Corners = std::move(labels.Corners);
  return found;
}

bool vtkPointSplatLattice::Find()
{
  if (!this->FindPlanes() || !this->FindCrossings() || this->IsGrid() ||
    !(this->Torn.IsEmpty() && this->HasLabels() ? this->FindLabels() : this->FindSurface()))
  {
    return false;
  }
  std::vector<unsigned char> cornered(this->Points.Used.size(), 0);
  for (const vtkIdType corner : this->Corners)
  {
    cornered[corner] = 1;
  }
  const auto without = std::count_if(this->Crossings.begin(), this->Crossings.end(),
    [&](const Crossing& crossing) {
      return !cornered[crossing.Id] && !vtkPointSplatInput::IsDuplicate(this->Points.Ghosts, crossing.Id);
    });
  return without <= MostWithout * this->Crossings.size() && this->HasPolygons(cornered);
}

VTK_ABI_NAMESPACE_END
