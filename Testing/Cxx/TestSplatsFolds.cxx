// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// The vertices of a mesh that is shaded smoothly over an edge: the points on the edge have
// averages of its faces' normals. The splats' picture must be the mesh's, convex and concave, and a
// point's parts on both faces have the point's colour and id.
#include "SplatScene.h"

#include "vtkCellArray.h"
#include "vtkPointSplatArrays.h"
#include "vtkPointSplatEstimation.h"

namespace
{
using namespace SplatScene;

/// Two squares that meet in a row of vertices, at a right angle.
vtkSmartPointer<vtkPolyData> MakeFold()
{
  const int half = 20, rows = 40;
  const double diagonal = std::sqrt(0.5);
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  vtkNew<vtkCellArray> triangles;
  for (int row = 0; row <= rows; ++row)
  {
    for (int k = -half; k <= half; ++k)
    {
      points->InsertNextPoint(std::min(k, 0), -std::max(k, 0), row);
      normals->InsertNextTuple3(
        k < 0 ? 0 : k > 0 ? 1 : diagonal, k < 0 ? 1 : k > 0 ? 0 : diagonal, 0);
      if (row < rows && k < half)
      {
        const vtkIdType a = points->GetNumberOfPoints() - 1, b = a + 2 * half + 1;
        const vtkIdType first[3] = { a, b, a + 1 }, second[3] = { a + 1, b, b + 1 };
        triangles->InsertNextCell(3, first);
        triangles->InsertNextCell(3, second);
      }
    }
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->GetPointData()->SetNormals(normals);
  mesh->SetPolys(triangles);
  return mesh;
}

Picture Draw(vtkMapper* mapper, double side)
{
  mapper->ScalarVisibilityOff();
  Window window;
  window.Add(mapper);
  vtkCamera* camera = window.Renderer->GetActiveCamera();
  camera->SetPosition(30 * side, 36 * side, 5);
  camera->SetFocalPoint(0, 0, 20);
  camera->SetViewUp(0, 0, 1);
  camera->SetViewAngle(20); // of the edge and the middle of both faces: no borders
  window.Renderer->ResetCameraClippingRange();
  return window.Draw();
}

void Compare(Checks& checks, double side)
{
  vtkSmartPointer<vtkPolyData> mesh = MakeFold();
  vtkNew<vtkPointSplatEstimation> estimation;
  estimation->SetInputData(Cloud(mesh));
  estimation->Update();
  vtkSmartPointer<vtkPolyData> splats = estimation->GetOutput();
  vtkNew<vtkPolyData> flat;
  flat->ShallowCopy(splats);
  flat->GetPointData()->RemoveArray(vtkPointSplatArrays::Fold);

  vtkNew<vtkPolyDataMapper> stock;
  stock->SetInputData(mesh);
  const Picture truth = Draw(stock, side);
  double psnr[2];
  for (int folded = 0; folded < 2; ++folded)
  {
    vtkNew<vtkPointSplatMapper> mapper;
    mapper->SetInputData(folded ? splats.Get() : flat.Get());
    psnr[folded] = Psnr(truth, Draw(mapper, side));
    const double more = mapper->GetNumberOfSplats() - splats->GetNumberOfPoints();
    checks.AtLeast(more, folded ? 35.0 : 0.0, "further parts of splats");
    checks.AtMost(more, folded ? 41.0 : 0.0, "further parts of splats");
  }
  const std::string name = side > 0 ? "convex" : "concave";
  std::cout << name << ": " << psnr[0] << " dB without, " << psnr[1] << " dB with folds\n";
  checks.AtLeast(psnr[1], 38.0, name + ": psnr");
  checks.AtLeast(psnr[1], psnr[0] + 3, name + ": psnr with folds");
}
}

int TestSplatsFolds(int, char*[])
{
  Checks checks;
  Compare(checks, 1);
  Compare(checks, -1);
  return checks.Result();
}
