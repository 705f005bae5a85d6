// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Of the estimates: stage 6, fill.
#include "vtkPointSplatEstimates.h"

#include "vtkMath.h"
#include "vtkPointSet.h"
#include "vtkPointSplatCurvature.h"
#include "vtkPointSplatEstimation.h"
#include "vtkPointSplatFoldSides.h"
#include "vtkPoints.h"
#include "vtkPointSplatThreads.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// How many fill points there are at most for each point, and besides; parts of few triangles have long edges and fine fillets.
constexpr std::size_t MostPerPoint = 4;
constexpr std::size_t MostOfFew = 4096;
constexpr std::size_t MostOfMesh = 65536;
/// Of an isosurface's vertices no size is less than this part of the median: where values differ by much from sample to sample,
/// as labels do, up to six lie together at a voxel's corner, and are as good as one (Testing/Accuracy/fit_constants.py).
constexpr float LatticeGrain = 0.1f;
/// What part of the turn of normals that are shaded with counts as the surface's bend (Testing/Accuracy/fit_constants.py).
constexpr float TurnShare = 0.6f;
}

/// Finds the sites of a cloud that are uneven, and that the surface goes on where only a denser part of the points ends.
bool vtkPointSplatEstimates::FindStars()
{
  if (this->MeshAlone)
  {
    return true;
  }
  const Slot slots = this->Neighbors.GetNumberOfSlots();
  this->Stars = std::make_unique<vtkPointSplatStars>(
    slots, [this](Slot s, double x[3]) { this->Neighbors.GetPosition(s, x); });
  this->Disks->TrustNormals();
  vtkPointSplatThreads::For(0, slots, [this](vtkIdType begin, vtkIdType end) {
    for (Slot s = static_cast<Slot>(begin); s < static_cast<Slot>(end); ++s)
    {
      if (this->Searched[s])
      {
        this->Stars->SetSize(s,
          { this->Disks->Distance[s], this->Disks->Turn[s], this->Disks->Farthest[s] },
          this->MayBend(s));
      }
    }
  });
  vtkPointSplatLargeArray<const vtkPointSplatCreases::Splat*> creased(slots, nullptr);
  for (const vtkPointSplatCreases::Splat& splat : this->Creases->Splats)
  {
    creased[splat.At] = &splat;
  }
  const vtkPointSplatStars::Cloud cloud{ &this->Neighbors, this->Directions, this->Disks.get(),
    this->Borders.get(), this->Creases.get(), &creased, this->Self->GetNumberOfNeighbors(), [this](Slot s) { return this->MayBend(s); } };
  if (!this->Stars->Find(this->Self, cloud))
  {
    return false;
  }
  this->Borders->Reopen(this->Stars->FindContinued(cloud));
  return true;
}

void vtkPointSplatEstimates::FindFill()
{
  if (this->MeshAlone)
  {
    if (this->FillsMesh())
    {
      this->FindMeshFill();
    }
    return;
  }
  if (!this->FillsNoise())
  {
    return;
  }
  const std::vector<float> covers =
    this->Refine(*this->Stars, this->SlotNormals.data(), this->Disks->Curvatures.data());
  for (Slot s = 0; s < this->Neighbors.GetNumberOfSlots(); ++s)
  {
    if (this->Stars->Uneven[s])
    {
      this->Disks->Shrink(s, covers[s] * this->Stars->GetRadius(s));
    }
  }
}

/// Finds how a mesh's disks end, and makes them no larger than its faces have room for. Arrays have them as they were, until
/// Write().
void vtkPointSplatEstimates::BoundMesh()
{
  if (!this->MeshAlone || this->Fans.GetBorder().empty())
  {
    return;
  }
  for (vtkIdType id = 0; id < this->NumberOfPoints; ++id)
  {
    this->Sizes[0]->SetValue(id, this->Corners[id].Radius);
    std::copy_n(this->Corners[id].Plane, 3, this->Planes->GetPointer(3 * id));
  }
  const std::vector<unsigned char> creased = this->GetSlotsAtCreases();
  this->Outline = std::make_unique<vtkPointSplatMeshOutline>(this->Fans);
  const vtkPointSplatMeshBorders borders(this->Fans, this->Sizes[0], this->Planes);
  this->Near = borders.FindNear();
  this->Ends = borders.FindEnds(this->Near, this->FillsMesh());
  for (const vtkPointSplatMeshBorders::End& end : this->Ends)
  {
    vtkPointSplatFans::Disk& disk = this->Corners[end.Id];
    if (end.Room < disk.Radius && !this->IsAt(creased, end.Id))
    {
      disk.Radius = end.Room;
      this->Bounded.push_back(end.Id);
    }
  }
}

/// The same for a mesh, whose triangles tell the stars.
void vtkPointSplatEstimates::FindMeshFill()
{
  const std::vector<unsigned char> creased = this->GetSlotsAtCreases();
  vtkPointSplatStars stars(this->NumberOfPoints, [this](Slot id, double x[3]) {
    std::copy_n(this->Fans.GetPosition(id), 3, x);
  });
  std::vector<float> curvatures(std::size_t(6) * this->NumberOfPoints, 0.0f);
  for (vtkIdType id = 0; id < this->NumberOfPoints; ++id)
  {
    const vtkPointSplatFans::Disk& disk = this->Corners[id];
    const Slot site = static_cast<Slot>(id);
    stars.SetSize(site, { disk.Distance, disk.Turn, disk.Farthest }, true);
    std::copy_n(disk.Curvature, 6, curvatures.data() + 6 * id);
    if (this->IsAt(creased, id))
    {
      stars.Uneven[site] = 0;
      continue;
    }
    stars.BoundBent(site, vtkPointSplatStars::GetBent(vtkPointSplatCurvature::GetBend(disk.Curvature), disk.Width), disk.Radius);
    stars.BoundBent(site, vtkPointSplatStars::GetBent(disk.Beside.Amount, disk.Beside.Within), disk.Radius);
    stars.BoundBent(site, vtkPointSplatStars::GetBent(TurnShare * this->GetTurn(id), disk.Width), disk.Radius);
    this->Fans.VisitNeighbors(id, [&](vtkIdType other) {
      stars.BoundBent(site, this->GetBeside(this->Fans.GetPosition(id), other), disk.Radius);
    });
    if (disk.Tip)
    {
      stars.BoundTip(site, disk.Radius);
    }
    if (stars.StandsOff(site, disk.Turn, disk.Radius))
    {
      stars.Uneven[site] = 1;
    }
  }
  for (const vtkIdType id : this->Bounded)
  {
    stars.Bound(static_cast<Slot>(id), this->Corners[id].Radius);
  }
  stars.Find(this->Fans, [&](Slot id) { return this->IsAt(creased, id) ? 0 : this->Corners[id].Radius; });
  const std::vector<float> covers =
    this->Refine(stars, this->Normals->GetPointer(0), curvatures.data());
  for (vtkIdType id = 0; id < this->NumberOfPoints; ++id)
  {
    if (stars.Uneven[id])
    {
      this->Corners[id].Radius = covers[id] * stars.GetRadius(static_cast<Slot>(id));
    }
  }
}

/// How fast the normals to shade with turn at a point of a mesh that was split, 1 / world units: disks' own ones do not tell
/// them.
float vtkPointSplatEstimates::GetTurn(vtkIdType id) const
{
  double largest = 0;
  if (this->Fans.IsSplit() && !this->Split.Normals.empty())
  {
    const float* own = this->Split.GetNormal(id);
    this->Fans.VisitNeighbors(id, [&](vtkIdType other) {
      const double squared = vtkMath::Distance2BetweenPoints(this->Fans.GetPosition(id), this->Fans.GetPosition(other));
      const double turn = vtkMath::Distance2BetweenPoints(own, this->Split.GetNormal(other));
      largest = squared > 0 ? std::max(largest, turn / squared) : largest;
    });
  }
  return static_cast<float>(std::sqrt(largest));
}

/// How a fill point of a mesh ends at its borders.
vtkPointSplatMeshBorders::End vtkPointSplatEstimates::FindEnd(
  const vtkPointSplatRefinement::Point& point, float radius)
{
  return vtkPointSplatMeshBorders(this->Fans, this->Sizes[0], this->Planes)
    .FindEnd({ point.X, point.Plane, radius },
      { { point.Ends, point.Ends + point.Count }, this->Near, *this->Outline });
}

/// The largest size of a place as near as that to what bends beside a vertex.
float vtkPointSplatEstimates::GetBeside(const double x[3], vtkIdType id) const
{
  const vtkPointSplatFans::Bend& bend = this->Corners[id].Beside;
  double way[3];
  vtkMath::Subtract(x, this->Fans.GetPosition(id), way);
  const double across = way[0] * bend.Way[0] + way[1] * bend.Way[1] + way[2] * bend.Way[2];
  return vtkPointSplatStars::GetGraded(
    vtkPointSplatStars::GetBent(bend.Amount, bend.Within), static_cast<float>(std::abs(across)));
}

/// The largest radius that a fill point of a mesh may have where the surface bends and ends.
float vtkPointSplatEstimates::GetRoom(const vtkPointSplatStars& stars, const vtkPointSplatRefinement::Point& point)
{
  float smallest = point.Size, beside = point.Size; // sizes of its ends, and by what bends beside them
  for (int k = 0; k < point.Count; ++k)
  {
    smallest = std::min(smallest, stars.Sizes[point.Ends[k]]);
    beside = std::min(beside, this->GetBeside(point.X, point.Ends[k]));
  }
  const float bent = vtkPointSplatStars::GetBent(vtkPointSplatCurvature::GetBend(point.Curvature));
  const float radius = vtkPointSplatStars::GetRadius(std::min(beside, std::max(bent, smallest)));
  return this->Fans.GetBorder().empty() ? radius : std::min(radius, this->FindEnd(point, radius).Room);
}

/**
 * Makes no more fill points than MostPerPoint for a point: where sizes differ by much within a few points, as of
 * copies of a cloud that are not quite the same, these are as good as one. What is less than a quarter of the median makes next
 * to no difference then. Returns by how much sites' splats are larger.
 */
std::vector<float> vtkPointSplatEstimates::Refine(
  vtkPointSplatStars& stars, const float* normals, const float* curvatures)
{
  const std::size_t most =
    MostPerPoint * static_cast<std::size_t>(this->NumberOfPoints) + (this->MeshAlone ? MostOfMesh : MostOfFew);
  const float median = stars.GetMedianSize();
  const float grain = this->OfLattice ? LatticeGrain : vtkPointSplatSheet::Grain;
  for (float least = grain * median;; least = std::max(0.25f * median, 4 * least))
  {
    stars.RaiseSizes(least);
    vtkPointSplatRefinement fill(stars, normals, curvatures);
    if (this->MeshAlone)
    {
      fill.GetRoom = [&](const vtkPointSplatRefinement::Point& point) {
        return std::max(this->GetRoom(stars, point), vtkPointSplatStars::GetRadius(least));
      };
    }
    if (fill.Make(most))
    {
      this->TakeFill(fill);
      return fill.Covers;
    }
  }
}

/// Fill points belong to the end that they are nearest to; those of other processes' points are theirs.
void vtkPointSplatEstimates::TakeFill(const vtkPointSplatRefinement& fill)
{
  vtkDataArray* points = this->Input->GetPoints()->GetData();
  for (vtkPointSplatRefinement::Point point : fill.Points)
  {
    int nearest = 0;
    double place[3] = { 0, 0, 0 };
    for (int k = 0; k < point.Count; ++k)
    {
      if (!this->MeshAlone)
      {
        point.Ends[k] = static_cast<Slot>(this->Neighbors.GetId(point.Ends[k]));
      }
      double x[3];
      points->GetTuple(point.Ends[k], x);
      const float weight = point.Weights[k], most = point.Weights[nearest];
      // Of two that are as near it is the same one for all processes.
      if (k == 0 || weight > most ||
        (weight == most && std::lexicographical_compare(x, x + 3, place, place + 3)))
      {
        nearest = k;
        std::copy_n(x, 3, place);
      }
    }
    if (this->IsDrawn(point.Ends[nearest]))
    {
      std::swap(point.Ends[0], point.Ends[nearest]);
      std::swap(point.Weights[0], point.Weights[nearest]);
      point.Size = this->GetScaled(point.Cover * vtkPointSplatStars::GetRadius(point.Size));
      this->Fill.push_back(point);
    }
  }
}

/// A fill point in the place of another point, with its normal.
vtkPointSplatRefinement::Point vtkPointSplatEstimates::MakeFillAt(vtkIdType id) const
{
  vtkPointSplatRefinement::Point point{};
  this->Input->GetPoint(id, point.X);
  this->Normals->GetTypedTuple(id, point.Normal);
  point.Count = 1;
  point.Ends[0] = static_cast<Slot>(id);
  point.Weights[0] = 1;
  return point;
}

/// Adds those of points on edges whose splats are too small on one side. They have their own lines.
void vtkPointSplatEstimates::AddFoldSides()
{
  const vtkPointSplatFoldSides finder(
    this->Neighbors, [this](Slot s) { return this->Disks->GetBounded(s); });
  for (const vtkPointSplatFoldSides::Side& side : finder.Find(this->Creases->Splats))
  {
    const vtkIdType id = this->Neighbors.GetId(side.Edge->At);
    if (!this->IsDrawn(id))
    {
      continue;
    }
    vtkPointSplatRefinement::Point point = this->MakeFillAt(id);
    // Turned as that is whose curvature it takes.
    const float turn = vtkMath::Dot(side.Plane, side.Next->Normal) < 0 ? -1.0f : 1.0f;
    std::transform(side.Plane, side.Plane + 3, point.Plane, [turn](float v) { return turn * v; });
    std::copy_n(side.Next->Tensor, 6, point.Curvature);
    std::copy_n(side.Clip, 3, point.Clip);
    point.Size = this->GetScaled(this->Disks->GetBounded(side.Next->At));
    this->Fill.push_back(point);
  }
}

void vtkPointSplatEstimates::MakeFill()
{
  if (this->NumberOfPoints == 0)
  {
    return;
  }
  const std::vector<vtkIdType>& sources = this->Split.Sources;
  const vtkIdType own = this->NumberOfPoints - static_cast<vtkIdType>(sources.size());
  const auto add = [&](vtkIdType id, const float* clip) {
    if (!(this->Sizes[0]->GetValue(id) > 0))
    {
      return; // it is not drawn
    }
    vtkPointSplatRefinement::Point point = this->MakeFillAt(id);
    point.Size = this->Sizes[0]->GetValue(id);
    this->Planes->GetTypedTuple(id, point.Plane);
    this->Curvatures->GetTypedTuple(id, point.Curvature);
    if (clip)
    {
      std::copy_n(clip, 6, point.Clip);
    }
    this->Fill.push_back(point);
  };
  for (vtkIdType id = own; id < this->NumberOfPoints; ++id)
  {
    add(id, this->Clips->GetNumberOfTuples() > 0 ? this->Clips->GetPointer(6 * id) : nullptr);
  }
  const std::vector<unsigned char> creased = this->GetSlotsAtCreases();
  for (const vtkPointSplatMeshBorders::End& end : this->Ends)
  {
    if (end.IsTwo() && !this->IsAt(creased, end.Id))
    {
      add(end.Id, end.Other);
    }
  }
  for (vtkPointSplatRefinement::Point& point : this->Fill)
  {
    for (int k = 0; k < point.Count; ++k)
    {
      vtkIdType end = point.Ends[k];
      point.Ends[k] = static_cast<Slot>(end < own ? end : sources[end - own]);
    }
  }
  for (vtkFloatArray* array : { this->Normals.Get(), this->Sizes[0].Get(), this->Planes.Get(), this->Curvatures.Get(),
         this->Clips.Get(), this->Folds.Get() })
  {
    if (array->GetNumberOfTuples() > 0)
    {
      array->SetNumberOfTuples(own);
    }
  }
  this->TakeShadingNormals();
  this->TurnPlanes();
}

/// Those of points that were split, and of fill points between these.
void vtkPointSplatEstimates::TakeShadingNormals()
{
  const std::vector<float>& normals = this->Split.Normals;
  if (normals.empty())
  {
    return;
  }
  std::copy(normals.begin(), normals.end(), this->Normals->GetPointer(0));
  for (vtkPointSplatRefinement::Point& point : this->Fill)
  {
    float sum[3] = { 0, 0, 0 };
    for (int k = 0; k < point.Count; ++k)
    {
      for (int c = 0; c < 3; ++c)
      {
        sum[c] += point.Weights[k] * this->Split.GetNormal(point.Ends[k])[c];
      }
    }
    if (vtkMath::Normalize(sum) > vtkPointSplatRefinement::LeastMean)
    {
      std::copy_n(sum, 3, point.Normal);
    }
  }
}

/// Turns planes to their normals' side, unless triangles tell the front.
void vtkPointSplatEstimates::TurnPlanes()
{
  if (this->Split.TellsFront)
  {
    return;
  }
  const auto turn = [](const float* normal, float* plane, float* curvature) {
    if (vtkMath::Dot(plane, normal) < 0)
    {
      std::transform(plane, plane + 3, plane, std::negate<float>());
      std::transform(curvature, curvature + 6, curvature, std::negate<float>());
    }
  };
  vtkPointSplatThreads::For(0, this->Planes->GetNumberOfTuples(), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType id = begin; id < end; ++id)
    {
      turn(this->GetNormal(id), this->Planes->GetPointer(3 * id), this->Curvatures->GetPointer(6 * id));
    }
  });
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(this->Fill.size()), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      turn(this->Fill[i].Normal, this->Fill[i].Plane, this->Fill[i].Curvature);
    }
  });
}

VTK_ABI_NAMESPACE_END
