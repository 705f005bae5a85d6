// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatMeshFaces.h"

#include "vtkCellArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointSplatFans.h"
#include "vtkPointSplatInput.h"
#include "vtkPointSplatThreads.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkTriangle.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// Of a mesh's sharp edges, what part are a flat face's if it has such: scans' triangles just differ (fitted by
/// Testing/Accuracy/fit_constants.py).
constexpr double LeastFlat = 0.45;
/// Or what part are of less than 45 degrees, if bends and sharp edges are two things (fitted there, too).
constexpr double MostBends = 0.1;
/// How many triangles are looked at, if so many sharp edges are found at these.
constexpr vtkIdType MostLookedAt = 10000;
constexpr std::size_t Enough = 100;
/// Thinner triangles than that, of their longest edge, say nothing of a round surface (fitted there, too).
constexpr double SliverShare = 0.1;
/// Needles thinner than that have normals of their coordinates' rounding, as where a surface's first row is there again as its
/// last.
constexpr double NeedleShare = 1e-4; // Testing/Python/TestVersions.py
/// Of how many of a mesh's corners the order tells the side of their normals where it does.
constexpr double LeastOrdered = 0.9;

double GetCosine(double angle)
{
  return std::cos(vtkMath::RadiansFromDegrees(angle));
}

/// How two triangles that share an edge meet there.
struct Fold
{
  double Sine, Cosine; // of the angle between their normals, as if both were turned the same way

  Fold(const vtkPointSplatFans& fans, const vtkIdType a[3], const vtkIdType b[3])
  {
    double n[3], m[3], across[3];
    vtkTriangle::ComputeNormalDirection(fans.GetPosition(a[0]), fans.GetPosition(a[1]), fans.GetPosition(a[2]), n);
    vtkTriangle::ComputeNormalDirection(fans.GetPosition(b[0]), fans.GetPosition(b[1]), fans.GetPosition(b[2]), m);
    vtkMath::Cross(n, m, across);
    const double lengths = vtkMath::Norm(n) * vtkMath::Norm(m);
    this->Sine = vtkMath::Norm(across) / lengths;
    this->Cosine = vtkMath::Dot(n, m) / lengths;
    for (int k = 0; k < 3; ++k)
    {
      const auto* end = std::find(b, b + 3, a[k]);
      if (end != b + 3 && b[(end - b + 1) % 3] == a[(k + 1) % 3])
      {
        this->Cosine = -this->Cosine; // both go along the edge the same way
      }
    }
  }
};

/// Calls visitor(other) for the triangles that a triangle shares edges with; both are told by where their corners begin.
template <typename Visitor>
void VisitBeside(const vtkPointSplatFans& fans, const vtkIdType own[3], const Visitor& visitor)
{
  for (int k = 0; k < 3; ++k)
  {
    const vtkIdType ends[2] = { own[k], own[(k + 1) % 3] };
    // Fans of thousands meet in a point.
    const int few = fans.GetNumberOfTriangles(ends[0]) < fans.GetNumberOfTriangles(ends[1]) ? 0 : 1;
    fans.VisitTriangles(ends[few], [&](const vtkIdType other[3]) {
      if (other != own && std::find(other, other + 3, ends[1 - few]) != other + 3)
      {
        visitor(other);
      }
    });
  }
}

/// Whether a triangle lies in a plane with one beside it.
bool IsFlat(const vtkPointSplatFans& fans, const vtkIdType own[3])
{
  bool flat = false;
  VisitBeside(fans, own, [&](const vtkIdType* other) {
    if (!flat)
    {
      const Fold fold(fans, own, other);
      flat = fold.Sine <= vtkPointSplatFans::FlatSine && fold.Cosine > 0;
    }
  });
  return flat;
}

/// Whether a triangle is so thin that its normal says nothing of the surface, unless that is of flat faces.
bool IsSliver(const vtkPointSplatFans& fans, const vtkIdType own[3])
{
  const vtkPointSplatFans::Shape shape = fans.GetShape(own);
  return shape.Height < SliverShare * shape.Longest;
}

/// Edges of more than 30 degrees; of them those of flat triangles, those of less than 45 degrees, and those sharper than
/// that between triangles that tell of the surface.
struct Count
{
  std::atomic<std::size_t> Edges{ 0 }, OfFlat{ 0 }, Bends{ 0 }, Sharper{ 0 };

  /// stride: looks at one in so many triangles.
  Count(const vtkPointSplatFans& fans, vtkIdType stride)
  {
    const double least = GetCosine(vtkPointSplatMeshFaces::FlatAngle);
    const double sharper = GetCosine(vtkPointSplatMeshFaces::RoundAngle);
    const std::vector<vtkIdType>& corners = fans.GetCorners();
    const vtkIdType count = (static_cast<vtkIdType>(corners.size() / 3) + stride - 1) / stride;
    vtkPointSplatThreads::For(0, count, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const vtkIdType* own = corners.data() + 3 * stride * i;
        VisitBeside(fans, own, [&](const vtkIdType* other) {
          const double cosine = other > own ? Fold(fans, own, other).Cosine : 1;
          if (cosine < least)
          {
            ++this->Edges;
            this->OfFlat += IsFlat(fans, own) || IsFlat(fans, other);
            this->Bends += cosine >= sharper;
            this->Sharper += cosine < sharper && !IsSliver(fans, own) && !IsSliver(fans, other);
          }
        });
      }
    });
  }

  vtkPointSplatMeshFaces::Edges Get() const
  {
    const bool flat = this->OfFlat > LeastFlat * this->Edges || this->Bends < MostBends * this->Edges;
    return { flat, flat || this->Sharper > 0, false };
  }
};

using Direction = std::array<float, 3>;

std::vector<Direction> GetDirections(const vtkPointSplatFans& fans, const std::vector<vtkIdType>& corners)
{
  std::vector<Direction> directions(corners.size() / 3);
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(directions.size()), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType t = begin; t < end; ++t)
    {
      const vtkIdType* own = corners.data() + 3 * t;
      double n[3];
      vtkTriangle::ComputeNormal(fans.GetPosition(own[0]), fans.GetPosition(own[1]), fans.GetPosition(own[2]), n);
      std::copy_n(n, 3, directions[t].begin());
    }
  });
  return directions;
}

/// The triangles' unit normals, turned the same way.
std::vector<Direction> GetTurned(const vtkPointSplatFans& fans)
{
  vtkNew<vtkPolyDataNormals> filter;
  filter->SetInputData(fans.MakeMesh());
  filter->SplittingOff();
  filter->ComputePointNormalsOff();
  filter->Update();
  std::vector<vtkIdType> corners;
  vtkCellArray* polygons = filter->GetOutput()->GetPolys();
  for (vtkIdType t = 0; t < polygons->GetNumberOfCells(); ++t)
  {
    vtkIdType count;
    const vtkIdType* ids;
    polygons->GetCellAtId(t, count, ids);
    corners.insert(corners.end(), ids, ids + count);
  }
  return GetDirections(fans, corners);
}

/// The same, turned to where points' normals are, unless the order of corners tells that for most of them, as is found.
std::vector<Direction> GetTurned(
  const vtkPointSplatFans& fans, std::vector<Direction> directions, const float* normals, bool& ordered)
{
  const std::vector<vtkIdType>& corners = fans.GetCorners();
  std::vector<unsigned char> against(directions.size(), 0);
  std::atomic<std::size_t> agree{ 0 };
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(directions.size()), [&](vtkIdType begin, vtkIdType end) {
    std::size_t here = 0;
    for (vtkIdType t = begin; t < end; ++t)
    {
      float sum = 0;
      for (int k = 0; k < 3; ++k)
      {
        const float cosine = vtkMath::Dot(directions[t].data(), normals + 3 * corners[3 * t + k]);
        here += cosine >= 0;
        sum += cosine;
      }
      against[t] = sum < 0;
    }
    agree += here;
  });
  ordered = agree >= LeastOrdered * corners.size();
  for (std::size_t t = 0; t < directions.size() && !ordered; ++t)
  {
    if (against[t])
    {
      vtkMath::MultiplyScalar(directions[t].data(), -1.0f);
    }
  }
  return directions;
}

/// Finds which of the triangles around a point are of one face.
class Around
{
public:
  Around(const vtkPointSplatFans& mesh, const std::vector<Direction>& directions, const vtkPointSplatMeshFaces::Edges& edges)
    : Mesh(mesh)
    , Directions(directions)
    , Least(GetCosine(edges.GetAngle()))
    , Slivers(directions.size(), 0)
    , Needles(directions.size(), 0)
  {
    vtkPointSplatThreads::For(0, static_cast<vtkIdType>(directions.size()), [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType t = begin; t < end; ++t)
      {
        const vtkPointSplatFans::Shape shape = mesh.GetShape(mesh.GetCorners().data() + 3 * t);
        this->Slivers[t] = !edges.OfFlat && shape.Height < SliverShare * shape.Longest;
        this->Needles[t] = shape.Height < NeedleShare * shape.Longest;
      }
    });
  }

  bool IsNeedle(std::size_t triangle) const { return this->Needles[triangle] != 0; }

  std::vector<std::size_t> Triangles; // around the point
  std::vector<int> Parts;             // of each, from 0 on
  int Count = 0;                      // of parts
  bool AreOrdered = true;             // whether, of all points', those that share an edge run along it both ways

  void Find(vtkIdType id)
  {
    this->Triangles.clear();
    this->Ends.clear();
    this->Mesh.VisitTriangles(id, [&](const vtkIdType own[3]) {
      const std::size_t at = this->Triangles.size();
      const auto first = std::find(own, own + 3, id) - own;
      this->Ends.push_back({ own[(first + 1) % 3], at, true });
      this->Ends.push_back({ own[(first + 2) % 3], at, false });
      this->Triangles.push_back((own - this->Mesh.GetCorners().data()) / 3);
    });
    this->Link();
    this->Parts.assign(this->Triangles.size(), -1);
    this->Count = 0;
    // Those with an edge of the border first, since of others all are around.
    for (const bool open : { true, false })
    {
      for (std::size_t t = 0; t < this->Triangles.size(); ++t)
      {
        if (this->Parts[t] < 0 && (!open || this->Beside[t][1] == None))
        {
          this->Walk(t);
        }
      }
    }
  }

private:
  static constexpr std::size_t None = static_cast<std::size_t>(-1);

  /// Which triangles share an edge at the point.
  void Link()
  {
    this->Beside.assign(this->Triangles.size(), { { None, None } });
    std::sort(this->Ends.begin(), this->Ends.end(), [](const End& a, const End& b) {
      return a.Id != b.Id ? a.Id < b.Id : a.Triangle < b.Triangle;
    });
    const auto link = [this](std::size_t from, std::size_t to) {
      this->Beside[from][this->Beside[from][0] == None ? 0 : 1] = to;
    };
    for (std::size_t i = 0, next; i < this->Ends.size(); i = next)
    {
      for (next = i + 1; next < this->Ends.size() && this->Ends[next].Id == this->Ends[i].Id;)
      {
        ++next;
      }
      if (next == i + 2)
      {
        link(this->Ends[i].Triangle, this->Ends[i + 1].Triangle);
        link(this->Ends[i + 1].Triangle, this->Ends[i].Triangle);
        this->AreOrdered = this->AreOrdered && this->Ends[i].IsNext != this->Ends[i + 1].IsNext;
      }
    }
  }

  bool IsSharp(std::size_t s, std::size_t t) const
  {
    const Direction &n = this->Directions[this->Triangles[s]], &m = this->Directions[this->Triangles[t]];
    return vtkMath::Dot(n.data(), m.data()) < this->Least;
  }

  /// Goes from triangle to triangle around the point.
  void Walk(std::size_t first)
  {
    const int firstPart = this->Count++;
    std::size_t before = None, at = first, told = None, firstTold = None;
    while (at != None && this->Parts[at] < 0)
    {
      if (!this->Slivers[this->Triangles[at]])
      {
        this->Count += told != None && this->IsSharp(told, at) ? 1 : 0;
        told = at;
        firstTold = firstTold == None ? at : firstTold;
      }
      this->Parts[at] = this->Count - 1;
      const std::size_t next = this->Beside[at][0] == before ? this->Beside[at][1] : this->Beside[at][0];
      before = at;
      at = next;
    }
    const int last = this->Count - 1;
    if (at == first && last > firstPart && !this->IsSharp(told, firstTold))
    {
      // All around, and the last ones are of the first one's.
      std::replace(this->Parts.begin(), this->Parts.end(), last, firstPart);
      --this->Count;
    }
  }

  const vtkPointSplatFans& Mesh;
  const std::vector<Direction>& Directions;
  const double Least;
  std::vector<unsigned char> Slivers, Needles; // triangles that tell nothing of the surface, and of themselves
  /// Of an edge at the point, and a triangle that it is of.
  struct End
  {
    vtkIdType Id;
    std::size_t Triangle;
    bool IsNext; // whether it follows the point in the order of the triangle's corners
  };
  std::vector<End> Ends;
  std::vector<std::array<std::size_t, 2>> Beside;      // of each triangle
};
}

vtkPointSplatMeshFaces::Edges vtkPointSplatMeshFaces::Look(const vtkPointSplatFans& mesh)
{
  const vtkIdType stride = 1 + static_cast<vtkIdType>(mesh.GetCorners().size() / 3) / MostLookedAt;
  const Count some(mesh, stride);
  const bool enough = some.Edges >= Enough && some.Get().AreSharp;
  return stride == 1 || enough ? some.Get() : Count(mesh, 1).Get();
}

vtkPointSplatMeshFaces::vtkPointSplatMeshFaces(
  const vtkPointSplatFans& mesh, const vtkPointSplatFans& joined, const Edges& edges, const float* normals)
{
  const std::vector<Direction> read = GetDirections(joined, joined.GetCorners());
  bool ordered = edges.Ordered;
  const std::vector<Direction> directions = ordered ? read
    : normals                                       ? GetTurned(joined, read, normals, ordered)
                                                    : GetTurned(joined);
  Around around(joined, directions, edges);
  std::vector<vtkIdType> ofJoined(joined.GetCorners().size());
  for (vtkIdType id = 0; id < joined.GetNumberOfPoints(); ++id)
  {
    around.Find(id);
    const std::size_t begin = this->Normals.size();
    this->Normals.resize(begin + 3 * around.Count, 0.0f);
    for (std::size_t t = 0; t < around.Triangles.size(); ++t)
    {
      const std::size_t triangle = around.Triangles[t];
      float* sum = this->Normals.data() + begin + 3 * around.Parts[t];
      const vtkIdType* own = joined.GetCorners().data() + 3 * triangle;
      if (!normals || !around.IsNeedle(triangle))
      {
        vtkMath::Add(sum, directions[triangle].data(), sum);
      }
      ofJoined[std::find(own, own + 3, id) - joined.GetCorners().data()] = (sum - this->Normals.data()) / 3;
    }
  }
  this->AreOrdered = ordered && (edges.Ordered || around.AreOrdered);
  vtkPointSplatThreads::For(0, static_cast<vtkIdType>(this->Normals.size() / 3), [this](vtkIdType begin, vtkIdType end) {
    for (vtkIdType corner = begin; corner < end; ++corner)
    {
      vtkMath::Normalize(this->Normals.data() + 3 * corner);
    }
  });
  const std::vector<vtkIdType>& corners = mesh.GetCorners();
  this->Corners.assign(corners.size(), None);
  this->Turned.assign(corners.size() / 3, 0);
  std::size_t next = 0;
  for (std::size_t i = 0; i < corners.size(); i += 3)
  {
    const vtkIdType a = joined.GetSame(corners[i]), b = joined.GetSame(corners[i + 1]), c = joined.GetSame(corners[i + 2]);
    if (a != b && b != c && c != a) // otherwise it has no area, and is none of those joined
    {
      std::copy_n(ofJoined.begin() + next, 3, this->Corners.begin() + i);
      this->Turned[i / 3] = vtkMath::Dot(read[next / 3].data(), directions[next / 3].data()) < 0;
      next += 3;
    }
  }
}

bool vtkPointSplatMeshFaces::GetNormal(vtkIdType corner, float normal[3]) const
{
  const float* found = this->Normals.data() + 3 * corner;
  if (vtkPointSplatInput::IsZero(found))
  {
    return false;
  }
  std::copy_n(found, 3, normal);
  return true;
}

VTK_ABI_NAMESPACE_END
