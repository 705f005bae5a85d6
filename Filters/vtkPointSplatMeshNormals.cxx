// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatMeshNormals.h"

#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSplatFans.h"
#include "vtkPointSplatInput.h"
#include "vtkPointSplatMeshFaces.h"
#include "vtkPointSplatThreads.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkTriangle.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// How long the mean of unit normals is at least that are about those of one face.
constexpr float LeastOfOneFace = 0.7f;
/// Vertices of more triangles are not looked at: they are few.
constexpr vtkIdType MostAtVertex = 64;

/// Whether two triangles of a vertex have a corner before it, or after it, in common.
bool IsOnSeam(const vtkPointSplatFans& fans, vtkIdType id)
{
  vtkIdType beside[2][MostAtVertex];
  int count = 0;
  bool seam = false;
  if (fans.GetNumberOfTriangles(id) > MostAtVertex)
  {
    return false;
  }
  fans.VisitTriangles(id, [&](const vtkIdType corners[3]) {
    const int own = corners[0] == id ? 0 : corners[1] == id ? 1 : 2;
    for (const int side : { 0, 1 })
    {
      const vtkIdType other = corners[(own + 1 + side) % 3];
      seam = seam || std::find(beside[side], beside[side] + count, other) != beside[side] + count;
      beside[side][count] = other;
    }
    ++count;
  });
  return seam;
}

/// The mean of a vertex' triangles' normals, turned to one side; false if they are not those of about one face.
bool FindTurned(const vtkPointSplatFans& fans, vtkIdType id, float mean[3])
{
  double sum[3] = { 0, 0, 0 };
  int count = 0;
  fans.VisitTriangles(id, [&](const vtkIdType corners[3]) {
    double n[3];
    vtkTriangle::ComputeNormal(
      fans.GetPosition(corners[0]), fans.GetPosition(corners[1]), fans.GetPosition(corners[2]), n);
    const double sign = vtkMath::Dot(n, sum) < 0 ? -1 : 1;
    for (int c = 0; c < 3; ++c)
    {
      sum[c] += sign * n[c];
    }
    ++count;
  });
  const double length = vtkMath::Normalize(sum);
  std::copy_n(sum, 3, mean);
  return length > LeastOfOneFace * count;
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

/// The corners of triangles that have none.
std::vector<vtkIdType> FindMissing(const vtkPointSplatFans& fans, const float* normals)
{
  std::vector<vtkIdType> missing;
  for (vtkIdType id = 0; id < fans.GetNumberOfPoints(); ++id)
  {
    if (vtkPointSplatInput::IsZero(normals + 3 * id) && fans.Has(id))
    {
      missing.push_back(id);
    }
  }
  return missing;
}

/// Sets some points' normals to those of their triangles, where these have one; returns whether any has.
bool Find(const vtkPointSplatFans& fans, const std::vector<vtkIdType>& ids, float* normals)
{
  if (ids.empty() || fans.IsEmpty())
  {
    return false;
  }
  vtkNew<vtkPolyDataNormals> filter;
  filter->SetInputData(fans.MakeMesh());
  filter->SplittingOff();
  filter->Update();
  bool any = false;
  for (const vtkIdType id : ids)
  {
    any = GetNormal(filter, fans.GetSame(id), normals + 3 * id) || any;
  }
  return any;
}

/// Sets normals of triangles that have points of their own: at a crease a corner has that of its own face.
bool FindOfFaces(const vtkPointSplatFans& apart, float* normals)
{
  vtkPointSplatFans joined = apart;
  joined.Join(normals);
  const vtkPointSplatMeshFaces::Edges edges = vtkPointSplatMeshFaces::Look(joined);
  if (joined.IsEmpty() || !edges.OfFlat)
  {
    return false;
  }
  const vtkPointSplatMeshFaces faces(apart, joined, edges, nullptr);
  const std::vector<vtkIdType>& corners = apart.GetCorners();
  bool any = false;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    float* normal = normals + 3 * corners[i];
    any = (faces.GetCorner(i) != vtkPointSplatMeshFaces::None && vtkPointSplatInput::IsZero(normal) &&
            faces.GetNormal(faces.GetCorner(i), normal)) ||
      any;
  }
  return any;
}
}

bool vtkPointSplatMeshNormals::AreMissing(const vtkPointSplatFans& fans, const float* normals)
{
  return !FindMissing(fans, normals).empty();
}

bool vtkPointSplatMeshNormals::Complete(vtkPointSplatFans& fans, float* normals)
{
  const std::vector<vtkIdType> missing = FindMissing(fans, normals);
  const bool any = !missing.empty() && (fans.AreApart() ? FindOfFaces(fans, normals) : Find(fans, missing, normals));
  const bool joined = fans.Join(normals);
  return (any && !joined) || Find(fans, missing, normals) || any;
}

vtkIdType vtkPointSplatMeshNormals::MendSeams(const vtkPointSplatFans& fans, float* normals)
{
  std::atomic<vtkIdType> mended{ 0 };
  vtkPointSplatThreads::For(0, fans.GetNumberOfPoints(), [&](vtkIdType begin, vtkIdType end) {
    vtkIdType here = 0;
    for (vtkIdType id = begin; id < end; ++id)
    {
      float turned[3];
      float* n = normals + 3 * id;
      if (!vtkPointSplatInput::IsZero(n) && fans.Has(id) && IsOnSeam(fans, fans.GetSame(id)) &&
        FindTurned(fans, fans.GetSame(id), turned) && std::abs(vtkMath::Dot(turned, n)) < AlikeCosine)
      {
        vtkMath::MultiplyScalar(turned, vtkMath::Dot(turned, n) < 0 ? -1.0f : 1.0f);
        std::copy_n(turned, 3, n);
        ++here;
      }
    }
    mended += here;
  });
  return mended;
}

void vtkPointSplatMeshNormals::TakeNeighbors(
  const vtkPointSplatFans& fans, const std::vector<unsigned char>& used, float* normals)
{
  std::vector<std::pair<vtkIdType, std::array<float, 3>>> missing;
  for (vtkIdType id = 0; id < fans.GetNumberOfPoints(); ++id)
  {
    if (used[id] && vtkPointSplatInput::IsZero(normals + 3 * id))
    {
      std::array<float, 3> sum{ { 0, 0, 0 } };
      fans.VisitNeighbors(
        fans.GetSame(id), [&](vtkIdType other) { vtkMath::Add(sum.data(), normals + 3 * other, sum.data()); });
      vtkMath::Normalize(sum.data());
      missing.emplace_back(id, sum);
    }
  }
  for (const auto& [id, normal] : missing)
  {
    std::copy(normal.begin(), normal.end(), normals + 3 * id);
  }
}

VTK_ABI_NAMESPACE_END
