// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSplatMeshNormals.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSplatFans.h"
#include "vtkPointSplatInput.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
vtkSmartPointer<vtkPolyData> MakeMesh(const vtkPointSplatFans& fans)
{
  vtkNew<vtkDoubleArray> positions;
  positions->SetNumberOfComponents(3);
  positions->SetNumberOfTuples(fans.GetNumberOfPoints());
  std::copy_n(fans.GetPosition(0), positions->GetNumberOfValues(), positions->GetPointer(0));
  vtkNew<vtkPoints> points;
  points->SetData(positions);
  vtkNew<vtkIdTypeArray> corners;
  corners->SetNumberOfValues(static_cast<vtkIdType>(fans.GetCorners().size()));
  std::copy(fans.GetCorners().begin(), fans.GetCorners().end(), corners->GetPointer(0));
  vtkNew<vtkCellArray> polygons;
  polygons->SetData(3, corners);
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(polygons);
  return mesh;
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
  vtkDataArray* found = filter->GetOutput()->GetPointData()->GetNormals();
  bool any = false;
  for (const vtkIdType id : ids)
  {
    double n[3];
    found->GetTuple(fans.GetSame(id), n);
    // Triangles that cancel one another, or that have no area, give none.
    if (std::isfinite(n[0] + n[1] + n[2]) && vtkMath::Normalize(n) > 0)
    {
      std::copy_n(n, 3, normals + 3 * id);
      any = true;
    }
  }
  return any;
}

/// The same of triangles that have points of their own: at a crease a corner has the normal of its own face.
bool FindSplit(const vtkPointSplatFans& apart, float* normals)
{
  vtkPointSplatFans joined = apart;
  joined.Join(normals);
  if (joined.IsEmpty())
  {
    return false;
  }
  vtkNew<vtkPolyDataNormals> filter; // splits at 30 degrees
  filter->SetInputData(MakeMesh(joined));
  filter->Update();
  vtkPolyData* split = filter->GetOutput();
  vtkDataArray* found = split->GetPointData()->GetNormals();
  bool any = false;
  vtkIdType triangle = 0;
  const std::vector<vtkIdType>& corners = apart.GetCorners();
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
      float* normal = normals + 3 * corners[i + k];
      // Triangles may have been turned.
      const auto* id = std::find_if(ids, ids + count, [&](vtkIdType at) {
        double x[3];
        split->GetPoint(at, x);
        return std::equal(x, x + 3, apart.GetPosition(corners[i + k]));
      });
      double n[3];
      if (id != ids + count && vtkPointSplatInput::IsZero(normal))
      {
        found->GetTuple(*id, n);
        if (std::isfinite(n[0] + n[1] + n[2]) && vtkMath::Normalize(n) > 0)
        {
          std::copy_n(n, 3, normal);
          any = true;
        }
      }
    }
  }
  return any;
}
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
  const bool any = !missing.empty() && (fans.AreApart() ? FindSplit(fans, normals) : Find(fans, missing, normals));
  const bool joined = fans.Join(normals);
  return (any && !joined) || Find(fans, missing, normals) || any;
}

VTK_ABI_NAMESPACE_END
