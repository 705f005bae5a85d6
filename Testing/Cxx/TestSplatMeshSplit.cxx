// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// That splats at a surface's sharp edges lie in its faces' planes, and are shaded with their points' normals all the same.
#include "MeshScene.h"

#include "vtkCleanPolyData.h"
#include "vtkCubeSource.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

namespace
{
using namespace MeshScene;

/// A splat, and the input's point that it is at or near to.
struct Splat
{
  vtkIdType Id, Source;
  double X[3];
  double Plane[3], Normal[3]; // unit length
  bool IsCopy;                // of that point
};

/// Estimates splats with fill points, and visits those that are drawn.
void VisitSplats(vtkPolyData* data, const std::function<void(const Splat&)>& visitor)
{
  vtkNew<vtkPointSplatEstimation> filter;
  filter->SetInputData(data);
  filter->FillGapsOn();
  filter->Update();
  vtkPolyData* splats = filter->GetOutput();
  vtkDataArray* sources = splats->GetPointData()->GetArray(vtkPointSplatArrays::Source);
  Expect(sources != nullptr, "there are fill points");
  for (vtkIdType id = 0; sources && id < splats->GetNumberOfPoints(); ++id)
  {
    Splat splat;
    splat.Id = id;
    splat.Source = static_cast<vtkIdType>(sources->GetTuple1(id));
    splats->GetPoint(id, splat.X);
    Array(splats, vtkPointSplatArrays::PlaneNormal)->GetTuple(id, splat.Plane);
    splats->GetPointData()->GetNormals()->GetTuple(id, splat.Normal);
    double x[3];
    splats->GetPoint(splat.Source, x);
    splat.IsCopy = id != splat.Source && std::equal(x, x + 3, splat.X);
    if (Array(splats, vtkPointSplatArrays::Radius)->GetValue(id) > 0)
    {
      visitor(splat);
    }
  }
}

double GetDistance(const double a[3], const double b[3])
{
  return std::sqrt(vtkMath::Distance2BetweenPoints(a, b));
}

/// A cube of eight points whose normals are means of its faces', and of as many polygons whose corners are in the wrong order.
vtkSmartPointer<vtkPolyData> MakeRoundedCube(int reversed)
{
  vtkNew<vtkCubeSource> cube;
  cube->Update();
  vtkNew<vtkPolyData> bare;
  bare->SetPoints(cube->GetOutput()->GetPoints());
  bare->SetPolys(cube->GetOutput()->GetPolys());
  vtkNew<vtkCleanPolyData> merged;
  merged->SetInputData(bare);
  merged->Update();
  vtkSmartPointer<vtkPolyData> data = merged->GetOutput();
  data->BuildCells();
  for (int polygon = 0; polygon < reversed; ++polygon)
  {
    data->ReverseCell(polygon);
  }
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  for (vtkIdType id = 0; id < data->GetNumberOfPoints(); ++id)
  {
    double n[3];
    data->GetPoint(id, n);
    vtkMath::Normalize(n);
    normals->InsertNextTuple(n);
  }
  data->GetPointData()->SetNormals(normals);
  return data;
}

/// The mean normals are shaded with, but no disk is across an edge.
void TestGivenNormals(int reversed)
{
  const std::string name = "a cube with " + std::to_string(reversed) + " polygons reversed: ";
  vtkSmartPointer<vtkPolyData> cube = MakeRoundedCube(reversed);
  int copies = 0;
  VisitSplats(cube, [&](const Splat& splat) {
    const std::string which = name + "splat " + std::to_string(splat.Id);
    const int axis = static_cast<int>(std::max_element(splat.Plane, splat.Plane + 3,
                                        [](double a, double b) { return std::abs(a) < std::abs(b); }) -
      splat.Plane);
    AtMost(std::abs(splat.Plane[axis] - 2 * splat.X[axis]), 1e-5, which + " is in a face's plane, and faces outward");
    double given[3];
    cube->GetPointData()->GetNormals()->GetTuple(splat.Source, given);
    if (splat.Id == splat.Source || splat.IsCopy)
    {
      AtMost(GetDistance(given, splat.Normal), 1e-6, which + " has its point's normal");
    }
    AtMost(std::sqrt(1.0 / 3) - vtkMath::Dot(splat.Plane, splat.Normal), 1e-5, which + " has a normal between its corners'");
    copies += splat.IsCopy;
  });
  Expect(copies == 16, name + std::to_string(copies) + " copies");
}

/// A ball with bumps, which has sharp edges, and no normals.
vtkSmartPointer<vtkPolyData> MakeRough()
{
  vtkSmartPointer<vtkPolyData> rough = MakeSphere(5);
  rough->GetPointData()->SetNormals(nullptr);
  for (vtkIdType id = 0; id < rough->GetNumberOfPoints(); ++id)
  {
    double x[3];
    rough->GetPoint(id, x);
    vtkMath::MultiplyScalar(x, 1 + 0.05 * std::sin(37.0 * id));
    rough->GetPoints()->SetPoint(id, x);
  }
  return rough;
}

/// It is shaded as one surface.
void TestRough()
{
  vtkSmartPointer<vtkPolyData> rough = MakeRough();
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(rough->GetNumberOfPoints());
  int copies = 0;
  VisitSplats(rough, [&](const Splat& splat) {
    double own[3];
    if (splat.Id == splat.Source)
    {
      normals->SetTuple(splat.Id, splat.Normal);
    }
    normals->GetTuple(splat.Source, own);
    AtMost(splat.IsCopy ? GetDistance(own, splat.Normal) : 0, 1e-6, "a rough ball's copy has its point's normal");
    copies += splat.IsCopy;
  });
  Expect(copies > 100, "a rough ball has sharp edges, at which there are " + std::to_string(copies) + " copies");
}

/// The same with normals from the middle.
vtkSmartPointer<vtkPolyData> MakeRoughWithNormals()
{
  vtkSmartPointer<vtkPolyData> rough = MakeRough();
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  for (vtkIdType id = 0; id < rough->GetNumberOfPoints(); ++id)
  {
    normals->InsertNextTuple(rough->GetPoint(id));
  }
  rough->GetPointData()->SetNormals(normals);
  return rough;
}

/// Planes face as the triangles do where some normals do not, but as the normals do where triangles contradict one another.
void TestFront()
{
  vtkSmartPointer<vtkPolyData> rough = MakeRoughWithNormals();
  vtkDataArray* normals = rough->GetPointData()->GetNormals();
  for (vtkIdType id = 0; id < 20; ++id)
  {
    double n[3];
    normals->GetTuple(id, n);
    normals->SetTuple3(id, -n[0], -n[1], -n[2]);
  }
  int inward = 0, against = 0;
  VisitSplats(rough, [&](const Splat& splat) {
    inward += vtkMath::Dot(splat.Plane, splat.X) < 0;
    against += vtkMath::Dot(splat.Plane, splat.Normal) < 0;
  });
  Expect(inward == 0, std::to_string(inward) + " planes face inward, as normals do");
  Expect(against >= 20, std::to_string(against) + " planes face away from their normals");
  rough->BuildCells();
  rough->ReverseCell(rough->GetNumberOfCells() / 2);
  against = 0;
  VisitSplats(rough, [&](const Splat& splat) { against += vtkMath::Dot(splat.Plane, splat.Normal) < 0; });
  Expect(against == 0, std::to_string(against) + " planes face as triangles do that contradict one another");
}

/// A triangle without area, whose corners lie in a line, takes nothing from the others.
void TestCollinear()
{
  vtkSmartPointer<vtkPolyData> rough = MakeRoughWithNormals();
  vtkNew<vtkPolyData> more;
  more->DeepCopy(rough);
  vtkIdType corners[3];
  for (int k = 0; k < 3; ++k)
  {
    corners[k] = more->GetPoints()->InsertNextPoint(2 + 0.25 * k, 0, 0);
    more->GetPointData()->GetNormals()->InsertNextTuple3(0, 0, 1);
  }
  more->InsertNextCell(VTK_TRIANGLE, 3, corners);
  int splats[2] = { 0, 0 };
  VisitSplats(rough, [&](const Splat&) { ++splats[0]; });
  VisitSplats(more, [&](const Splat&) { ++splats[1]; });
  AtMost(std::abs(splats[1] - splats[0]), 10, "how many splats there are more or less by a triangle without area");
}

/// Points and normals of an isosurface with a ridge: of these the volume's gradients are means, and tell of no plane.
void TestRidge()
{
  vtkNew<vtkImageData> volume;
  volume->SetDimensions(24, 24, 24);
  volume->SetOrigin(-11.7, -12, -11.5);
  volume->AllocateScalars(VTK_FLOAT, 1);
  for (vtkIdType id = 0; id < volume->GetNumberOfPoints(); ++id)
  {
    double x[3];
    volume->GetPoint(id, x);
    // Nine off from the middle all around, and on top of it two planes that meet at 74 degrees.
    const double wedge = std::max(0.8 * x[0] + 0.6 * x[1], 0.8 * x[0] - 0.6 * x[1]);
    const double ball = vtkMath::Norm(x) - 9;
    volume->GetPointData()->GetScalars()->SetTuple1(id, std::max(wedge - 3, ball));
  }
  vtkNew<vtkFlyingEdges3D> surface;
  surface->SetInputData(volume);
  surface->SetValue(0, 0);
  surface->ComputeScalarsOff();
  surface->Update();
  vtkNew<vtkPolyData> points;
  points->SetPoints(surface->GetOutput()->GetPoints());
  points->GetPointData()->SetNormals(surface->GetOutput()->GetPointData()->GetNormals());
  int seen = 0;
  VisitSplats(points, [&](const Splat& splat) {
    const bool onRidge = std::abs(splat.X[1]) < 1e-3 && splat.X[0] > 0 && vtkMath::Norm(splat.X) < 7;
    if (onRidge && (splat.Id == splat.Source || splat.IsCopy))
    {
      ++seen;
      AtMost(std::abs(vtkMath::Dot(splat.Plane, splat.Normal) - 0.8), 0.02, "a ridge's splat is in one of its planes");
      AtMost(std::abs(std::abs(splat.Plane[1]) - 0.6), 0.02, "a ridge's splat is in one of its planes");
      AtMost(std::abs(splat.Normal[1]), 0.02, "a ridge's splat is shaded with the volume's gradient");
    }
  });
  Expect(seen >= 20, "a ridge has " + std::to_string(seen) + " splats, two a point");
}
}

int TestSplatMeshSplit(int, char*[])
{
  TestGivenNormals(0);
  TestGivenNormals(1);
  TestGivenNormals(6);
  TestRough();
  TestFront();
  TestCollinear();
  TestRidge();
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
