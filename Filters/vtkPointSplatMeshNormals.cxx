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
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// Of each point the one that stands for all in its place.
std::vector<vtkIdType> Weld(const vtkPointSplatFans& fans, vtkIdType numberOfPoints)
{
  std::vector<vtkIdType> welded(numberOfPoints);
  std::iota(welded.begin(), welded.end(), vtkIdType(0));
  const std::vector<vtkIdType> border = fans.GetBorderByPosition();
  for (std::size_t i = 1; i < border.size(); ++i)
  {
    if (fans.IsSamePlace(border[i - 1], border[i]))
    {
      welded[border[i]] = welded[border[i - 1]];
    }
  }
  return welded;
}

vtkSmartPointer<vtkPolyData> MakeMesh(
  const vtkPointSplatFans& fans, const std::vector<vtkIdType>& welded)
{
  vtkNew<vtkDoubleArray> positions;
  positions->SetNumberOfComponents(3);
  positions->SetNumberOfTuples(static_cast<vtkIdType>(welded.size()));
  std::copy_n(fans.GetPosition(0), 3 * welded.size(), positions->GetPointer(0));
  vtkNew<vtkPoints> points;
  points->SetData(positions);
  vtkNew<vtkCellArray> polygons;
  const std::vector<vtkIdType>& corners = fans.GetCorners();
  for (std::size_t i = 0; i < corners.size(); i += 3)
  {
    const vtkIdType triangle[3] = { welded[corners[i]], welded[corners[i + 1]],
      welded[corners[i + 2]] };
    if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
    {
      polygons->InsertNextCell(3, triangle);
    }
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(polygons);
  return mesh;
}
}

bool vtkPointSplatMeshNormals::Complete(const vtkPointSplatFans& fans, float* normals)
{
  const vtkIdType numberOfPoints = fans.GetNumberOfPoints();
  const auto isMissing = [&](vtkIdType id) {
    const float* n = normals + 3 * id;
    return n[0] == 0 && n[1] == 0 && n[2] == 0 && fans.Has(id);
  };
  std::vector<vtkIdType> missing;
  for (vtkIdType id = 0; id < numberOfPoints; ++id)
  {
    if (isMissing(id))
    {
      missing.push_back(id);
    }
  }
  if (missing.empty())
  {
    return false;
  }
  const std::vector<vtkIdType> welded = Weld(fans, numberOfPoints);
  vtkNew<vtkPolyDataNormals> filter;
  filter->SetInputData(MakeMesh(fans, welded));
  filter->SplittingOff();
  filter->Update();
  vtkDataArray* found = filter->GetOutput()->GetPointData()->GetNormals();
  bool any = false;
  for (const vtkIdType id : missing)
  {
    double n[3];
    found->GetTuple(welded[fans.GetSame(id)], n);
    // Triangles that cancel one another, or that have no area, give none.
    if (std::isfinite(n[0] + n[1] + n[2]) && vtkMath::Normalize(n) > 0)
    {
      std::copy_n(n, 3, normals + 3 * id);
      any = true;
    }
  }
  return any;
}

VTK_ABI_NAMESPACE_END
