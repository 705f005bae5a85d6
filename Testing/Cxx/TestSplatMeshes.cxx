// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// That vtkPointSplatEstimation takes sizes and curvature from a mesh's triangles where there are such,
// whatever the cells index.
#include "MeshScene.h"

#include "vtkClipPolyData.h"
#include "vtkIdTypeArray.h"
#include "vtkMath.h"
#include "vtkPlane.h"
#include "vtkTransform.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
using namespace MeshScene;

void TestSphere()
{
  const double radius = 5;
  vtkSmartPointer<vtkPolyData> sphere = MakeSphere(radius);
  Estimated estimated(sphere);
  Expect(estimated.Filter->GetNoise() == 0, "a mesh is not noisy");
  vtkFloatArray* curvature =
    Array(estimated.Filter->GetOutput(), vtkPointSplatArrays::Curvature);
  const double around = 2 * 3.14159265 * radius;
  // At the poles, the first points, many narrow triangles meet.
  for (vtkIdType id = 2; id < sphere->GetNumberOfPoints(); ++id)
  {
    double x[3];
    sphere->GetPoint(id, x);
    const double across = around / 48 * std::hypot(x[0], x[1]) / radius, along = around / 62;
    const double longest = std::hypot(across, along);
    Expect(estimated.Radius(id) >= 0.4 * longest && estimated.Radius(id) <= 0.8 * longest,
      "the radius of point " + std::to_string(id) + " is " + std::to_string(estimated.Radius(id)) +
        " beside triangles of " + std::to_string(longest));
    double tensor[6];
    curvature->GetTuple(id, tensor);
    AtMost(std::abs(0.5 * (tensor[0] + tensor[1] + tensor[2]) * radius - 0.9), 0.06,
      "curvature of point " + std::to_string(id));
  }
}

/// Sheets nearer than any search could tell apart, with normals to the same side.
void TestNearSheets()
{
  vtkSmartPointer<vtkPolyData> data = MakeEmpty();
  AddSquare(data, 20, 0, 1);
  Estimated one(data);
  AddSquare(data, 20, 0.01, 1);
  Estimated two(data);
  for (vtkIdType id = 0; id < 800; ++id)
  {
    Expect(two.Radius(id) == one.Radius(id % 400),
      "the radius of point " + std::to_string(id) + " does not depend on the other sheet");
    Expect(two.Radius(id) >= 0.55f && two.Radius(id) <= 0.75f,
      "the radius of point " + std::to_string(id) + " fits its squares");
  }
}

/// A cell array whose connectivity is as given.
vtkSmartPointer<vtkCellArray> MakeCells(
  const std::vector<vtkIdType>& offsets, const std::vector<vtkIdType>& ids)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  vtkNew<vtkIdTypeArray> first, connectivity;
  for (const vtkIdType offset : offsets)
  {
    first->InsertNextValue(offset);
  }
  for (const vtkIdType id : ids)
  {
    connectivity->InsertNextValue(id);
  }
  cells->SetData(first, connectivity);
  return cells;
}

void TestBadCells()
{
  vtkSmartPointer<vtkPolyData> data = MakeEmpty();
  AddSquare(data, 3, 0, 1);
  Estimated good(data);
  Expect(good.Warnings == 0, "good cells are not warned of");
  const vtkIdType far = vtkIdType(1) << 40;
  for (const vtkIdType bad : { vtkIdType(-1), vtkIdType(9), far })
  {
    vtkNew<vtkCellArray> cells;
    cells->DeepCopy(data->GetPolys());
    const vtkIdType wrong[3] = { 0, bad, 1 };
    cells->InsertNextCell(3, wrong);
    vtkNew<vtkPolyData> other;
    other->ShallowCopy(data);
    other->SetPolys(cells);
    Estimated estimated(other);
    Expect(estimated.Warnings == 1, "a corner " + std::to_string(bad) + " is warned of once");
    for (vtkIdType id = 0; id < 9; ++id)
    {
      Expect(estimated.Radius(id) == good.Radius(id), "and leaves the others as they are");
    }
    vtkNew<vtkPolyData> strip;
    strip->ShallowCopy(data);
    strip->SetStrips(cells);
    Expect(Estimated(strip).Warnings == 1, "so it is in a strip");
  }
  // Offsets that leave the connectivity, cells of two corners, of the same corner, of none.
  for (const auto& cells : { MakeCells({ 0, 3, 50 }, { 0, 1, 4 }), MakeCells({ 0, 2 }, { 0, 1 }),
         MakeCells({ 0, 3 }, { 4, 4, 4 }), MakeCells({ 0, 0, 0 }, {}) })
  {
    vtkNew<vtkPolyData> other;
    other->ShallowCopy(data);
    other->SetPolys(cells);
    Estimated estimated(other);
    for (vtkIdType id = 0; id < 9; ++id)
    {
      Expect(estimated.Radius(id) > 0, "points without triangles are sized as a cloud's");
    }
  }
}

/// Points that belong to no triangle, hidden ones, and a mesh without any.
void TestMixed()
{
  vtkSmartPointer<vtkPolyData> data = MakeEmpty();
  AddSquare(data, 20, 0, 1);
  Estimated mesh(data);
  for (int k = 0; k < 100; ++k)
  {
    data->GetPoints()->InsertNextPoint(30 + k % 10, k / 10, 0);
    data->GetPointData()->GetNormals()->InsertNextTuple3(0, 0, 1);
  }
  Estimated mixed(data);
  for (vtkIdType id = 0; id < 500; ++id)
  {
    Expect(id < 400 ? mixed.Radius(id) == mesh.Radius(id)
                    : mixed.Radius(id) > 0.5f && mixed.Radius(id) < 1,
      "point " + std::to_string(id) + " of a mesh and a cloud");
  }
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(500);
  ghosts->FillValue(0);
  ghosts->SetValue(0, vtkDataSetAttributes::HIDDENPOINT);
  ghosts->SetValue(21, vtkDataSetAttributes::DUPLICATEPOINT);
  data->GetPointData()->AddArray(ghosts);
  Estimated hidden(data);
  Expect(hidden.Radius(0) == 0 && hidden.Radius(21) == 0, "ghosts have no radius");
  Expect(hidden.Radius(22) == mesh.Radius(22), "their neighbours have theirs");

  vtkNew<vtkPolyData> vertices;
  vertices->SetPoints(data->GetPoints());
  vertices->GetPointData()->SetNormals(data->GetPointData()->GetNormals());
  Estimated bare(vertices);
  vtkNew<vtkCellArray> single;
  for (vtkIdType id = 0; id < 500; ++id)
  {
    single->InsertNextCell(1, &id);
  }
  vertices->SetVerts(single);
  Estimated same(vertices);
  for (vtkIdType id = 0; id < 500; ++id)
  {
    Expect(bare.Radius(id) == same.Radius(id), "vertex cells say nothing of sizes");
  }
}

/// An isosurface through a sample of its volume has several points there, which triangles of no area connect.
void TestJoined()
{
  vtkSmartPointer<vtkPolyData> square = MakeEmpty();
  AddSquare(square, 8, 0, 1);
  Estimated one(square);
  vtkSmartPointer<vtkPolyData> parted = MakeEmpty();
  AddSquare(parted, 8, 0, 1);
  // The cell to the right of a point is its twin's.
  ChangeCells(parted, [](vtkIdType, vtkIdList* ids) { return ids->GetId(0) != 27 && ids->GetId(0) != 4; });
  vtkCellArray* cells = parted->GetPolys();
  for (const vtkIdType id : { 27, 4 }) // inside, and on the border
  {
    const vtkIdType twin = parted->GetPoints()->InsertNextPoint(parted->GetPoint(id));
    parted->GetPointData()->GetNormals()->InsertNextTuple3(0, 0, 1);
    const vtkIdType sliver[3] = { twin, id, id + 8 };
    cells->InsertNextCell(3, sliver);
    const vtkIdType quad[4] = { twin, id + 1, id + 9, id + 8 };
    cells->InsertNextCell(4, quad);
  }
  // Two at a place of their own have no area.
  const vtkIdType off = parted->GetPoints()->InsertNextPoint(20, 20, 0);
  parted->GetPoints()->InsertNextPoint(20, 20, 0);
  parted->GetPoints()->InsertNextPoint(20, 20, 0);
  for (int k = 0; k < 3; ++k)
  {
    parted->GetPointData()->GetNormals()->InsertNextTuple3(0, 0, 1);
  }
  const vtkIdType speck[3] = { off, off + 1, off + 2 };
  cells->InsertNextCell(3, speck);
  Estimated several(parted);
  AtMost(several.Radius(off), 0, "the radius of what has no area");
  vtkFloatArray* clips[2] = { Array(one.Filter->GetOutput(), vtkPointSplatArrays::Clip),
    Array(several.Filter->GetOutput(), vtkPointSplatArrays::Clip) };
  Expect(clips[0] && clips[1], "both squares end");
  for (vtkIdType id = 0; id < off && clips[0] && clips[1]; ++id)
  {
    const vtkIdType same = id < 64 ? id : (id == 64 ? 27 : 4);
    AtMost(std::abs(several.Radius(id) - one.Radius(same)), 1e-6, "the radius of joined points differs");
    for (int c = 0; c < 6; ++c)
    {
      AtMost(std::abs(clips[1]->GetTypedComponent(id, c) - clips[0]->GetTypedComponent(same, c)), 1e-4,
        "lines of joined points differ");
    }
  }
}

/// A mesh's disks end at its border, however near to that its points lie.
void TestBorders()
{
  vtkSmartPointer<vtkPolyData> square = MakeEmpty();
  AddSquare(square, 20, 0, 1);
  Estimated ends(square);
  vtkFloatArray* clips = Array(ends.Filter->GetOutput(), vtkPointSplatArrays::Clip);
  Expect(clips != nullptr, "a square ends somewhere");
  vtkIdType count = 0;
  for (vtkIdType id = 0; clips && id < 400; ++id)
  {
    count += clips->GetTypedComponent(id, 0) != 0 || clips->GetTypedComponent(id, 1) != 0;
  }
  // Kernels of the points beside the border reach it, too.
  Expect(count == 4 * 19 + 4 * 17, std::to_string(count) + " points have lines");
  AtMost(GetFarthest(ends), 0.03, "past the border");

  // Triangles are long along the border: kernels of several rows reach over it.
  vtkSmartPointer<vtkPolyData> dense = MakeEmpty();
  AddSquare(dense, 60, 0, 1);
  for (vtkIdType id = 0; id < dense->GetNumberOfPoints(); ++id)
  {
    double x[3];
    dense->GetPoint(id, x);
    dense->GetPoints()->SetPoint(id, x[0] / 8, x[1], x[2]);
  }
  Estimated stretched(dense);
  AtMost(GetFarthest(stretched, 1.5), 0.03, "past the border, of long triangles");

  // A cell is missing, whose corners are reflex: what is left of it, and what is not covered around.
  vtkSmartPointer<vtkPolyData> holed = MakeEmpty();
  AddSquare(holed, 6, 0, 1);
  ChangeCells(holed, [](vtkIdType cell, vtkIdList*) { return cell != 12; }); // between 2 and 3
  Estimated around(holed);
  clips = Array(around.Filter->GetOutput(), vtkPointSplatArrays::Clip);
  int open = 0, uncovered = 0;
  constexpr int samples = 50;
  for (int j = 0; j <= 5 * samples && clips; ++j)
  {
    for (int i = 0; i <= 5 * samples; ++i)
    {
      const double at[2] = { static_cast<double>(i) / samples, static_cast<double>(j) / samples };
      bool covered = false;
      for (vtkIdType id = 0; id < 36 && !covered; ++id)
      {
        double clip[6], x[3];
        clips->GetTuple(id, clip);
        holed->GetPoint(id, x);
        const double d[3] = { at[0] - x[0], at[1] - x[1], 0 };
        // Kernels reach farther than disks, here less than they do.
        covered = vtkMath::Norm(d) <= 1.1 * around.Radius(id) && vtkMath::Dot(clip, d) <= 1 &&
          vtkMath::Dot(clip + 3, d) <= 1;
      }
      const bool hole = std::max(std::abs(at[0] - 2.5), std::abs(at[1] - 2.5)) < 0.5;
      open += hole && !covered;
      uncovered += !hole && !covered;
    }
  }
  Expect(uncovered == 0, std::to_string(uncovered) + " places of the mesh are not covered");
  Expect(open > samples * samples / 3, "of the hole " + std::to_string(open) + " places are open");

  // One polygon of so many corners that each cannot look at what all others have.
  vtkSmartPointer<vtkPolyData> disc = MakeEmpty();
  AddDisc(disc, 30000, 0, 1);
  Estimated ofDisc(disc);
  Expect(ofDisc.Radius(1) > 0, "a polygon's corner has a radius");

  // Cut at a slant, and turned so that x = 0 is the cut.
  const double slant = std::atan(0.03);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(10, 10, 0);
  plane->SetNormal(std::cos(slant), std::sin(slant), 0);
  vtkNew<vtkClipPolyData> cut;
  cut->SetInputData(square);
  cut->SetClipFunction(plane);
  vtkNew<vtkTransform> turn;
  turn->RotateZ(-vtkMath::DegreesFromRadians(slant));
  turn->Translate(-10, -10, 0);
  cut->Update();
  vtkPolyData* piece = cut->GetOutput();
  vtkNew<vtkPoints> turned;
  turn->TransformPoints(piece->GetPoints(), turned);
  piece->SetPoints(turned);
  vtkIdType beside = 0;
  for (vtkIdType id = 0; id < piece->GetNumberOfPoints(); ++id)
  {
    const double x = piece->GetPoint(id)[0];
    beside += x > 1e-4 && x < 0.3;
  }
  Expect(beside >= 5, "points lie beside the cut");
  Estimated atCut(piece);
  AtMost(GetFarthest(atCut), 0.03, "past the cut");

  // Next to a point of the border lies another one, so near to it that the edge between both goes anywhere.
  vtkSmartPointer<vtkPolyData> sliver = MakeEmpty();
  AddSquare(sliver, 20, 0, 1);
  ChangeCells(sliver, [&sliver](vtkIdType, vtkIdList* ids) {
    double x[3];
    sliver->GetPoint(ids->GetId(0), x);
    if (x[0] == 0)
    {
      ids->InsertNextId(sliver->GetPoints()->InsertNextPoint(-1e-6, x[1] + 1e-8, 0));
      sliver->GetPointData()->GetNormals()->InsertNextTuple3(0, 0, 1);
    }
    return true;
  });
  Estimated straight(sliver);
  AtMost(GetFarthest(straight), 0.03, "past a border with slivers");
  clips = Array(straight.Filter->GetOutput(), vtkPointSplatArrays::Clip);
  for (vtkIdType id = 0; clips && id < sliver->GetNumberOfPoints(); ++id)
  {
    double clip[6], x[3];
    sliver->GetPoint(id, x);
    clips->GetTuple(id, clip);
    if (x[0] < 0.5 && x[1] > 2.5 && x[1] < 16.5)
    {
      Expect(-clip[0] > 0.98 * vtkMath::Norm(clip) && vtkMath::Dot(clip + 3, clip + 3) <= 1.1 * vtkMath::Dot(clip, clip) &&
          std::abs(clip[4]) <= 0.2 * vtkMath::Norm(clip),
        "a line along the border at " + std::to_string(x[1]));
    }
  }

  // A sphere is closed; its points are there once for each triangle, and it still is.
  vtkSmartPointer<vtkPolyData> sphere = MakeSphere(5);
  vtkSmartPointer<vtkPolyData> soup = MakeSoup(sphere);
  for (vtkPolyData* closed : { sphere.Get(), soup.Get() })
  {
    Estimated estimated(closed);
    Expect(!Array(estimated.Filter->GetOutput(), vtkPointSplatArrays::Clip),
      "a closed mesh has no lines");
  }
}
}

int TestSplatMeshes(int, char*[])
{
  TestSphere();
  TestNearSheets();
  TestBadCells();
  TestMixed();
  TestJoined();
  TestBorders();
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
