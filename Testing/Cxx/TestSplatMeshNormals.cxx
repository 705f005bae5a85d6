// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// That vtkPointSplatEstimation takes normals that a mesh does not have from its triangles, and makes one of points
// where triangles meet.
#include "MeshScene.h"

#include <cmath>

namespace
{
using namespace MeshScene;

/// How many normals are off those of a sphere about the origin by more than 3 degrees.
int CountOff(Estimated& estimated)
{
  vtkPolyData* splats = estimated.Filter->GetOutput();
  int off = 0;
  for (vtkIdType id = 0; id < splats->GetNumberOfPoints(); ++id)
  {
    double x[3], n[3];
    splats->GetPoint(id, x);
    splats->GetPointData()->GetNormals()->GetTuple(id, n);
    off += !(vtkMath::Dot(x, n) > std::cos(vtkMath::RadiansFromDegrees(3.0)) * vtkMath::Norm(x));
  }
  return off;
}

/// Triangles tell the normals that a mesh does not have, and on which side these are.
void TestSpheres()
{
  vtkSmartPointer<vtkPolyData> sphere = MakeSphere(5);
  Estimated given(sphere);
  vtkSmartPointer<vtkPolyData> soup = MakeSoup(sphere);
  Estimated joined(soup);
  vtkNew<vtkPolyData> flipped;
  flipped->DeepCopy(sphere);
  ChangeCells(flipped, [](vtkIdType cell, vtkIdList* ids) {
    if (cell % 3 == 1)
    {
      const vtkIdType first = ids->GetId(0);
      ids->SetId(0, ids->GetId(2));
      ids->SetId(2, first);
    }
    return true;
  });
  for (vtkPolyData* mesh : { sphere.Get(), soup.Get(), flipped.Get() })
  {
    vtkNew<vtkPolyData> bare;
    bare->ShallowCopy(mesh);
    bare->GetPointData()->SetNormals(nullptr);
    Estimated found(bare);
    Expect(CountOff(found) == 0, std::to_string(CountOff(found)) + " normals from triangles are off");
    Estimated ellipses(bare);
    ellipses.Filter->SetShapeToElliptical();
    ellipses.Filter->Update();
    Expect(CountOff(ellipses) == 0, std::to_string(CountOff(ellipses)) + " normals of ellipses are off");
    Estimated& same = mesh == soup ? joined : given;
    for (vtkIdType id = 0; id < mesh->GetNumberOfPoints(); ++id)
    {
      AtMost(std::abs(found.Radius(id) / same.Radius(id) - 1), 0.01, "radius of point " + std::to_string(id));
    }
  }
  // The first corner of each triangle of the soup, against the sphere's own points.
  for (vtkIdType cell = 0; cell < sphere->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> ids;
    sphere->GetCellPoints(cell, ids);
    AtMost(std::abs(joined.Radius(3 * cell) / given.Radius(ids->GetId(0)) - 1), 0.01,
      "the radius of triangle " + std::to_string(cell) + "'s corner");
  }
}

/// Normals that are given stay; of sheets that lie close to one another no search would tell the others.
void TestNearSheets()
{
  vtkSmartPointer<vtkPolyData> sheets = MakeEmpty();
  AddSquare(sheets, 20, 0, 0);
  AddSquare(sheets, 20, 0.01, 0);
  sheets->GetPointData()->GetNormals()->SetTuple3(7, 0, 0, -1);
  Estimated completed(sheets);
  vtkDataArray* normals = completed.Filter->GetOutput()->GetPointData()->GetNormals();
  for (vtkIdType id = 0; id < 800; ++id)
  {
    AtMost(std::abs(normals->GetComponent(id, 2) - (id == 7 ? -1 : 1)), 1e-6,
      "the normal of point " + std::to_string(id));
  }
}

/// Three squares that share edges, not points: the second goes on where the first ends, the third stands on both.
void TestPieces()
{
  vtkSmartPointer<vtkPolyData> pieces = MakeEmpty();
  for (int piece = 0; piece < 3; ++piece)
  {
    AddSquare(pieces, 20, 0, 0);
    for (vtkIdType id = 400 * piece; id < 400 * (piece + 1); ++id)
    {
      double x[3];
      pieces->GetPoint(id, x);
      pieces->GetPoints()->SetPoint(id, x[0] + (piece == 1 ? 19 : 0), piece == 2 ? 0.0 : x[1], piece == 2 ? x[1] : 0.0);
    }
  }
  pieces->GetPointData()->SetNormals(nullptr);
  Estimated angled(pieces);
  vtkDataArray* normals = angled.Filter->GetOutput()->GetPointData()->GetNormals();
  for (vtkIdType id = 0; id < 1200; ++id)
  {
    AtMost(1 - std::abs(normals->GetComponent(id, id < 800 ? 2 : 1)), 1e-6,
      "the normal of a piece's point " + std::to_string(id));
  }
}

/// Two squares that meet at an edge of 10 degrees, as a wing's sides do: their normals are nearly opposite, and each ends
/// there.
void TestSharpEdge()
{
  vtkSmartPointer<vtkPolyData> wedge = MakeEmpty();
  AddSquare(wedge, 20, 0, 0);
  AddSquare(wedge, 20, 0, 0);
  const double slope = std::tan(vtkMath::RadiansFromDegrees(10.0));
  for (vtkIdType id = 400; id < 800; ++id)
  {
    double x[3];
    wedge->GetPoint(id, x);
    wedge->GetPoints()->SetPoint(id, x[0], x[1], -slope * x[0]);
  }
  ChangeCells(wedge, [](vtkIdType, vtkIdList* ids) {
    for (vtkIdType k = 0; k < 2 && ids->GetId(0) >= 400; ++k)
    {
      const vtkIdType first = ids->GetId(k);
      ids->SetId(k, ids->GetId(3 - k));
      ids->SetId(3 - k, first);
    }
    return true;
  });
  wedge->GetPointData()->SetNormals(nullptr);
  Estimated estimated(wedge);
  vtkDataArray* normals = estimated.Filter->GetOutput()->GetPointData()->GetNormals();
  for (vtkIdType id = 0; id < 800; ++id)
  {
    const double across = normals->GetComponent(id, 2) + (id < 400 ? 0 : slope) * normals->GetComponent(id, 0);
    AtMost(1 - std::abs(across) / (id < 400 ? 1 : std::sqrt(1 + slope * slope)), 1e-5,
      "the normal of a wedge's point " + std::to_string(id));
  }
  AtMost(GetFarthest(estimated), 0.03, "past the wedge's edge");
}
}

int TestSplatMeshNormals(int, char*[])
{
  TestSpheres();
  TestNearSheets();
  TestPieces();
  TestSharpEdge();
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
