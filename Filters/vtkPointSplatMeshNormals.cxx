// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatMeshNormals.h"

#include "vtkCellArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSplatFans.h"
#include "vtkPointSplatInput.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkTriangle.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// Of a mesh's sharp edges, what part are a flat face's if it has faces: scans' triangles just differ (fitted by
/// Testing/Accuracy/fit_constants.py).
constexpr double LeastFlat = 0.45;
/// How many triangles are looked at, if so many sharp edges are found at these.
constexpr vtkIdType MostLookedAt = 10000;
constexpr std::size_t Enough = 100;
/// Of the angle from which on vtkPolyDataNormals splits (30 degrees), and a little less.
constexpr double SplitCosine = 0.87;

vtkSmartPointer<vtkCellArray> MakePolygons(const std::vector<vtkIdType>& corners)
{
  vtkNew<vtkIdTypeArray> ids;
  ids->SetNumberOfValues(static_cast<vtkIdType>(corners.size()));
  std::copy(corners.begin(), corners.end(), ids->GetPointer(0));
  auto polygons = vtkSmartPointer<vtkCellArray>::New();
  polygons->SetData(3, ids);
  return polygons;
}

vtkSmartPointer<vtkPolyData> MakeMesh(const vtkPointSplatFans& fans)
{
  vtkNew<vtkDoubleArray> positions;
  positions->SetNumberOfComponents(3);
  positions->SetNumberOfTuples(fans.GetNumberOfPoints());
  std::copy_n(fans.GetPosition(0), positions->GetNumberOfValues(), positions->GetPointer(0));
  vtkNew<vtkPoints> points;
  points->SetData(positions);
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(MakePolygons(fans.GetCorners()));
  return mesh;
}

/// A mesh with copies of some of its points after these.
vtkSmartPointer<vtkPolyData> MakeSplit(vtkPolyData* mesh, const std::vector<vtkIdType>& sources,
  const std::vector<float>& normals, const std::vector<vtkIdType>& corners)
{
  const vtkIdType count = mesh->GetNumberOfPoints(), copies = static_cast<vtkIdType>(sources.size());
  vtkNew<vtkIdList> from, to;
  for (vtkIdType k = 0; k < copies; ++k)
  {
    from->InsertNextId(sources[k]);
    to->InsertNextId(count + k);
  }
  const auto extend = [&](vtkAbstractArray* array, vtkAbstractArray* extended) {
    extended->SetName(array->GetName());
    extended->SetNumberOfComponents(array->GetNumberOfComponents());
    extended->SetNumberOfTuples(count + copies);
    extended->InsertTuples(0, count, 0, array);
    extended->InsertTuples(to, from, array);
  };
  vtkNew<vtkPoints> points;
  points->SetDataType(mesh->GetPoints()->GetDataType());
  extend(mesh->GetPoints()->GetData(), points->GetData());
  vtkNew<vtkFloatArray> directions;
  directions->SetNumberOfComponents(3);
  directions->SetNumberOfTuples(count + copies);
  std::copy(normals.begin(), normals.end(), directions->GetPointer(0));
  auto split = vtkSmartPointer<vtkPolyData>::New();
  split->SetPoints(points);
  split->SetPolys(MakePolygons(corners));
  split->GetPointData()->SetNormals(directions);
  if (vtkPointSplatInput::GetGhosts(mesh))
  {
    vtkNew<vtkUnsignedCharArray> ghosts;
    extend(mesh->GetPointData()->GetArray(vtkDataSetAttributes::GhostArrayName()), ghosts);
    split->GetPointData()->AddArray(ghosts);
  }
  return split;
}

/// Gives a point's normal, of those that were found; returns whether it has one. Triangles that cancel one another, or that
/// have no area, give none.
bool GetNormal(vtkPolyDataNormals* found, vtkIdType at, float normal[3])
{
  double n[3];
  found->GetOutput()->GetPointData()->GetNormals()->GetTuple(at, n);
  if (!std::isfinite(n[0] + n[1] + n[2]) || !(vtkMath::Normalize(n) > 0))
  {
    return false;
  }
  std::copy_n(n, 3, normal);
  return true;
}

/// Sets some points' normals to those of their triangles, where these have one; returns whether any has.
bool Find(const vtkPointSplatFans& fans, const std::vector<vtkIdType>& ids, float* normals)
{
  if (ids.empty() || fans.IsEmpty())
  {
    return false;
  }
  vtkNew<vtkPolyDataNormals> filter;
  filter->SetInputData(MakeMesh(fans));
  filter->SplittingOff();
  filter->Update();
  bool any = false;
  for (const vtkIdType id : ids)
  {
    any = GetNormal(filter, fans.GetSame(id), normals + 3 * id) || any;
  }
  return any;
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

/// Edges so sharp that vtkPolyDataNormals splits there, and of them those of flat triangles.
struct Sharp
{
  std::atomic<std::size_t> Edges{ 0 }, OfFlat{ 0 };

  /// stride: looks at one in so many triangles.
  Sharp(const vtkPointSplatFans& fans, vtkIdType stride)
  {
    const std::vector<vtkIdType>& corners = fans.GetCorners();
    const vtkIdType count = (static_cast<vtkIdType>(corners.size() / 3) + stride - 1) / stride;
    vtkSMPTools::For(0, count, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const vtkIdType* own = corners.data() + 3 * stride * i;
        VisitBeside(fans, own, [&](const vtkIdType* other) {
          if (other > own && Fold(fans, own, other).Cosine < SplitCosine)
          {
            ++this->Edges;
            this->OfFlat += IsFlat(fans, own) || IsFlat(fans, other);
          }
        });
      }
    });
  }

  bool AreOfFaces() const { return this->OfFlat > LeastFlat * this->Edges; }
};

bool HasFaces(const vtkPointSplatFans& fans)
{
  const vtkIdType stride = 1 + static_cast<vtkIdType>(fans.GetCorners().size() / 3) / MostLookedAt;
  const Sharp some(fans, stride);
  return stride == 1 || some.Edges >= Enough ? some.AreOfFaces() : Sharp(fans, 1).AreOfFaces();
}

/// A mesh that was split where its faces end.
struct Faces
{
  vtkNew<vtkPolyDataNormals> Filter; // splits at 30 degrees
  std::vector<vtkIdType> Corners;    // of each triangle's corners the point there, or of those without area none
  static constexpr vtkIdType None = -1;

  /// joined: the mesh, as it is after Join().
  Faces(const vtkPointSplatFans& mesh, const vtkPointSplatFans& joined)
  {
    this->Filter->SetInputData(MakeMesh(joined));
    this->Filter->Update();
    vtkPolyData* split = this->Filter->GetOutput();
    const std::vector<vtkIdType>& corners = mesh.GetCorners();
    this->Corners.assign(corners.size(), None);
    vtkIdType triangle = 0;
    for (std::size_t i = 0; i < corners.size(); i += 3)
    {
      const auto getSame = [&](int k) { return joined.GetSame(corners[i + k]); };
      if (getSame(0) == getSame(1) || getSame(1) == getSame(2) || getSame(2) == getSame(0))
      {
        continue; // it has no area, and is none of those joined
      }
      vtkIdType count;
      const vtkIdType* ids;
      split->GetPolys()->GetCellAtId(triangle++, count, ids);
      for (int k = 0; k < 3; ++k)
      {
        // Triangles may have been turned.
        const auto* id = std::find_if(ids, ids + count, [&](vtkIdType at) {
          double x[3];
          split->GetPoint(at, x);
          return std::equal(x, x + 3, mesh.GetPosition(corners[i + k]));
        });
        this->Corners[i + k] = id != ids + count ? *id : None;
      }
    }
  }
};

/// Sets normals of triangles that have points of their own: at a crease a corner has that of its own face.
bool FindOfFaces(const vtkPointSplatFans& apart, float* normals)
{
  vtkPointSplatFans joined = apart;
  joined.Join(normals);
  if (joined.IsEmpty() || !HasFaces(joined))
  {
    return false;
  }
  const Faces faces(apart, joined);
  bool any = false;
  for (std::size_t i = 0; i < faces.Corners.size(); ++i)
  {
    float* normal = normals + 3 * apart.GetCorners()[i];
    any = (faces.Corners[i] != Faces::None && vtkPointSplatInput::IsZero(normal) &&
            GetNormal(faces.Filter, faces.Corners[i], normal)) ||
      any;
  }
  return any;
}
}

vtkSmartPointer<vtkPolyData> vtkPointSplatMeshNormals::Split(
  vtkPolyData* mesh, vtkPointSplatFans& fans, std::vector<vtkIdType>& sources)
{
  fans.Clear();
  sources.clear();
  std::vector<unsigned char> used;
  const vtkIdType count = mesh->GetNumberOfPoints();
  if (count == 0 || mesh->GetPointData()->GetNormals())
  {
    return nullptr;
  }
  vtkPointSplatInput::MarkUsable(mesh, used);
  if (fans.Read(mesh, used.data()) > 0)
  {
    fans.Clear(); // whoever reads it again tells of bad cells
  }
  if (fans.IsEmpty() || fans.AreApart() || !HasFaces(fans))
  {
    return nullptr;
  }
  for (vtkIdType id = 0; id < count; ++id)
  {
    if (used[id] && !fans.Has(id))
    {
      return nullptr;
    }
  }
  std::vector<float> normals(3 * count, 0.0f);
  vtkPointSplatFans joined = fans;
  joined.Join(normals.data());
  if (joined.IsEmpty())
  {
    return nullptr;
  }
  const Faces faces(fans, joined);

  // The first face at a point has this, and each other one a copy.
  std::map<std::pair<vtkIdType, vtkIdType>, vtkIdType> copies; // of a point and a face's corner
  std::vector<vtkIdType> first(count, Faces::None), corners = fans.GetCorners();
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const vtkIdType point = corners[i], corner = faces.Corners[i];
    if (corner == Faces::None)
    {
      continue;
    }
    if (first[point] == Faces::None)
    {
      first[point] = corner;
      GetNormal(faces.Filter, corner, normals.data() + 3 * point);
    }
    if (first[point] == corner)
    {
      continue;
    }
    const vtkIdType next = count + static_cast<vtkIdType>(sources.size());
    const auto [copy, isNew] = copies.try_emplace({ point, corner }, next);
    corners[i] = copy->second;
    if (isNew)
    {
      sources.push_back(point);
      normals.resize(normals.size() + 3, 0.0f);
      GetNormal(faces.Filter, corner, normals.data() + 3 * next);
    }
  }
  if (sources.empty())
  {
    return nullptr;
  }
  return MakeSplit(mesh, sources, normals, corners);
}

bool vtkPointSplatMeshNormals::Complete(vtkPointSplatFans& fans, float* normals)
{
  std::vector<vtkIdType> missing;
  for (vtkIdType id = 0; id < fans.GetNumberOfPoints(); ++id)
  {
    if (vtkPointSplatInput::IsZero(normals + 3 * id) && fans.Has(id))
    {
      missing.push_back(id);
    }
  }
  const bool any = !missing.empty() && (fans.AreApart() ? FindOfFaces(fans, normals) : Find(fans, missing, normals));
  const bool joined = fans.Join(normals);
  return (any && !joined) || Find(fans, missing, normals) || any;
}

VTK_ABI_NAMESPACE_END
