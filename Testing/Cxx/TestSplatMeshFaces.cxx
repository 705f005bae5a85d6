// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// That splats of faces with few triangles, as CAD has them, cover these, and nothing beside them.
#include "MeshScene.h"

#include "vtkCleanPolyData.h"
#include "vtkConeSource.h"
#include "vtkCubeSource.h"
#include "vtkPolyDataNormals.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <string>

namespace
{
using namespace MeshScene;

/// A data set's splats, fill points among them.
vtkSmartPointer<vtkPolyData> MakeSplats(vtkPolyData* data, double scale = 1)
{
  vtkNew<vtkPointSplatEstimation> filter;
  filter->SetInputData(data);
  filter->FillGapsOn();
  filter->SetRadiusScale(scale);
  filter->Update();
  return filter->GetOutput();
}

/// Whether a splat, so many times as large, reaches a place.
bool IsCovered(vtkPolyData* splats, const double place[3], double times)
{
  for (vtkIdType id = 0; id < splats->GetNumberOfPoints(); ++id)
  {
    double clip[6] = { 0, 0, 0, 0, 0, 0 }, x[3], d[3];
    if (vtkFloatArray* clips = Array(splats, vtkPointSplatArrays::Clip))
    {
      clips->GetTuple(id, clip);
    }
    splats->GetPoint(id, x);
    vtkMath::Subtract(place, x, d);
    const double radius = Array(splats, vtkPointSplatArrays::Radius)->GetValue(id);
    if (vtkMath::Norm(d) <= times * radius && vtkMath::Dot(clip, d) <= 1 && vtkMath::Dot(clip + 3, d) <= 1)
    {
      return true;
    }
  }
  return false;
}

/// Looks at places of the plane z from -1 to 4 by x and by y. distance: to the faces, less than 0 inside.
void CheckFaces(vtkPolyData* splats, const std::function<double(double, double)>& distance, const std::string& name)
{
  constexpr int samples = 60;
  int open = 0, past = 0;
  for (int j = 0; j <= samples; ++j)
  {
    for (int i = 0; i <= samples; ++i)
    {
      const double place[3] = { -1 + 5.0 * i / samples, -1 + 5.0 * j / samples, 0 };
      const double off = distance(place[0], place[1]);
      // Kernels reach farther than disks: they cover with less than they reach.
      open += off < 0 && !IsCovered(splats, place, 1.1);
      past += off > 0.12 && IsCovered(splats, place, 1.5);
    }
  }
  Expect(open == 0, name + ": " + std::to_string(open) + " places are open");
  Expect(past == 0, name + ": " + std::to_string(past) + " places beside it are covered");
}

double GetDistance(double x, double y, double width, double height)
{
  return std::max({ -x, -y, x - width, y - height });
}

void AddPolygon(vtkPolyData* data, std::initializer_list<std::array<double, 2>> corners)
{
  data->GetPolys()->InsertNextCell(static_cast<int>(corners.size()));
  for (const std::array<double, 2>& corner : corners)
  {
    data->GetPolys()->InsertCellPoint(data->GetPoints()->InsertNextPoint(corner[0], corner[1], 0));
    data->GetPointData()->GetNormals()->InsertNextTuple3(0, 0, 1);
  }
}

void TestPolygons()
{
  vtkSmartPointer<vtkPolyData> square = MakeEmpty();
  AddPolygon(square, { { { 0, 0 } }, { { 3, 0 } }, { { 3, 3 } }, { { 0, 3 } } });
  vtkSmartPointer<vtkPolyData> splats = MakeSplats(square);
  CheckFaces(splats, [](double x, double y) { return GetDistance(x, y, 3, 3); }, "a square");
  Expect(splats->GetNumberOfPoints() > 4 && splats->GetNumberOfPoints() < 12, "a square takes few splats");

  vtkSmartPointer<vtkPolyData> larger = MakeSplats(square, 1.5);
  for (vtkIdType id = 0; id < 4; ++id)
  {
    AtMost(std::abs(Array(larger, vtkPointSplatArrays::Radius)->GetValue(id) -
             1.5 * Array(splats, vtkPointSplatArrays::Radius)->GetValue(id)),
      1e-5, "the scale changes what there is room for");
  }

  vtkSmartPointer<vtkPolyData> strip = MakeEmpty();
  AddPolygon(strip, { { { 0, 0 } }, { { 3, 0 } }, { { 3, 0.4 } }, { { 0, 0.4 } } });
  CheckFaces(MakeSplats(strip), [](double x, double y) { return GetDistance(x, y, 3, 0.4); }, "a strip");

  vtkSmartPointer<vtkPolyData> thin = MakeEmpty();
  AddPolygon(thin, { { { 0, 0 } }, { { 3, 0 } }, { { 3, 0.02 } }, { { 0, 0.02 } } });
  CheckFaces(MakeSplats(thin), [](double x, double y) { return GetDistance(x, y, 3, 0.02); }, "a thin strip");

  vtkSmartPointer<vtkPolyData> triangle = MakeEmpty();
  AddPolygon(triangle, { { { 0, 0 } }, { { 3, 0 } }, { { 0, 3 } } });
  CheckFaces(MakeSplats(triangle),
    [](double x, double y) { return std::max({ -x, -y, (x + y - 3) / std::sqrt(2.0) }); }, "a triangle");

  // Two squares, and one of them lies on a plate that goes on.
  vtkSmartPointer<vtkPolyData> two = MakeEmpty();
  AddPolygon(two, { { { 0, 0 } }, { { 1, 0 } }, { { 1, 1 } }, { { 0, 1 } } });
  AddPolygon(two, { { { -1, -1 } }, { { 4, -1 } }, { { 4, 4 } }, { { -1, 4 } } });
  CheckFaces(MakeSplats(two), [](double, double) { return -1.0; }, "a square on a plate");
}

/// A mesh that was split along a part of a line, as where an edge gets blunt, is covered on both sides and at its end.
void TestSlit()
{
  vtkSmartPointer<vtkPolyData> square = MakeEmpty();
  AddSquare(square, 4, 0, 1);
  const vtkIdType first = square->GetNumberOfPoints();
  for (vtkIdType i = 0; i < 2; ++i)
  {
    // Of the line y = 1.
    square->GetPoints()->InsertNextPoint(square->GetPoint(4 + i));
    square->GetPointData()->GetNormals()->InsertNextTuple3(0, 0.35, 0.94);
    square->GetPointData()->GetNormals()->SetTuple3(4 + i, 0, -0.35, 0.94);
  }
  ChangeCells(square, [&](vtkIdType cell, vtkIdList* ids) {
    for (vtkIdType k = 0; k < 4 && cell >= 3; ++k)
    {
      const vtkIdType id = ids->GetId(k);
      ids->SetId(k, id == 4 || id == 5 ? first + id - 4 : id);
    }
    return true;
  });
  CheckFaces(MakeSplats(square), [](double x, double y) { return GetDistance(x, y, 3, 3); }, "a square with a slit");
}

/// An edge is as long as the face, and its ends are far from points beside it.
void TestLongEdge()
{
  vtkSmartPointer<vtkPolyData> strip = MakeEmpty();
  AddPolygon(strip, { { { 0, 0.1 } }, { { 0, 0 } }, { { 3, 0 } }, { { 3, 0.4 } }, { { 1.6, 0.4 } }, { { 1.5, 0.4 } },
                      { { 1.4, 0.4 } }, { { 0, 0.4 } } });
  CheckFaces(MakeSplats(strip), [](double x, double y) { return GetDistance(x, y, 3, 0.4); }, "a strip of long edges");
}

/// A strip that is three thousand times as long as it is wide ends where it ends.
void TestString()
{
  vtkSmartPointer<vtkPolyData> strip = MakeEmpty();
  AddPolygon(strip, { { { 0, 0 } }, { { 3, 0 } }, { { 3, 0.001 } }, { { 0, 0.001 } } });
  vtkSmartPointer<vtkPolyData> splats = MakeSplats(strip);
  CheckFaces(splats, [](double x, double y) { return GetDistance(x, y, 3, 0.001); }, "a string");
  int past = 0;
  for (int i = 0; i <= 100; ++i)
  {
    for (const double y : { -0.0005, 0.0015 })
    {
      const double place[3] = { 0.03 * i, y, 0 };
      past += IsCovered(splats, place, 1.5);
    }
  }
  Expect(past == 0, "a string is wider at " + std::to_string(past) + " places");
}

/// Where the outline turns inward one line across the corner would reach past it, or leave it open.
void TestNotch()
{
  vtkSmartPointer<vtkPolyData> angle = MakeEmpty();
  AddSquare(angle, 4, 0, 1);
  ChangeCells(angle, [](vtkIdType cell, vtkIdList*) { return cell != 8; });
  vtkNew<vtkCleanPolyData> used;
  used->SetInputData(angle);
  used->Update();
  vtkSmartPointer<vtkPolyData> splats = MakeSplats(used->GetOutput());
  CheckFaces(splats,
    [](double x, double y) { return std::max(GetDistance(x, y, 3, 3), std::min(x, y) - 2); }, "an angle");
  int past = 0, open = 0;
  for (int i = 1; i < 20; ++i)
  {
    const double out[3] = { 2 + 0.05 * i, 2.02, 0 }, in[3] = { 2 + 0.05 * i, 1.98, 0 };
    past += IsCovered(splats, out, 1.5);
    open += !IsCovered(splats, in, 1.1);
  }
  Expect(past == 0, "a notch is covered at " + std::to_string(past) + " places");
  Expect(open == 0, "the edge of a notch is open at " + std::to_string(open) + " places");
}

/// Teeth are so narrow, and so near to one another, that fill points of one may be as near to the next one's as to its own.
void TestComb()
{
  constexpr int teeth = 30;
  constexpr double pitch = 0.1, width = 0.05;
  vtkSmartPointer<vtkPolyData> comb = MakeEmpty();
  for (int k = 0; k < teeth; ++k)
  {
    const double x = pitch * k;
    AddPolygon(comb, { { { x, 0.2 } }, { { x + width, 0.2 } }, { { x + width, 3 } }, { { x, 3 } } });
  }
  AddPolygon(comb, { { { 0, 0 } }, { { pitch * teeth, 0 } }, { { pitch * teeth, 0.2 } }, { { 0, 0.2 } } });
  vtkNew<vtkCleanPolyData> merged;
  merged->SetInputData(comb);
  merged->Update();
  vtkSmartPointer<vtkPolyData> splats = MakeSplats(merged->GetOutput());
  int past = 0;
  for (int k = 0; k < teeth; ++k)
  {
    for (int i = 0; i < 50; ++i)
    {
      const double place[3] = { pitch * k + width + 0.5 * (pitch - width), 0.3 + 0.05 * i, 0 };
      past += IsCovered(splats, place, 1.5);
    }
  }
  Expect(past == 0, "gaps of a comb are covered at " + std::to_string(past) + " places");
}

/// Two triangles meet in a point, whose disk would need four lines.
void TestPinch()
{
  vtkSmartPointer<vtkPolyData> bow = MakeEmpty();
  AddPolygon(bow, { { { 1.5, 1.5 } }, { { 0, 3 } }, { { 0, 0 } }, { { 3, 0 } }, { { 3, 3 } } });
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1, 2 });
  cells->InsertNextCell({ 0, 3, 4 });
  bow->SetPolys(cells);
  CheckFaces(MakeSplats(bow),
    [](double x, double y) {
      return std::max(GetDistance(x, y, 3, 3), (std::abs(y - 1.5) - std::abs(x - 1.5)) / std::sqrt(2.0));
    },
    "a bow");
}

/// Of a surface that is there once for each side the second one is left out.
void TestTwoSides()
{
  vtkSmartPointer<vtkPolyData> square = MakeEmpty();
  AddSquare(square, 4, 0, 1);
  square->GetPointData()->SetNormals(nullptr);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(square);
  triangles->Update();
  vtkPolyData* both = triangles->GetOutput();
  vtkNew<vtkCellArray> back;
  back->DeepCopy(both->GetPolys());
  for (vtkIdType cell = 0; cell < back->GetNumberOfCells(); ++cell)
  {
    back->ReverseCellAtId(cell);
  }
  both->GetPolys()->Append(back);
  CheckFaces(MakeSplats(both), [](double x, double y) { return GetDistance(x, y, 3, 3); }, "a square with two sides");
}

/// Beside a flat face that is one or some triangles wide, in rows up to x = 2.7, a fillet of as long and narrow ones falls
/// off: no disk may stick out.
void TestFillet(std::initializer_list<double> rows, const std::string& name)
{
  vtkSmartPointer<vtkPolyData> data = MakeEmpty();
  data->GetPointData()->SetNormals(nullptr);
  constexpr int steps = 6;
  constexpr double radius = 0.3;
  const auto addRow = [&](double x, double z) {
    data->GetPoints()->InsertNextPoint(x, 0, z);
    data->GetPoints()->InsertNextPoint(x, 3, z);
  };
  for (const double x : rows)
  {
    addRow(x, 0);
  }
  for (int k = 1; k <= steps; ++k)
  {
    const double angle = vtkMath::Pi() / 2 * k / steps;
    addRow(2.7 + radius * std::sin(angle), radius * (std::cos(angle) - 1));
  }
  for (vtkIdType k = 0; 2 * k + 3 < data->GetNumberOfPoints(); ++k)
  {
    const vtkIdType corners[4] = { 2 * k, 2 * k + 2, 2 * k + 3, 2 * k + 1 };
    data->GetPolys()->InsertNextCell(4, corners);
  }
  vtkSmartPointer<vtkPolyData> splats = MakeSplats(data);
  const double first = *rows.begin();
  CheckFaces(splats,
    [first](double x, double y) { return x > 2.7 && x < 3.1 ? 0.0 : GetDistance(x - first, y, 2.7 - first, 3); }, name);
}

/// A dome has one flat face, whose edges are few, and at which it has that one's normals, too.
void TestDome()
{
  vtkSmartPointer<vtkPolyData> dome = MakeSphere(5);
  for (vtkIdType id = 0; id < dome->GetNumberOfPoints(); ++id)
  {
    double x[3];
    dome->GetPoint(id, x);
    vtkMath::MultiplyScalar(x, 1 + 0.001 * std::sin(37.0 * id));
    dome->GetPoints()->SetPoint(id, x[0], x[1], std::max(3 * x[2], -13.0));
  }
  dome->GetPointData()->SetNormals(nullptr);
  vtkSmartPointer<vtkPolyData> splats = MakeSplats(dome);
  int copies = 0;
  for (vtkIdType id = dome->GetNumberOfPoints(); id < splats->GetNumberOfPoints(); ++id)
  {
    double n[3], x[3];
    splats->GetPointData()->GetNormals()->GetTuple(id, n);
    splats->GetPoint(id, x);
    copies += x[2] < -12.999 && n[2] < -0.999;
  }
  Expect(copies > 20, std::to_string(copies) + " splats of a dome's rim are of its flat face");
}

/// A lens has no flat face, but its rim is the only edge that is not a bend: there it has the normals of either side.
void TestLens()
{
  vtkNew<vtkSphereSource> ball;
  ball->SetThetaResolution(48);
  ball->SetPhiResolution(33); // a ring of its points lies half way between the poles
  ball->SetRadius(1);
  ball->Update();
  vtkPolyData* lens = ball->GetOutput();
  for (vtkIdType id = 0; id < lens->GetNumberOfPoints(); ++id)
  {
    double x[3];
    lens->GetPoint(id, x);
    const double cap = std::sqrt(std::max(2 - x[0] * x[0] - x[1] * x[1], 1.0)) - 1;
    const double height = std::abs(x[2]) < 1e-6 ? 0 : std::copysign(cap, x[2]);
    lens->GetPoints()->SetPoint(id, x[0], x[1], height + 0.0002 * std::sin(37.0 * id));
  }
  lens->GetPointData()->SetNormals(nullptr);
  vtkSmartPointer<vtkPolyData> splats = MakeSplats(lens);
  int sides[2] = { 0, 0 };
  for (vtkIdType id = 0; id < splats->GetNumberOfPoints(); ++id)
  {
    double n[3], x[3];
    splats->GetPointData()->GetNormals()->GetTuple(id, n);
    splats->GetPoint(id, x);
    if (std::hypot(x[0], x[1]) > 0.999)
    {
      AtMost(std::abs(std::abs(n[2]) - std::sqrt(0.5)), 0.1, "the normal at a lens' rim, splat " + std::to_string(id));
      ++sides[n[2] < 0];
    }
  }
  Expect(sides[0] >= 48 && sides[1] >= 48, "a lens' rim has splats on both sides");
}

/// A polygon of many short edges: what is looked at for each fill point does not grow with them.
void TestFineOutline()
{
  vtkSmartPointer<vtkPolyData> disc = MakeEmpty();
  AddDisc(disc, 2000, 1.5, 1.5);
  CheckFaces(MakeSplats(disc), [](double x, double y) { return std::hypot(x - 1.5, y - 1.5) - 1.5; }, "a disc");
}

void CheckCube(vtkPolyData* splats)
{
  for (vtkIdType id = 0; id < splats->GetNumberOfPoints(); ++id)
  {
    double n[3], x[3];
    splats->GetPointData()->GetNormals()->GetTuple(id, n);
    splats->GetPoint(id, x);
    const int axis = static_cast<int>(
      std::max_element(n, n + 3, [](double a, double b) { return std::abs(a) < std::abs(b); }) - n);
    AtMost(std::abs(n[axis] - 2 * x[axis]), 1e-5, "the normal of a cube's splat " + std::to_string(id));
  }
}

/// A cube of triangles with points of their own and no normals has those of its faces.
void TestCube()
{
  vtkNew<vtkCubeSource> cube;
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(cube->GetOutputPort());
  triangles->Update();
  vtkSmartPointer<vtkPolyData> soup = MakeSoup(triangles->GetOutput());
  soup->GetPointData()->SetNormals(nullptr);
  CheckCube(MakeSplats(soup));
}

/// Of a cube's eight points each has a splat on all three faces, if it has no normal.
void TestSharedPoints()
{
  vtkNew<vtkCubeSource> cube;
  vtkNew<vtkCleanPolyData> merged;
  vtkSmartPointer<vtkPolyData> bare = MakeEmpty();
  cube->Update();
  bare->SetPoints(cube->GetOutput()->GetPoints());
  bare->SetPolys(cube->GetOutput()->GetPolys());
  bare->GetPointData()->SetNormals(nullptr);
  merged->SetInputData(bare);
  merged->Update();
  vtkPolyData* eight = merged->GetOutput();
  vtkNew<vtkFloatArray> heat;
  heat->SetName("heat");
  for (vtkIdType id = 0; id < 8; ++id)
  {
    heat->InsertNextValue(static_cast<float>(id));
  }
  eight->GetPointData()->AddArray(heat);
  vtkSmartPointer<vtkPolyData> splats = MakeSplats(eight);
  Expect(eight->GetNumberOfPoints() == 8 && splats->GetNumberOfPoints() == 24 + 6,
    "a cube's splats are " + std::to_string(splats->GetNumberOfPoints()));
  CheckCube(splats);
  vtkDataArray* sources = splats->GetPointData()->GetArray(vtkPointSplatArrays::Source);
  int copies = 0;
  for (vtkIdType id = 8; sources && id < splats->GetNumberOfPoints(); ++id)
  {
    double x[3], y[3];
    const vtkIdType source = static_cast<vtkIdType>(sources->GetTuple1(id));
    Expect(source >= 0 && source < 8, "a fill point's source is a point");
    splats->GetPoint(id, x);
    splats->GetPoint(source, y);
    if (std::equal(x, x + 3, y))
    {
      ++copies;
      AtMost(std::abs(Array(splats, "heat")->GetValue(id) - static_cast<float>(source)), 0, "a copy's value");
    }
  }
  Expect(copies == 16, std::to_string(copies) + " copies of a cube's points");
}

/// A cone's tip is one point, about which no disk lies on the surface.
void TestTip()
{
  vtkNew<vtkConeSource> cone;
  cone->SetResolution(24);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(cone->GetOutputPort());
  normals->Update();
  vtkSmartPointer<vtkPolyData> splats = MakeSplats(normals->GetOutput());
  for (vtkIdType id = 0; id < splats->GetNumberOfPoints(); ++id)
  {
    double x[3];
    splats->GetPoint(id, x);
    const double width = std::hypot(x[1], x[2]);
    // Its base lies at x = -0.5.
    if (x[0] > -0.49)
    {
      AtMost(Array(splats, vtkPointSplatArrays::Radius)->GetValue(id), std::max(0.06, 0.8 * width),
        "a splat's radius where the cone is " + std::to_string(2 * width) + " wide");
    }
  }
}
}

int TestSplatMeshFaces(int, char*[])
{
  Expect(MakeSplats(MakeEmpty())->GetNumberOfPoints() == 0, "no points have no splats");
  TestPolygons();
  TestSlit();
  TestLongEdge();
  TestString();
  TestNotch();
  TestComb();
  TestPinch();
  TestTwoSides();
  TestFillet({ 0, 2.7 }, "a face with a fillet");
  TestFillet({ 2.4, 2.5, 2.6, 2.7 }, "a face of three rows with a fillet");
  TestFineOutline();
  TestCube();
  TestSharedPoints();
  TestDome();
  TestLens();
  TestTip();
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
